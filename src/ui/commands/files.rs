//! The commands of files and of the clipboard.

use egui::{Key, ViewportCommand};

use super::command::{CTRL, CTRL_ALT, CTRL_SHIFT, Command, Group, command, key};
use crate::app::App;

/// Begins anew.
pub static NEW: Command = command(
    Group::File,
    [
        "new",
        "New session",
        "Start a new session; undo brings this one back",
    ],
    &[key(CTRL, Key::N)],
    App::start_anew,
);

/// Opens a file.
pub static OPEN: Command = Command {
    is_enabled: App::has_files,
    ..command(
        Group::File,
        [
            "open",
            "Open…",
            "Open a session in place of this one, or a material or its data beside the others; files can also be dropped on the window",
        ],
        &[key(CTRL, Key::O)],
        |app, _| app.ask_open(),
    )
};

/// Saves to the file of the session.
pub static SAVE: Command = Command {
    is_enabled: App::has_files,
    ..command(
        Group::File,
        ["save", "Save", "Save the session to its file"],
        &[key(CTRL, Key::S)],
        |app, _| app.save(),
    )
};

/// Saves to another file.
pub static SAVE_AS: Command = Command {
    is_enabled: App::has_files,
    ..command(
        Group::File,
        ["save_as", "Save as…", "Save the session to another file"],
        &[key(CTRL_SHIFT, Key::S)],
        |app, _| app.ask_save(),
    )
};

/// Saves to a file that needs no other.
pub static SAVE_WITH_DATA: Command = Command {
    is_enabled: App::has_files,
    ..command(
        Group::File,
        [
            "save_with_data",
            "Save with data…",
            "Save the session to a file with all data in it: it opens the same where the files of the data are missing",
        ],
        &[key(CTRL_ALT, Key::S)],
        |app, _| app.ask_save_with_data(),
    )
};

/// Copies the session.
pub static COPY_SESSION: Command = command(
    Group::File,
    [
        "copy_session",
        "Copy session as text",
        "Copy everything on the screen, data included, as one text that restores it where it is pasted",
    ],
    &[key(CTRL_SHIFT, Key::C)],
    App::copy_session,
);

/// Copies a link to what is on the screen.
pub static COPY_LINK: Command = command(
    Group::File,
    [
        "copy_link",
        "Copy link",
        "Copy everything on the screen as a link: a page in a browser shows it, and so does this window where it is pasted",
    ],
    &[key(CTRL_SHIFT, Key::K)],
    App::copy_link,
);

/// Asks for the address that links begin with.
pub static PAGE: Command = Command {
    is_enabled: App::has_page_to_choose,
    ..command(
        Group::File,
        [
            "page",
            "Address of the page…",
            "Set the address that links begin with: where the page of this program is hosted",
        ],
        &[key(CTRL_ALT, Key::K)],
        |app, _| app.ask_page(),
    )
};

/// Pastes what is in the clipboard.
pub static PASTE: Command = command(
    Group::File,
    [
        "paste",
        "Paste",
        "Add the material in the clipboard (id:name=value,name=value, or the text of a file), or switch to its session",
    ],
    &[key(CTRL, Key::V)],
    |_, ctx| ctx.send_viewport_cmd(ViewportCommand::RequestPaste),
);

/// Lets a person choose a figure of the view last clicked into.
pub static FIGURE: Command = Command {
    is_enabled: App::has_files,
    ..command(
        Group::File,
        [
            "figure",
            "Export figure…",
            "Export the view last clicked as a figure for a slide, a column of print or a page of the web",
        ],
        &[key(CTRL, Key::E)],
        |app, _| app.choose_figure(app.current_view()),
    )
};

/// Copies the figure of the view last clicked into.
pub static COPY_PICTURE: Command = Command {
    is_enabled: App::has_files,
    ..command(
        Group::File,
        [
            "copy_picture",
            "Copy picture",
            "Copy the view last clicked as a picture, as figures were made last",
        ],
        &[key(CTRL_ALT, Key::C)],
        |app, ctx| app.copy_picture(app.current_view(), ctx),
    )
};
