//! What is kept from one run to the next, and that nothing of it is lost.

use super::super::own::DELAY;
use super::*;

#[test]
fn the_session_is_kept_a_moment_after_it_changes() {
    let folder = Folder::new("kept");
    let mut store = folder.store();
    assert_eq!(
        store.restore(fresh()).session,
        fresh(),
        "nothing is there at first"
    );
    assert_eq!(
        store.keep(&fresh(), 0.0).again,
        None,
        "and nothing is edited"
    );
    assert_eq!(store.keep(&session(10.0), 5.0).again, Some(DELAY));
    assert_eq!(store.keep(&session(11.0), 5.75).again, Some(0.25));
    assert!(folder.names().is_empty());
    assert_eq!(store.keep(&session(12.0), 6.5).again, None);
    drop(store);
    assert_eq!(folder.restored(), (Some(session(12.0)), Vec::new()));
    keep(&folder, 13.0);
    assert_eq!(folder.names(), [LAST_SESSION, "session.toml.bak"]);
    let mut restored = folder.store();
    assert_eq!(restored.restore(fresh()).session, session(13.0));
    assert_eq!(restored.keep(&session(13.0), 0.0).again, None);
}

#[test]
fn without_a_folder_nothing_is_kept() {
    let mut store = Store::new(Arc::new(Disk), None);
    assert_eq!(store.keep(&session(1.0), 100.0).again, None);
    store.keep_now(&session(1.0)).unwrap();
    assert_eq!(store.restore(fresh()).session, fresh());
    assert!(store.recent().is_empty());
}

#[test]
fn a_killed_program_is_restored_from_what_is_left() {
    for works in 0..3 {
        let folder = Folder::new(&format!("killed-{works}"));
        keep(&folder, 10.0);
        keep(&folder, 20.0);
        let files = Failing::after(works, true);
        let mut killed = Store::new(Arc::new(files), Some(folder.0.clone()));
        assert!(killed.keep_now(&session(30.0)).is_err());
        drop(killed);
        assert_eq!(
            folder.restored(),
            (Some(session(20.0)), Vec::new()),
            "{works}"
        );
    }
}

