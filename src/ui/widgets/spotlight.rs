//! Marks controls of the window by their accessible names, wherever they stand.

use egui::plugin::Plugin;
use egui::{Context, FullOutput, Id, LayerId, Order, Rect, Stroke, StrokeKind, accesskit, pos2};

use super::things;
use crate::theme::Palette;
use bxdf_study::lessons::Thing;

/// From the edge of a control to its mark, in points.
const GAP: f32 = 3.0;

/// The width of the mark, in points.
const WIDTH: f32 = 2.5;

/// Finds the places of controls in what screen readers are told of the window.
#[derive(Default)]
struct Finder {
    names: Vec<String>,
    places: Vec<Rect>,
}

impl Plugin for Finder {
    fn debug_name(&self) -> &'static str {
        "Spotlight"
    }

    fn output_hook(&mut self, ctx: &Context, output: &mut FullOutput) {
        let update = output.platform_output.accesskit_update.as_ref();
        let places = update.map_or_else(Vec::new, |update| self.found(update));
        if places != self.places {
            self.places = places;
            ctx.request_repaint();
        }
    }
}

impl Finder {
    /// Where the controls stand that have one of the names.
    fn found(&self, update: &accesskit::TreeUpdate) -> Vec<Rect> {
        if self.names.is_empty() {
            return Vec::new();
        }
        let nodes = update.nodes.iter().map(|(_, node)| node);
        let named = nodes.filter(|node| {
            let label = node.label();
            label.is_some_and(|label| self.names.iter().any(|name| name == label))
        });
        let places = named.filter_map(accesskit::Node::bounds);
        let rect = |place: accesskit::Rect| {
            let [x0, y0, x1, y1] = [place.x0, place.y0, place.x1, place.y1].map(|x| x as f32);
            Rect::from_min_max(pos2(x0, y0), pos2(x1, y1))
        };
        places.map(rect).filter(Rect::is_positive).collect()
    }
}

/// Marks the controls that words point at, above all else.
pub fn show(ctx: &Context, palette: &Palette) {
    let wanted = things::pointed_by_words(ctx).into_iter();
    let names: Vec<String> = wanted
        .filter_map(|thing| match thing {
            Thing::Control(name) => Some(name),
            _ => None,
        })
        .collect();
    if !names.is_empty() {
        // The places are known by what screen readers are told.
        ctx.enable_accesskit();
    }
    if ctx.with_plugin(|_: &mut Finder| ()).is_none() {
        if names.is_empty() {
            return;
        }
        ctx.add_plugin(Finder::default());
    }
    let places = ctx.with_plugin(|finder: &mut Finder| {
        if finder.names != names {
            finder.names = names;
            ctx.request_repaint();
        }
        finder.places.clone()
    });
    let layer = LayerId::new(Order::Tooltip, Id::unique("spotlight"));
    let painter = ctx.layer_painter(layer);
    for place in places.unwrap_or_default() {
        let stroke = Stroke::new(WIDTH, palette.accent_line);
        painter.rect_stroke(place.expand(GAP), 4.0, stroke, StrokeKind::Outside);
    }
}
