//! Undo and redo: the states that a session was in.

use std::collections::VecDeque;

use super::session::Session;
pub use edit::{Area, Edit};

mod edit;

/// What tells a control of the window from the others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Control(pub u64);

/// Which of the sessions that were on the screen a state is one of: what is opened or begun in place of a session is another.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Document(u64);

/// How many steps can be undone. A session takes some ten kilobytes.
const STEPS: usize = 500;

/// The states before and after the present one. What is selected is no edit. A move of the camera is a step, but none that takes
/// away what can be done again: then it is kept as it is.
pub struct History {
    past: VecDeque<Step>,
    present: Session,
    future: Vec<Step>,
    /// Which session the present state is one of.
    document: Document,
    /// Which one that of the next record is, where another has come.
    coming: Option<Document>,
    /// The last of them.
    last: Document,
    /// The control whose drag made the last step.
    control: Option<Control>,
}

/// A step to or from the present.
struct Step {
    /// The state that it leads to.
    state: Session,
    /// Which session that is one of.
    document: Document,
    /// What it changes.
    edit: Edit,
    /// Whether the camera is part of it; else it stays where it is.
    moves_camera: bool,
}

impl History {
    /// Nothing to undo yet.
    #[must_use]
    pub fn new(session: &Session) -> Self {
        Self {
            past: VecDeque::new(),
            present: session.clone(),
            future: Vec::new(),
            document: Document::default(),
            coming: None,
            last: Document::default(),
            control: None,
        }
    }

    /// Takes note of what a frame has made of the session. `control`: what is being dragged; all drags of one control in
    /// a row are one step.
    pub fn record(&mut self, session: &Session, control: Option<Control>) {
        let before = self.document;
        self.document = self.document();
        self.coming = None;
        if *session == self.present {
            return;
        }
        let has_edits = is_edited(&self.present, session);
        let is_look = !has_edits && session.camera != self.present.camera;
        if has_edits || is_look && self.future.is_empty() {
            let is_same = before == self.document;
            let is_continued = control.is_some() && control == self.control && is_same;
            if !is_continued {
                if self.past.len() == STEPS {
                    self.past.pop_front();
                }
                self.past
                    .push_back(Step::between(&self.present, before, session));
            } else if let Some(step) = self.past.pop_back() {
                self.past
                    .push_back(Step::between(&step.state, step.document, session));
            }
            self.future.clear();
            self.control = control;
        }
        self.present.clone_from(session);
    }

    /// Which session is on the screen. Undo and redo bring that of their state back.
    #[must_use]
    pub fn document(&self) -> Document {
        self.coming.unwrap_or(self.document)
    }

    /// Takes note that another session comes in place of this one, and returns which.
    pub fn replace(&mut self) -> Document {
        self.last = Document(self.last.0 + 1);
        self.coming = Some(self.last);
        self.last
    }

    /// Takes the session back to the state at the end of the last frame.
    pub fn refuse(&mut self, session: &mut Session) {
        session.clone_from(&self.present);
        self.coming = None;
    }

    /// Changes every state alike: for what is no edit, as data that has come meanwhile.
    pub fn change_all(&mut self, mut change: impl FnMut(&mut Session)) {
        let steps = self.past.iter_mut().chain(&mut self.future);
        let states = steps.map(|step| &mut step.state);
        states.chain([&mut self.present]).for_each(&mut change);
    }

    /// The state at the end of the last frame.
    #[must_use]
    pub fn present(&self) -> &Session {
        &self.present
    }

    /// What would be undone, if there is anything.
    #[must_use]
    pub fn undone(&self) -> Option<&Edit> {
        self.past.back().map(|step| &step.edit)
    }

    /// What would be done again, if there is anything.
    #[must_use]
    pub fn redone(&self) -> Option<&Edit> {
        self.future.last().map(|step| &step.edit)
    }

    /// Takes the session back by a step.
    pub fn undo(&mut self, session: &mut Session) {
        if let Some(step) = self.past.pop_back() {
            let back = self.go(step, session);
            self.future.push(back);
        }
    }

    /// Takes the session forward again by a step that was undone.
    pub fn redo(&mut self, session: &mut Session) {
        if let Some(step) = self.future.pop() {
            let back = self.go(step, session);
            self.past.push_back(back);
        }
    }

    /// Goes a step. Returns the one that leads back.
    fn go(&mut self, step: Step, session: &mut Session) -> Step {
        let Step {
            mut state,
            document,
            edit,
            moves_camera,
        } = step;
        if !moves_camera {
            state.camera = session.camera.clone();
        }
        self.control = None;
        self.coming = None;
        let left = std::mem::replace(&mut self.present, state);
        session.clone_from(&self.present);
        Step {
            state: left,
            document: std::mem::replace(&mut self.document, document),
            edit,
            moves_camera,
        }
    }
}

impl Step {
    /// The step back to `before`, a state of `document`, from `after`.
    fn between(before: &Session, document: Document, after: &Session) -> Self {
        Self {
            state: before.clone(),
            document,
            edit: Edit::between(before, after),
            moves_camera: before.camera != after.camera,
        }
    }
}