/// Texts that no session is read from, with what is said of them.
fn unreadable() -> [(Vec<u8>, &'static str); 6] {
    let text = session(10.0).to_toml().unwrap();
    [
        (Vec::new(), "there is nothing in it"),
        (b"theta_deg = \"steep\"".to_vec(), "session.toml: line 1"),
        (
            text.replace("version = 3", "version = 4").into_bytes(),
            "a newer one is needed",
        ),
        (
            text.replace("\"polar\"", "\"polar\", flavour = 1")
                .into_bytes(),
            "unknown field `flavour`",
        ),
        (text.as_bytes()[..400].to_vec(), "the file is cut off"),
        (b"\x89PNG\xff".to_vec(), "no text"),
    ]
}

#[test]
fn what_is_left_out_at_the_start_is_said_and_the_rest_is_shown() {
    let folder = Folder::new("left-out");
    keep(&folder, 10.0);
    let path = folder.file(LAST_SESSION);
    let text = fs::read_to_string(&path).unwrap();
    fs::write(&path, text.replace("\"polar\"", "\"hologram\"")).unwrap();
    let Restored {
        session: shown,
        said,
    } = folder.store().restore(fresh());
    assert_eq!((shown.theta_deg, shown.views.ids().len()), (10.0, 1));
    assert!(said[0].contains("unknown view 'hologram'"), "{said:?}");
    assert_eq!(said.len(), 1);
}

#[test]
fn what_cannot_be_read_at_the_start_is_never_lost() {
    for (index, (bytes, expected)) in unreadable().into_iter().enumerate() {
        let folder = Folder::new(&format!("broken-{index}"));
        keep(&folder, 10.0);
        keep(&folder, 20.0);
        let path = folder.file(LAST_SESSION);
        fs::write(&path, &bytes).unwrap();
        let stands = |name: &str| fs::read(folder.file(name)).unwrap();
        let before = stands("session.toml.bak");
        // The backup is shown and said, and so is what becomes of the other one.
        let mut store = folder.store();
        let Restored {
            session: shown,
            said,
        } = store.restore(fresh());
        assert_eq!(shown, session(10.0));
        let said = said.join("\n");
        for part in [expected, "session.toml.bak", "session.toml.unreadable-1"] {
            assert!(said.contains(part), "{said}");
        }
        // Looking at it writes nothing, not even at the end.
        for now in [0.0, 10.0, 20.0] {
            assert_eq!(store.keep(&shown, now).again, None);
        }
        store.keep_now(&shown).unwrap();
        assert_eq!(stands(LAST_SESSION), bytes);
        assert_eq!(folder.names(), [LAST_SESSION, "session.toml.bak"]);
        // The first edit sets it aside; further ones touch neither it nor, at first, the backup.
        store.keep(&session(30.0), 30.0);
        let kept = store.keep(&session(30.0), 32.0);
        let Some(News::SetAside(aside)) = kept.news else {
            panic!("{kept:?}");
        };
        assert_eq!(aside, folder.file("session.toml.unreadable-1"));
        assert_eq!(stands("session.toml.bak"), before);
        store.keep_now(&session(40.0)).unwrap();
        store.keep_now(&session(50.0)).unwrap();
        assert_eq!(stands("session.toml.unreadable-1"), bytes);
        drop(store);
        assert_eq!(folder.restored(), (Some(session(50.0)), Vec::new()));
        // One more of them is set aside under another name, and so is a backup.
        fs::write(&path, &bytes).unwrap();
        fs::write(backup(&path), &bytes).unwrap();
        let (restored, said) = folder.restored();
        assert_eq!(restored, None);
        assert!(said.join("\n").contains("session.toml.unreadable-2"));
        keep(&folder, 60.0);
        keep(&folder, 70.0);
        for name in ["session.toml.unreadable-2", "session.toml.bak.unreadable-1"] {
            assert_eq!(stands(name), bytes);
        }
    }
}

#[test]
fn every_window_keeps_a_session_of_its_own() {
    let folder = Folder::new("windows");
    keep(&folder, 10.0);
    let mut first = folder.store();
    assert_eq!(first.restore(fresh()).session, session(10.0));
    let mut second = folder.store();
    let Restored {
        session: shown,
        said,
    } = second.restore(fresh());
    assert_eq!(shown, fresh());
    assert!(
        said.len() == 1 && said[0].contains("session-2.toml"),
        "{said:?}"
    );
    second.keep_now(&session(20.0)).unwrap();
    first.keep_now(&session(11.0)).unwrap();
    let mut third = folder.store();
    third.keep_now(&session(30.0)).unwrap();
    // Whoever comes next takes the first place that is free, without waiting.
    drop(first);
    assert_eq!(folder.restored(), (Some(session(11.0)), Vec::new()));
    drop((second, third));
    let mut next = folder.store();
    assert_eq!(next.restore(fresh()).session, session(11.0));
    let mut after = folder.store();
    assert_eq!(after.restore(fresh()).session, session(20.0));
    assert_eq!(
        fs::read_dir(&folder.0).unwrap().count(),
        7,
        "and no other file is left"
    );
}

#[test]
fn a_full_disk_is_said_once_and_tried_again_until_there_is_room() {
    let folder = Folder::new("full");
    let files = Failing::after(3, false);
    let mut store = Store::new(Arc::new(files.clone()), Some(folder.0.clone()));
    store.restore(fresh());
    store.keep_now(&session(10.0)).unwrap();
    files.works.store(0, Ordering::SeqCst);
    assert_eq!(store.keep(&session(20.0), 0.0).again, Some(DELAY));
    let failed = store.keep(&session(20.0), 1.0);
    assert!(matches!(failed.news, Some(News::Failed(_))), "{failed:?}");
    // With longer and longer waits, without a word more, and never more often than said.
    let (mut now, mut waits) = (1.0, Vec::new());
    let mut again = failed.again;
    for _ in 0..8 {
        let wait = again.unwrap();
        waits.push(wait);
        assert_eq!(
            store.keep(&session(20.0), now + 0.5 * wait).again,
            Some(0.5 * wait)
        );
        now += wait;
        let failed = store.keep(&session(20.0), now);
        assert!(failed.news.is_none());
        again = failed.again;
    }
    assert_eq!(waits, [2.0, 4.0, 8.0, 16.0, 32.0, 60.0, 60.0, 60.0]);
    assert!(store.keep_now(&session(20.0)).is_err(), "at the end, too");
    files.works.store(9, Ordering::SeqCst);
    let kept = store.keep(&session(20.0), now + 60.0);
    assert!(matches!(kept.news, Some(News::Recovered)) && kept.again.is_none());
    drop(store);
    assert_eq!(folder.restored().0, Some(session(20.0)));
}

#[test]
fn room_that_comes_before_the_end_is_used_at_the_end() {
    let folder = Folder::new("late");
    let files = Failing::after(0, false);
    let mut store = Store::new(Arc::new(files.clone()), Some(folder.0.clone()));
    store.restore(fresh());
    store.keep(&session(20.0), 0.0);
    assert!(store.keep(&session(20.0), 1.0).news.is_some());
    files.works.store(9, Ordering::SeqCst);
    store.keep_now(&session(20.0)).unwrap();
    drop(store);
    assert_eq!(folder.restored().0, Some(session(20.0)));
}

#[test]
fn a_thread_keeps_the_session_and_its_failures_are_said_and_tried_again() {
    let folder = Folder::new("threads");
    let files = Failing::after(0, false);
    let store = Store::new(Arc::new(files.clone()), Some(folder.0.clone()));
    let mut store = store.in_threads(Pool::new());
    store.restore(fresh());
    // Until there is news; the clock stands still meanwhile.
    let news = |store: &mut Store, now: f64| loop {
        let keeping = store.keep(&session(20.0), now);
        if keeping.news.is_some() {
            break keeping;
        }
        std::thread::sleep(std::time::Duration::from_millis(1));
    };
    store.keep(&session(20.0), 0.0);
    let failed = news(&mut store, 1.0);
    assert!(matches!(failed.news, Some(News::Failed(_))));
    files.works.store(9, Ordering::SeqCst);
    let kept = news(&mut store, 1.0 + failed.again.unwrap());
    assert!(matches!(kept.news, Some(News::Recovered)));
    // What is being written at the end comes to its end first.
    store.keep(&session(30.0), 20.0);
    store.keep(&session(30.0), 21.0);
    store.keep_now(&session(40.0)).unwrap();
    drop(store);
    assert_eq!(folder.restored().0, Some(session(40.0)));
    fs::remove_file(folder.file(LAST_SESSION)).unwrap();
    assert_eq!(folder.restored().0, Some(session(30.0)));
}

/// People keep their sessions elsewhere, under a link in the program's folder: it stays, and all is kept where it leads.
#[cfg(unix)]
#[test]
fn a_link_to_the_session_stays_one() {
    let folder = Folder::new("own-link");
    let elsewhere = folder.file("elsewhere");
    fs::create_dir_all(&elsewhere).unwrap();
    let [link, real] = [folder.file(LAST_SESSION), elsewhere.join("mine.toml")];
    std::os::unix::fs::symlink("elsewhere/mine.toml", &link).unwrap();
    for theta_deg in [10.0, 20.0, 30.0] {
        keep(&folder, theta_deg);
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        assert_eq!(folder.restored().0, Some(session(theta_deg)));
    }
    assert!(backup(&real).exists() && !backup(&link).exists());
    fs::write(&real, "no session").unwrap();
    assert_eq!(
        folder.restored().0,
        Some(session(20.0)),
        "the backup is found"
    );
}

/// Who edits the file by hand loses what is broken, and nothing else.
#[test]
fn one_broken_line_of_the_preferences_spoils_no_other() {
    let folder = Folder::new("preferences");
    let mut store = folder.store();
    store.keep_first_steps_seen();
    store.keep_labels(LabelSize::Double);
    drop(store);
    let path = folder.file(PREFERENCES);
    let text = fs::read_to_string(&path).unwrap();
    let broken = text.replace("\"double\"", "\"enormous\"");
    assert_ne!(broken, text);
    fs::write(&path, broken + "recent = 3\n").unwrap();
    let store = folder.store();
    assert!(store.has_seen_first_steps());
    assert_eq!(store.labels(), LabelSize::default());
}
