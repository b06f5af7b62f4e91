//! What the tiles hold: the views, and what stands in the bar above each.

use egui::{RichText, Ui, WidgetText};
use egui_tiles::{Behavior, SimplificationOptions, Tabs, Tile, TileId, Tiles, UiResponse};

use crate::theme;
use crate::widgets::{at_right, small};
use bxdf_study::export::{FORMATS, Format};
use bxdf_study::session::{LEAST_PLACE, ViewId, Views};
use bxdf_study::views::{Options, ViewKind};

/// What is to be made of a view.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wish {
    /// A figure, which is chosen first.
    Figure,
    /// A file.
    Export(Format),
    /// A picture in the clipboard.
    CopyPicture,
    /// Another view like it.
    Duplicate,
    /// A section of its own, or that of the others again.
    OwnSection,
}

/// Draws a view into the space left in the `Ui`.
pub type ShowView<'a> = dyn FnMut(&mut Ui, ViewId) + 'a;

/// How the tiles look and what they hold.
pub(super) struct Panes<'a, 'b> {
    pub(super) views: &'a Views,
    pub(super) show_view: &'a mut ShowView<'b>,
    pub(super) is_edited: bool,
    /// What is to be made of a view.
    pub(super) wished: Option<(ViewId, Wish)>,
    /// The view that has all the room.
    pub(super) maximised: Option<ViewId>,
}

impl Panes<'_, '_> {
    /// What stands at the right of the bar with a view's name.
    pub(super) fn show_menus(&mut self, ui: &mut Ui, view: ViewId) {
        let (Some(kind), title) = (self.views.kind(view), self.views.title(view)) else {
            return;
        };
        let is_maximised = self.maximised == Some(view);
        let is_several = self.views.ids().len() > 1;
        at_right::show(ui, ui.scope_id().with("menus of a view"), |ui| {
            if is_several && maximise_button(ui, is_maximised, &title) {
                self.maximised = (!is_maximised).then_some(view);
            }
            if let Some(wish) = export_menu(ui, kind, &title) {
                self.wished = Some((view, wish));
            }
        });
    }
}

/// What can be done to a view, beside what its place offers. Returns what was chosen.
fn tab_menu(ui: &mut Ui, views: &Views, view: ViewId) -> Option<Wish> {
    let mut wished = None;
    let hint = "Open a copy beside it, with settings of its own";
    let button = ui.add_enabled(views.has_room(), egui::Button::new("Duplicate"));
    if button.on_hover_text(hint).clicked() {
        wished = Some(Wish::Duplicate);
    }
    let mut options = views.get(view).cloned();
    if let Some(section) = options.as_mut().and_then(Options::own_section) {
        let hint = "Give it a section at an azimuth of its own, whatever the other views show";
        let mut is_own = section.0.is_some();
        let switch = ui.checkbox(&mut is_own, "Own section");
        if switch.on_hover_text(hint).clicked() {
            wished = Some(Wish::OwnSection);
            ui.close();
        }
    }
    wished
}

/// The menu of what can be exported of a view. Returns what was chosen.
pub(super) fn export_menu(ui: &mut Ui, view: &ViewKind, title: &str) -> Option<Wish> {
    let mut wished = None;
    let menu = ui.menu_button(RichText::new("Export").small(), |ui| {
        let hint =
            "Choose size, theme and title of a figure of this view, and see how it will look";
        if ui.button("Figure…").on_hover_text(hint).clicked() {
            wished = Some(Wish::Figure);
        }
        let hint = "Copy the picture that would be exported";
        if ui.button("Copy picture").on_hover_text(hint).clicked() {
            wished = Some(Wish::CopyPicture);
        }
        for spec in FORMATS.iter().filter(|spec| view.has_file(spec.format)) {
            let item = ui.button(spec.title);
            if item.on_hover_text(spec.meaning).clicked() {
                wished = Some(Wish::Export(spec.format));
            }
        }
    });
    let name = format!("Export {title}");
    ui.ctx()
        .accesskit_node_builder(menu.response.id, |node| node.set_label(name));
    wished
}

/// The button that gives a view all the room, or gives it back.
fn maximise_button(ui: &mut Ui, is_maximised: bool, title: &str) -> bool {
    let (sign, name, hint) = if is_maximised {
        (
            "🗗",
            "Restore",
            "Show the other views again (double-click the name)",
        )
    } else {
        (
            "🗖",
            "Maximise",
            "Give this view all the room (double-click the name)",
        )
    };
    let button = ui.add(small::button(ui, sign)).on_hover_text(hint);
    let name = format!("{name} {title}");
    ui.ctx()
        .accesskit_node_builder(button.id, |node| node.set_label(name));
    button.clicked()
}

impl Behavior<ViewId> for Panes<'_, '_> {
    fn pane_ui(&mut self, ui: &mut Ui, _tile: TileId, id: &mut ViewId) -> UiResponse {
        if self.views.kind(*id).is_some() {
            // What a view draws beyond its tile would lie below what its neighbour draws.
            ui.set_clip_rect(ui.max_rect().intersect(ui.clip_rect()));
            egui::Frame::NONE
                .inner_margin(theme::TILE_MARGIN)
                .show(ui, |ui| (self.show_view)(ui, *id));
        }
        UiResponse::None
    }

    fn top_bar_right_ui(
        &mut self,
        tiles: &Tiles<ViewId>,
        ui: &mut Ui,
        _tile: TileId,
        tabs: &Tabs,
        _scroll_offset: &mut f32,
    ) {
        let active = tabs.active.and_then(|active| tiles.get(active));
        if let Some(Tile::Pane(view)) = active {
            self.show_menus(ui, *view);
        }
    }

    fn tab_title_for_pane(&mut self, view: &ViewId) -> WidgetText {
        self.views.title(*view).into()
    }

    fn on_tab_button(
        &mut self,
        tiles: &mut Tiles<ViewId>,
        tile: TileId,
        response: egui::Response,
    ) -> egui::Response {
        if let Some(Tile::Pane(view)) = tiles.get(tile) {
            if response.double_clicked() {
                self.maximised = Some(*view);
            }
            response.context_menu(|ui| {
                if let Some(wish) = tab_menu(ui, self.views, *view) {
                    self.wished = Some((*view, wish));
                }
            });
        }
        response
    }

    fn is_tab_closable(&self, _tiles: &Tiles<ViewId>, _tile: TileId) -> bool {
        self.views.ids().len() > 1
    }

    fn on_tab_close(&mut self, _tiles: &mut Tiles<ViewId>, _tile: TileId) -> bool {
        self.is_edited = true;
        true
    }

    fn on_edit(&mut self, action: egui_tiles::EditAction) {
        self.is_edited |= action != egui_tiles::EditAction::TileDragged;
    }

    fn simplification_options(&self) -> SimplificationOptions {
        SimplificationOptions {
            all_panes_must_have_tabs: true,
            ..SimplificationOptions::default()
        }
    }

    fn min_size(&self) -> f32 {
        let [_, height] = LEAST_PLACE;
        height
    }

    fn tab_bar_height(&self, _style: &egui::Style) -> f32 {
        theme::TAB_BAR_HEIGHT
    }
}
