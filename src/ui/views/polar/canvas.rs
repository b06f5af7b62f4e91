//! What is drawn of the plot: the grid, the curves, the directions and the deltas.

use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::Arc;

use egui::{Align2, Color32, Context, Pos2, Rect, Stroke, Ui, vec2};
use egui_plot::{Line, LineStyle, PlotPoint, PlotPoints, PlotTransform, PlotUi};

use super::super::context::Named;
use super::radial::{Radial, Rings, at};
use crate::theme;
use crate::theme::Dash;
use crate::widgets::things::{self, By};
use crate::widgets::{chart, deltas as arrows, draw};
use bxdf_lab::analysis::polar::{self, Point};
use bxdf_lab::analysis::{Channel, deltas};
use bxdf_study::lessons::Thing;
use bxdf_study::session::{Curves, EntryId, PaletteIndex, Section, Session};

/// Width of the note, as a share of the plot's.
const NOTE_WIDTH: f32 = 0.27;
/// Spacing of the angle rays.
pub(super) const RAY_STEP_DEG: i32 = 15;

fn line<'a>(points: impl IntoIterator<Item = [f64; 2]>, stroke: impl Into<Stroke>) -> Line<'a> {
    Line::new("", PlotPoints::from_iter(points))
        .stroke(stroke)
        // A line everywhere: as a band a ring is thin where it is steep, and no line in a drawing.
        .allow_band(false)
        .allow_hover(false)
}

pub(super) fn draw_grid(
    plot_ui: &mut PlotUi<'_>,
    rings: &Rings,
    palette: &theme::Palette,
    has_lower: bool,
) {
    let sweep = if has_lower { PI } else { FRAC_PI_2 };
    for tick in &rings.ticks {
        let radius = rings.radius(*tick);
        let angles = (-90..=90).map(|i| f64::from(i) / 90.0 * sweep);
        plot_ui.line(line(
            angles.map(|angle| at(radius, angle)),
            (1.0, palette.grid),
        ));
    }
    let limit: i32 = if has_lower { 180 } else { 90 };
    for angle_deg in (-limit + RAY_STEP_DEG..limit).step_by(RAY_STEP_DEG as usize) {
        let angle = f64::from(angle_deg).to_radians();
        plot_ui.line(line([[0.0, 0.0], at(1.0, angle)], (1.0, palette.grid)));
    }
    plot_ui.line(line([[-1.0, 0.0], [1.0, 0.0]], (1.5, palette.axis)));
}

/// A material as the plot draws it.
pub(super) struct Plotted {
    pub(super) entry: EntryId,
    pub(super) slot: PaletteIndex,
    pub(super) is_selected: bool,
    pub(super) section: Arc<polar::Section>,
    pub(super) radial: Radial,
}

fn arcs(section: &polar::Section) -> impl Iterator<Item = &Vec<Point>> {
    [&section.upper, &section.lower]
        .into_iter()
        .filter(|arc| !arc.is_empty())
}

/// Where channels are equal, the later curve leaves the earlier one visible at its sides.
fn stroke(channel: Channel, slot: PaletteIndex, palette: &theme::Palette) -> Stroke {
    let width = match channel {
        Channel::Luminance => 1.0,
        Channel::Red => 2.0,
        Channel::Green => 1.3,
        Channel::Blue => 0.8,
    };
    Stroke::new(width * theme::CURVE_WIDTH, palette.channel(channel, slot))
}

/// By how much wider is drawn what words of a text point at.
fn emphasis(ctx: &Context, mut meant: impl Iterator<Item = Thing>) -> f32 {
    if meant.any(|thing| things::is_pointed(ctx, &thing, By::Words)) {
        2.0
    } else {
        1.0
    }
}

pub(super) fn draw_curves(
    plot_ui: &mut PlotUi<'_>,
    session: &Session,
    plotted: &Plotted,
    palette: &theme::Palette,
) {
    let radial = &plotted.radial;
    let place = session.materials.position(plotted.entry);
    let material = place.map(|index| Thing::Material(index + 1));
    let lobe = plotted.is_selected.then_some(Thing::Lobe);
    let factor = emphasis(plot_ui.ctx(), material.into_iter().chain(lobe));
    for channel in session.shown_curves().channels() {
        let style = chart::style(Dash::of_channel(*channel, plotted.slot));
        for arc in arcs(&plotted.section) {
            let curve = arc
                .iter()
                .map(|point| at(radial.radius(channel.of(point.value)), point.angle));
            let closed = [[0.0, 0.0]].into_iter().chain(curve).chain([[0.0, 0.0]]);
            let mut stroke = stroke(*channel, plotted.slot, palette);
            stroke.width *= factor;
            plot_ui.line(line(closed, stroke).style(style));
        }
    }
}

/// A direction that is named.
pub(super) struct Way {
    pub(super) name: &'static str,
    pub(super) angle: f64,
    pub(super) color: Color32,
    /// Whether it lies in the section.
    is_inside: bool,
}

/// The directions that are named, by importance: light and viewer, the mirror direction and n.
pub(super) fn named_directions(
    session: &Session,
    directions: &[Named],
    section: Section,
    palette: &theme::Palette,
) -> Vec<Way> {
    let azimuth = section.phi();
    let way = |one: &Named| Way {
        name: one.name,
        angle: polar::signed_angle(one.direction, azimuth),
        color: one.color,
        is_inside: if one.is_held {
            section.holds_held
        } else {
            deltas::is_in_section(one.direction, azimuth)
        },
    };
    let mut ways: Vec<Way> = directions.iter().rev().map(way).collect();
    let held = polar::signed_angle(session.held(), azimuth);
    for (name, angle, color) in [("mirror", -held, palette.mirror), ("n", 0.0, palette.ink)] {
        ways.push(Way {
            name,
            angle,
            color,
            is_inside: true,
        });
    }
    ways
}

