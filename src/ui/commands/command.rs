//! What a command is, and its buttons.

use egui::{Button, Context, Key, KeyboardShortcut, Modifiers, Ui, vec2};

use crate::app::App;

/// What a command is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Group {
    /// Files and the clipboard.
    File,
    /// The history.
    Edit,
    /// The list of materials.
    Materials,
    /// How things are shown.
    View,
    /// The program itself.
    Help,
}

impl Group {
    /// Every group, in the order of the help.
    pub const ALL: [Self; 5] = [
        Self::File,
        Self::Edit,
        Self::Materials,
        Self::View,
        Self::Help,
    ];

    /// Its name at the screen.
    #[must_use]
    pub fn title(self) -> &'static str {
        match self {
            Self::File => "File",
            Self::Edit => "Edit",
            Self::Materials => "Materials",
            Self::View => "View",
            Self::Help => "Help",
        }
    }
}

/// Something that can be done to the whole window.
pub struct Command {
    /// The id: a word that never changes.
    pub id: &'static str,
    /// The name at the screen.
    pub title: &'static str,
    /// What it does, in a sentence.
    pub hint: &'static str,
    /// What it is about.
    pub group: Group,
    /// The keys for it, the first of which is shown at buttons.
    pub shortcuts: &'static [KeyboardShortcut],
    /// Whether it can be done now.
    pub is_enabled: fn(&App) -> bool,
    /// Does it.
    pub run: fn(&mut App, &Context),
    /// How things are now that it changes, in a few words; for what one sees anyway there are none.
    pub state: Option<fn(&App) -> String>,
    /// Its name now, where that says what it would be done to.
    pub now: fn(&App) -> Option<String>,
}

pub(super) const CTRL: Modifiers = Modifiers::COMMAND;
pub(super) const CTRL_SHIFT: Modifiers = Modifiers::COMMAND.plus(Modifiers::SHIFT);
pub(super) const CTRL_ALT: Modifiers = Modifiers::COMMAND.plus(Modifiers::ALT);
pub(super) const SHIFT: Modifiers = Modifiers::SHIFT;
pub(super) const PLAIN: Modifiers = Modifiers::NONE;

pub(super) const fn key(modifiers: Modifiers, key: Key) -> KeyboardShortcut {
    KeyboardShortcut::new(modifiers, key)
}

/// A thing that is on or off.
pub(super) fn switched(what: &str, is_on: bool) -> String {
    format!("{what}: {}", if is_on { "on" } else { "off" })
}

/// A command that can always be done: the start from which the others differ.
pub(super) const fn command(
    group: Group,
    [id, title, hint]: [&'static str; 3],
    shortcuts: &'static [KeyboardShortcut],
    run: fn(&mut App, &Context),
) -> Command {
    Command {
        id,
        title,
        hint,
        group,
        shortcuts,
        is_enabled: |_| true,
        run,
        state: None,
        now: |_| None,
    }
}

impl Command {
    /// Does it, if it can be done now.
    pub fn try_run(&self, app: &mut App, ctx: &Context) {
        if (self.is_enabled)(app) {
            (self.run)(app, ctx);
        }
    }

    /// Does it, if it can be done now, and says what has become of it.
    pub fn run_and_say(&self, app: &mut App, ctx: &Context) {
        if !(self.is_enabled)(app) {
            app.say(format!("Not possible now: {}", self.title), ctx);
            return;
        }
        (self.run)(app, ctx);
        if let Some(state) = self.state {
            app.say(state(app), ctx);
        }
    }

    /// Its name in menus and in the search.
    #[must_use]
    pub fn title_now(&self, app: &App) -> String {
        (self.now)(app).unwrap_or_else(|| self.title.to_owned())
    }

    /// The keys for it, as the screen shows them; empty where it has none.
    #[must_use]
    pub fn keys(&self, ctx: &Context) -> String {
        let keys = self.shortcuts.iter().map(|keys| ctx.format_shortcut(keys));
        keys.collect::<Vec<_>>().join(" or ")
    }

    /// The first of the keys for it.
    #[must_use]
    pub fn first_keys(&self, ctx: &Context) -> Option<String> {
        let first = self.shortcuts.first();
        first.map(|shortcut| ctx.format_shortcut(shortcut))
    }

    /// What it does, with the first of the keys for it.
    #[must_use]
    pub fn hint(&self, ctx: &Context) -> String {
        self.with_keys(self.hint, ctx)
    }

    fn with_keys(&self, text: &str, ctx: &Context) -> String {
        self.first_keys(ctx)
            .map_or_else(|| text.to_owned(), |keys| format!("{text} ({keys})"))
    }

    /// A button for it. Returns whether it is clicked.
    pub fn button(&self, ui: &mut Ui, app: &App) -> bool {
        self.show(ui, app, Button::new(self.title))
    }

    /// A button for it that looks like the field that it opens, of this width in points. Returns whether it is clicked.
    pub fn field_button(&self, ui: &mut Ui, app: &App, width: f32) -> bool {
        let keys = self.first_keys(ui.ctx()).unwrap_or_default();
        let button = Button::new(self.title)
            .shortcut_text(keys)
            .truncate()
            .min_size(vec2(width, 0.0))
            .fill(ui.visuals().extreme_bg_color);
        ui.scope(|ui| {
            ui.set_max_width(width);
            self.show(ui, app, button)
        })
        .inner
    }

    /// A button for it that shows `icon` in place of its name. Returns whether it is clicked.
    pub fn icon(&self, ui: &mut Ui, app: &App, icon: &str) -> bool {
        self.show(ui, app, Button::new(icon))
    }

    /// An entry of a menu for it, which closes the menu. Returns whether it is clicked.
    pub fn menu_item(&self, ui: &mut Ui, app: &App) -> bool {
        let mut button = Button::new(self.title_now(app));
        if let Some(keys) = self.first_keys(ui.ctx()) {
            button = button.shortcut_text(keys);
        }
        let is_clicked = self.show(ui, app, button);
        if is_clicked {
            ui.close();
        }
        is_clicked
    }

    fn show(&self, ui: &mut Ui, app: &App, button: Button<'_>) -> bool {
        let hint = match (self.now)(app) {
            Some(now) => self.with_keys(&now, ui.ctx()),
            None => self.hint(ui.ctx()),
        };
        let is_enabled = (self.is_enabled)(app);
        let response = ui.add_enabled(is_enabled, button);
        // The keys beside the title are for the eye: the name is the title.
        response
            .widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, is_enabled, self.title));
        response
            .on_hover_text(&hint)
            .on_disabled_hover_text(hint)
            .clicked()
    }
}
