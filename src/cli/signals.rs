//! Signals that end the program while files are written.

use std::ffi::c_int;
use std::fs;
use std::sync::{Once, mpsc};

use signal_hook::consts::{SIGHUP, SIGINT, SIGQUIT, SIGTERM};
use signal_hook::iterator::Signals;
use signal_hook::low_level::emulate_default_handler;

use bxdf_study::store::abandon_partial;

/// The signals that end a program which does not care.
const ENDING: [c_int; 4] = [SIGINT, SIGTERM, SIGHUP, SIGQUIT];

/// From now on a signal that ends the program removes the pending files first.
pub(super) fn watch() {
    static START: Once = Once::new();
    START.call_once(|| {
        let (is_ready, ready) = mpsc::channel();
        let wait = move || {
            if let Ok(mut signals) = Signals::new(wanted()) {
                // Nobody listens where the program ends by itself.
                let _ = is_ready.send(());
                signals.forever().for_each(end);
            }
        };
        let thread = std::thread::Builder::new().name("signals".to_owned());
        // Where no thread can be had, no signal is caught: each ends the program as it did before.
        if thread.spawn(wait).is_ok() {
            let _ = ready.recv();
        }
    });
}

/// Removes the pending files and ends the program as if nobody had cared: whoever waits for it sees which signal did.
fn end(signal: c_int) {
    abandon_partial(|| drop(emulate_default_handler(signal)));
}

/// The signals to be caught, without those that whoever started the program had it ignore, as `nohup` does. What is ignored
/// is known on Linux only.
fn wanted() -> impl Iterator<Item = c_int> {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let ignored = status
        .lines()
        .find_map(|line| line.strip_prefix("SigIgn:"))
        .and_then(|digits| u64::from_str_radix(digits.trim(), 16).ok())
        .unwrap_or(0);
    ENDING
        .into_iter()
        .filter(move |signal| (ignored >> (signal - 1)) & 1 == 0)
}
