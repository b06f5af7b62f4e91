//! Starting again where the environment makes libraries complain.

use std::env;
use std::os::unix::process::CommandExt as _;
use std::path::Path;
use std::process::Command;

/// The variable that names the folder of the user's sockets. Where it is missing or relative, the Wayland library, which
/// graphics drivers ask for displays even where nothing is to be shown, complains on standard error each time.
const RUNTIME_FOLDER: &str = "XDG_RUNTIME_DIR";

/// What is named in its place: an absolute path at which there is no socket, and nothing to be removed afterwards.
const NOWHERE: &str = "/nonexistent";

/// The verbs that draw without a display.
const DRAWING: [&str; 2] = ["render", "export"];

/// Replaces the process by the same program with the same arguments, where its verb draws and the variable is missing; does
/// nothing where it is set, as it is the second time, or where the program cannot be started again.
///
/// Changing a variable of one's own process is not safe; the process, its streams and its exit code stay the same so.
pub(super) fn in_quiet_environment() {
    let mut words = env::args_os();
    let name = words.next();
    let words: Vec<_> = words.collect();
    let is_drawing = words
        .first()
        .is_some_and(|verb| DRAWING.iter().any(|drawing| verb == drawing));
    let is_set = env::var_os(RUNTIME_FOLDER).is_some_and(|folder| Path::new(&folder).is_absolute());
    let Ok(program) = env::current_exe() else {
        return;
    };
    if is_drawing && !is_set {
        let mut command = Command::new(program);
        command.args(words).env(RUNTIME_FOLDER, NOWHERE);
        if let Some(name) = name {
            command.arg0(name);
        }
        // It returns only where it failed. All is as before then, and only less quiet.
        let _ = command.exec();
    }
}
