//! The slice: f over theta_h and theta_d, the angles of half vector and difference.

use std::sync::Arc;

use egui::{Align2, Rect, Response, Ui, vec2};

use super::context::ViewContext;
use super::settings;
use crate::theme::Palette;
use crate::widgets::pictures::{self, Cell, ColorScale, Picture, ScaleKind};
use crate::widgets::{choice, deltas, draw};
use bxdf_lab::analysis::slice::{REGIONS, Region, Request, Slice, mirrored_at, pair_at, place_of};
use bxdf_lab::analysis::{Channel, Subject};
use bxdf_study::format;
use bxdf_study::memo::{Memo, Same};
use bxdf_study::session::{EntryId, MaterialEntry};
use bxdf_study::views::DECADES;
use bxdf_study::views::slice::{DIFFERENCE_AZIMUTH, Options};

/// Room for what stands at a delta, beyond the right and the lower edge, in points.
const END_ROOM: egui::Vec2 = vec2(4.0, 12.0);

/// Room for the names and numbers of the axes, in points: at the left and below.
const LABELS: egui::Vec2 = vec2(42.0, 34.0);

/// Between the title and the picture, in points.
const TITLE_GAP: f32 = 5.0;

/// The angles written at the axes, in degrees: the ends first.
const TICKS_DEG: [f64; 4] = [0.0, 90.0, 30.0, 60.0];

/// Of so many pixels one is looked at to find the range of colours: a prime, so that all columns are met.
const EVERY: usize = 37;

/// The share of the largest values that all have the brightest colour.
const GRAZING_SHARE: f64 = 0.01;

/// Narrower pictures have no room for the names of regions, in points.
const ROOM_FOR_NAMES: f32 = 150.0;

pub(super) fn show(ui: &mut Ui, cx: &mut ViewContext<'_, Options>) {
    settings::show(ui, cx, |ui, cx| controls(ui, cx.options));
    if let Some(note) = bxdf_study::export::nothing_to_show(cx.session) {
        draw::centred_note(ui, note);
        return;
    }
    let slices = slices(cx);
    let Colors { scale, has_values } = *colors(cx, &slices);
    let mut room = ui.available_rect_before_wrap();
    if has_values {
        room = pictures::color_bar(ui, room, scale, "f, 1/sr", cx.palette);
    }
    let labels = draw::label_scale(ui) * LABELS;
    let mut inner = room;
    inner.min.x += labels.x;
    inner.max.y -= labels.y;
    let cells = pictures::cells(ui, inner, slices.len(), 1.0);
    // Pictures beside one another share their numbers.
    let mut taken = Vec::new();
    for (cell, (entry, slice)) in cells.iter().zip(&slices) {
        let is_below = |other: &Cell| {
            other.picture.left() == cell.picture.left() && other.picture.top() > cell.picture.top()
        };
        let edges = Edges {
            is_left: cells
                .iter()
                .all(|other| other.picture.left() >= cell.picture.left()),
            is_lowest: !cells.iter().any(is_below),
        };
        let mut picture = cell.picture;
        picture.min.y += TITLE_GAP;
        picture.max.x -= TITLE_GAP;
        let cell = Cell { picture, ..*cell };
        show_slice(ui, cx, (cell, edges), (*entry, slice), scale, &mut taken);
    }
    ui.advance_cursor_after_rect(room);
}

/// Which edges of the grid of pictures one of them is at.
#[derive(Clone, Copy)]
struct Edges {
    is_left: bool,
    is_lowest: bool,
}

fn controls(ui: &mut Ui, options: &mut Options) {
    ui.horizontal_wrapped(|ui| {
        let hint = "The azimuth of the difference about the half vector: at 90° both \
            directions are equally far from n";
        choice::angle(
            ui,
            ("φd", hint),
            &mut options.phi_d_deg,
            &DIFFERENCE_AZIMUTH,
        );
        let hint = "θh by its square root: more room for the specular peak";
        choice::switch(ui, ("√θh", hint), &mut options.is_square_root);
        let hint = "A logarithmic scale: decades below the highest value";
        choice::switch(ui, ("By decades", hint), &mut options.is_logarithmic);
        let hint = "Names of the regions in which materials differ";
        choice::switch(ui, ("Regions", hint), &mut options.has_regions);
    });
}

