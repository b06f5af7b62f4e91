use std::sync::{Mutex, mpsc};
use std::time::Duration;

use super::*;
use crate::platform;
use crate::views::{OwnSection, polar};
use bxdf_lab::analysis::{IsWanted, Pace, Steps, Tell, finish, pause, thumbnail};
use bxdf_lab::contract::PhysicalLaws;

#[test]
fn views_that_ask_the_same_have_one_answer_and_else_each_its_own() {
    let mut session = Session::of("oren_nayar".parse().unwrap());
    let second = session.views.duplicate(session.views.ids()[0]).unwrap();
    let views = [session.views.ids()[0], second];
    let mut answers = Answers::at_once();
    let mut ask = |azimuths: [f64; 2]| {
        answers.begin_frame(&session);
        let asked = [0, 1].map(|index| {
            answers.asked_by(Some(views[index]));
            let own_section_deg = OwnSection(Some(azimuths[index]));
            let request = polar::Options {
                own_section_deg,
                ..polar::Options::default()
            }
            .request(&session);
            answers.ask(&session, session.materials.selected(), request)
        });
        answers.asked_by(None);
        asked
    };
    let [first, second] = ask([10.0, 10.0]);
    assert!(Arc::ptr_eq(&first, &second));
    // One is turned: the other one keeps its answer.
    let [kept, turned] = ask([10.0, 20.0]);
    assert!(Arc::ptr_eq(&first, &kept) && !Arc::ptr_eq(&kept, &turned));
    let [again, still] = ask([10.0, 20.0]);
    assert!(Arc::ptr_eq(&again, &kept) && Arc::ptr_eq(&still, &turned));
}

#[test]
fn each_material_keeps_its_answers_until_it_is_removed() {
    let mut session = Session::of("oren_nayar".parse().unwrap());
    let added = session.materials.add("phong".parse().unwrap()).unwrap();
    let mut answers = Answers::at_once();
    answers.begin_frame(&session);
    let section = |answers: &mut Answers, session: &Session, index: usize| {
        let entry = session.materials.iter().nth(index).unwrap();
        answers.ask(session, entry, polar::Options::default().request(session))
    };
    let [first, second] = [0, 1].map(|index| section(&mut answers, &session, index));
    assert_ne!(first, second);
    // One is edited: the other one is not computed anew.
    session.materials.get_mut(added).unwrap().material = "ward".parse().unwrap();
    assert!(Arc::ptr_eq(&first, &section(&mut answers, &session, 0)));
    assert!(!Arc::ptr_eq(&second, &section(&mut answers, &session, 1)));
    // The laws of a material do not depend on what is held.
    let laws = |answers: &mut Answers, session: &Session| {
        answers.of_material(session.materials.selected(), PhysicalLaws)
    };
    let checked = laws(&mut answers, &session).unwrap();
    session.theta_deg = 10.0;
    assert!(Arc::ptr_eq(
        &checked,
        &laws(&mut answers, &session).unwrap()
    ));
    // Nor on how it is turned; and they may be out of sight for a while.
    session.rotation_deg = 30.0;
    section(&mut answers, &session, 0);
    (0..10).for_each(|_| answers.begin_frame(&session));
    assert!(Arc::ptr_eq(
        &checked,
        &laws(&mut answers, &session).unwrap()
    ));
    session.materials.remove(added);
    answers.begin_frame(&session);
    assert_eq!(answers.given.len(), 1);
}

#[test]
fn what_is_named_is_answered_without_a_session() {
    let named = &bxdf::material::library::all()[0];
    let request = thumbnail::Request { side: 4 };
    let mut answers = Answers::at_once();
    let picture = answers
        .of_listed(named.id, &named.material, request)
        .unwrap();
    assert!(picture.pixels.iter().flatten().any(|x| *x > 0.0));
    assert!(Arc::ptr_eq(
        &picture,
        &answers
            .of_listed(named.id, &named.material, request)
            .unwrap()
    ));
    (0..2 * FRAMES_KEPT).for_each(|_| answers.begin_frame(&Session::default()));
    assert!(answers.given.is_empty());
}

