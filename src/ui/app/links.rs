//! Links: copying one to what is on the screen, and following one.

use egui::Context;

use super::App;
use super::linking::{self, Outcome};
use crate::widgets::saved::Saved;
use bxdf::error::Result;
use bxdf_study::lessons::Named;
use bxdf_study::link::{self, Linked};

impl App {
    /// Lets links begin with the address of a page; `None`: with nothing, as texts that are pasted.
    pub fn is_linked_from(&mut self, page: Option<String>) {
        self.links.page = page;
    }

    /// Copies a link to all that is on the screen, and says what is not in it.
    pub fn copy_link(&mut self, ctx: &Context) {
        let Some(made) = self.notice.report(link::to_session(&self.session)) else {
            return;
        };
        self.give_link(made.fragment, ctx);
        if !made.left_behind.is_empty() {
            let names = made.left_behind.join(", ");
            self.notice.say(&format!(
                "Not in the link: {names}. Whoever follows it drops the file there"
            ));
        }
    }

    /// Copies a link, and says so.
    pub(super) fn give_link(&mut self, fragment: String, ctx: &Context) {
        let page = self.links.page.clone().unwrap_or_default();
        let link = format!("{page}{fragment}");
        let mut said = format!("The link is in the clipboard, {} characters", link.len());
        if page.is_empty() {
            said += ": paste it here or in another window. File > Address of the page makes it one for browsers";
        }
        self.saved = Some(Saved::done(&said));
        ctx.copy_text(link);
        self.links.made = Some(fragment);
    }

    /// The link that was made since this was asked last, from `#` on.
    pub fn take_made_link(&mut self) -> Option<String> {
        self.links.made.take()
    }

    /// Shows what a link leads to, from `#` on, which can be undone; where it leads nowhere all stays as it is.
    pub fn open_link(&mut self, fragment: &str, ctx: &Context) {
        match self.notice.report(link::read(fragment)) {
            Some(Linked::Session(opened)) => {
                self.take(Ok(opened), None);
                self.picker.close(ctx);
            }
            Some(Linked::Step(named)) => {
                let followed = self.follow_step(&named);
                self.notice.report(followed);
            }
            None => {}
        }
    }

    fn follow_step(&mut self, named: &str) -> Result<()> {
        let Named { lesson, step } = Named::listed(named)?;
        self.open_lesson(&lesson, step.unwrap_or(0));
        Ok(())
    }

    /// Whether it can be chosen where links lead: a page in a browser knows its own address.
    #[must_use]
    pub fn has_page_to_choose(&self) -> bool {
        !cfg!(target_arch = "wasm32")
    }

    /// Asks for the address of the page.
    pub fn ask_page(&mut self) {
        self.links.typed = Some(self.links.page.clone().unwrap_or_default());
    }

    /// Whether the address of the page is being typed.
    pub(super) fn is_asking_page(&self) -> bool {
        self.links.typed.is_some()
    }

    /// The field for the address of the page, while it is asked for.
    pub(crate) fn show_page_field(&mut self, ctx: &Context) {
        let Some(mut typed) = self.links.typed.take() else {
            return;
        };
        match linking::show_field(ctx, &mut typed) {
            Outcome::Open => self.links.typed = Some(typed),
            Outcome::Left => {}
            Outcome::Set => {
                let page = Some(typed.trim().to_owned()).filter(|page| !page.is_empty());
                if let Some(files) = &mut self.files {
                    files.store.keep_page(page.clone());
                }
                self.links.page = page;
            }
        }
    }

    /// Shows the one view that is first, or the lesson that is open, without anything around: within another page.
    pub fn embed(&mut self) {
        if self.is_learning() {
            self.zoom_before = Some(1.0);
        } else {
            self.only = Some(self.session.views.any());
        }
    }
}
