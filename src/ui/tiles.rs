//! The views as tiles that can be split, tabbed, dragged, closed and added.
//!
//! The session's [`Layout`] says where they stand; the tree of tiles is made from it where it has changed, and turned
//! back into it where a gesture has changed the tree.

use egui::Ui;
use egui_tiles::{Container, Linear, LinearDir, Tabs, Tile, TileId, Tiles, Tree};

use bxdf_study::session::{Layout, Part, Place, ViewId, Views};
use one::Seen;
use panes::Panes;
pub use panes::{ShowView, Wish};

mod one;
mod panes;

/// What was done with the tiles in a frame.
pub struct Shown {
    /// Where the views stand now, if a gesture has changed it.
    pub layout: Option<Layout>,
    /// What is to be made of a view, if anything was chosen.
    pub wished: Option<(ViewId, Wish)>,
}

/// The tree, and the layout it stands for.
pub struct ViewTiles {
    tree: Tree<ViewId>,
    layout: Layout,
    /// The view that has all the room, if one has.
    maximised: Option<ViewId>,
    /// The view that is seen where there is room for one alone.
    seen: Seen,
}

impl Default for ViewTiles {
    fn default() -> Self {
        let layout = Views::default().layout().clone();
        Self {
            tree: tree_of(&layout),
            layout,
            maximised: None,
            seen: Seen::default(),
        }
    }
}

impl ViewTiles {
    /// The view that is seen where there is room for one alone.
    #[must_use]
    pub fn seen(&self) -> Option<ViewId> {
        self.seen.view()
    }

    /// Draws the views where they stand, each by `show_view`; or one alone with tabs for all where the window `is_small`.
    pub fn show(
        &mut self,
        ui: &mut Ui,
        views: &Views,
        is_small: bool,
        show_view: &mut ShowView<'_>,
    ) -> Shown {
        self.seen.follow(views);
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
        if is_small {
            let layout = panes.show_one(ui, &mut self.seen);
            let wished = panes.wished;
            return Shown { layout, wished };
        }
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
                seen: Seen::default(),
            };
            let root = tiles.tree.root().unwrap();
            assert_eq!(tiles.place(root), Some(layout));
        }
    }
}
