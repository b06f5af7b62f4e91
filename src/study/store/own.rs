//! The session that the program keeps by itself, from one run to the next.

use std::io;
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, TryRecvError};

use super::files::Held;
use super::place::{Places, backup};
use crate::parallel::Pool;
use crate::session::Session;
use bxdf::error::{Error, Result};

/// How long an edit may stay unsaved, in seconds: what a crash costs at most.
pub(super) const DELAY: f64 = 1.0;

/// After how many seconds a failure is followed by another try, and after how many at most: the wait doubles.
const RETRIES: [f64; 2] = [2.0, 60.0];

/// How often it is looked whether the session is written, in seconds.
const POLL: f64 = 0.1;

/// The most windows that keep a session each.
const MOST_WINDOWS: u32 = 9;

/// What a run begins with.
#[derive(Debug)]
pub struct Restored {
    /// The session to go on with.
    pub session: Session,
    /// What there is to say of it, line by line: what could not be read, what is shown instead.
    pub said: Vec<String>,
}

/// How keeping the session went.
#[derive(Debug, Default)]
pub struct Keeping {
    /// After how many seconds it has to be asked again.
    pub again: Option<f64>,
    /// What is new.
    pub news: Option<News>,
}

/// What is new of a session that is kept.
#[derive(Debug)]
pub enum News {
    /// It could not be written; that is tried again.
    Failed(Error),
    /// It is written, which failed before.
    Recovered,
    /// What stood in its place could not be read, and has this name now.
    SetAside(PathBuf),
}

/// The session of the program's own.
#[derive(Default)]
pub(super) struct Own {
    place: Option<Place>,
    /// The session as it was last kept for the next run, or as this run began with it.
    kept: Option<Session>,
    /// When the session was first seen to differ from it, in the time of the window.
    changed_at: Option<f64>,
    failure: Option<Failure>,
    writing: Option<Writing>,
    /// What it is written by: a disk that is busy takes seconds to have it.
    pub(super) pool: Pool,
}

/// A session that is being written.
struct Writing {
    session: Session,
    answer: Receiver<Result<Option<PathBuf>>>,
}

/// The file of the session, which no other window has.
struct Place {
    path: PathBuf,
    /// Which window this is, counted from 1.
    number: u32,
    /// Held until the program ends, by the system itself; `None` where it knows no locks.
    _lock: Option<Held>,
}

/// What went wrong last.
struct Failure {
    text: String,
    wait: f64,
    next: f64,
}

impl Own {
    /// The file of the session in `folder`: the first one that no other window has; `None` where there are too many.
    fn claim(&mut self, places: &Places, folder: &Path) -> Option<&Place> {
        if self.place.is_none() {
            // Where the folder cannot be made, writing the session will say so.
            let _ = places.files.make_folder(folder);
            self.place = (1..=MOST_WINDOWS).find_map(|number| {
                let name = match number {
                    1 => "session".to_owned(),
                    _ => format!("session-{number}"),
                };
                let lock = match places.files.lock(&folder.join(format!("{name}.lock"))) {
                    Ok(None) => return None,
                    Ok(lock) => lock,
                    Err(_) => None,
                };
                Some(Place {
                    path: folder.join(format!("{name}.toml")),
                    number,
                    _lock: lock,
                })
            });
        }
        self.place.as_ref()
    }

    /// The session of the last run, or the one before it where that cannot be read, or `start` where there is none.
    pub(super) fn restore(&mut self, places: &Places, folder: &Path, start: Session) -> Restored {
        let mut said = Vec::new();
        let Some(place) = self.claim(places, folder) else {
            said.push(format!(
                "{MOST_WINDOWS} windows are open: this one keeps no session for the next start"
            ));
            self.kept = Some(start.clone());
            return Restored {
                session: start,
                said,
            };
        };
        // Its backup stands beside the file itself, where a link leads to it.
        let behind = places.files.behind_links(&place.path);
        let path = behind.unwrap_or_else(|_| place.path.clone());
        if place.number > 1 {
            said.push(format!(
                "Another window is open: this one keeps a session of its own, {}",
                name(&path)
            ));
        }
        let (mut unread, mut found) = (Vec::new(), None);
        for path in [path.clone(), backup(&path)] {
            match places.read(&path) {
                Ok(opened) => {
                    found = Some((path, opened));
                    break;
                }
                Err(Error::Io { source, .. }) if source.kind() == io::ErrorKind::NotFound => {}
                Err(error) => unread.push((path, error)),
            }
        }
        for (path, error) in &unread {
            said.push(format!("The session cannot be read: {error}"));
            if let Ok(aside) = places.aside(path) {
                said.push(format!(
                    "It is left as it is until you change something, then kept as {}",
                    name(&aside)
                ));
            }
        }
        if !unread.is_empty() {
            said.push(match &found {
                Some((path, _)) => format!("The session before it is shown: {}", name(path)),
                None => "There is no readable one before it: this is a new session".to_owned(),
            });
        }
        let session = match found {
            Some((_, opened)) => {
                said.extend(opened.remarks());
                opened.into_session()
            }
            None => start,
        };
        self.kept = Some(session.clone());
        Restored { session, said }
    }

