//! Sessions that older versions of the program wrote open and look as they did.

use std::fs;
use std::path::PathBuf;

use brdf_explorer::study::session::Session;

/// The stored sessions, by name: those of version 1 the program has written, but for the one by hand.
pub(super) fn stored() -> Vec<(String, Session)> {
    let files = fs::read_dir("tests/data/sessions").unwrap();
    let mut paths: Vec<PathBuf> = files.map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    let read = |path: PathBuf| {
        let text = fs::read_to_string(&path).unwrap();
        let session = Session::from_toml(&text, &path.display().to_string()).unwrap();
        let name = path.file_stem().unwrap().to_str().unwrap();
        (name.to_owned(), session)
    };
    paths.into_iter().map(read).collect()
}

#[test]
fn stored_sessions_are_read_and_written_as_they_are() {
    let all = stored();
    assert_eq!(all.len(), 4);
    for (name, session) in all {
        let text = session.to_toml().unwrap();
        assert_eq!(Session::from_toml(&text, &name).unwrap(), session, "{text}");
    }
}
