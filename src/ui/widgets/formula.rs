//! Formulas in TeX, laid out as KaTeX does and drawn with its fonts, so that they are sharp at any size.

use std::sync::Arc;

use egui::cache::{ComputerMut, FrameCache};
use egui::{
    Color32, FontId, Pos2, Rect, Response, Role, Sense, Stroke, Ui, Vec2, WidgetInfo, pos2, vec2,
};
use ratex_types::display_item::{DisplayItem, DisplayList};

use super::things::{self, By};
use crate::theme::{Palette, family_of};
use bxdf_study::lessons::Thing;
use bxdf_study::lessons::formula::{COLOURED, Symbol, expanded, parameters, spoken};

/// A formula that is laid out; `None` where it cannot be.
type Laid = Option<Arc<DisplayList>>;

#[derive(Default)]
struct LayOut;

impl ComputerMut<(&str, bool), Laid> for LayOut {
    fn compute(&mut self, (tex, is_inline): (&str, bool)) -> Laid {
        laid_out(tex, is_inline).map(Arc::new)
    }
}

/// Lays a formula out, in em: `is_inline` as in a line of text, else larger.
#[must_use]
pub fn laid_out(tex: &str, is_inline: bool) -> Option<DisplayList> {
    use ratex_types::math_style::MathStyle;
    let nodes = ratex_parser::parse(&expanded(tex, marker)).ok()?;
    let options = ratex_layout::LayoutOptions {
        style: if is_inline {
            MathStyle::Text
        } else {
            MathStyle::Display
        },
        ..ratex_layout::LayoutOptions::default()
    };
    let laid = ratex_layout::layout(&nodes, &options);
    Some(ratex_layout::to_display_list(&laid))
}

/// The colour by which a coloured symbol is known when it is laid out: its place in the list, from 1 on, in red for a thing, in
/// green for a parameter.
fn marker(symbol: Symbol) -> String {
    match symbol {
        Symbol::Thing(name) => {
            let place = COLOURED.iter().position(|one| *one == name);
            format!("#{:02x}0000", place.map_or(0, |place| place + 1))
        }
        Symbol::Parameter(place) => format!("#00{:02x}00", (place + 1).min(0xff)),
    }
}

/// What a piece of a formula stands for; `parameters`: the names of those that it has symbols for.
fn thing(color: &ratex_types::color::Color, parameters: &[&str]) -> Option<Thing> {
    let place = |share: f32| ((share * 255.0).round() as usize).checked_sub(1);
    if let Some(place) = place(color.g) {
        let name = parameters.get(place)?;
        return Some(Thing::Control((*name).to_owned()));
    }
    Some(match *COLOURED.get(place(color.r)?)? {
        "light" => Thing::Light,
        "viewer" => Thing::Viewer,
        "normal" => Thing::Normal,
        "half" => Thing::Half,
        "mirror" => Thing::Mirror,
        _ => Thing::Lobe,
    })
}

/// How a formula looks.
#[derive(Clone, Copy)]
pub struct Look<'a> {
    /// The size of its letters, in points.
    pub size: f32,
    /// The colours.
    pub palette: &'a Palette,
    /// That of the lobe.
    pub lobe: Color32,
}

/// The colour of the symbol of a thing.
fn color(thing: &Thing, look: Look<'_>) -> Color32 {
    match thing {
        Thing::Control(_) => look.palette.accent_line,
        thing => things::color(thing, look.palette, look.lobe),
    }
}

/// The width of a formula by itself, in sizes of its letters; 0 where it cannot be laid out.
#[must_use]
pub fn width(ui: &Ui, tex: &str, is_inline: bool) -> f32 {
    laid(ui, tex, is_inline).map_or(0.0, |list| list.width as f32)
}

fn laid(ui: &Ui, tex: &str, is_inline: bool) -> Laid {
    ui.memory_mut(|memory| {
        let cache = memory.caches.cache::<FrameCache<Laid, LayOut>>();
        cache.get((tex, is_inline)).clone()
    })
}