/// Whether more has changed than where one looks from and what is selected.
fn is_edited(before: &Session, after: &Session) -> bool {
    let mut seen = before.clone();
    seen.camera = after.camera.clone();
    seen.materials.select(after.materials.selected().id());
    seen != *after
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A session after some edits of theta, and its history.
    fn edited(thetas: &[f64], control: Option<Control>) -> (Session, History) {
        let mut session = Session::default();
        let mut history = History::new(&session);
        for theta in thetas {
            session.theta_deg = *theta;
            history.record(&session, control);
        }
        (session, history)
    }

    #[test]
    fn steps_are_undone_and_done_again() {
        let (mut session, mut history) = edited(&[10.0, 20.0, 30.0], None);
        for expected in [20.0, 10.0, 50.0, 50.0] {
            history.undo(&mut session);
            assert_eq!(session.theta_deg, expected);
        }
        assert!(history.undone().is_none());
        for expected in [10.0, 20.0] {
            history.redo(&mut session);
            assert_eq!(session.theta_deg, expected);
        }
        session.theta_deg = 45.0;
        history.record(&session, None);
        assert!(
            history.redone().is_none(),
            "a new edit leaves nothing to redo"
        );
    }

    #[test]
    fn a_session_in_place_of_another_is_another_document() {
        let (mut session, mut history) = edited(&[10.0], None);
        let first = history.document();
        let second = history.replace();
        session.theta_deg = 20.0;
        assert_eq!(history.document(), second, "before it is recorded too");
        history.record(&session, None);
        session.theta_deg = 30.0;
        history.record(&session, None);
        let mut seen = Vec::new();
        for _ in 0..3 {
            seen.push((session.theta_deg, history.document()));
            history.undo(&mut session);
        }
        assert_eq!(seen, [(30.0, second), (20.0, second), (10.0, first)]);
        history.redo(&mut session);
        history.redo(&mut session);
        assert_eq!((session.theta_deg, history.document()), (20.0, second));
        // What is refused has not come; what is the same in all has.
        session.theta_deg = 70.0;
        let third = history.replace();
        history.refuse(&mut session);
        assert_eq!((session.theta_deg, history.document()), (20.0, second));
        let fourth = history.replace();
        history.record(&session, None);
        assert_eq!(history.document(), fourth);
        assert!(third != fourth && history.redone().is_some());
    }

    #[test]
    fn drags_of_one_control_are_one_step() {
        let [a, b] = [1, 2].map(Control);
        let (mut session, mut history) = edited(&[10.0, 20.0, 30.0], Some(a));
        session.rotation_deg = 5.0;
        history.record(&session, Some(b));
        history.undo(&mut session);
        assert_eq!((session.theta_deg, session.rotation_deg), (30.0, 0.0));
        history.undo(&mut session);
        assert_eq!(session.theta_deg, 50.0);
    }

    #[test]
    fn hundreds_of_steps_are_kept_and_no_more() {
        let thetas: Vec<f64> = (0..700).map(|step| 0.1 * f64::from(step)).collect();
        let (mut session, mut history) = edited(&thetas, None);
        let mut steps = 0;
        while history.undone().is_some() {
            history.undo(&mut session);
            steps += 1;
        }
        assert_eq!(steps, STEPS);
    }

    #[test]
    fn what_is_selected_is_no_step() {
        let (mut session, mut history) = edited(&[10.0], None);
        let added = session.materials.add("phong".parse().unwrap()).unwrap();
        history.record(&session, None);
        let first = session.materials.iter().next().unwrap().id();
        session.materials.select(first);
        history.record(&session, None);
        history.undo(&mut session);
        let undone = &session.materials;
        assert!(undone.get(added).is_none() && session.theta_deg == 10.0);
        history.redo(&mut session);
        assert_eq!(session.materials.selected().id(), first);
    }

    #[test]
    fn a_move_of_the_camera_is_a_step_of_its_own_kind() {
        let (mut session, mut history) = edited(&[10.0], None);
        let home = session.camera.clone();
        for _ in 0..3 {
            session.camera.zoom(1.1);
            history.record(&session, Some(Control(1)));
        }
        let zoomed = session.camera.clone();
        assert_eq!(history.undone().unwrap().area, Area::Camera);
        session.theta_deg = 30.0;
        history.record(&session, None);
        // An edit leaves the camera where it is, a move of the camera what is edited.
        history.undo(&mut session);
        assert_eq!((session.theta_deg, &session.camera), (10.0, &zoomed));
        history.undo(&mut session);
        assert_eq!((session.theta_deg, &session.camera), (10.0, &home));
        history.redo(&mut session);
        assert_eq!((session.theta_deg, &session.camera), (10.0, &zoomed));
        // To look around takes nothing away of what can be done again.
        session.camera.orbit([50.0, 0.0]);
        history.record(&session, None);
        let turned = session.camera.clone();
        history.redo(&mut session);
        assert_eq!((session.theta_deg, &session.camera), (30.0, &turned));
    }
}