pub(super) fn draw_directions(
    plot_ui: &mut PlotUi<'_>,
    session: &Session,
    directions: &[Named],
    section: Section,
    palette: &theme::Palette,
) {
    let ctx = plot_ui.ctx().clone();
    let emphasis = |name: &str| emphasis(&ctx, Thing::named(name).into_iter());
    let width = 1.5 * emphasis("n");
    plot_ui.line(line([[0.0, 0.0], [0.0, 1.0]], (width, palette.ink)));
    // The most important one lies over the others.
    for way in named_directions(session, directions, section, palette)
        .iter()
        .rev()
        .filter(|way| way.name != "n")
    {
        let is_mirror = way.name == "mirror";
        // Outside the section directions are shown at their theta, but faintly: they do not lie in it.
        let style = if is_mirror || !way.is_inside {
            LineStyle::dashed_dense()
        } else {
            LineStyle::Solid
        };
        let width = if is_mirror { 1.5 } else { 2.0 } * emphasis(way.name);
        let ends = [[0.0, 0.0], at(1.0, way.angle)];
        plot_ui.line(line(ends, (width, way.color)).style(style));
    }
}

/// The plot as a canvas for what has no place among its items.
pub(super) struct Canvas<'a> {
    pub(super) ui: &'a Ui,
    pub(super) transform: &'a PlotTransform,
}

impl Canvas<'_> {
    pub(super) fn painter(&self) -> egui::Painter {
        self.ui.painter_at(*self.transform.frame())
    }

    /// The radius of labels: as far outside of the circle as they are large.
    pub(super) fn outside(&self, radius: f64) -> f64 {
        1.0 + (radius - 1.0) * f64::from(draw::label_scale(self.ui))
    }

    pub(super) fn position(&self, radius: f64, angle: f64) -> Pos2 {
        let [x, y] = at(radius, angle);
        self.transform.position_from_point(&PlotPoint::new(x, y))
    }

    /// Tints the area inside the curve, as a fan about the origin: a lobe is star-shaped by construction.
    pub(super) fn fill(&self, session: &Session, plotted: &Plotted, palette: &theme::Palette) {
        if session.shown_curves() != Curves::Luminance {
            return;
        }
        let color = theme::fill_of(palette.material(plotted.slot));
        for arc in arcs(&plotted.section) {
            let mut mesh = egui::Mesh::default();
            mesh.colored_vertex(self.position(0.0, 0.0), color);
            for (index, point) in arc.iter().enumerate() {
                mesh.colored_vertex(
                    self.position(
                        plotted.radial.radius(Channel::Luminance.of(point.value)),
                        point.angle,
                    ),
                    color,
                );
                if index > 0 {
                    mesh.add_triangle(0, index as u32, index as u32 + 1);
                }
            }
            self.painter().add(mesh);
        }
    }

    /// A sentence in the corner that the circle leaves free.
    pub(super) fn note(&self, text: &str, palette: &theme::Palette) {
        let frame = self.transform.frame();
        let width = NOTE_WIDTH * frame.width();
        let painter = self.painter();
        let galley = painter.layout(
            text.to_owned(),
            draw::small_font(self.ui),
            palette.ink,
            width,
        );
        painter.galley(
            frame.left_bottom() + vec2(8.0, -8.0 - galley.size().y),
            galley,
            palette.ink,
        );
    }

    /// The names of the curves of a material, where there are several.
    pub(super) fn name_curves(&self, session: &Session, palette: &theme::Palette) {
        let slot = session.materials.selected().slot();
        let corner = self.transform.frame().left_top() + vec2(8.0, 10.0);
        for (row, channel) in session.shown_curves().channels().iter().enumerate() {
            let Some(name) = channel.symbol() else {
                continue;
            };
            let left = corner + vec2(0.0, 16.0 * row as f32);
            let ends = [left, left + vec2(theme::LINE_SAMPLE, 0.0)];
            let painter = self.painter();
            let stroke = stroke(*channel, slot, palette);
            draw::line(&painter, ends, stroke, Dash::of_channel(*channel, slot));
            let place = left + vec2(theme::LINE_SAMPLE + 6.0, 0.0);
            painter.text(
                place,
                Align2::LEFT_CENTER,
                name,
                draw::small_font(self.ui),
                palette.ink,
            );
        }
    }

    /// Its deltas: an arrow of the share of the flux as its length, 1 at the unit circle; broken where it lies outside the
    /// section.
    pub(super) fn draw_arrows(
        &self,
        plotted: &Plotted,
        taken: &mut Vec<Rect>,
        palette: &theme::Palette,
    ) {
        let painter = self.painter();
        let color = palette.material(plotted.slot);
        for stem in &plotted.section.stems {
            let (share, angle) = (stem.share(), stem.x_deg.to_radians());
            let ends = [self.position(0.0, 0.0), self.position(share, angle)];
            let dash = if stem.is_inside {
                Dash::Solid
            } else {
                Dash::Dashed
            };
            arrows::stem(&painter, ends, color, dash);
            // Beside a long arrow, beyond the tip of a short one: either way clear of the horizon's numbers.
            let place = if share > 0.4 {
                self.position(0.45 * share, angle)
            } else {
                self.position(share + 0.2, angle)
            };
            let outwards = vec2(if angle > 0.0 { 10.0 } else { -10.0 }, 0.0);
            let anchor = if angle > 0.0 {
                Align2::LEFT_CENTER
            } else {
                Align2::RIGHT_CENTER
            };
            let text = arrows::label(share);
            let place = (place + outwards, anchor);
            arrows::write(self.ui, &painter, taken, place, &text, (color, palette));
        }
    }
}