/// The letters of the material's title, told one after the other, each as soon as the gate lets it through.
#[derive(Clone)]
struct Letters(Arc<Mutex<mpsc::Receiver<()>>>);

impl PartialEq for Letters {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

impl Query for Letters {
    type Answer = String;

    const BASIS: Basis = Basis::Material;

    const PACE: Pace = Pace::Long;

    fn answer(&self, of: &Subject<'_>, detail: Detail, is_wanted: IsWanted<'_>) -> Option<String> {
        finish(self.in_steps(*of, detail, is_wanted, &|_, _| {}))
    }

    fn in_steps<'a>(
        &'a self,
        of: Subject<'a>,
        _: Detail,
        is_wanted: IsWanted<'a>,
        tell: Tell<'a, String>,
    ) -> Steps<'a, Option<String>> {
        Box::pin(async move {
            let title = of.material?.title();
            for end in 1..title.len() {
                self.0.lock().unwrap().recv().ok()?;
                pause().await;
                is_wanted().then_some(())?;
                tell(title[..end].to_owned(), end as f64 / title.len() as f64);
            }
            self.0.lock().unwrap().recv().ok()?;
            Some(title)
        })
    }
}

/// Letters that wait at a gate.
fn letters() -> (Letters, mpsc::Sender<()>) {
    let (open, gate) = mpsc::channel();
    (Letters(Arc::new(Mutex::new(gate))), open)
}

#[test]
fn what_is_ordered_is_told_in_parts_and_stays_until_the_next_order() {
    let mut session = Session::of("phong".parse().unwrap());
    let (told, news) = mpsc::channel();
    let mut answers = Answers::new(Some(platform::seconds), Pool::new(), move || {
        let _ = told.send(());
    });
    let next = || news.recv_timeout(Duration::from_secs(10)).unwrap();
    assert!(answers.ordered::<Letters>().is_none());
    let (query, open) = letters();
    let entry = session.materials.selected().clone();
    let title = entry.material.title();
    answers.begin_frame(&session);
    answers.order(&entry, query.clone());
    assert!(answers.is_ordered(&entry, &query) && !answers.is_ordered(&entry, &letters().0));
    for end in 1..3 {
        open.send(()).unwrap();
        let told = title[..end].to_owned();
        let ordered = loop {
            let ordered = answers.ordered::<Letters>().unwrap();
            if ordered.answer.as_deref() == Some(&told) {
                break ordered;
            }
            next();
        };
        let share = ordered.part.unwrap().share;
        assert!(ordered.is_awaited && (share * title.len() as f64 - end as f64).abs() < 1e-9);
        // Nobody is told to wait for it, and what the views ask meanwhile is answered.
        answers.begin_frame(&session);
        assert!(matches!(answers.progress(), Progress::Complete(_)));
        session.theta_deg += 1.0;
        while {
            answers.ask(
                &session,
                &entry,
                polar::Options::default().request(&session),
            );
            answers.shown() != Some(Detail::Full)
        } {
            next();
            answers.begin_frame(&session);
        }
    }
    // It is called off; what is known of it stays, whatever becomes of the material.
    answers.call_off::<Letters>();
    open.send(()).unwrap();
    session.materials.selected_mut().material = "ward".parse().unwrap();
    (0..10).for_each(|_| answers.begin_frame(&session));
    let ordered = answers.ordered::<Letters>().unwrap();
    assert_eq!(ordered.answer.unwrap().as_str(), &title[..2]);
    assert!(!ordered.is_awaited && ordered.surface.material == entry.material);
    assert!(!answers.is_ordered(session.materials.selected(), &query));
    // The next one begins anew, and comes to its end.
    let (query, open) = letters();
    (0..title.len()).for_each(|_| open.send(()).unwrap());
    answers.order(&entry, query);
    while answers
        .ordered::<Letters>()
        .is_some_and(|ordered| ordered.is_awaited)
    {
        next();
    }
    let ordered = answers.ordered::<Letters>().unwrap();
    assert!(ordered.part.is_none() && ordered.answer.unwrap().as_str() == title);
}