fn slices(cx: &mut ViewContext<'_, Options>) -> Vec<(EntryId, Arc<Slice>)> {
    let (session, answers) = (&*cx.session, &mut *cx.answers);
    let request = cx.options.request(session);
    let slice = |entry: &MaterialEntry| (entry.id(), answers.ask(session, entry, request));
    session.materials.shown().map(slice).collect()
}

/// How the slices are coloured.
struct Colors {
    scale: ColorScale,
    /// Whether any value is above 0.
    has_values: bool,
}

/// Those of these slices, found anew only where one of them is another one.
fn colors(cx: &mut ViewContext<'_, Options>, slices: &[(EntryId, Arc<Slice>)]) -> Arc<Colors> {
    let is_logarithmic = cx.options.is_logarithmic;
    let all = slices.iter().map(|(_, slice)| Same(Arc::clone(slice)));
    let key: (Vec<Same<Slice>>, bool) = (all.collect(), is_logarithmic);
    let kept: &mut Memo<(Vec<Same<Slice>>, bool), Colors> = cx.state.own(cx.view);
    kept.get(key, || {
        let is_above_zero = |rgb: &[f64; 3]| rgb.iter().any(|x| *x > 0.0);
        let mut pixels = slices.iter().flat_map(|(_, slice)| &slice.raster.pixels);
        Colors {
            scale: scale(slices.iter().map(|(_, slice)| &**slice), is_logarithmic),
            has_values: pixels.any(is_above_zero),
        }
    })
}

/// The colours of the slices: without the few values at grazing angles that dwarf all others.
fn scale<'a>(slices: impl Iterator<Item = &'a Slice>, is_logarithmic: bool) -> ColorScale {
    let some = slices.flat_map(|slice| slice.raster.pixels.iter().step_by(EVERY));
    let luminance = some.map(|rgb| Channel::Luminance.of(*rgb));
    let mut values: Vec<f64> = luminance.filter(|value| *value > 0.0).collect();
    values.sort_by(f64::total_cmp);
    let quantile = |share: f64| {
        let index = share * values.len().saturating_sub(1) as f64;
        values.get(index as usize).copied().unwrap_or(1.0)
    };
    let largest = quantile(1.0 - GRAZING_SHARE);
    if is_logarithmic {
        let least = quantile(0.0).clamp(largest * 10_f64.powf(-DECADES), 0.5 * largest);
        ColorScale {
            range: [least, largest],
            kind: ScaleKind::Logarithmic,
        }
    } else {
        ColorScale {
            range: [0.0, largest],
            kind: ScaleKind::Linear,
        }
    }
}

fn show_slice(
    ui: &Ui,
    cx: &mut ViewContext<'_, Options>,
    (cell, edges): (Cell, Edges),
    (entry, slice): (EntryId, &Arc<Slice>),
    scale: ColorScale,
    taken: &mut Vec<Rect>,
) {
    let picture = Picture {
        entry,
        sources: vec![Arc::clone(slice) as _],
        look: Some(scale),
    };
    let paint = || scale.paint(&slice.raster.map(|rgb| Channel::Luminance.of(*rgb)));
    let textures = &mut cx.state.textures;
    let response = pictures::show(ui, textures, cell, picture, cx.session, cx.palette, paint);
    let request = cx.options.request(cx.session);
    let theta_d = theta_d_held(cx);
    let ring = pictures::position_of(cell.picture, place([0.0, theta_d], &request));
    let ring =
        Rect::from_center_size(ring, egui::Vec2::splat(2.0 * deltas::BESIDE_RING)).shrink(1.0);
    let has_ring = delta_at(cx, entry, theta_d).is_some();
    taken.extend(has_ring.then_some(ring));
    draw_axes(ui, (cell.picture, edges), &request, taken, cx.palette);
    if cx.options.has_regions && cell.picture.width() > ROOM_FOR_NAMES {
        let mut taken = Vec::new();
        for region in &REGIONS {
            name_region(
                ui,
                (cell.picture, &mut taken),
                &request,
                region,
                &response,
                cx.palette,
            );
        }
    }
    draw_delta(ui, cx, cell.picture, taken, entry);
    point(ui, cx, cell.picture, (entry, slice), &response);
}

