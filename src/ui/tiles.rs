//! The views as tiles that can be split, tabbed, dragged, closed and added.
//!
//! The session's [`Layout`] says where they stand; the tree of tiles is made from it where it has changed, and turned
//! back into it where a gesture has changed the tree.

use egui::{RichText, Ui, WidgetText};
use egui_tiles::{
    Behavior, Container, Linear, LinearDir, SimplificationOptions, Tabs, Tile, TileId, Tiles, Tree,
    UiResponse,
};

use super::theme;
use super::widgets::at_right;
use bxdf_study::export::{FORMATS, Format};
use bxdf_study::session::{LEAST_PLACE, Layout, Part, Place, ViewId, Views};
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

/// What was done with the tiles in a frame.
pub struct Shown {
    /// Where the views stand now, if a gesture has changed it.
    pub layout: Option<Layout>,
    /// What is to be made of a view, if anything was chosen.
    pub wished: Option<(ViewId, Wish)>,
}

/// Draws a view into the space left in the `Ui`.
pub type ShowView<'a> = dyn FnMut(&mut Ui, ViewId) + 'a;

/// The tree, and the layout it stands for.
pub struct ViewTiles {
    tree: Tree<ViewId>,
    layout: Layout,
    /// The view that has all the room, if one has.
    maximised: Option<ViewId>,
}

impl Default for ViewTiles {
    fn default() -> Self {
        let layout = Views::default().layout().clone();
        Self {
            tree: tree_of(&layout),
            layout,
            maximised: None,
        }
    }
}

impl ViewTiles {
    /// Draws the views where they stand, each by `show_view`.
    pub fn show(&mut self, ui: &mut Ui, views: &Views, show_view: &mut ShowView<'_>) -> Shown {
        if *views.layout() != self.layout {
            self.layout.clone_from(views.layout());
            self.tree = tree_of(&self.layout);
            // What was opened or arranged is to be seen.
            self.maximised = None;
        }
        let mut panes = Panes {
            views,
            show_view,
            is_edited: false,
            wished: None,
            maximised: self.maximised.filter(|view| views.get(*view).is_some()),
        };
        match panes.maximised {
            Some(view) => panes.show_maximised(ui, view),
            None => self.tree.ui(&mut panes, ui),
        }
        let Panes {
            is_edited,
            wished,
            maximised,
            ..
        } = panes;
        self.maximised = maximised;
        // While a tile is dragged the tree is the library's own affair.
        let root = self.tree.root().filter(|_| is_edited);
        let layout = root.and_then(|root| self.place(root));
        if let Some(edited) = &layout {
            self.layout.clone_from(edited);
        }
        Shown { layout, wished }
    }

    /// The layout of a tile; `None` where no view is in it.
    fn place(&self, id: TileId) -> Option<Layout> {
        match self.tree.tiles.get(id)? {
            Tile::Pane(view) => Some(Place::View(*view)),
            Tile::Container(Container::Linear(linear)) => {
                let part = |child: &TileId| {
                    let share = linear.shares.iter().find(|(id, _)| *id == child);
                    let share = share.map_or(1.0, |(_, share)| *share);
                    Some(Part::of(share, self.place(*child)?))
                };
                let mut parts: Vec<Part<ViewId>> =
                    linear.children.iter().filter_map(part).collect();
                if parts.len() < 2 {
                    return parts.pop().map(|part| part.place);
                }
                Some(match linear.dir {
                    LinearDir::Horizontal => Place::Row(parts),
                    LinearDir::Vertical => Place::Column(parts),
                })
            }
            Tile::Container(container) => {
                let active = match container {
                    Container::Tabs(tabs) => tabs.active,
                    _ => None,
                };
                let places = container.children().map(|id| (*id, self.place(*id)));
                let mut places: Vec<_> = places
                    .filter_map(|(id, place)| Some((id, place?)))
                    .collect();
                let [_, _, ..] = &places[..] else {
                    return places.pop().map(|(_, place)| place);
                };
                let seen = places.iter().position(|(id, _)| Some(*id) == active);
                Some(Place::Tabs {
                    active: seen.unwrap_or(0),
                    views: places
                        .iter()
                        .flat_map(|(_, place)| place.views().into_iter().copied())
                        .collect(),
                })
            }
        }
    }
}

/// The tree of a layout. Each view has a bar with its name, to be dragged by.
fn tree_of(layout: &Layout) -> Tree<ViewId> {
    let mut tiles = Tiles::default();
    let root = insert(&mut tiles, layout);
    Tree::new(egui::Id::unique("views"), root, tiles)
}

fn insert(tiles: &mut Tiles<ViewId>, layout: &Layout) -> TileId {
    match layout {
        Place::View(view) => {
            let pane = tiles.insert_pane(*view);
            tiles.insert_tab_tile(vec![pane])
        }
        Place::Row(parts) => insert_parts(tiles, LinearDir::Horizontal, parts),
        Place::Column(parts) => insert_parts(tiles, LinearDir::Vertical, parts),
        Place::Tabs { views, active } => {
            let panes: Vec<TileId> = views.iter().map(|view| tiles.insert_pane(*view)).collect();
            let mut tabs = Tabs::new(panes.clone());
            if let Some(active) = panes.get(*active) {
                tabs.set_active(*active);
            }
            tiles.insert_container(tabs)
        }
    }
}

fn insert_parts(tiles: &mut Tiles<ViewId>, dir: LinearDir, parts: &[Part<ViewId>]) -> TileId {
    let children: Vec<TileId> = parts
        .iter()
        .map(|part| insert(tiles, &part.place))
        .collect();
    let mut linear = Linear::new(dir, children.clone());
    for (child, part) in children.into_iter().zip(parts) {
        linear.shares.set_share(child, part.share);
    }
    tiles.insert_container(linear)
}

/// How the tiles look and what they hold.
struct Panes<'a, 'b> {
    views: &'a Views,
    show_view: &'a mut ShowView<'b>,
    is_edited: bool,
    /// What is to be made of a view.
    wished: Option<(ViewId, Wish)>,
    /// The view that has all the room.
    maximised: Option<ViewId>,
}

impl Panes<'_, '_> {
    /// What stands at the right of the bar with a view's name.
    fn show_menus(&mut self, ui: &mut Ui, view: ViewId) {
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

    /// The view that has all the room, below a bar with its name.
    fn show_maximised(&mut self, ui: &mut Ui, mut view: ViewId) {
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
fn export_menu(ui: &mut Ui, view: &ViewKind, title: &str) -> Option<Wish> {
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
    let button = ui.small_button(sign).on_hover_text(hint);
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

#[cfg(test)]
mod tests {
    use super::*;
    use bxdf_study::session::READY_LAYOUTS;

    #[test]
    fn a_tree_stands_for_its_layout() {
        for ready in &READY_LAYOUTS {
            let layout = Views::ready(ready).layout().clone();
            let tiles = ViewTiles {
                tree: tree_of(&layout),
                layout: layout.clone(),
                maximised: None,
            };
            let root = tiles.tree.root().unwrap();
            assert_eq!(tiles.place(root), Some(layout));
        }
    }
}
