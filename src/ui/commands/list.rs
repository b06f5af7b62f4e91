//! The one list of commands, which buttons, menus, shortcuts, the search and the help make use of.

use egui::Key;

use super::command::{CTRL, CTRL_SHIFT, Command, Group, PLAIN, SHIFT, command, key, switched};
use super::directions::{LIGHT, VIEWER};
use super::edits::{PIN, REDO, UNDO};
use super::files::{
    COPY_LINK, COPY_PICTURE, COPY_SESSION, FIGURE, NEW, OPEN, PAGE, PASTE, SAVE, SAVE_AS,
    SAVE_WITH_DATA,
};
use super::learn::{COPY_STEP, LEARN, NEXT_STEP, STEP_BACK};
use crate::app::App;
use bxdf_lab::analysis::Hold;
use bxdf_study::session::{Curves, MAX_MATERIALS};

/// Adds the next choice of the picker.
pub static ADD: Command = Command {
    is_enabled: has_room,
    ..command(
        Group::Materials,
        [
            "add",
            "Add…",
            "Add the next model or material you pick, beside those there are",
        ],
        &[key(CTRL, Key::M)],
        App::start_adding,
    )
};

/// Replaces the selected material by the next choice of the picker.
pub static CHANGE: Command = command(
    Group::Materials,
    [
        "change",
        "Change…",
        "Choose another model or material in place of the selected one",
    ],
    &[key(CTRL_SHIFT, Key::M)],
    App::start_changing,
);

/// Duplicates the selected material.
pub static DUPLICATE: Command = Command {
    is_enabled: has_room,
    ..command(
        Group::Materials,
        [
            "duplicate",
            "Duplicate the selected material",
            "Add a copy to edit beside it",
        ],
        &[key(CTRL, Key::D)],
        |app, _| app.duplicate(),
    )
};

/// Removes the selected material.
pub static REMOVE: Command = Command {
    is_enabled: is_several,
    ..command(
        Group::Materials,
        [
            "remove",
            "Remove the selected material",
            "Remove it from the session; one is always left",
        ],
        &[key(CTRL, Key::Delete), key(CTRL, Key::Backspace)],
        |app, _| {
            let id = app.session.materials.selected().id();
            app.session.materials.remove(id);
        },
    )
};

/// Shows the selected material alone.
pub static SOLO: Command = Command {
    is_enabled: is_several,
    state: Some(|app| {
        let materials = &app.session.materials;
        let shown = materials.solo().and_then(|id| materials.get(id));
        let title = shown.map(|entry| materials.title(entry));
        title.map_or_else(
            || "Shown again: every material with a tick".to_owned(),
            |title| format!("Shown alone: {title}"),
        )
    }),
    ..command(
        Group::Materials,
        [
            "solo",
            "Show the selected material alone",
            "Hide all others, or show them again",
        ],
        &[key(PLAIN, Key::S)],
        |app, _| {
            let materials = &mut app.session.materials;
            let id = materials.selected().id();
            let is_alone = materials.solo() == Some(id);
            materials.set_solo((!is_alone).then_some(id));
        },
    )
};

/// Selects the material above.
pub static PREVIOUS: Command = Command {
    is_enabled: is_several,
    ..command(
        Group::Materials,
        [
            "previous",
            "Select the material above",
            "Edit the one before it in the list",
        ],
        &[key(CTRL, Key::ArrowUp)],
        |app, _| app.session.materials.select_neighbour(-1),
    )
};

/// Selects the material below.
pub static NEXT: Command = Command {
    is_enabled: is_several,
    ..command(
        Group::Materials,
        [
            "next",
            "Select the material below",
            "Edit the one after it in the list",
        ],
        &[key(CTRL, Key::ArrowDown)],
        |app, _| app.session.materials.select_neighbour(1),
    )
};

/// Holds the other direction.
pub static HOLD: Command = Command {
    state: Some(|app| format!("Fixed: {}", app.session.held_name())),
    ..command(
        Group::View,
        [
            "hold",
            "Fix the light or the viewer",
            "Switch between fixing the light and the viewer",
        ],
        &[key(PLAIN, Key::H)],
        |app, _| {
            app.session.set_hold(match app.session.hold {
                Hold::Light => Hold::Viewer,
                Hold::Viewer => Hold::Light,
            });
        },
    )
};

/// Changes between the radial scales.
pub static SCALE: Command = Command {
    state: Some(|app| switched("Logarithmic radius", app.session.views.is_logarithmic())),
    ..command(
        Group::View,
        [
            "scale",
            "Linear or logarithmic radius",
            "Switch between lengths proportional to f and lengths in decades",
        ],
        &[key(PLAIN, Key::L)],
        |app, _| {
            let views = &mut app.session.views;
            let is_logarithmic = views.is_logarithmic();
            views.each_scale(|scale| scale.set_logarithmic(!is_logarithmic));
        },
    )
};

/// Shows the four kinds of reflection side by side.
pub static FOUR_KINDS: Command = command(
    Group::View,
    [
        "four_kinds",
        "Four kinds",
        "Show diffuse, glossy, perfect specular and retro-reflective reflection side by side, in place of your materials, which undo brings back",
    ],
    &[key(CTRL, Key::Num4)],
    App::show_four_kinds,
);

