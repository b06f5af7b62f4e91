//! Pictures of rasters, one for each material, side by side; values as colours, with the scale beside them.

use egui::{
    Align2, ColorImage, FontSelection, Pos2, Rect, Response, RichText, Role, Sense, TextWrapMode,
    Ui, Vec2, WidgetInfo, WidgetText, pos2, vec2,
};

use super::{draw, hint, still};
use crate::theme::{self, Palette};
use bxdf_study::format;
use bxdf_study::session::{EntryId, Session};
pub use scale::{ColorScale, ScaleKind};
pub use textures::{Source, Texture, Textures};
pub use turns::{Turned, Turns};

mod scale;
mod textures;
mod turns;

/// Between two pictures, in points.
const GAP: f32 = 8.0;

/// How much a grid without empty places is preferred to larger pictures.
const FILLING: f32 = 0.3;

/// Width over height that the charts of several materials may have.
const CHART_ASPECTS: [f32; 5] = [0.9, 1.2, 1.6, 2.1, 2.8];

/// A place for a picture: square, with a title above where there are several.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cell {
    /// The picture.
    pub picture: Rect,
    /// Its title; empty where there is one picture only.
    pub title: Rect,
}

/// Square places for `n` pictures in `room`, as large as they go, row by row; `aspect`: width over height.
#[must_use]
pub fn cells(ui: &Ui, room: Rect, n: usize, aspect: f32) -> Vec<Cell> {
    cells_below(ui, (room, aspect), n, 1)
}

/// The same below titles of so many `rows`.
#[must_use]
pub fn cells_below(ui: &Ui, (room, aspect): (Rect, f32), n: usize, rows: usize) -> Vec<Cell> {
    let row = draw::label_scale(ui) * theme::LEGEND_ROW;
    below_titles(room, n, (aspect, rows as f32 * row))
}

/// The same below titles of this height, where there are several.
fn below_titles(room: Rect, n: usize, (aspect, title): (f32, f32)) -> Vec<Cell> {
    let title = if n > 1 { title } else { 0.0 };
    let height_for = |columns: usize| {
        let rows = n.div_ceil(columns);
        let width = (room.width() - GAP * (columns as f32 - 1.0)) / columns as f32;
        let height = (room.height() - GAP * (rows as f32 - 1.0)) / rows as f32 - title;
        height.min(width / aspect).max(1.0)
    };
    // Of nearly equal sizes the one that leaves no places empty.
    let worth = |columns: usize| {
        let places = columns * n.div_ceil(columns);
        height_for(columns) * (n as f32 / places as f32).powf(FILLING)
    };
    let columns = (1..=n.max(1)).max_by(|a, b| worth(*a).total_cmp(&worth(*b)));
    let columns = columns.unwrap_or(1);
    let rows = n.div_ceil(columns);
    let size = height_for(columns) * vec2(aspect, 1.0);
    let step = size + vec2(GAP, GAP + title);
    let used = vec2(columns as f32, rows as f32) * step - Vec2::splat(GAP);
    let corner = room.center() - 0.5 * used;
    (0..n)
        .map(|index| {
            let (column, row) = ((index % columns) as f32, (index / columns) as f32);
            let corner = corner + vec2(column, row) * step;
            Cell {
                title: Rect::from_min_size(corner, vec2(size.x, title)),
                picture: Rect::from_min_size(corner + vec2(0.0, title), size),
            }
        })
        .collect()
}

/// Places for the charts of `n` materials in `room`: of grids of charts of several shapes the one that leaves the most room
/// for one.
#[must_use]
pub fn cells_of_charts(ui: &Ui, room: Rect, n: usize) -> Vec<Cell> {
    if n < 2 {
        return cells(ui, room, n, room.aspect_ratio());
    }
    let grids = CHART_ASPECTS.map(|aspect| cells(ui, room, n, aspect));
    let area = |cells: &Vec<Cell>| cells.first().map_or(0.0, |cell| cell.picture.area());
    let largest = grids.into_iter().max_by(|a, b| area(a).total_cmp(&area(b)));
    largest.unwrap_or_default()
}

/// A place of a picture in 0..1 from the upper left, and back.
#[must_use]
pub fn share_of(rect: Rect, position: Pos2) -> [f64; 2] {
    let share = (position - rect.min) / rect.size();
    [f64::from(share.x), f64::from(share.y)]
}

/// The position of a place of a picture; see [`share_of`].
#[must_use]
pub fn position_of(rect: Rect, [x, y]: [f64; 2]) -> Pos2 {
    rect.min + vec2(x as f32, y as f32) * rect.size()
}

/// A picture to be drawn.
pub struct Picture {
    /// Whose it is.
    pub entry: EntryId,
    /// What it is made of.
    pub sources: Vec<Source>,
    /// How values become colours, where the picture is made so.
    pub look: Option<ColorScale>,
}

/// Draws a picture with its title. Returns what the pointer does with it.
pub fn show(
    ui: &Ui,
    textures: &mut Textures,
    cell: Cell,
    picture: Picture,
    session: &mut Session,
    palette: &Palette,
    paint: impl FnOnce() -> ColorImage,
) -> Response {
    let id = ui.scope_id().with(("picture", picture.entry));
    let made_of = (picture.sources, picture.look);
    let texture = textures.get(ui, id, made_of, paint);
    texture.paint(ui.painter(), cell.picture);
    let name = title(ui, cell, picture.entry, session, palette);
    let sense = still::sense(ui, Sense::click_and_drag());
    let response = ui.interact(cell.picture, id, sense);
    response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, &name));
    response
}

