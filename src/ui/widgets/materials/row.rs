//! A row of the list of materials.

use egui::text::{CCursor, CCursorRange};
use egui::{
    Align, Button, Checkbox, FontSelection, Key, Layout, Rect, Response, RichText, Role, Sense,
    TextEdit, TextWrapMode, Ui, Vec2, WidgetInfo, WidgetText, pos2, vec2,
};

use super::action::{Action, grip_id, is_pressed};
use crate::theme::{self, Dash, Palette};
use crate::widgets::badges::Badges;
use crate::widgets::draw;
use crate::widgets::focus;
use crate::widgets::things;
use crate::widgets::thumbnails::{self, Thumbnails};
use bxdf_lab::contract::PhysicalLaws;
use bxdf_study::answers::Answers;
use bxdf_study::lessons::Thing;
use bxdf_study::session::{MaterialEntry, Materials};

/// The length of the line below a name, in points: it shows what of it are dashes.
const LINE_LENGTH: f32 = 40.0;

/// The room of that line, in points.
const LINE_ROOM: f32 = 6.0;

/// A row, about to be shown.
pub(super) struct Row<'a> {
    pub(super) materials: &'a Materials,
    pub(super) entry: &'a MaterialEntry,
    pub(super) title: String,
    /// What was typed as the new name, while it is typed.
    pub(super) typed: Option<&'a str>,
}