/// A formula in a line of text, or by itself. It is read aloud in words. A symbol of a parameter `\param{name}{..}` stands for the
/// control of that accessible name.
pub fn show(ui: &mut Ui, tex: &str, is_inline: bool, look: Look<'_>) -> Response {
    let Some(list) = laid(ui, tex, is_inline) else {
        // What could not be laid out was refused when it was read.
        return ui.code(tex);
    };
    let em = look.size;
    // A line of text keeps its height as long as the formula fits into it.
    let (width, height) = (
        list.width as f32 * em,
        (list.height + list.depth) as f32 * em,
    );
    let least = if is_inline { look.size } else { 0.0 };
    let room = vec2(width, height.max(least));
    let (rect, response) = ui.allocate_exact_size(room, Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, spoken(tex)));
    if ui.is_rect_visible(rect) {
        let origin = pos2(rect.left(), rect.center().y - 0.5 * height);
        paint(ui, &list, (origin, &parameters(tex)), look);
    }
    response
}

/// Draws what is laid out from the corner `origin` on.
fn paint(ui: &Ui, list: &DisplayList, (origin, parameters): (Pos2, &[&str]), look: Look<'_>) {
    let em = look.size;
    let at = |x: f64, y: f64| origin + vec2(x as f32 * em, y as f32 * em);
    let ink = |marker: &ratex_types::color::Color| match thing(marker, parameters) {
        Some(thing) => look.palette.text_in(color(&thing, look)),
        None => look.palette.ink,
    };
    for item in &list.items {
        match item {
            DisplayItem::GlyphPath {
                x,
                y,
                scale,
                font,
                char_code,
                color,
            } => {
                let Some(letter) = char::from_u32(*char_code) else {
                    continue;
                };
                let font = FontId::new(*scale as f32 * em, family_of(font));
                let place = glyph(ui, letter, font, at(*x, *y), ink(color));
                if let Some(thing) = thing(color, parameters) {
                    link(ui, place, &thing, look.palette);
                }
            }
            DisplayItem::Line {
                x,
                y,
                width,
                thickness,
                color,
                ..
            } => {
                let [from, to] = [at(*x, *y), at(*x + *width, *y)];
                let stroke = Stroke::new((*thickness as f32 * em).max(1.0), ink(color));
                ui.painter().line_segment([from, to], stroke);
            }
            DisplayItem::Rect {
                x,
                y,
                width,
                height,
                color,
            } => {
                let size = vec2(*width as f32 * em, *height as f32 * em);
                let rect = Rect::from_min_size(at(*x, *y), size);
                ui.painter().rect_filled(rect, 0.0, ink(color));
            }
            // Braces taller than any letter are the only ones: no formula of ours has them.
            DisplayItem::Path { .. } => {}
        }
    }
}

/// Draws a letter with its baseline from `at` on; returns its place.
fn glyph(ui: &Ui, letter: char, font: FontId, at: Pos2, color: Color32) -> Rect {
    let painter = ui.painter();
    let galley = painter.layout_no_wrap(letter.to_string(), font, color);
    let baseline = galley.rows.first().and_then(|row| {
        let glyph = row.row.glyphs.first()?;
        Some(row.pos.to_vec2() + glyph.pos.to_vec2())
    });
    let corner = at - baseline.unwrap_or(Vec2::ZERO);
    let place = Rect::from_min_size(corner, galley.size());
    painter.galley(corner, galley, color);
    place
}

/// A symbol and the thing it stands for point at one another.
fn link(ui: &Ui, place: Rect, thing: &Thing, palette: &Palette) {
    let ctx = ui.ctx();
    if ui.rect_contains_pointer(place) {
        things::point(ctx, thing, By::Words);
    }
    if things::is_pointed(ctx, thing, By::Place) {
        let line = [place.left_bottom(), place.right_bottom()];
        let stroke = Stroke::new(1.5, palette.accent_line);
        ui.painter().line_segment(line, stroke);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formulas_are_laid_out_with_the_things_they_name() {
        let tex = r"\lobe{f}(\light{\omega_i}, \viewer{\omega_o})\param{Alpha s}{x}";
        let (list, named) = (laid_out(tex, true).unwrap(), parameters(tex));
        let found = list.items.iter().filter_map(|item| match item {
            DisplayItem::GlyphPath { color, .. } => thing(color, &named),
            _ => None,
        });
        let found: Vec<Thing> = found.collect();
        let expected = [
            Thing::Lobe,
            Thing::Light,
            Thing::Light,
            Thing::Viewer,
            Thing::Viewer,
            Thing::Control("Alpha s".to_owned()),
        ];
        assert_eq!(found, expected);
        assert!(laid_out(r"\frac{1", false).is_none());
    }
}
