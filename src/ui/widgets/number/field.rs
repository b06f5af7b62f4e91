//! The field of a number: a text while it has the focus, and a handle to drag while it has not.

use egui::accesskit::{Action, ActionData, Invalid};
use egui::text::{CCursor, CCursorRange};
use egui::text_edit::TextEditState;
use egui::{
    Align2, Color32, Context, CursorIcon, Id, Key, Modifiers, Response, Sense, Stroke, StrokeKind,
    TextEdit, Ui, UiBuilder, WidgetInfo, emath, vec2,
};

use super::described::{Number, Shown};
use super::late;
use super::moving::Moving;
use crate::theme;
use crate::widgets::work::{self, Work};
use bxdf_study::number::plain;

/// With Shift a drag is slower by this factor.
const SLOW: f64 = 0.1;

/// What a field keeps between frames.
#[derive(Clone, Default)]
struct State {
    /// The text of the person, while they type and while it is refused.
    text: Option<String>,
    /// The value that the text is to replace.
    value: f64,
    /// Why the text is refused.
    refusal: Option<String>,
    /// Whether it had the focus when it was last drawn, and when that was.
    is_typing: bool,
    pass: u64,
    /// Where a drag stands, before it is rounded.
    dragged: Option<f64>,
    moving: Moving,
}

/// One frame of the field.
pub(super) fn show(number: &Number<'_>, ui: &mut Ui, value: &mut f64) -> Shown {
    let id = ui.make_persistent_id(("number", number.name));
    let state: Option<State> = ui.data(|data| data.get_temp(id));
    let mut state = state.unwrap_or_default();
    // A text for another value is out of date: something else has changed it.
    if state.text.is_some() && state.value.to_bits() != value.to_bits() {
        state.text = None;
        state.refusal = None;
    }
    let is_dragging = ui.ctx().dragged_id().is_some();
    state.moving.note(*value, is_dragging);
    let layer = ui.layer_id();
    let has_focus = ui.is_enabled()
        && ui.memory_mut(|memory| {
            memory.interested_in_focus(id, layer);
            memory.has_focus(id)
        });
    let mut field = Field {
        number,
        id,
        state,
        value,
    };
    field.obey(ui);
    let response = if has_focus {
        field.edit(ui)
    } else {
        field.leave(ui);
        field.rest(ui)
    };
    field.describe(ui, &response);
    field.state.pass = ui.ctx().cumulative_pass_nr();
    let refusal = field.state.refusal.clone();
    let state = field.state;
    ui.data_mut(|data| data.insert_temp(id, state));
    Shown { response, refusal }
}

struct Field<'a> {
    number: &'a Number<'a>,
    id: Id,
    state: State,
    value: &'a mut f64,
}

