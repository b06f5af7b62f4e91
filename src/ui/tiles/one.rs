//! One view alone: the one that is maximised, or the one that is seen in a small window, with a tab for each.

use egui::{Align, Layout, ScrollArea, Ui, vec2};
use egui_tiles::{Behavior, TileId};

use super::panes::{Panes, export_menu};
use crate::theme;
use crate::widgets::at_right;
use bxdf_study::session::{Layout as Places, ViewId, Views};

/// The view that is seen where there is room for one alone.
#[derive(Default)]
pub(super) struct Seen {
    view: Option<ViewId>,
    /// The views there were.
    all: Vec<ViewId>,
}

impl Seen {
    pub(super) fn view(&self) -> Option<ViewId> {
        self.view
    }

    /// Lets it be one of these views: one that has been added, else the one that it was, else the first.
    pub(super) fn follow(&mut self, views: &Views) {
        let all: Vec<ViewId> = views.layout().views().into_iter().copied().collect();
        if all == self.all {
            return;
        }
        let mut new = all.iter().filter(|view| !self.all.contains(view));
        let added = new.next().filter(|_| new.next().is_none());
        let is_added = all.len() == self.all.len() + 1;
        let kept = self.view.filter(|view| all.contains(view));
        let added = added.copied().filter(|_| is_added);
        self.view = added.or(kept).or(all.first().copied());
        self.all = all;
    }
}

impl Panes<'_, '_> {
    /// The view that has all the room, below a bar with its name.
    pub(super) fn show_maximised(&mut self, ui: &mut Ui, mut view: ViewId) {
        let height = theme::TAB_BAR_HEIGHT;
        let room = egui::vec2(ui.available_width(), height);
        ui.allocate_ui_with_layout(
            room,
            egui::Layout::right_to_left(egui::Align::Center),
            |ui| {
                self.show_menus(ui, view);
                ui.with_layout(egui::Layout::left_to_right(egui::Align::Center), |ui| {
                    let name = egui::Label::new(self.views.title(view)).sense(egui::Sense::click());
                    if ui.add(name).double_clicked() {
                        self.maximised = None;
                    }
                });
            },
        );
        let no_tile = TileId::from_u64(0);
        let _ = self.pane_ui(ui, no_tile, &mut view);
    }

    /// The view that is seen, below tabs for all. Returns the layout without a view that is closed.
    pub(super) fn show_one(&mut self, ui: &mut Ui, seen: &mut Seen) -> Option<Places> {
        let mut view = seen.view?;
        let mut closed = None;
        let is_several = seen.all.len() > 1;
        let room = vec2(ui.available_width(), theme::TOUCHED);
        ui.allocate_ui_with_layout(room, Layout::left_to_right(Align::Center), |ui| {
            let id = ui.scope_id().with("menus of the view that is seen");
            let gap = ui.spacing().item_spacing.x;
            let tabs = ui.available_width() - at_right::width(ui, id) - gap;
            ScrollArea::horizontal()
                .id_salt("tabs")
                .max_width(tabs)
                .show(ui, |ui| {
                    for other in &seen.all {
                        let tab = ui.selectable_label(*other == view, self.views.title(*other));
                        if tab.clicked() {
                            seen.view = Some(*other);
                        }
                    }
                });
            at_right::show(ui, id, |ui| {
                let title = self.views.title(view);
                if let Some(wish) = self
                    .views
                    .kind(view)
                    .and_then(|kind| export_menu(ui, kind, &title))
                {
                    self.wished = Some((view, wish));
                }
                if is_several {
                    let close = ui.button("×").on_hover_text("Close this view");
                    let name = format!("Close {title}");
                    ui.ctx()
                        .accesskit_node_builder(close.id, |node| node.set_label(name));
                    if close.clicked() {
                        closed = Some(view);
                    }
                }
            });
        });
        let no_tile = TileId::from_u64(0);
        let _ = self.pane_ui(ui, no_tile, &mut view);
        let closed = closed?;
        let mut rest = |id: &ViewId| (*id != closed).then_some(*id);
        self.views.layout().filter_map(&mut rest)
    }
}