    /// Keeps the session a moment after it has changed; `now` in seconds.
    pub(super) fn keep(
        &mut self,
        places: &Places,
        folder: &Path,
        session: &Session,
        now: f64,
    ) -> Keeping {
        if let Some(keeping) = self.take_written(session, now) {
            return keeping;
        }
        if self.kept.as_ref() == Some(session) {
            self.changed_at = None;
            let news = self.failure.take().map(|_| News::Recovered);
            return Keeping { again: None, news };
        }
        let changed_at = *self.changed_at.get_or_insert(now);
        let failed_before = self.failure.as_ref();
        let due = failed_before.map_or(changed_at + DELAY, |failure| failure.next);
        if due > now {
            return Keeping {
                again: Some(due - now),
                news: None,
            };
        }
        let Some(path) = self.claim(places, folder).map(|place| place.path.clone()) else {
            return Keeping::default();
        };
        let (places, folder, kept) = (places.clone(), folder.to_owned(), session.clone());
        let write = move || write(&places, &folder, &path, &kept);
        self.writing = Some(Writing {
            session: session.clone(),
            answer: self.pool.wait_for(write, || {}),
        });
        self.take_written(session, now).unwrap_or(Keeping {
            again: Some(POLL),
            news: None,
        })
    }

    /// Takes what has become of the writing that was begun, while the session is this one; `None` where none was.
    fn take_written(&mut self, session: &Session, now: f64) -> Option<Keeping> {
        let writing = self.writing.take()?;
        let written = match writing.answer.try_recv() {
            Ok(written) => written,
            Err(TryRecvError::Empty) => {
                self.writing = Some(writing);
                return Some(Keeping {
                    again: Some(POLL),
                    news: None,
                });
            }
            Err(TryRecvError::Disconnected) => return None,
        };
        let is_another = writing.session != *session;
        let keeping = self.written(writing.session, written, now);
        Some(Keeping {
            again: keeping.again.or(is_another.then_some(0.0)),
            ..keeping
        })
    }

    /// Takes note of what has become of writing `session`.
    fn written(&mut self, session: Session, written: Result<Option<PathBuf>>, now: f64) -> Keeping {
        match written {
            Ok(aside) => {
                self.kept = Some(session);
                self.changed_at = None;
                let recovered = self.failure.take().map(|_| News::Recovered);
                Keeping {
                    again: None,
                    news: aside.map(News::SetAside).or(recovered),
                }
            }
            Err(error) => {
                let [first, most] = RETRIES;
                let before = self.failure.take();
                let wait = before
                    .as_ref()
                    .map_or(first, |before| most.min(2.0 * before.wait));
                let text = error.to_string();
                let is_new = before.is_none_or(|before| before.text != text);
                self.failure = Some(Failure {
                    text,
                    wait,
                    next: now + wait,
                });
                Keeping {
                    again: Some(wait),
                    news: is_new.then_some(News::Failed(error)),
                }
            }
        }
    }

    /// Keeps the session at once, unless it is kept already. Returns the name of what was set aside.
    pub(super) fn keep_now(
        &mut self,
        places: &Places,
        folder: &Path,
        session: &Session,
    ) -> Result<Option<PathBuf>> {
        // One that is being written comes to its end first.
        if let Some(Writing { session, answer }) = self.writing.take()
            && let Ok(Ok(_)) = answer.recv()
        {
            self.kept = Some(session);
        }
        if self.kept.as_ref() == Some(session) {
            return Ok(None);
        }
        let Some(place) = self.claim(places, folder) else {
            return Ok(None);
        };
        let path = place.path.clone();
        let aside = write(places, folder, &path, session)?;
        self.kept = Some(session.clone());
        self.changed_at = None;
        Ok(aside)
    }
}

/// Writes `session` to the file at `path` in `folder`. Returns the name of what was set aside.
fn write(
    places: &Places,
    folder: &Path,
    path: &Path,
    session: &Session,
) -> Result<Option<PathBuf>> {
    let made = places.files.make_folder(folder);
    made.map_err(|error| Error::io(folder, error))?;
    places.replace(path, session)
}

/// The name of a file, to be said.
fn name(path: &Path) -> std::borrow::Cow<'_, str> {
    path.file_name().unwrap_or_default().to_string_lossy()
}