impl Field<'_> {
    /// Takes the text for the value, if it is one.
    fn enter(&mut self, ctx: &Context) -> bool {
        let Some(text) = self.state.text.clone() else {
            return true;
        };
        // What was not touched is not read: the value may have been there before its range.
        let is_touched = text != plain(*self.value);
        match self.number.read(&text) {
            Ok(x) if is_touched => self.set(ctx, x),
            Err(words) if is_touched => {
                self.state.refusal = Some(words);
                return false;
            }
            _ => {}
        }
        self.forget();
        true
    }

    /// The value as it stands there while nobody types.
    fn text(&self) -> String {
        let shown = if self.state.moving.is_on_way() {
            self.number.shown_moving(*self.value)
        } else {
            self.number.shown(*self.value)
        };
        format!("{}{shown}", self.number.prefix)
    }

    fn set(&mut self, ctx: &Context, x: f64) {
        if x.to_bits() != self.value.to_bits() {
            *self.value = x;
            work::note(ctx, Work::Entered);
        }
    }

    /// Shows the value again, whatever was typed.
    fn forget(&mut self) {
        self.state.text = None;
        self.state.refusal = None;
    }

    /// Moves the value by so many steps, to a round number.
    fn move_by(&mut self, steps: f64) {
        let step = self.number.step_at(*self.value);
        let moved = emath::round_to_decimals(*self.value + steps * step, decimals_of(step));
        self.number.spec.put(self.value, moved);
        self.forget();
    }

    /// What assistive tools ask for.
    fn obey(&mut self, ui: &Ui) {
        let (steps, wanted) = ui.input(|input| {
            let count = |action| input.num_accesskit_action_requests(self.id, action) as f64;
            let steps = count(Action::Increment) - count(Action::Decrement);
            let requests = input.accesskit_action_requests(self.id, Action::SetValue);
            let text = |data: &ActionData| match data {
                ActionData::NumericValue(x) => Some(plain(*x)),
                ActionData::Value(text) => Some(text.to_string()),
                _ => None,
            };
            let last = requests
                .filter_map(|request| request.data.as_ref().and_then(text))
                .last();
            (steps, last)
        });
        if steps != 0.0 {
            self.move_by(steps);
        }
        if let Some(text) = wanted {
            self.state.value = *self.value;
            self.state.text = Some(text);
            self.enter(ui.ctx());
        }
    }

    /// What becomes of the text when the focus is gone.
    fn leave(&mut self, ui: &Ui) {
        if !std::mem::take(&mut self.state.is_typing) {
            return;
        }
        let pass = ui.ctx().cumulative_pass_nr();
        if ui.input(|input| input.key_pressed(Key::Escape)) {
            self.forget();
        } else if self.state.pass + 1 < pass {
            // It was out of sight meanwhile: what it changed then would come as a surprise now.
            let is_touched = self
                .state
                .text
                .as_ref()
                .is_some_and(|text| *text != plain(*self.value));
            if is_touched {
                self.state.refusal = Some("Typed, but not stored yet: press Enter here".to_owned());
            } else {
                self.forget();
            }
        } else {
            self.catch_up(ui);
            self.enter(ui.ctx());
        }
    }

    /// Takes the keys that came before the Tab that ends the text.
    fn catch_up(&mut self, ui: &Ui) {
        let Some(text) = &mut self.state.text else {
            return;
        };
        let end = text.chars().count();
        let range = TextEditState::load(ui.ctx(), self.id)
            .and_then(|edit| edit.cursor.char_range())
            .map_or(end..end, |range| {
                let [from, to] = range.sorted_cursors();
                usize::from(from.index)..usize::from(to.index)
            });
        ui.input_mut(|input| late::type_before_tab(&mut input.events, text, range));
    }

    /// All of the text is selected when it gets the focus, so that typing replaces it.
    fn begin(&mut self, ui: &Ui) {
        let text = self.state.text.get_or_insert_with(|| plain(*self.value));
        let mut edit = TextEditState::default();
        let all = CCursorRange::two(CCursor::default(), CCursor::new(text.chars().count()));
        edit.cursor.set_char_range(Some(all));
        edit.store(ui.ctx(), self.id);
        self.state.value = *self.value;
        self.state.is_typing = true;
    }

    fn size(&self, ui: &Ui) -> egui::Vec2 {
        let text = self.text();
        let font = ui.style().drag_value_text_style.resolve(ui.style());
        let galley = ui
            .painter()
            .layout_no_wrap(text, font, Color32::PLACEHOLDER);
        let spacing = ui.spacing();
        let width = galley.size().x + 2.0 * spacing.button_padding.x;
        vec2(width.max(theme::NUMBER_WIDTH), spacing.interact_size.y)
    }

    /// The text that is typed in.
    fn edit(&mut self, ui: &mut Ui) -> Response {
        let size = self.size(ui);
        if !self.state.is_typing || self.state.text.is_none() {
            self.begin(ui);
        }
        let (is_entered, steps) = ui.input_mut(|input| {
            let mut count = |key| input.count_and_consume_key(Modifiers::NONE, key) as f64;
            let steps = count(Key::ArrowUp) - count(Key::ArrowDown);
            (count(Key::Enter) > 0.0, steps)
        });
        if steps != 0.0 && self.enter(ui.ctx()) {
            self.move_by(steps);
            work::note(ui.ctx(), Work::Moved(self.id));
            self.begin(ui);
        }
        let color = self
            .state
            .refusal
            .as_ref()
            .map(|_| ui.visuals().error_fg_color);
        let style = ui.style().drag_value_text_style.clone();
        let mut text = self.state.text.take().unwrap_or_default();
        let edit = TextEdit::singleline(&mut text)
            .id(self.id)
            .font(style)
            .text_color_opt(color)
            .return_key(None)
            .clip_text(true)
            .align(Align2::CENTER_CENTER)
            .margin(vec2(4.0, 0.0))
            .min_size(size)
            .desired_width(size.x);
        // In a room of its own, so that nothing beside it moves.
        let (_, rect) = ui.allocate_space(size);
        let room = UiBuilder::new().max_rect(rect).layout(*ui.layout());
        let response = ui.new_child(room).add(edit);
        self.state.text = Some(text);
        if self.state.refusal.is_some() && response.changed() {
            let read = self.state.text.as_ref().map(|text| self.number.read(text));
            self.state.refusal = read.and_then(Result::err);
        }
        if let Some(color) = color {
            frame(ui, &response, color);
        }
        // Before what is pressed there takes the field away.
        let is_left = ui.input(|input| input.pointer.any_pressed()) && !response.contains_pointer();
        if is_entered || is_left {
            let is_stored = self.enter(ui.ctx());
            if is_stored || is_left {
                self.state.is_typing = false;
                response.surrender_focus();
            }
        }
        response
    }

    /// The value, or the text that was refused; a drag changes it, a click lets one type.
    fn rest(&mut self, ui: &mut Ui) -> Response {
        let (_, rect) = ui.allocate_space(self.size(ui));
        // As many ids as the text takes: controls after the field are the same ones when it loses the focus, and a click that
        // takes it away finds them.
        ui.skip_ahead_auto_ids(1);
        let response = ui.interact(rect, self.id, Sense::click_and_drag());
        let response = response.on_hover_cursor(CursorIcon::ResizeHorizontal);
        self.drag(ui, &response);
        if response.clicked() {
            response.request_focus();
            ui.ctx().request_repaint();
        }
        if TextEditState::load(ui.ctx(), self.id).is_none() {
            // By this it is known as a text, so that no key that is typed next is taken for a command.
            TextEditState::default().store(ui.ctx(), self.id);
        }
        if ui.is_rect_visible(rect) {
            self.paint(ui, &response);
        }
        response
    }

    fn drag(&mut self, ui: &Ui, response: &Response) {
        if !response.dragged() {
            self.state.dragged = None;
            return;
        }
        let is_slow = ui.input(|input| input.modifiers.shift_only());
        let points = f64::from(response.drag_delta().x) * if is_slow { SLOW } else { 1.0 };
        if points == 0.0 {
            return;
        }
        let step = if self.number.is_logarithmic {
            self.number.step_at(*self.value)
        } else {
            self.number.speed
        };
        let [low, high] = self.number.spec.range;
        let from = self.state.dragged.unwrap_or(*self.value);
        let exact = (from + points * step).clamp(low, high);
        let half = 0.5 * step * if is_slow { SLOW } else { 1.0 };
        let round = emath::smart_aim::best_in_range_f64(exact - half, exact + half);
        self.number.spec.put(self.value, round);
        self.state.dragged = Some(exact);
        self.forget();
    }

    fn paint(&self, ui: &Ui, response: &Response) {
        let visuals = ui.style().interact(response);
        let rect = response.rect;
        let painter = ui.painter_at(rect.expand(1.0));
        painter.rect(
            rect,
            visuals.corner_radius,
            visuals.weak_bg_fill,
            visuals.bg_stroke,
            StrokeKind::Inside,
        );
        let font = ui.style().drag_value_text_style.resolve(ui.style());
        let refused = self
            .state
            .text
            .as_ref()
            .filter(|_| self.state.refusal.is_some());
        let (text, color) = if let Some(text) = refused {
            (text.clone(), ui.visuals().error_fg_color)
        } else {
            let text = self.text();
            (text, visuals.text_color())
        };
        let inner = painter.with_clip_rect(rect.shrink(2.0).intersect(ui.clip_rect()));
        inner.text(rect.center(), Align2::CENTER_CENTER, text, font, color);
        if refused.is_some() {
            frame(ui, response, color);
        }
    }

    /// Tells tests and screen readers name, value and range, and why a text is refused.
    fn describe(&self, ui: &Ui, response: &Response) {
        let value = *self.value;
        response.widget_info(|| WidgetInfo::drag_value(ui.is_enabled(), value));
        let [low, high] = self.number.spec.range;
        let text = self.state.text.clone().unwrap_or_else(|| self.text());
        let step = self.number.step_at(*self.value);
        ui.ctx().accesskit_node_builder(self.id, |node| {
            node.set_label(self.number.name.to_owned());
            node.set_value(text);
            node.set_min_numeric_value(low);
            node.set_max_numeric_value(high);
            node.set_numeric_value_step(step);
            for action in [Action::SetValue, Action::Increment, Action::Decrement] {
                node.add_action(action);
            }
            if let Some(words) = &self.state.refusal {
                node.set_invalid(Invalid::True);
                node.set_description(words.clone());
            }
        });
    }
}

/// The mark of a text that is refused.
fn frame(ui: &Ui, response: &Response, color: Color32) {
    let stroke = Stroke::new(1.5, color);
    let radius = ui.visuals().widgets.inactive.corner_radius;
    ui.painter()
        .rect_stroke(response.rect, radius, stroke, StrokeKind::Inside);
}

/// The decimals of a step: one more than its first digit has.
fn decimals_of(step: f64) -> usize {
    const MOST: f64 = 15.0;
    (1.0 - step.log10().floor()).clamp(0.0, MOST) as usize
}
