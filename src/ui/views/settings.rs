//! The settings of a view: a row at its top, seen while the view has the pointer or the focus, and those settings that
//! several kinds of views have alike.

use egui::{Align2, Button, Rect, RichText, Ui, UiBuilder};

use super::context::ViewContext;
use crate::theme;
use crate::widgets::{choice, draw, options, small as small_widget};
use bxdf_study::format;
use bxdf_study::session::{Curves, EntryId};
use bxdf_study::views::{Arrangement, Scale, ScaleChoice};

/// Whether the settings of a view were seen in the last frame.
#[derive(Default)]
struct Seen(bool);

/// The row of settings that `add` fills. What is to be seen in the view stands in its place while nobody sets anything; a
/// picture has neither.
pub(super) fn show<O>(
    ui: &mut Ui,
    cx: &mut ViewContext<'_, O>,
    add: impl FnOnce(&mut Ui, &mut ViewContext<'_, O>),
) {
    if cx.state.is_picture {
        return;
    }
    let was_seen = cx.state.own::<Seen>(cx.view).0;
    let is_chosen_from = was_seen && egui::Popup::is_any_open(ui.ctx());
    let is_seen = is_chosen_from || ui.rect_contains_pointer(ui.max_rect()) || has_focus(ui);
    cx.state.own::<Seen>(cx.view).0 = is_seen;
    // What is too wide for the view does not make the view wider.
    let room = ui.available_rect_before_wrap();
    let mut row = ui.new_child(UiBuilder::new().max_rect(room).id_salt("settings"));
    // The size of labels is that of the plot.
    theme::plain_text(&mut row);
    if !is_seen {
        // Out of sight, they keep their places and their names for who does not look.
        row.multiply_opacity(0.0);
    }
    add(&mut row, cx);
    let covered = row.min_rect().intersect(room);
    ui.advance_cursor_after_rect(covered);
    if !is_seen {
        caption(ui, cx, covered);
    }
}

/// [`show`], of controls that stand one after the other.
pub(super) fn row<O>(
    ui: &mut Ui,
    cx: &mut ViewContext<'_, O>,
    add: impl FnOnce(&mut Ui, &mut ViewContext<'_, O>),
) {
    show(ui, cx, |ui, cx| {
        ui.horizontal_wrapped(|ui| add(ui, cx));
    });
}

/// Whether a control of the view has the focus.
fn has_focus(ui: &Ui) -> bool {
    let focused = ui.memory(egui::Memory::focused);
    let response = focused.and_then(|id| ui.ctx().read_response(id));
    response.is_some_and(|response| ui.max_rect().contains(response.rect.center()))
}

/// What there is to see, in the room of the settings.
fn caption<O>(ui: &Ui, cx: &ViewContext<'_, O>, room: Rect) {
    let kind = cx.session.views.kind(cx.view);
    let what = kind.map_or("", |kind| kind.what_you_see);
    let painter = ui.painter_at(room.with_max_x(ui.max_rect().right()));
    let small = egui::TextStyle::Small;
    let font = small.resolve(&ui.ctx().global_style());
    let width = ui.max_rect().right() - room.left();
    let mut job =
        egui::text::LayoutJob::simple(what.to_owned(), font, ui.visuals().weak_text_color(), width);
    let height = ui.text_style_height(&small) / draw::label_scale(ui);
    job.wrap.max_rows = ((room.height() / height) as usize).max(1);
    let galley = painter.layout_job(job);
    let place = Align2::LEFT_CENTER.anchor_size(room.left_center(), galley.size());
    painter.galley(place.min, galley, ui.visuals().weak_text_color());
}

/// The name of a control of a view for tests and screen readers: two views have controls of the same kind.
fn named<O>(ui: &Ui, cx: &ViewContext<'_, O>, response: &egui::Response, what: &str) {
    let name = format!("{what} of {}", cx.session.views.title(cx.view));
    ui.ctx()
        .accesskit_node_builder(response.id, |node| node.set_label(name));
}

/// A drop-down without a name before it: its choices say what they are of.
pub(super) fn combo<O, T: Copy + PartialEq>(
    ui: &mut Ui,
    cx: &ViewContext<'_, O>,
    (what, hint): (&str, &str),
    value: &mut T,
    all: &[(T, &'static str)],
) {
    let chosen = all.iter().find(|(one, _)| one == value);
    let chosen = chosen.map_or("", |(_, title)| *title);
    choice::keep_together(ui, choice::combo_width(ui, chosen));
    let shown = egui::ComboBox::from_id_salt(what)
        .selected_text(chosen)
        .width(0.0)
        .show_ui(ui, |ui| {
            for (one, title) in all {
                ui.selectable_value(value, *one, *title);
            }
        });
    named(ui, cx, &shown.response.on_hover_text(hint), what);
}

/// How values become lengths. `full`: the value that has the full length now, where all materials share one.
pub(super) fn scale<O>(ui: &mut Ui, cx: &ViewContext<'_, O>, scale: &mut Scale, full: Option<f64>) {
    let mut choice = scale.choice();
    let hint = "Same scale: lengths of all materials compare. Each to its peak: shapes compare. Logarithmic: decades below \
                the peak, which shows the tails of a narrow lobe";
    let all = ScaleChoice::ALL.map(|one| (one, one.title()));
    combo(ui, cx, ("Scale", hint), &mut choice, &all);
    scale.choose(choice);
    if choice == ScaleChoice::Logarithmic && cx.session.materials.is_overlay() {
        let hint = "The full length is the peak of each, which compares shapes";
        choice::switch(ui, ("To each peak", hint), &mut scale.is_each_to_peak);
    }
    let Some(full) = full.or(scale.locked_at) else {
        return;
    };
    let mut is_locked = scale.locked_at.is_some();
    let text = RichText::new(if is_locked { "🔒" } else { "🔓" }).small();
    let hint = "Keep the scale as it is, whatever is shown; else it follows the peak";
    let switch = ui.toggle_value(&mut is_locked, text).on_hover_text(hint);
    named(ui, cx, &switch, "Lock the scale");
    if is_locked != scale.locked_at.is_some() {
        scale.lock(is_locked.then_some(full));
    }
}

/// How several materials stand, where there are several.
pub(super) fn arrangement<O>(ui: &mut Ui, cx: &ViewContext<'_, O>, value: &mut Arrangement) {
    if cx.session.materials.is_overlay() {
        let hint = "All materials in one picture, or each in one of its own under the same light";
        let all = Arrangement::ALL.map(|one| (one, one.title()));
        combo(ui, cx, ("Arrangement", hint), value, &all);
    }
}

/// Whether values carry the cosine.
pub(super) fn cosine<O>(ui: &mut Ui, cx: &mut ViewContext<'_, O>) {
    let hint = "Show f |cos θ| of the free direction: the flux, rather than the radiance";
    let mut with_cosine = cx.session.with_cosine;
    let switch = ui.checkbox(&mut with_cosine, "Times cos θ");
    named(ui, cx, &switch.on_hover_text(hint), "Times cos θ");
    cx.session.with_cosine = with_cosine;
}

/// The curves of a single material; several have one each.
pub(super) fn curves<O>(ui: &mut Ui, cx: &mut ViewContext<'_, O>) {
    if cx.session.materials.is_overlay() {
        let hint =
            "R, G and B are drawn where one material is shown: show it alone, or hide the others";
        let button = ui.add_enabled(false, Button::new("Luminance"));
        named(ui, cx, &button.on_disabled_hover_text(hint), "Curves");
        return;
    }
    let hint = "One curve of the luminance, or three, one for each channel";
    let mut shown = cx.session.curves;
    let all = [(Curves::Luminance, "Luminance"), (Curves::Rgb, "R, G, B")];
    combo(ui, cx, ("Curves", hint), &mut shown, &all);
    cx.session.curves = shown;
}

/// The section that views share.
pub(super) fn section<O>(ui: &mut Ui, cx: &mut ViewContext<'_, O>) {
    let hint = "Cut the lobe along the plane of the fixed direction and n, or along any azimuth";
    let combo = options::section(ui, cx.session);
    named(ui, cx, &combo.on_hover_text(hint), "Section");
}

/// Below this share of the full length a lobe is too small to be seen beside the others.
const SMALL: f64 = 0.05;

/// The name of the lobe that is too small to be seen on the scale that all share, with its share of the full length.
pub(super) fn smallest<O>(
    cx: &ViewContext<'_, O>,
    radii: impl Iterator<Item = (EntryId, f64)>,
) -> Option<(String, f64)> {
    let seen = radii.filter(|(_, radius)| *radius > 0.0);
    let (of, radius) = seen.min_by(|a, b| a.1.total_cmp(&b.1))?;
    let entry = cx.session.materials.get(of)?;
    (radius < SMALL).then(|| (cx.session.materials.title(entry), radius))
}

/// Offers, in a corner of `room`, to show each lobe to its peak.
pub(super) fn offer_peaks<O>(
    ui: &mut Ui,
    cx: &ViewContext<'_, O>,
    scale: &mut Scale,
    small: Option<(String, f64)>,
    room: Rect,
) {
    let Some((title, share)) = small.filter(|_| !cx.state.is_picture) else {
        return;
    };
    if scale.choice() != ScaleChoice::Same {
        return;
    }
    let place = room.shrink(theme::TILE_MARGIN);
    let place = place.with_max_x(place.left() + OFFER_SHARE * place.width());
    let mut above = ui.new_child(UiBuilder::new().max_rect(place).id_salt("offer peaks"));
    if place.width() < LEAST_OFFER {
        return;
    }
    let text = format!(
        "{} is {} % of the scale",
        draw::clipped(&title, LONGEST_TITLE),
        format::value(100.0 * share)
    );
    above.label(RichText::new(text).small());
    let button = above.add(small_widget::button(
        &above,
        ScaleChoice::EachToPeak.title(),
    ));
    let button = button.on_hover_text("Show every lobe in the same size, so that shapes compare");
    named(ui, cx, &button, "Small lobes");
    if button.clicked() {
        scale.choose(ScaleChoice::EachToPeak);
    }
}

/// The share of a view's width that the offer takes: the corner that the circle leaves free.
const OFFER_SHARE: f32 = 0.27;

/// In less width there is no room for it, in points.
const LEAST_OFFER: f32 = 100.0;

/// The most characters of a name in it.
const LONGEST_TITLE: usize = 24;
