//! The views of a session, as instances: the same kind may stand twice, each with options of its own.

use std::collections::BTreeMap;

use super::layout::{Layout, Place, ViewId};
use super::ready::{READY_LAYOUTS, ReadyLayout};
use crate::number::{Refused, are_allowed, checked, keep};
use crate::views::{OfKind, Options, ViewKind, find};
use bxdf::error::{Error, Result};

mod alike;

/// The most views of a session: more are too small to be seen.
pub const MAX_VIEWS: usize = 32;

/// The views of a session: where they stand, and the options of each. There is always one.
#[derive(Clone, Debug)]
pub struct Views {
    layout: Layout,
    /// The options of each view of the layout.
    open: BTreeMap<ViewId, Options>,
    /// The options of the view of each kind that was closed last, by the id of the kind, unless they are those that it has
    /// at first.
    closed: BTreeMap<&'static str, Options>,
}

impl Default for Views {
    /// The first of the ready layouts.
    fn default() -> Self {
        let [first, ..] = &READY_LAYOUTS;
        Self::ready(first)
    }
}

/// Views are alike that stand alike and show alike, whatever their numbers.
impl PartialEq for Views {
    fn eq(&self, other: &Self) -> bool {
        let same = |one: &ViewId, two: &ViewId| self.open.get(one) == other.open.get(two);
        self.layout.is_like(&other.layout, &same) && self.closed == other.closed
    }
}

impl From<Place<Options>> for Views {
    /// Views with these options, where they stand. No places are without one.
    fn from(places: Place<Options>) -> Self {
        let mut open = BTreeMap::new();
        let layout = places.filter_map(&mut |options| {
            let id = ViewId(open.len() as u32 + 1);
            open.insert(id, options.clone());
            Some(id)
        });
        layout.map_or_else(Self::default, |layout| Self {
            layout,
            open,
            closed: BTreeMap::new(),
        })
    }
}

impl Views {
    /// A ready layout, with the options that its views have at first.
    #[must_use]
    pub fn ready(ready: &ReadyLayout) -> Self {
        let views = (ready.layout)().filter_map(&mut |id| find(id).ok().map(Options::of));
        views.map_or_else(
            || unreachable!("a ready layout has views, which are of the list"),
            Self::from,
        )
    }

    /// Where they stand.
    #[must_use]
    pub fn layout(&self) -> &Layout {
        &self.layout
    }

    /// Where their options stand.
    pub(super) fn places(&self) -> Option<Place<&Options>> {
        self.layout.filter_map(&mut |id| self.open.get(id))
    }

