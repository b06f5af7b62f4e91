//! What a student has made of a question.

use super::ask::{Ask, Choice, Kind, Verdict, right_choice, typed_number};
use super::patch::Patch;
use super::scenes::Scenes;
use super::text::Span;
use crate::session::Session;

/// The work at a question.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Work {
    /// What stands in the field of a number.
    pub typed: String,
    /// The choice that was taken last.
    pub chosen: Option<usize>,
    /// How the last answer was.
    pub verdict: Option<Verdict>,
    /// How many hints are shown.
    pub hints: usize,
    /// Whether the answer was looked up.
    pub is_looked_up: bool,
}

impl Work {
    /// Whether the answer is read: the question is answered rightly, or its answer was looked up.
    #[must_use]
    pub fn is_revealed(&self) -> bool {
        self.is_looked_up || self.verdict == Some(Verdict::Right)
    }

    /// Answers with the choice at `index`.
    pub fn choose(&mut self, ask: &Ask, index: usize, scenes: &Scenes) {
        if let Kind::Choice(choices) = &ask.kind {
            self.chosen = Some(index);
            self.verdict = Some(match right_choice(choices, scenes) {
                Ok(right) => Verdict::from(right == index),
                Err(problem) => Verdict::Unreadable(problem),
            });
        }
    }

    /// Answers with what stands in the field.
    pub fn submit(&mut self, ask: &Ask, scenes: &Scenes) {
        if let Kind::Number(number) = &ask.kind {
            let graded = number.grade_text(&self.typed, scenes);
            self.verdict = Some(graded.unwrap_or_else(Verdict::Unreadable));
        }
    }

    /// Looks whether the state is reached that is asked for. Returns whether it is since now.
    pub fn look(&mut self, ask: &Ask, scenes: &Scenes) -> bool {
        let Kind::Reach(reach) = &ask.kind else {
            return false;
        };
        if self.is_revealed() || reach.until.holds(scenes) != Ok(true) {
            return false;
        }
        self.verdict = Some(Verdict::Right);
        true
    }

    /// Looks the answer up. Returns the state that shows it, where it is one that was to be reached.
    pub fn look_up(&mut self, ask: &Ask, scenes: &Scenes) -> Option<Patch> {
        self.is_looked_up = true;
        match &ask.kind {
            Kind::Choice(choices) => {
                self.chosen = right_choice(choices, scenes).ok();
                None
            }
            Kind::Number(_) => None,
            Kind::Reach(reach) => Some(reach.solution.clone()),
        }
    }

    /// Why the choice that was taken is wrong.
    #[must_use]
    pub fn because<'a>(&self, ask: &'a Ask) -> Option<&'a [Span]> {
        self.wrong_choice(ask)?.because.as_deref()
    }

    fn wrong_choice<'a>(&self, ask: &'a Ask) -> Option<&'a Choice> {
        let Kind::Choice(choices) = &ask.kind else {
            return None;
        };
        let chosen = choices.get(self.chosen?);
        chosen.filter(|_| self.verdict == Some(Verdict::Wrong))
    }

    /// What would be seen if the wrong answer were right, where that can be shown.
    #[must_use]
    pub fn shown(&self, ask: &Ask, session: &Session) -> Option<Session> {
        match &ask.kind {
            Kind::Choice(_) => {
                let patch = self.wrong_choice(ask)?.shows.as_ref()?;
                let mut session = session.clone();
                patch.apply(&mut session).ok()?;
                Some(session)
            }
            Kind::Number(number) if self.verdict == Some(Verdict::Wrong) => {
                number.shown(typed_number(&self.typed)?, session)
            }
            Kind::Number(_) | Kind::Reach(_) => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::lesson::Lesson;
    use super::super::read::read;
    use super::*;

    const HEAD: &str =
        "+++\ntitle = \"T\"\n[state]\nmaterials = [\"chalk\"]\nlight = 30\n+++\n## One\n\n";

    fn lesson(ask: &str) -> Lesson {
        let text = format!("{HEAD}```ask\nquestion = \"Q\"\nhints = [\"H\"]\n{ask}\n```\n");
        read(&text, "t", "t.md").unwrap()
    }

    fn begun(lesson: &Lesson) -> (&Ask, Session, Scenes) {
        let session = lesson.state_of(0).unwrap();
        let scenes = Scenes::of(&session);
        (lesson.steps[0].ask.as_ref().unwrap(), session, scenes)
    }

    #[test]
    fn a_choice_is_right_or_shows_what_it_would_mean() {
        let lesson = lesson(
            "choices = [{ text = \"A\", when = \"1 < 2\" }, { text = \"B\", when = \"1 > 2\", because = \"No.\", shows = { light = 70 } }]",
        );
        let (ask, session, scenes) = begun(&lesson);
        let mut work = Work::default();
        work.choose(ask, 1, &scenes);
        assert_eq!(work.verdict, Some(Verdict::Wrong));
        assert!(!work.is_revealed() && work.because(ask).is_some());
        assert_eq!(work.shown(ask, &session).unwrap().theta_deg, 70.0);
        work.choose(ask, 0, &scenes);
        assert!(work.is_revealed() && work.shown(ask, &session).is_none());
        let mut other = Work::default();
        assert_eq!(other.look_up(ask, &scenes), None);
        assert_eq!((other.is_revealed(), other.chosen), (true, Some(0)));
        assert_eq!(other.verdict, None, "what was looked up is not answered");
    }

    #[test]
    fn a_number_is_typed() {
        let lesson = lesson("number = \"angle(light)\"\ntolerance = 1\nshows = \"light\"");
        let (ask, session, scenes) = begun(&lesson);
        let mut work = Work::default();
        work.submit(ask, &scenes);
        assert!(matches!(work.verdict, Some(Verdict::Unreadable(_))));
        work.typed = "45".to_owned();
        work.submit(ask, &scenes);
        assert_eq!(work.verdict, Some(Verdict::Wrong));
        assert_eq!(work.shown(ask, &session).unwrap().theta_deg, 45.0);
        work.typed = "30,2".to_owned();
        work.submit(ask, &scenes);
        assert!(work.is_revealed());
    }

    #[test]
    fn a_state_is_reached_by_hand() {
        let lesson = lesson("until = \"angle(light) > 60\"\nsolution = { light = 75 }");
        let (ask, mut session, scenes) = begun(&lesson);
        let mut work = Work::default();
        assert!(!work.look(ask, &scenes));
        session.theta_deg = 61.0;
        let scenes = Scenes::of(&session);
        assert!(work.look(ask, &scenes) && !work.look(ask, &scenes));
        assert!(work.is_revealed());
        let solution = Work::default().look_up(ask, &scenes).unwrap();
        solution.apply(&mut session).unwrap();
        assert_eq!(session.theta_deg, 75.0);
    }
}