/// The share of the flux that a material mirrors at this theta_d, as a delta.
fn delta_at(cx: &mut ViewContext<'_, Options>, entry: EntryId, theta_d_deg: f64) -> Option<f64> {
    let session = &*cx.session;
    let entry = session.materials.get(entry)?;
    let request = cx.options.request(session);
    let share = |subject: &Subject<'_>| mirrored_at(&request, subject, theta_d_deg);
    let share = cx.answers.with_subject(session, entry, share)?;
    Some(Channel::Luminance.of(share))
}

/// The theta_d of a mirror under the direction held, in degrees.
fn theta_d_held(cx: &ViewContext<'_, Options>) -> f64 {
    let theta = cx.session.theta_deg;
    theta.min(180.0 - theta)
}

/// The delta of a mirror: it stands along the edge theta_h = 0, with a ring at the theta_d of the direction held.
fn draw_delta(
    ui: &Ui,
    cx: &mut ViewContext<'_, Options>,
    rect: Rect,
    taken: &mut Vec<Rect>,
    entry: EntryId,
) {
    let theta_d = theta_d_held(cx);
    let Some(share) = delta_at(cx, entry, theta_d) else {
        return;
    };
    let Some(found) = cx.session.materials.get(entry) else {
        return;
    };
    let color = cx.palette.material(found.slot());
    let beside = vec2(deltas::BESIDE_RING, deltas::BESIDE_RING);
    let painter = ui.painter_at(Rect::from_min_max(rect.min - beside, rect.max + END_ROOM));
    painter.vline(rect.left(), rect.y_range(), (3.0, color));
    let at = pictures::position_of(rect, place([0.0, theta_d], &cx.options.request(cx.session)));
    deltas::ring(&painter, at, (color, cx.palette), true);
    let beside = (at + vec2(deltas::BESIDE_RING, 0.0), Align2::LEFT_CENTER);
    let (text, look) = (deltas::label(share), (cx.palette.ink, cx.palette));
    deltas::write(ui, &painter, taken, beside, &text, look);
}

/// Where angles stand in the picture, as a share from its upper left.
fn place([theta_h_deg, theta_d_deg]: [f64; 2], request: &Request) -> [f64; 2] {
    let x = theta_h_deg / 90.0;
    let x = if request.is_square_root { x.sqrt() } else { x };
    [x, 1.0 - theta_d_deg / 90.0]
}

/// The frame, and at the edges of the grid names and numbers: of the numbers those that have room beside one another and what
/// is `taken`.
fn draw_axes(
    ui: &Ui,
    (rect, edges): (Rect, Edges),
    request: &Request,
    taken: &mut Vec<Rect>,
    palette: &Palette,
) {
    let painter = ui.painter();
    let font = draw::small_font(ui);
    painter.rect_stroke(rect, 0.0, (1.0, palette.axis), egui::StrokeKind::Outside);
    for tick in TICKS_DEG {
        let text = format::degrees(tick);
        let galley = painter.layout_no_wrap(text, font.clone(), palette.faint_ink);
        let below = pictures::position_of(rect, place([tick, 0.0], request)) + vec2(0.0, 3.0);
        let left = pictures::position_of(rect, place([0.0, tick], request)) - vec2(4.0, 0.0);
        let axes = [
            (edges.is_lowest, below, Align2::CENTER_TOP),
            (edges.is_left, left, Align2::RIGHT_CENTER),
        ];
        for (_, at, anchor) in axes.into_iter().filter(|(is_here, ..)| *is_here) {
            let place = anchor.anchor_size(at, galley.size());
            if !taken.iter().any(|other| other.intersects(place)) {
                taken.push(place);
                painter.galley(place.min, galley.clone(), palette.faint_ink);
            }
        }
    }
    let name = if request.is_square_root {
        "θh (half vector), by its square root"
    } else {
        "θh (half vector)"
    };
    // Where an edge is shorter than its name, the name is left out: beside others it would lie over theirs.
    let named = |name: &str| {
        let galley = painter.layout_no_wrap(name.to_owned(), font.clone(), palette.ink);
        Some(galley).filter(|galley| galley.size().x <= rect.width())
    };
    let scale = draw::label_scale(ui);
    if let Some(galley) = named(name).filter(|_| edges.is_lowest) {
        let below = rect.center_bottom() + vec2(-0.5 * galley.size().x, scale * 18.0);
        painter.galley(below, galley, palette.ink);
    }
    if let Some(galley) = named("θd (difference)").filter(|_| edges.is_left) {
        let corner = rect.left_center() + vec2(-scale * LABELS.x, 0.5 * galley.size().x);
        let text = egui::epaint::TextShape::new(corner, galley, palette.ink);
        painter.add(text.with_angle(-std::f32::consts::FRAC_PI_2));
    }
}