    /// The options of closed views, by the ids of their kinds.
    pub(super) fn closed(&self) -> &BTreeMap<&'static str, Options> {
        &self.closed
    }

    /// The views, from the left and from the top.
    #[must_use]
    pub fn ids(&self) -> Vec<ViewId> {
        self.layout.views().into_iter().copied().collect()
    }

    /// One of them: the first one opened.
    #[must_use]
    pub fn any(&self) -> ViewId {
        let first = self.open.first_key_value();
        first.map_or(ViewId(1), |(id, _)| *id)
    }

    /// The options of all views, those of closed ones last.
    pub(super) fn iter(&self) -> impl Iterator<Item = &Options> {
        self.open.values().chain(self.closed.values())
    }

    /// What a view shows and how; `None` where there is none of this number.
    #[must_use]
    pub fn get(&self, id: ViewId) -> Option<&Options> {
        self.open.get(&id)
    }

    /// What a view shows and how, to be changed.
    pub fn get_mut(&mut self, id: ViewId) -> Option<&mut Options> {
        self.open.get_mut(&id)
    }

    /// The kind of a view.
    #[must_use]
    pub fn kind(&self, id: ViewId) -> Option<&'static ViewKind> {
        self.get(id).map(Options::kind)
    }

    /// How many of its kind were opened before a view.
    fn rank(&self, id: ViewId, kind: &ViewKind) -> usize {
        let before = self.open.range(..id).map(|(_, options)| options.kind().id);
        before.filter(|other| *other == kind.id).count()
    }

    /// The name of a view at the screen: that of its kind, with a number where others of the kind were opened before.
    #[must_use]
    pub fn title(&self, id: ViewId) -> String {
        let named = |kind: &'static ViewKind| match self.rank(id, kind) {
            0 => kind.title.to_owned(),
            before => format!("{} {}", kind.title, before + 1),
        };
        self.kind(id).map_or_else(String::new, named)
    }

    /// The name of a file of a view, without its end.
    #[must_use]
    pub fn file_name(&self, id: ViewId) -> String {
        let named = |kind: &'static ViewKind| match self.rank(id, kind) {
            0 => kind.id.to_owned(),
            before => format!("{}-{}", kind.id, before + 1),
        };
        self.kind(id).map_or_else(String::new, named)
    }

    /// The first view of a kind.
    #[must_use]
    pub fn first(&self, kind: &ViewKind) -> Option<ViewId> {
        let is_it = |id: &ViewId| self.kind(*id).is_some_and(|other| other.id == kind.id);
        self.ids().into_iter().find(is_it)
    }

    /// The options of the first view of a kind; where none is open, those of the one closed last, or else those that it has at
    /// first.
    #[must_use]
    pub fn options<T: OfKind>(&self) -> T {
        let open = self.first(T::KIND).and_then(|id| self.get(id));
        let found = open.or_else(|| self.closed.get(T::KIND.id));
        found.and_then(T::among).cloned().unwrap_or_default()
    }

    /// The options of all open views of a kind.
    #[must_use]
    pub fn all<T: OfKind>(&self) -> Vec<&T> {
        self.open.values().filter_map(T::among).collect()
    }

    /// Changes the options of the first view of a kind; where none is open, those of the next that is opened.
    pub fn first_of<T: OfKind>(&mut self, change: impl FnOnce(&mut T)) {
        let mut options: T = self.options();
        change(&mut options);
        match self.first(T::KIND) {
            Some(id) => {
                self.open.insert(id, options.into());
            }
            None => self.put_away(options.into()),
        }
    }

    /// Changes the options of every view of a kind, those of the next that is opened too.
    pub fn each<T: OfKind>(&mut self, change: impl Fn(&mut T)) {
        let mut next = self.closed.remove(T::KIND.id);
        if self.first(T::KIND).is_none() {
            next = next.or_else(|| Some(T::default().into()));
        }
        for options in self.open.values_mut().chain(&mut next) {
            if let Some(options) = T::among_mut(options) {
                change(options);
            }
        }
        if let Some(options) = next {
            self.put_away(options);
        }
    }

    /// A number that no view has.
    fn unused(&self) -> ViewId {
        let last = self.open.last_key_value();
        ViewId(last.map_or(1, |(ViewId(number), _)| number + 1))
    }

    /// Keeps the options of a view that is closed, for the next one of its kind.
    pub(super) fn put_away(&mut self, options: Options) {
        let kind = options.kind();
        if options == Options::of(kind) {
            self.closed.remove(kind.id);
        } else {
            self.closed.insert(kind.id, options);
        }
    }

    /// The options of a view of this kind that is opened: those of the one closed last, else those of one that is open.
    fn take(&mut self, kind: &ViewKind) -> Options {
        let closed = self.closed.remove(kind.id);
        let open = || self.first(kind).and_then(|id| self.get(id)).cloned();
        closed.or_else(open).unwrap_or_else(|| Options::of(kind))
    }

    /// Lets views stand as `layout` has them. Those that it has not are closed.
    pub fn arrange(&mut self, layout: &Layout) {
        let known = layout.filter_map(&mut |id| self.open.contains_key(id).then_some(*id));
        let Some(layout) = known else { return };
        let left: Vec<ViewId> = self.ids();
        self.layout = layout;
        let stays = self.ids();
        // Of several of a kind that are closed together the first is the one to come back.
        for id in left.into_iter().rev().filter(|id| !stays.contains(id)) {
            if let Some(options) = self.open.remove(&id) {
                self.put_away(options);
            }
        }
    }

    /// Goes over to a ready layout, fitted to a window with this room for views. Its views are those that are open, as far as
    /// there are any of their kinds.
    pub fn show_ready(&mut self, ready: &ReadyLayout, room: [f32; 2]) {
        let mut left = self.ids();
        let layout = (ready.layout)().fitted(room).filter_map(&mut |id| {
            let kind = find(id).ok()?;
            let is_it = |id: &ViewId| self.kind(*id).is_some_and(|other| other.id == kind.id);
            if let Some(index) = left.iter().position(is_it) {
                return Some(left.remove(index));
            }
            let (id, options) = (self.unused(), self.take(kind));
            self.open.insert(id, options);
            Some(id)
        });
        if let Some(layout) = layout {
            self.arrange(&layout);
        }
    }

    /// Lets them stand as they fit into a window with this room for views.
    pub fn fit(&mut self, room: [f32; 2]) {
        self.layout = self.layout.clone().turned_and_fitted(room);
    }

    /// Whether they stand as in a ready layout, or as that fits into this room.
    #[must_use]
    pub fn is_ready(&self, ready: &ReadyLayout, room: [f32; 2]) -> bool {
        let same = |id: &ViewId, kind: &&str| self.kind(*id).is_some_and(|own| own.id == *kind);
        let whole = (ready.layout)();
        self.layout.is_like(&whole, &same) || self.layout.is_like(&whole.fitted(room), &same)
    }

    /// Whether they are the views of a ready layout, wherever they stand.
    #[must_use]
    pub fn has_views_of(&self, ready: &ReadyLayout) -> bool {
        let mut own: Vec<&str> = self
            .ids()
            .iter()
            .filter_map(|id| self.kind(*id))
            .map(|kind| kind.id)
            .collect();
        let whole = (ready.layout)();
        let mut wanted: Vec<&str> = whole.views().into_iter().copied().collect();
        own.sort_unstable();
        wanted.sort_unstable();
        own == wanted
    }

    /// Whether another view can be opened.
    #[must_use]
    pub fn has_room(&self) -> bool {
        self.open.len() < MAX_VIEWS
    }

    /// Opens a view of this kind where there is most room, in a window with this room for views: as the one closed last was,
    /// or like one that is open.
    ///
    /// # Errors
    /// [`Error::Limit`] where there are too many.
    pub fn add(&mut self, kind: &ViewKind, room: [f32; 2]) -> Result<ViewId> {
        let mut layout = self.layout.clone();
        layout.put_into_largest(self.unused(), room);
        require_readable(&layout)?;
        let options = self.take(kind);
        Ok(self.opened(layout, options))
    }

    /// Opens another view like this one, beside it.
    ///
    /// # Errors
    /// [`Error::Limit`] where there are too many.
    pub fn duplicate(&mut self, id: ViewId) -> Result<ViewId> {
        let Some(options) = self.get(id).cloned() else {
            return Ok(id);
        };
        let mut layout = self.layout.clone();
        layout.put_beside(id, self.unused());
        require_readable(&layout)?;
        Ok(self.opened(layout, options))
    }

    fn opened(&mut self, layout: Layout, options: Options) -> ViewId {
        let id = self.unused();
        self.open.insert(id, options);
        self.layout = layout;
        id
    }

    /// Shows the first view of this kind alone, as pictures of one view do.
    pub fn show_alone(&mut self, kind: &ViewKind) -> ViewId {
        let id = self.first(kind).unwrap_or_else(|| {
            let options = self.take(kind);
            self.opened(self.layout.clone().with(self.unused()), options)
        });
        self.arrange(&Place::View(id));
        id
    }

    /// Checks every number of the options, and folds angles into their turn.
    pub(super) fn check_numbers(&mut self) -> std::result::Result<(), Refused> {
        self.open
            .values_mut()
            .chain(self.closed.values_mut())
            .try_for_each(|options| {
                options.check_whole()?;
                checked(options.numbers())
            })
    }

    /// Takes each number of the options that is not allowed from those `before`.
    pub(super) fn keep_allowed(&mut self, before: &Self) {
        for (id, options) in &mut self.open {
            keep_allowed(options, before.open.get(id));
        }
        for (kind, options) in &mut self.closed {
            keep_allowed(options, before.closed.get(kind));
        }
    }
}

/// Refuses a layout that no file could be read with.
fn require_readable(layout: &Layout) -> Result<()> {
    require_room(layout.views().len())?;
    let depth = layout.validate();
    depth.map_err(|problem| Error::parse("view", problem))
}

/// Refuses more views than there may be.
pub(super) fn require_room(count: usize) -> Result<()> {
    if count <= MAX_VIEWS {
        return Ok(());
    }
    Err(Error::Limit {
        what: "the number of views",
        value: count.to_string(),
        limit: format!("1 to {MAX_VIEWS}"),
    })
}

fn keep_allowed(options: &mut Options, before: Option<&Options>) {
    if !are_allowed(&options.numbers()) {
        let mut before = before.cloned();
        let before = before.as_mut().map(Options::numbers);
        keep(options.numbers(), &before.unwrap_or_default());
    }
}

#[cfg(test)]
mod tests;
