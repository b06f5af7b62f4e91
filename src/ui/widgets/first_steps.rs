//! The first steps: captions over the views, each of which goes on once its step is done.

use egui::{Align2, Area, Context, Frame, Id, Order, Rect, Ui, vec2};

use super::small;
use crate::theme;
use bxdf::material::library;
use bxdf_study::session::Session;

/// A step: what to do and to see, and when it is done.
struct Step {
    text: &'static str,
    /// Whether the session shows that it is done; the other one is that of its beginning.
    is_done: fn(&Session, &Session) -> bool,
}

/// The steps: the light first, then one material of each category.
static STEPS: [Step; 5] = [
    Step {
        text: "Drag the round handle of the light: the lobe shows where its light goes",
        is_done: |now, before| now.held() != before.held(),
    },
    Step {
        text: "Press Change… on the left and choose chalk: a diffuse surface sends light everywhere",
        is_done: |now, _| shows(now, "chalk"),
    },
    Step {
        text: "Now brass: a glossy surface sends most of it near the mirror direction",
        is_done: |now, _| shows(now, "brass"),
    },
    Step {
        text: "Now the silvered mirror: it sends all of it into one direction, drawn as an arrow",
        is_done: |now, _| shows(now, "mirror"),
    },
    Step {
        text: "Now road sign: it sends light back to where it came from",
        is_done: |now, _| shows(now, "road_sign"),
    },
];

/// What is said when all are done.
const LAST: &str =
    "These are the four kinds of reflection. \"Four kinds\" at the top shows them side by side";

/// From the lower edge of the views, in points.
const ABOVE_EDGE: f32 = 44.0;

/// The least room at either side, in points.
const MARGIN: f32 = 12.0;

/// Where somebody is in the steps.
pub struct FirstSteps {
    index: usize,
    /// What was shown when the step began.
    before: Session,
}

/// Whether the selected material is the named one with this id.
fn shows(session: &Session, id: &str) -> bool {
    library::find(id).is_ok_and(|named| named.material == *session.material())
}

impl FirstSteps {
    /// The first of them, from what is shown now.
    #[must_use]
    pub fn begin(session: &Session) -> Self {
        Self {
            index: 0,
            before: session.clone(),
        }
    }

    /// The caption of the step that is to be done, over the `views`. Returns whether the steps are left.
    pub fn show(&mut self, ctx: &Context, views: Rect, session: &Session) -> bool {
        // A gesture is finished first: a caption that changes under the hand is not read.
        let is_idle = ctx.dragged_id().is_none();
        if let Some(step) = STEPS.get(self.index)
            && is_idle
            && (step.is_done)(session, &self.before)
        {
            self.index += 1;
            self.before = session.clone();
        }
        let step = STEPS.get(self.index);
        let text = step.map_or(LAST, |step| step.text);
        let mut is_left = false;
        Area::new(Id::unique("first steps"))
            .order(Order::Foreground)
            .pivot(Align2::CENTER_BOTTOM)
            .fixed_pos(views.center_bottom() + vec2(0.0, -ABOVE_EDGE))
            .show(ctx, |ui| {
                Frame::popup(ui.style()).show(ui, |ui| {
                    if views.width() < theme::SMALL_WINDOW.x {
                        ui.set_max_width(views.width() - 2.0 * MARGIN);
                        ui.label(text);
                        ui.horizontal(|ui| {
                            self.show_place(ui);
                            is_left = self.show_leave(ui);
                        });
                    } else {
                        ui.horizontal(|ui| {
                            self.show_place(ui);
                            ui.label(text);
                            is_left = self.show_leave(ui);
                        });
                    }
                });
            });
        is_left
    }

    /// The number of the step.
    fn show_place(&self, ui: &mut Ui) {
        if self.index < STEPS.len() {
            ui.weak(format!("{} of {}", self.index + 1, STEPS.len()));
        }
    }

    /// The button that leaves the steps. Returns whether it is clicked.
    fn show_leave(&self, ui: &mut Ui) -> bool {
        let word = if self.index < STEPS.len() {
            "Skip"
        } else {
            "Done"
        };
        let hint =
            "Leave the first steps: Shift+F1, or \"First steps\" in the search, brings them back";
        let button = ui.add(small::button(ui, word));
        button.on_hover_text(hint).clicked()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_step_is_done_by_what_it_says() {
        let mut session = Session::default();
        let before = session.clone();
        assert!(STEPS.iter().all(|step| !(step.is_done)(&session, &before)));
        session.set_theta_deg(20.0);
        assert!((STEPS[0].is_done)(&session, &before));
        for (step, id) in STEPS
            .iter()
            .skip(1)
            .zip(["chalk", "brass", "mirror", "road_sign"])
        {
            let named = library::find(id).unwrap();
            session
                .materials
                .selected_mut()
                .replace(named.material.clone());
            assert!((step.is_done)(&session, &before), "{id}");
            let name = named.material.name.to_lowercase();
            assert!(step.text.contains(&name), "{} names {name}", step.text);
        }
    }
}