/// The name of the material above its picture; a click selects it.
pub fn title(
    ui: &Ui,
    cell: Cell,
    entry: EntryId,
    session: &mut Session,
    palette: &Palette,
) -> String {
    let Some(of) = session.materials.get(entry) else {
        return String::new();
    };
    let name = session.materials.title(of);
    if cell.title.height() == 0.0 {
        return name;
    }
    let color = palette.material(of.slot());
    let is_selected = session.materials.selected().id() == entry;
    let is_strong = is_selected || still::is(ui);
    let painter = ui.painter_at(cell.title);
    let swatch = Rect::from_min_size(
        cell.title.min + vec2(0.0, 0.5 * (cell.title.height() - theme::SWATCH.y)),
        theme::SWATCH,
    );
    painter.rect_filled(swatch, 2.0, color);
    let ink = if is_strong {
        palette.ink
    } else {
        palette.faint_ink
    };
    let width = cell.title.right() - swatch.right() - GAP;
    let text = WidgetText::from(RichText::new(&name).small());
    let wrap = Some(TextWrapMode::Truncate);
    let galley = text.into_galley(ui, wrap, width, FontSelection::Default);
    let place = swatch.right_center() + vec2(5.0, -0.5 * galley.size().y);
    painter.galley_with_override_text_color(place, galley, ink);
    if still::is(ui) {
        return name;
    }
    let id = ui.scope_id().with(("title", entry));
    let response = ui.interact(cell.title, id, Sense::click());
    response.widget_info(|| {
        WidgetInfo::selected(Role::Button, true, is_selected, format!("Picture: {name}"))
    });
    if hint::in_plot(response, &name).clicked() {
        session.materials.select(entry);
    }
    name
}

/// The colours of a scale with the values at its ends and between, upright at the right of `room`. Returns what is left
/// of the room.
#[must_use]
pub fn color_bar(ui: &Ui, room: Rect, scale: ColorScale, name: &str, palette: &Palette) -> Rect {
    const WIDTH: f32 = 12.0;
    const STEPS: usize = 48;
    let [text_width, tick_spacing, top] =
        [62.0, 14.0, 22.0].map(|room| room * draw::label_scale(ui));
    let font = draw::small_font(ui);
    let painter = ui.painter_at(room);
    let bar = Rect::from_min_max(
        pos2(room.right() - text_width - WIDTH, room.top() + top),
        pos2(room.right() - text_width, room.bottom() - 10.0),
    );
    if bar.height() < 20.0 || room.width() < 3.0 * (text_width + WIDTH) {
        return room;
    }
    still::follows_room(ui, room.with_min_x(bar.left() - GAP));
    for step in 0..STEPS {
        let [from, to] = [step, step + 1].map(|step| step as f64 / STEPS as f64);
        let corner = |share: f64| bar.bottom() - share as f32 * bar.height();
        let patch = Rect::from_x_y_ranges(bar.x_range(), corner(to)..=corner(from) + 0.5);
        painter.rect_filled(patch, 0.0, scale.color(scale.value(0.5 * (from + to))));
    }
    painter.text(
        pos2(room.right(), room.top()),
        Align2::RIGHT_TOP,
        name,
        font.clone(),
        palette.faint_ink,
    );
    let mut last = f32::INFINITY;
    for value in scale.ticks() {
        let y = bar.bottom() - scale.share(value) as f32 * bar.height();
        // From below: where two would touch, the lower one stays.
        if last - y < tick_spacing {
            continue;
        }
        last = y;
        painter.hline(bar.right()..=bar.right() + 4.0, y, (1.0, palette.axis));
        let text = format::value(value);
        let place = pos2(bar.right() + 6.0, y);
        painter.text(
            place,
            Align2::LEFT_CENTER,
            text,
            font.clone(),
            palette.faint_ink,
        );
    }
    room.with_max_x(bar.left() - GAP)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pictures_fill_the_room_and_do_not_overlap() {
        let room = Rect::from_min_size(pos2(10.0, 20.0), vec2(640.0, 300.0));
        for n in 1..=8 {
            let cells = below_titles(room, n, (1.0, theme::LEGEND_ROW));
            assert_eq!(cells.len(), n);
            for (index, cell) in cells.iter().enumerate() {
                assert!(
                    room.expand(0.01).contains_rect(cell.picture),
                    "{n}: {cell:?}"
                );
                assert!((cell.picture.aspect_ratio() - 1.0).abs() < 1e-4);
                let is_apart = |other: &Cell| !other.picture.intersects(cell.picture);
                assert!(cells.iter().take(index).all(is_apart), "{n}");
            }
        }
        assert!(below_titles(room, 1, (1.0, 0.0))[0].picture.height() > 299.0);
    }

    #[test]
    fn places_of_a_picture_go_both_ways() {
        let rect = Rect::from_min_size(pos2(5.0, 7.0), vec2(100.0, 50.0));
        let place = [0.25, 0.5];
        assert_eq!(share_of(rect, position_of(rect, place)), place);
    }
}
