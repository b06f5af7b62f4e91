//! The ring about what has the focus.

use egui::{Context, Event, Id, Key, Memory, Response, StrokeKind, Ui};

/// The radius of its corners, and the room between it and what it is about, in points.
const CORNER: f32 = 3.0;
const GAP: f32 = 1.0;

/// What is kept of the focus.
#[derive(Clone, Copy, Default)]
struct Kept {
    /// Whether Tab brought it where it is: who clicks knows where.
    is_by_key: bool,
    /// The pass in which something drew a ring of its own.
    drawn_in: Option<u64>,
}

fn kept(ctx: &Context, change: impl FnOnce(&mut Kept)) -> Kept {
    ctx.data_mut(|data| {
        let kept: &mut Kept = data.get_temp_mut_or_default(Id::unique("focus ring"));
        change(kept);
        *kept
    })
}

/// Says that what has the focus shows it by itself.
pub fn is_shown(ctx: &Context) {
    let pass = ctx.cumulative_pass_nr();
    kept(ctx, |kept| kept.drawn_in = Some(pass));
}

/// The ring inside of something that is painted by hand, while it has the focus.
pub fn ring(ui: &Ui, response: &Response) {
    if response.has_focus() {
        let stroke = ui.visuals().selection.stroke;
        ui.painter()
            .rect_stroke(response.rect, CORNER, stroke, StrokeKind::Inside);
        is_shown(ui.ctx());
    }
}

/// The ring about whatever else has the focus, where Tab brought it there. To be called when all is drawn.
pub fn around(ctx: &Context) {
    let (is_tab, is_press) = ctx.input(|input| {
        let is_tab = |event: &Event| {
            matches!(
                event,
                Event::Key {
                    key: Key::Tab,
                    pressed: true,
                    ..
                }
            )
        };
        let is_tab = input.events.iter().any(is_tab);
        (is_tab, input.pointer.any_pressed())
    });
    let now = kept(ctx, |kept| {
        kept.is_by_key = (kept.is_by_key || is_tab) && !is_press;
    });
    let is_drawn = now.drawn_in == Some(ctx.cumulative_pass_nr());
    let focused = ctx
        .memory(Memory::focused)
        .filter(|_| now.is_by_key && !is_drawn);
    let Some(response) = focused.and_then(|id| ctx.read_response(id)) else {
        return;
    };
    let seen = response.interact_rect;
    if seen.is_positive() {
        let stroke = ctx.global_style().visuals.selection.stroke;
        ctx.layer_painter(response.layer_id).rect_stroke(
            seen.expand(GAP),
            CORNER,
            stroke,
            StrokeKind::Outside,
        );
    }
}
