//! Looking for data that materials wait for: files that a text names, and what is to be baked again.

use std::path::Path;
use std::sync::mpsc::TryRecvError;

use egui::Context;

use super::App;
use bxdf::error::{Error, Result};
use bxdf::material;
use bxdf::resource::{Content, Origin, ReadFile};
use bxdf::{ParamSpec, Resource};

/// What is found for `resource`.
fn found(spec: &ParamSpec, mut resource: Resource, read: ReadFile<'_>) -> Content {
    material::data::fetch(spec, &mut resource, read);
    resource.content().clone()
}

impl App {
    /// Shows the data that was found, and begins to look for what else is awaited.
    pub(crate) fn fetch_data(&mut self, ctx: &Context) {
        let mut still = Vec::new();
        for (awaited, answer) in std::mem::take(&mut self.fetches) {
            match answer.try_recv() {
                Ok(content) => self.take_data(&awaited, &content),
                Err(TryRecvError::Empty) => still.push((awaited, answer)),
                Err(TryRecvError::Disconnected) => {
                    let content = Content::Missing("it could not be made".into());
                    self.take_data(&awaited, &content);
                }
            }
        }
        self.fetches = still;
        for (spec, awaited) in self.session.awaited() {
            if self.fetches.iter().all(|(other, _)| *other != awaited) {
                self.start_fetch(spec, awaited, ctx);
            }
        }
    }

    fn start_fetch(&mut self, spec: &'static ParamSpec, awaited: Resource, ctx: &Context) {
        let reader = self.files.as_ref().map(|files| files.store.data_reader());
        let read = move |path: &Path| -> Result<Vec<u8>> {
            let no_files = || Error::io(path, std::io::ErrorKind::Unsupported.into());
            reader
                .as_ref()
                .map_or_else(|| Err(no_files()), |read| read(path))
        };
        let (resource, wake) = (awaited.clone(), ctx.clone());
        let find = move || found(spec, resource, &read);
        let wake = move || wake.request_repaint();
        let answer = match awaited.origin() {
            Origin::Baked(_) => self.pool.compute(find, wake),
            Origin::Inline | Origin::File(_) => self.pool.wait_for(find, wake),
        };
        self.fetches.push((awaited, answer));
        ctx.request_repaint();
    }

    /// Shows what was found, in every state that can be come back to: it is no edit.
    fn take_data(&mut self, awaited: &Resource, content: &Content) {
        let before: Vec<String> = self.session.problems().collect();
        self.session.take_data(awaited, content);
        self.history
            .change_all(|session| session.take_data(awaited, content));
        let mut problems: Vec<String> = self.session.problems().collect();
        problems.retain(|problem| !before.contains(problem));
        if !problems.is_empty() {
            self.notice.say_all(&problems);
        }
    }
}
