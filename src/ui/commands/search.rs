//! The search of all that can be done at once: commands, views to add, arrangements, lessons and questions.

use egui::Context;

use super::command::Command;
use super::list::COMMANDS;
use crate::app::App;
use crate::widgets::hits::{self, Found, Known};
use crate::widgets::search::{Entry, Outcome, Search};
use bxdf_study::lessons::{Lesson, lessons, questions};
use bxdf_study::session::{READY_LAYOUTS, ReadyLayout};
use bxdf_study::views::{VIEWS, ViewKind};

/// Something that is found.
#[derive(Clone, Copy)]
pub enum Hit {
    /// A command.
    Command(&'static Command),
    /// A kind of view, to be added.
    View(&'static ViewKind),
    /// A ready arrangement.
    Ready(&'static ReadyLayout),
    /// A lesson, to be opened.
    Lesson(&'static Lesson),
    /// A question, to be opened.
    Question(&'static Lesson),
}

impl Hit {
    /// All there are: the commands first.
    fn all() -> impl Iterator<Item = Self> {
        let commands = COMMANDS.into_iter().map(Self::Command);
        let ready = READY_LAYOUTS.iter().map(Self::Ready);
        let lessons = lessons().iter().map(Self::Lesson);
        let questions = questions().iter().map(Self::Question);
        let views = VIEWS.iter().map(Self::View);
        commands
            .chain(ready)
            .chain(views)
            .chain(lessons)
            .chain(questions)
    }

    fn known(self) -> Known<'static> {
        let (name, texts) = match self {
            Self::Command(command) => (command.title, vec![command.group.title(), command.hint]),
            Self::View(view) => (view.title, vec!["View", "Add", view.what_you_see]),
            Self::Ready(ready) => (ready.name, vec!["Arrangement", ready.meaning]),
            Self::Lesson(lesson) | Self::Question(lesson) => {
                let keywords = lesson.keywords.iter().map(String::as_str);
                let texts = ["Learn", self.sort(), &lesson.summary];
                (
                    lesson.title.as_str(),
                    texts.into_iter().chain(keywords).collect(),
                )
            }
        };
        Known {
            names: vec![name],
            texts,
        }
    }

    fn entry(self, app: &App, ctx: &Context) -> Entry {
        let (title, hint) = match self {
            Self::Command(command) => {
                return Entry {
                    title: format!("{}: {}", command.group.title(), command.title_now(app)),
                    keys: command.first_keys(ctx).unwrap_or_default(),
                    hint: command.hint,
                    is_enabled: (command.is_enabled)(app),
                };
            }
            Self::View(view) => (format!("Add view: {}", view.title), view.what_you_see),
            Self::Ready(ready) => (format!("Arrangement: {}", ready.name), ready.meaning),
            Self::Lesson(lesson) | Self::Question(lesson) => {
                let title = format!("{}: {}", self.sort(), lesson.title);
                (title, lesson.summary.as_str())
            }
        };
        Entry {
            title,
            keys: String::new(),
            hint,
            is_enabled: !matches!(self, Self::View(_)) || app.session.views.has_room(),
        }
    }

    /// Does what was chosen.
    pub fn run(self, app: &mut App, ctx: &Context) {
        match self {
            Self::Command(command) => command.run_and_say(app, ctx),
            Self::View(view) => app.add_view(view),
            Self::Ready(ready) => {
                let room = app.room_of_views();
                app.session.views.show_ready(ready, room);
            }
            Self::Lesson(lesson) | Self::Question(lesson) => {
                app.open_lesson(lesson, 0);
                app.attend_step(ctx);
            }
        }
    }

    /// What sort of thing it is, in a word.
    fn sort(self) -> &'static str {
        match self {
            Self::Command(_) => "Command",
            Self::View(_) => "View",
            Self::Ready(_) => "Arrangement",
            Self::Lesson(_) => "Lesson",
            Self::Question(_) => "Question",
        }
    }
}

/// The window of `search`, while it goes on.
pub fn show(search: &mut Search, ctx: &Context, app: &App) -> Outcome<Hit> {
    search.show(ctx, found, |hit| hit.entry(app, ctx))
}

/// What `wanted` finds; all there is where nothing is wanted.
fn found(wanted: &str) -> Found<Hit> {
    hits::found(wanted, Hit::all(), Hit::known)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ids(wanted: &str) -> Vec<&'static str> {
        let found = found(wanted);
        let id = |hit: &Hit| match hit {
            Hit::Command(command) => command.id,
            Hit::View(view) => view.id,
            Hit::Ready(ready) => ready.name,
            Hit::Lesson(lesson) | Hit::Question(lesson) => lesson.id.as_str(),
        };
        found.listed().iter().map(id).collect()
    }

    #[test]
    fn all_words_must_be_found() {
        let learnt = lessons().len() + questions().len();
        let all = COMMANDS.len() + VIEWS.len() + READY_LAYOUTS.len() + learnt;
        assert_eq!(ids("").len(), all);
        assert_eq!(ids("save")[..3], ["save", "save_as", "save_with_data"]);
        assert_eq!(ids("save another"), ["save_as"]);
        assert_eq!(ids("  FILE  text session"), ["copy_session", "paste"]);
        // The title goes before the hints of commands that stand earlier in the list.
        assert_eq!(ids("undo")[0], "undo");
        assert_eq!(ids("sve")[0], "save");
        assert!(matches!(found("xyzzy"), Found::Nearest(_)));
    }

    /// Who looks for a picture does not know that it is called a view.
    #[test]
    fn views_and_arrangements_are_found_by_what_they_show() {
        assert_eq!(ids("integral")[0], "integral");
        assert_eq!(ids("fresnel")[0], "fresnel");
        assert_eq!(ids("compare")[0], "Compare");
        assert!(ids("brewster").contains(&"fresnel"));
        assert!(ids("add view").len() >= VIEWS.len());
    }

    #[test]
    fn lessons_and_questions_are_found_by_their_words() {
        assert!(ids("lambert").contains(&"06-lambert"));
        assert!(ids("why question").contains(&"01-why-one-over-pi"));
        let all = lessons().iter().chain(questions());
        assert!(
            all.map(|lesson| &lesson.id)
                .all(|id| ids("learn").contains(&id.as_str()))
        );
    }
}
