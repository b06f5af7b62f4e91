//! What is done to one view.

use egui::Context;

use super::App;
use bxdf_lab::analysis::Hold;
use bxdf_study::session::ViewId;
use bxdf_study::views::{Options, ViewKind};

impl App {
    /// The view that commands are about: the one last clicked into, else the first.
    #[must_use]
    pub fn current_view(&self) -> ViewId {
        let views = &self.session.views;
        let clicked = self.clicked.filter(|view| views.get(*view).is_some());
        clicked.unwrap_or_else(|| views.any())
    }

    /// The width and height of the room that the views had in the last frame, in points.
    #[must_use]
    pub fn room_of_views(&self) -> [f32; 2] {
        self.room_of_views.size().into()
    }

    /// Shows the four kinds of reflection, and says what has become of the materials.
    pub fn show_four_kinds(&mut self, ctx: &Context) {
        let room = self.room_of_views();
        self.session.show_four_kinds(room);
        let words =
            "The four kinds stand in place of your materials: Undo (Ctrl+Z) brings those back";
        self.say(words.to_owned(), ctx);
    }

    /// Gives the light or the viewer the focus, in the view that commands are about, or else in any that shows it.
    pub fn focus_direction(&mut self, of: Hold, ctx: &Context) {
        self.state.wish_focus(of, self.current_view());
        ctx.request_repaint();
    }

    /// Adds a view of this kind where there is most room.
    pub fn add_view(&mut self, kind: &ViewKind) {
        let room = self.room_of_views();
        let opened = self.session.views.add(kind, room);
        self.clicked = self.notice.report(opened).or(self.clicked);
    }

    /// Opens another view like this one, beside it.
    pub fn duplicate_view(&mut self, view: ViewId) {
        let opened = self.session.views.duplicate(view);
        self.clicked = self.notice.report(opened).or(self.clicked);
    }

    /// Whether the view that commands are about shows a section.
    #[must_use]
    pub fn is_current_cut(&self) -> bool {
        let mut options = self.session.views.get(self.current_view()).cloned();
        let section = options.as_mut().and_then(Options::own_section);
        section.is_some()
    }

    /// Gives a view a section of its own, or takes it away again.
    pub fn switch_own_section(&mut self, view: ViewId) {
        let mut options = self.session.views.get(view).cloned();
        if let Some(section) = options.as_mut().and_then(Options::own_section) {
            section.set(section.0.is_none(), &self.session);
        }
        if let (Some(options), Some(own)) = (options, self.session.views.get_mut(view)) {
            *own = options;
        }
    }
}
