//! The panel at the side: the materials, the parameters of the selected one, and the picker beside them.

use egui::{
    Area, Color32, Context, Id, Order, Panel, Rect, RichText, ScrollArea, Sense, Ui, UiBuilder,
};

use super::app::{App, Drawer};
use super::commands;
use super::theme::{self, Palette};
use super::widgets::chevron::{self, Points};
use super::widgets::params::Ties;
use super::widgets::{at_right, badges, components, covered};
use bxdf_study::cursor::Cursor;
use bxdf_study::lessons::Cover;
use bxdf_study::session::Session;

impl App {
    /// The panel, as it is folded.
    pub(super) fn show_side(&mut self, ui: &mut Ui, palette: &Palette) {
        let is_folded = self.is_side_folded(ui.ctx());
        let (id, width) = if is_folded {
            ("folded side", theme::FOLDED_WIDTH)
        } else {
            ("side", theme::SIDE_WIDTH)
        };
        Panel::left(id)
            .resizable(false)
            .exact_size(width)
            .show(ui, |ui| {
                ui.add_space(4.0);
                if is_folded {
                    self.show_icons(ui, palette);
                } else {
                    self.show_whole(ui, palette);
                }
            });
    }

    /// The panel over the view of a small window, in this `room`, while it is asked for. Pressed beside it, or with Escape, it
    /// goes.
    pub(super) fn show_drawer(&mut self, ctx: &Context, room: Rect, palette: &Palette) {
        let is_there = self.is_small() && !self.is_presenting() && !self.is_side_folded(ctx);
        if !is_there {
            return;
        }
        let width = theme::SIDE_WIDTH.min(room.width() - theme::BESIDE_DRAWER);
        let place = room.with_max_x(room.left() + width);
        let drawer = Area::new(Id::unique("drawer"))
            .order(Order::Middle)
            .movable(false)
            .constrain(false)
            .fixed_pos(room.min)
            .show(ctx, |ui| {
                // Tab does not stop at either.
                let pressed = Sense::CLICK | Sense::DRAG;
                let beside = ui.allocate_rect(room, pressed);
                let shade = Color32::from_black_alpha(theme::DRAWER_SHADE);
                ui.painter().rect_filled(room, 0.0, shade);
                ui.interact(place, ui.scope_id().with("panel"), pressed);
                ui.painter()
                    .rect_filled(place, 0.0, ui.visuals().panel_fill);
                let inner = egui::Frame::side_top_panel(ui.style()).inner_margin;
                let mut panel = ui.new_child(UiBuilder::new().max_rect(place - inner));
                panel.set_clip_rect(place);
                self.show_whole(&mut panel, palette);
                beside.clicked()
            });
        if drawer.inner || self.is_drawer_escaped(ctx) {
            self.drawer = Drawer::Closed;
        }
    }

    /// The picker, while it is shown, over the `views`.
    pub(super) fn show_picker(&mut self, ctx: &Context, views: Rect) {
        let materials = &mut self.session.materials;
        let picked = self.picker.show(ctx, views, materials, &mut self.answers);
        self.notice.report(picked);
    }

    /// The materials alone, as icons, with what brings back the rest.
    fn show_icons(&mut self, ui: &mut Ui, palette: &Palette) {
        ui.vertical_centered(|ui| {
            self.fold_button(ui, true);
            let is_added = commands::ADD.icon(ui, self, "➕");
            let is_changed = commands::CHANGE.icon(ui, self, "🔍");
            let wished = is_added.then_some(&commands::ADD);
            let wished = wished.or(is_changed.then_some(&commands::CHANGE));
            self.run(wished, ui.ctx());
        });
        ui.separator();
        let materials = &mut self.session.materials;
        self.list.icons(ui, materials, &mut self.answers, palette);
    }

    /// The list, and what is set of the selected material.
    fn show_whole(&mut self, ui: &mut Ui, palette: &Palette) {
        self.list_header(ui);
        let materials = &mut self.session.materials;
        let listed = self.list.show(ui, materials, &mut self.answers, palette);
        let mut wished = self.notice.report(listed).flatten();
        let below_list = ui.cursor().top();
        ui.separator();
        let before = materials.selected().clone();
        let mut edited = before.clone();
        let mut is_changing = false;
        let area = ScrollArea::vertical()
            .id_salt("parameters")
            .auto_shrink([false, false]);
        let top = ui.cursor().top();
        let scrolled = area.show(ui, |ui| {
            // The scroll bar must not lie over the reset buttons. The badges end in words: they need all of the line.
            let width = ui.available_width() - theme::SCROLL_ROOM;
            let title = self.session.materials.title(&before);
            let material = &mut edited.material;
            ui.push_id(before.id(), |ui| {
                let has_parameters = !covered::is_covered(ui.ctx(), Cover::Parameters);
                ui.scope(|ui| {
                    ui.set_max_width(width);
                    if !has_parameters {
                        covered::stand_in(ui, "Kind and parameters");
                        return;
                    }
                    components::describe(ui, material, |ui| {
                        is_changing = commands::CHANGE.button(ui, self);
                    });
                });
                let clicked =
                    badges::show(ui, &title, &before, material, &mut self.answers, palette);
                wished = clicked.or(wished.take());
                if !has_parameters {
                    return;
                }
                ui.scope(|ui| {
                    ui.set_max_width(width);
                    let Session {
                        materials,
                        locked,
                        pinned,
                        ..
                    } = &mut self.session;
                    let mut ties = Ties {
                        has_linked_widths: &mut edited.has_linked_widths,
                        locked,
                        pinned,
                        is_shared: &|spec| materials.is_shared(spec),
                    };
                    self.components
                        .show(ui, material, &mut ties, &mut self.side);
                });
            });
            ui.add_space(4.0);
        });
        let gap = top - below_list + ui.spacing().item_spacing.y;
        self.list
            .leave_below(ui.ctx(), gap + scrolled.content_size.y);
        self.take_edited(edited);
        self.run(is_changing.then_some(&commands::CHANGE), ui.ctx());
        if let Some(witness) = wished {
            let selected = self.session.materials.selected().id();
            self.cursor = Cursor::jump(&mut self.session, selected, &witness).or(self.cursor);
        }
    }

    /// The heading of the list, with the commands that add to it and the one that folds the panel.
    fn list_header(&mut self, ui: &mut Ui) {
        let mut wished = None;
        ui.horizontal(|ui| {
            ui.label(RichText::new("Your materials").strong());
            at_right::show(ui, Id::unique("buttons of the list"), |ui| {
                for command in [&commands::ADD, &commands::PASTE] {
                    if command.button(ui, self) {
                        wished = Some(command);
                    }
                }
                self.fold_button(ui, false);
            });
        });
        self.run(wished, ui.ctx());
    }

    fn fold_button(&mut self, ui: &mut Ui, is_folded: bool) {
        let points = if is_folded {
            Points::Right
        } else {
            Points::Left
        };
        let hint = commands::FOLD.hint(ui.ctx());
        let button = chevron::button(ui, points, !is_folded, commands::FOLD.title, &hint);
        self.run(button.clicked().then_some(&commands::FOLD), ui.ctx());
    }
}