impl Row<'_> {
    /// The row: grip, whether it is seen, picture, name over its line, badge, menu. Returns what the user wants.
    pub(super) fn show(
        &self,
        ui: &mut Ui,
        thumbnails: &mut Thumbnails,
        answers: &mut Answers,
        palette: &Palette,
    ) -> Vec<Action> {
        let mut wished = Vec::new();
        let size = vec2(ui.available_width(), theme::ROW_HEIGHT);
        let row = Rect::from_min_size(ui.cursor().min, size);
        if let Some(index) = self.materials.position(self.entry.id()) {
            things::frame(ui, row, &Thing::Material(index + 1), palette);
        }
        if self.is_selected() {
            let fill = ui.visuals().selection.bg_fill;
            ui.painter().rect_filled(row, 4.0, fill);
        }
        ui.allocate_ui_with_layout(size, Layout::left_to_right(Align::Center), |ui| {
            ui.set_min_height(theme::ROW_HEIGHT);
            ui.spacing_mut().item_spacing.x = theme::ROW_SPACING;
            self.grip(ui, &mut wished);
            self.visibility(ui, &mut wished);
            self.picture(ui, thumbnails, answers);
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                self.menu_button(ui, &mut wished);
                self.badge(ui, answers, palette, &mut wished);
                if self.is_alone() {
                    let solo = ui
                        .selectable_label(true, "Alone")
                        .on_hover_text("It is shown alone: click to show the others too");
                    if solo.clicked() {
                        wished.push(Action::SetSolo(false));
                    }
                }
                ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                    match self.typed {
                        None => self.name(ui, palette, &mut wished),
                        Some(typed) => self.name_field(ui, typed, &mut wished),
                    }
                });
            });
        });
        wished
    }

    /// What became of the laws, where it is in sight.
    fn badge(
        &self,
        ui: &mut Ui,
        answers: &mut Answers,
        palette: &Palette,
        wished: &mut Vec<Action>,
    ) {
        if let Some(lack) = self.entry.material.lack() {
            let mark = ui.colored_label(palette.warning, "⚠");
            let name = format!("{} is not shown: {lack}", self.title);
            mark.widget_info(|| WidgetInfo::labeled(Role::Label, true, &name));
            mark.on_hover_text(name);
            return;
        }
        let size = vec2(theme::RESET_WIDTH, theme::GRIP.y);
        let is_in_sight = ui.is_rect_visible(Rect::from_center_size(ui.max_rect().center(), size));
        let checks = if is_in_sight {
            answers.of_material(self.entry, PhysicalLaws)
        } else {
            None
        };
        let badges = Badges {
            title: &self.title,
            reports: checks.as_ref().map(|checks| checks.as_slice()),
        };
        wished.extend(badges.summary(ui, palette).map(Action::Inspect));
    }

    fn is_alone(&self) -> bool {
        self.materials.solo() == Some(self.entry.id())
    }

    fn place(&self) -> usize {
        self.materials.position(self.entry.id()).unwrap_or(0)
    }

    fn is_last(&self) -> bool {
        self.place() + 1 == self.materials.count()
    }

    fn grip(&self, ui: &mut Ui, wished: &mut Vec<Action>) {
        if self.materials.count() == 1 {
            return;
        }
        let (rect, _) = ui.allocate_exact_size(theme::GRIP, Sense::hover());
        let grip = ui.interact(rect, grip_id(self.entry.id()), Sense::click_and_drag());
        let name = format!("Move {}", self.title);
        grip.widget_info(|| WidgetInfo::labeled(Role::Button, true, &name));
        let color = if grip.hovered() || grip.dragged() || grip.has_focus() {
            ui.visuals().strong_text_color()
        } else {
            ui.visuals().weak_text_color()
        };
        for line in [-1.0, 0.0, 1.0] {
            let y = rect.center().y + 3.5 * line;
            ui.painter()
                .hline(rect.x_range().shrink(1.0), y, (1.5, color));
        }
        self.move_by_keys(ui, &grip, wished);
        grip.on_hover_cursor(egui::CursorIcon::Grab)
            .on_hover_text("Drag to change the order, or press Alt+Up and Alt+Down");
    }

    fn move_by_keys(&self, ui: &Ui, focused: &Response, wished: &mut Vec<Action>) {
        if is_pressed(ui, focused, Key::ArrowUp, true) && self.place() > 0 {
            wished.push(Action::MoveTo(self.place() - 1));
        }
        if is_pressed(ui, focused, Key::ArrowDown, true) && !self.is_last() {
            wished.push(Action::MoveTo(self.place() + 1));
        }
    }

    fn visibility(&self, ui: &mut Ui, wished: &mut Vec<Action>) {
        let mut is_visible = self.entry.is_visible;
        // While one is shown alone, the boxes of all keep what they say for later.
        let checkbox = ui.add(Checkbox::without_text(&mut is_visible));
        let name = format!("Show {}", self.title);
        checkbox.widget_info(|| WidgetInfo::selected(Role::CheckBox, true, is_visible, &name));
        if checkbox.on_hover_text("Show it in the views").changed() {
            wished.push(Action::SetVisible(is_visible));
        }
    }

    /// How it looks, as a sphere.
    fn picture(&self, ui: &mut Ui, thumbnails: &mut Thumbnails, answers: &mut Answers) {
        let side = Vec2::splat(theme::ROW_PICTURE);
        let (rect, _) = ui.allocate_exact_size(side, Sense::hover());
        if ui.is_rect_visible(rect)
            && let Some(texture) =
                thumbnails.of_entry(ui.ctx(), self.entry, theme::ROW_PICTURE, answers)
        {
            let strength = self.strength();
            let tint = egui::Color32::WHITE.gamma_multiply(strength);
            thumbnails::paint(ui, rect, texture, tint);
        }
    }

    /// The strength of what stands for it: less where the views do not show it.
    fn strength(&self) -> f32 {
        if self.materials.is_shown(self.entry) {
            1.0
        } else {
            theme::HIDDEN_STRENGTH
        }
    }

    fn is_selected(&self) -> bool {
        self.materials.selected().id() == self.entry.id()
    }

    /// The name, over its line and colour in the views.
    fn name(&self, ui: &mut Ui, palette: &Palette, wished: &mut Vec<Action>) {
        let size = vec2(ui.available_width(), theme::ROW_HEIGHT);
        let (rect, row) = ui.allocate_exact_size(size, Sense::click());
        let is_selected = self.is_selected();
        let name = format!("Select {}", self.title);
        row.widget_info(|| WidgetInfo::selected(Role::Button, true, is_selected, &name));
        let color = if is_selected || row.hovered() {
            ui.visuals().strong_text_color()
        } else {
            ui.visuals().text_color()
        };
        let text = WidgetText::from(RichText::new(&self.title).color(color)).into_galley(
            ui,
            Some(TextWrapMode::Truncate),
            rect.width(),
            FontSelection::Default,
        );
        // Both together stand in the middle of the row.
        let height = text.size().y + LINE_ROOM;
        let top = rect.center().y - 0.5 * height;
        ui.painter().galley(pos2(rect.left(), top), text, color);
        let y = top + height - theme::CURVE_WIDTH;
        let ends = [rect.left(), rect.left() + LINE_LENGTH.min(rect.width())];
        let line = palette
            .material(self.entry.slot())
            .gamma_multiply(self.strength());
        draw::line(
            ui.painter(),
            ends.map(|x| pos2(x, y)),
            (theme::CURVE_WIDTH, line),
            Dash::of(self.entry.slot()),
        );
        focus::ring(ui, &row);
        if row.double_clicked() || is_pressed(ui, &row, Key::F2, false) {
            wished.push(Action::StartRenaming);
        } else if row.clicked() {
            wished.push(Action::Select);
        }
        if is_pressed(ui, &row, Key::Delete, false) {
            wished.push(Action::Remove);
        }
        self.move_by_keys(ui, &row, wished);
        row.context_menu(|ui| self.menu(ui, wished));
        row.on_hover_text(format!(
            "{}, with its line and colour in the views\nClick to edit it below, double-click to rename it",
            self.title
        ));
    }

    /// The name, while it is typed: Enter takes it over, Escape does not.
    fn name_field(&self, ui: &mut Ui, typed: &str, wished: &mut Vec<Action>) {
        let mut name = typed.to_owned();
        let id = ui.scope_id().with("name");
        let had_focus = ui.memory(|memory| memory.had_focus_last_frame(id));
        let mut output = TextEdit::singleline(&mut name)
            .id(id)
            .char_limit(theme::LONGEST_NAME)
            .desired_width(f32::INFINITY)
            .show(ui);
        let field = &output.response.response;
        ui.ctx().accesskit_node_builder(id, |node| {
            node.set_label(format!("Name of {}", self.title));
        });
        if field.lost_focus() {
            let is_escaped = ui.input(|input| input.key_pressed(Key::Escape));
            if name != typed {
                wished.push(Action::Type(name));
            }
            wished.push(Action::EndRenaming(!is_escaped));
            return;
        }
        if !field.has_focus() && !had_focus {
            field.request_focus();
            let whole = CCursorRange::two(CCursor::new(0), CCursor::new(name.chars().count()));
            output.state.cursor.set_char_range(Some(whole));
            output.state.store(ui.ctx(), id);
        }
        if name != typed {
            wished.push(Action::Type(name));
        }
    }

    fn menu_button(&self, ui: &mut Ui, wished: &mut Vec<Action>) {
        let menu = ui.menu_button("…", |ui| self.menu(ui, wished));
        let name = format!("Menu of {}", self.title);
        menu.response
            .widget_info(|| WidgetInfo::labeled(Role::Button, true, &name));
        menu.response
            .on_hover_text("Show alone, rename, duplicate, copy, move, remove");
    }

    fn menu(&self, ui: &mut Ui, wished: &mut Vec<Action>) {
        let mut item = |ui: &mut Ui, is_enabled: bool, words: [&str; 2], action: Action| {
            let [name, hint] = words;
            let item = ui.add_enabled(is_enabled, Button::new(name));
            if item.on_hover_text(hint).clicked() {
                wished.push(action);
                ui.close();
            }
        };
        let is_several = self.materials.count() > 1;
        if self.is_alone() {
            let words = ["Show with the others", "Show all ticked materials again"];
            item(ui, true, words, Action::SetSolo(false));
        } else {
            let words = ["Show alone", "Hide all the others for now"];
            item(ui, is_several, words, Action::SetSolo(true));
        }
        ui.separator();
        let words = ["Rename", "Give it a name of its own (F2)"];
        item(ui, true, words, Action::StartRenaming);
        let words = ["Duplicate", "Add a copy to edit beside it"];
        item(ui, true, words, Action::Duplicate);
        let words = [
            "Copy as text",
            "Copy it as text, to paste here, save as a file or use on the command line",
        ];
        item(ui, true, words, Action::Copy);
        ui.separator();
        let place = self.place();
        let words = [
            "Move up",
            "Move it up in this list and in the legends (Alt+Up)",
        ];
        item(
            ui,
            place > 0,
            words,
            Action::MoveTo(place.saturating_sub(1)),
        );
        let words = [
            "Move down",
            "Move it down in this list and in the legends (Alt+Down)",
        ];
        item(ui, !self.is_last(), words, Action::MoveTo(place + 1));
        ui.separator();
        let words = [
            "Remove",
            "Remove it from the session; one is always left (Delete)",
        ];
        item(ui, is_several, words, Action::Remove);
    }
}