/// Multiplies by the cosine, or does not.
pub static COSINE: Command = Command {
    state: Some(|app| switched(COSINE.title, app.session.with_cosine)),
    ..command(
        Group::View,
        [
            "cosine",
            "Times cos θ",
            "Show f |cos θ| of the free direction, or f alone",
        ],
        &[key(PLAIN, Key::C)],
        |app, _| app.session.with_cosine ^= true,
    )
};

/// Changes between luminance and channels.
pub static CURVES: Command = Command {
    is_enabled: |app| !app.session.materials.is_overlay(),
    state: Some(|app| switched("R, G and B", app.session.curves == Curves::Rgb)),
    ..command(
        Group::View,
        [
            "curves",
            "Luminance, or R, G and B",
            "Switch between one curve in the polar plot and three",
        ],
        &[key(PLAIN, Key::R)],
        |app, _| {
            app.session.curves = match app.session.curves {
                Curves::Luminance => Curves::Rgb,
                Curves::Rgb => Curves::Luminance,
            };
        },
    )
};

/// Draws the angles, or does not.
pub static ANGLES: Command = Command {
    state: Some(|app| switched(ANGLES.title, app.session.show_geometry)),
    ..command(
        Group::View,
        [
            "angles",
            "Angles of the fixed direction",
            "Show or hide theta, phi and the projection in the 3D lobe",
        ],
        &[key(PLAIN, Key::A)],
        |app, _| app.session.show_geometry ^= true,
    )
};

/// Opens another view like the one last clicked into.
pub static DUPLICATE_VIEW: Command = Command {
    is_enabled: |app| app.session.views.has_room(),
    ..command(
        Group::View,
        [
            "duplicate_view",
            "Duplicate the view",
            "Open a copy of the view last clicked, beside it, with settings of its own",
        ],
        &[key(CTRL_SHIFT, Key::D)],
        |app, _| app.duplicate_view(app.current_view()),
    )
};

/// Gives the view last clicked into a section of its own, or takes it away.
pub static OWN_SECTION: Command = Command {
    is_enabled: App::is_current_cut,
    ..command(
        Group::View,
        [
            "own_section",
            "Own section",
            "Give the view last clicked a section at an azimuth of its own, or the shared one again",
        ],
        &[key(CTRL_SHIFT, Key::E)],
        |app, _| app.switch_own_section(app.current_view()),
    )
};

/// Shows the views alone, large.
pub static PRESENT: Command = command(
    Group::View,
    [
        "present",
        "Present",
        "Show the views alone, with large labels, on the whole screen; Escape returns",
    ],
    &[key(PLAIN, Key::F5), key(PLAIN, Key::F11)],
    App::switch_presenting,
);

/// Makes the labels of plots larger, or normal again.
pub static LABELS: Command = Command {
    state: Some(|app| format!("Labels in plots: {} %", app.labels.percent())),
    ..command(
        Group::View,
        [
            "labels",
            "Size of labels in plots",
            "Make the labels of plots larger: 100, 125, 150 or 200 % of other text",
        ],
        &[key(CTRL_SHIFT, Key::L)],
        |app, _| app.labels = app.labels.next(),
    )
};

/// Folds the panel at the side, or unfolds it.
pub static FOLD: Command = command(
    Group::View,
    [
        "fold",
        "Fold the side panel",
        "Fold the panel at the side to icons, or unfold it",
    ],
    &[key(CTRL, Key::B)],
    App::fold_side,
);

/// Searches the commands.
pub static SEARCH: Command = command(
    Group::Help,
    [
        "search",
        "Search and commands",
        "Find a command by its name and run it",
    ],
    &[key(CTRL, Key::K), key(CTRL, Key::P)],
    App::start_search,
);

/// Begins the first steps, or leaves them.
pub static FIRST_STEPS: Command = command(
    Group::Help,
    [
        "first_steps",
        "First steps",
        "Show in five captions what to drag and what to choose, or leave them",
    ],
    &[key(SHIFT, Key::F1)],
    |app, _| app.switch_first_steps(),
);

/// Shows the help.
pub static HELP: Command = Command {
    state: Some(|app| switched(HELP.title, app.is_help_shown())),
    ..command(
        Group::Help,
        ["help", "Shortcuts", "Show what keys and the mouse do"],
        &[key(PLAIN, Key::F1), key(PLAIN, Key::Questionmark)],
        |app, _| app.show_help(),
    )
};

/// Every command, in the order of the menus and the help.
pub static COMMANDS: [&Command; 41] = [
    &NEW,
    &OPEN,
    &SAVE,
    &SAVE_AS,
    &SAVE_WITH_DATA,
    &FIGURE,
    &COPY_PICTURE,
    &COPY_SESSION,
    &COPY_LINK,
    &PAGE,
    &PASTE,
    &UNDO,
    &REDO,
    &PIN,
    &ADD,
    &CHANGE,
    &DUPLICATE,
    &REMOVE,
    &SOLO,
    &PREVIOUS,
    &NEXT,
    &HOLD,
    &SCALE,
    &FOUR_KINDS,
    &COSINE,
    &CURVES,
    &ANGLES,
    &DUPLICATE_VIEW,
    &OWN_SECTION,
    &LIGHT,
    &VIEWER,
    &PRESENT,
    &LABELS,
    &FOLD,
    &SEARCH,
    &LEARN,
    &NEXT_STEP,
    &STEP_BACK,
    &COPY_STEP,
    &FIRST_STEPS,
    &HELP,
];

fn has_room(app: &App) -> bool {
    app.session.materials.count() < MAX_MATERIALS
}

fn is_several(app: &App) -> bool {
    app.session.materials.count() > 1
}
