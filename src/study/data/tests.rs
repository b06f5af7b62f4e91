use super::*;
use crate::views::{OwnSection, polar};

#[test]
fn views_that_ask_the_same_have_one_answer_and_else_each_its_own() {
    let mut session = Session::of("oren_nayar".parse().unwrap());
    let second = session.views.duplicate(session.views.ids()[0]).unwrap();
    let views = [session.views.ids()[0], second];
    let mut data = Data::new(None, || {});
    let mut ask = |azimuths: [f64; 2]| {
        data.begin_frame(&session);
        let asked = [0, 1].map(|index| {
            data.asked_by(Some(views[index]));
            let own_section_deg = OwnSection(Some(azimuths[index]));
            let request = polar::Options { own_section_deg }.request(&session);
            data.ask(&session, session.materials.selected(), request)
        });
        data.asked_by(None);
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
    let mut data = Data::new(None, || {});
    data.begin_frame(&session);
    let section = |data: &mut Data, session: &Session, index: usize| {
        let entry = session.materials.iter().nth(index).unwrap();
        data.ask(session, entry, polar::Options::default().request(session))
    };
    let [first, second] = [0, 1].map(|index| section(&mut data, &session, index));
    assert_ne!(first, second);
    // One is edited: the other one is not computed anew.
    session.materials.get_mut(added).unwrap().material = "ward".parse().unwrap();
    assert!(Arc::ptr_eq(&first, &section(&mut data, &session, 0)));
    assert!(!Arc::ptr_eq(&second, &section(&mut data, &session, 1)));
    // The laws of a material do not depend on what is held.
    let laws = |data: &mut Data, session: &Session| data.checks(session.materials.selected());
    let checked = laws(&mut data, &session).unwrap();
    session.theta_deg = 10.0;
    assert!(Arc::ptr_eq(&checked, &laws(&mut data, &session).unwrap()));
    session.materials.remove(added);
    data.begin_frame(&session);
    assert_eq!(data.answers.len(), 1);
}
