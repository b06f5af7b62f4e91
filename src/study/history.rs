//! Undo and redo: the states that a session was in.

use std::collections::VecDeque;

use super::session::Session;

/// What tells a control of the window from the others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Control(pub u64);

/// How many steps can be undone. A session takes some ten kilobytes.
const STEPS: usize = 500;

/// The states before and after the present one. Looking around is no edit: the camera and the selection change nothing
/// that could be lost, so that they make no step.
pub struct History {
    past: VecDeque<Session>,
    present: Session,
    future: Vec<Session>,
    /// The control whose drag made the last step.
    control: Option<Control>,
}

impl History {
    /// Nothing to undo yet.
    #[must_use]
    pub fn new(session: &Session) -> Self {
        Self {
            past: VecDeque::new(),
            present: session.clone(),
            future: Vec::new(),
            control: None,
        }
    }

    /// Takes note of what a frame has made of the session. `control`: what is being dragged; all drags of one control in
    /// a row are one step.
    pub fn record(&mut self, session: &Session, control: Option<Control>) {
        if *session == self.present {
            return;
        }
        if is_edited(&self.present, session) {
            let is_continued = control.is_some() && control == self.control;
            if !is_continued {
                if self.past.len() == STEPS {
                    self.past.pop_front();
                }
                self.past.push_back(self.present.clone());
            }
            self.future.clear();
            self.control = control;
        }
        self.present.clone_from(session);
    }

    /// Changes every state alike: for what is no edit, as data that has come meanwhile.
    pub fn change_all(&mut self, mut change: impl FnMut(&mut Session)) {
        let states = self.past.iter_mut().chain(&mut self.future);
        states.chain([&mut self.present]).for_each(&mut change);
    }

    /// The state at the end of the last frame.
    #[must_use]
    pub fn present(&self) -> &Session {
        &self.present
    }

    /// Whether there is a step to undo.
    #[must_use]
    pub fn can_undo(&self) -> bool {
        !self.past.is_empty()
    }

    /// Whether there is a step to do again.
    #[must_use]
    pub fn can_redo(&self) -> bool {
        !self.future.is_empty()
    }

    /// Takes the session back by a step.
    pub fn undo(&mut self, session: &mut Session) {
        if let Some(before) = self.past.pop_back() {
            self.future
                .push(std::mem::replace(&mut self.present, before));
            self.show(session);
        }
    }

    /// Takes the session forward again by a step that was undone.
    pub fn redo(&mut self, session: &mut Session) {
        if let Some(after) = self.future.pop() {
            self.past
                .push_back(std::mem::replace(&mut self.present, after));
            self.show(session);
        }
    }

    /// The present state, seen as it is looked at now.
    fn show(&mut self, session: &mut Session) {
        self.control = None;
        self.present.camera = session.camera.clone();
        session.clone_from(&self.present);
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
        assert!(!history.can_undo());
        for expected in [10.0, 20.0] {
            history.redo(&mut session);
            assert_eq!(session.theta_deg, expected);
        }
        session.theta_deg = 45.0;
        history.record(&session, None);
        assert!(!history.can_redo(), "a new edit leaves nothing to redo");
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
        while history.can_undo() {
            history.undo(&mut session);
            steps += 1;
        }
        assert_eq!(steps, STEPS);
    }

    #[test]
    fn looking_around_is_no_step() {
        let (mut session, mut history) = edited(&[10.0], None);
        session.camera.zoom(2.0);
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
        let mut zoomed = Session::default().camera;
        zoomed.zoom(2.0);
        assert_eq!(session.camera, zoomed, "it stays where it is");
    }
}
