//! Interrupts while a long file is written.

use std::os::unix::process::ExitStatusExt as _;
use std::path::Path;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::time::{Duration, Instant};

use super::{files_in, folder};

/// The longest that is waited for anything: a loaded machine starts the program in a second.
const PATIENCE: Duration = Duration::from_mins(1);

/// Runs the program so that it writes a file in `folder` for hours, with the signals treated as by default, since whoever
/// runs the tests may ignore some, but for what `treatment` says (options of `env`).
fn writing(folder: &Path, treatment: &[&str]) -> Child {
    Command::new("env")
        .arg("--default-signal")
        .args(treatment)
        .arg(env!("CARGO_BIN_EXE_brdf-explorer"))
        .args(["sample", "oren_nayar", "--wo", "30,0", "-n", "1000000000"])
        .arg("--out")
        .arg(folder.join("out.csv"))
        .stdin(Stdio::null())
        .spawn()
        .unwrap()
}

/// Waits until `is_so`.
fn wait_until(mut is_so: impl FnMut() -> bool) {
    let start = Instant::now();
    while !is_so() {
        assert!(start.elapsed() < PATIENCE, "waited in vain");
        std::thread::sleep(Duration::from_millis(10));
    }
}

/// Whether something of the file is on the disk.
fn is_begun(folder: &Path) -> bool {
    let sizes = std::fs::read_dir(folder).unwrap();
    sizes
        .flatten()
        .any(|entry| entry.metadata().is_ok_and(|found| found.len() > 0))
}

fn send(signal: &str, child: &Child) {
    let process = child.id().to_string();
    assert!(
        Command::new("kill")
            .args(["-s", signal, &process])
            .status()
            .unwrap()
            .success()
    );
}

fn ended(mut child: Child) -> ExitStatus {
    wait_until(|| child.try_wait().unwrap().is_some());
    child.wait().unwrap()
}

#[test]
fn nothing_is_left_of_a_file_that_is_interrupted() {
    for (signal, number) in [("INT", 2), ("TERM", 15), ("HUP", 1), ("QUIT", 3)] {
        let folder = folder("interrupted");
        let child = writing(&folder, &[]);
        wait_until(|| is_begun(&folder));
        send(signal, &child);
        // A shell calls it 128 more: 130, 143, 129, 131.
        assert_eq!(ended(child).signal(), Some(number), "{signal}");
        assert_eq!(files_in(&folder), [""; 0], "{signal}");
    }
}

#[test]
fn what_is_to_be_ignored_stays_ignored() {
    let folder = folder("ignored");
    let child = writing(&folder, &["--ignore-signal=HUP"]);
    wait_until(|| is_begun(&folder));
    send("HUP", &child);
    std::thread::sleep(Duration::from_millis(300));
    assert!(is_begun(&folder));
    send("TERM", &child);
    assert_eq!(ended(child).signal(), Some(15));
    assert_eq!(files_in(&folder), [""; 0]);
}