/// The name of a region, inside the picture.
fn name_region(
    ui: &Ui,
    (rect, taken): (Rect, &mut Vec<Rect>),
    request: &Request,
    region: &Region,
    response: &Response,
    palette: &Palette,
) {
    let share = place([region.theta_h_deg, region.theta_d_deg], request);
    let at = pictures::position_of(rect, share);
    let anchor = match share {
        [x, _] if x < 0.2 => Align2::LEFT_CENTER,
        [x, _] if x > 0.8 => Align2::RIGHT_CENTER,
        _ => Align2::CENTER_CENTER,
    };
    let painter = ui.painter_at(rect);
    // What the name means is told where the pointer is; the rest of the picture reads out values.
    let font = draw::small_font(ui);
    let is_near = response
        .hover_pos()
        .is_some_and(|pointer| pointer.distance(at) < 12.0);
    let text = if is_near { region.meaning } else { region.name };
    if is_near {
        let galley = painter.layout(text.to_owned(), font, palette.ink, 0.8 * rect.width());
        let place = anchor.anchor_size(at, galley.size());
        painter.rect_filled(place.expand(3.0), 3.0, palette.background);
        painter.galley(place.min, galley, palette.ink);
    } else {
        let galley = painter.layout_no_wrap(text.to_owned(), font.clone(), palette.ink);
        let place = draw::free_place(
            taken,
            anchor
                .anchor_size(at, galley.size())
                .expand2(vec2(4.0, 2.0)),
        );
        let (at, anchor) = (place.center(), Align2::CENTER_CENTER);
        draw::haloed_text(&painter, at, anchor, text, font, palette.ink, palette);
    }
}

/// The pair of directions under the pointer, which a click holds; that of the other views.
fn point(
    ui: &Ui,
    cx: &mut ViewContext<'_, Options>,
    rect: Rect,
    (entry, slice): (EntryId, &Arc<Slice>),
    response: &Response,
) {
    let request = cx.options.request(cx.session);
    let Some(pointer) = response.hover_pos() else {
        let (wo, wi) = cx.pair();
        if let Some([x, y]) = place_of(&request, wo, wi) {
            let at = pictures::position_of(rect, [x, 1.0 - y]);
            ui.painter().circle_stroke(at, 5.0, (1.5, cx.palette.ink));
        }
        return;
    };
    let [x, y] = pictures::share_of(rect, pointer);
    let (wo, wi) = pair_at(&request, [x, 1.0 - y]);
    let raster = &slice.raster;
    let pixel = [x * raster.width as f64, y * raster.height as f64];
    let value = raster.at(pixel[0] as usize, pixel[1] as usize);
    let value = value
        .map(|rgb| Channel::Luminance.of(*rgb))
        .filter(|value| value.is_finite());
    let value = value.map_or_else(
        || "below the surface".to_owned(),
        |value| format!("f {} 1/sr", format::value(value)),
    );
    let theta_h = 90.0 * if request.is_square_root { x * x } else { x };
    let is_at_edge = pointer.x - rect.left() < deltas::BESIDE_RING;
    let delta = delta_at(cx, entry, 90.0 * (1.0 - y)).filter(|_| is_at_edge);
    let delta = delta.map_or_else(String::new, |share| {
        format!("\n{} at θh 0°", deltas::label(share))
    });
    let name = cx
        .session
        .materials
        .get(entry)
        .map(|entry| cx.session.materials.title(entry));
    let text = format!(
        "{}\nθh {}  θd {}\n{value}{delta}",
        name.unwrap_or_default(),
        format::degrees(theta_h),
        format::degrees(90.0 * (1.0 - y))
    );
    draw::pointer_note(ui, pointer, ui.clip_rect(), &text, cx.palette);
    if response.clicked() && wo.z.min(wi.z) > 0.0 {
        cx.session.materials.select(entry);
        cx.hold_pair(wo, wi);
    }
}
