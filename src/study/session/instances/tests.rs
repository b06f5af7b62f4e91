use super::*;
use crate::views::{VIEWS, cartesian, hemisphere, polar};

/// The room for views of a window, in points.
const ROOM: [f32; 2] = [1000.0, 700.0];

fn kind(id: &str) -> &'static ViewKind {
    find(id).unwrap()
}

fn kinds(views: &Views) -> Vec<&'static str> {
    let ids = views.ids().into_iter();
    ids.map(|id| views.kind(id).unwrap().id).collect()
}

/// A Cartesian plot at this angle.
fn at(fixed_deg: f64) -> cartesian::Options {
    cartesian::Options {
        fixed_deg,
        ..cartesian::Options::default()
    }
}

/// The angles of all Cartesian plots, by their numbers.
fn angles(views: &Views) -> Vec<f64> {
    let all = views.all::<cartesian::Options>();
    all.iter().map(|options| options.fixed_deg).collect()
}

fn set(views: &mut Views, id: ViewId, options: cartesian::Options) {
    *views.get_mut(id).unwrap() = options.into();
}

#[test]
fn ready_layouts_are_valid_and_known_again() {
    for ready in &READY_LAYOUTS {
        let views = Views::ready(ready);
        assert_eq!(views.layout().validate(), Ok(()));
        let is_it = |other: &&ReadyLayout| views.is_ready(other, ROOM);
        let found: Vec<&str> = READY_LAYOUTS.iter().filter(is_it).map(|r| r.name).collect();
        assert_eq!(found, [ready.name]);
    }
}

#[test]
fn a_kind_stands_twice_with_options_and_names_of_its_own() {
    let mut views = Views::default();
    let first = views.add(kind("cartesian"), ROOM).unwrap();
    set(&mut views, first, at(10.0));
    let second = views.duplicate(first).unwrap();
    assert_eq!(angles(&views), [10.0, 10.0]);
    set(&mut views, second, at(20.0));
    assert_eq!(angles(&views), [10.0, 20.0]);
    assert_eq!(kinds(&views), ["lobe3d", "cartesian", "cartesian", "polar"]);
    let titles = [first, second].map(|id| views.title(id));
    assert_eq!(titles, ["Cartesian plot", "Cartesian plot 2"]);
    let names = [first, second].map(|id| views.file_name(id));
    assert_eq!(names, ["cartesian", "cartesian-2"]);
    assert_eq!(views.options::<cartesian::Options>(), at(10.0));
    let shown = views.show_alone(kind("cartesian"));
    assert_eq!(shown, first);
}

#[test]
fn what_is_closed_comes_back_as_it_was() {
    let mut views = Views::default();
    let first = views.add(kind("cartesian"), ROOM).unwrap();
    set(&mut views, first, at(10.0));
    let [start, ..] = &READY_LAYOUTS;
    views.show_ready(start, ROOM);
    assert_eq!(
        (kinds(&views), angles(&views)),
        (vec!["lobe3d", "polar"], vec![])
    );
    assert_eq!(views.options::<cartesian::Options>(), at(10.0));
    views.add(kind("cartesian"), ROOM).unwrap();
    assert_eq!(angles(&views), [10.0]);
    // One that is like at first is not kept: there is nothing to lose.
    assert!(views.closed().is_empty());
    // Of two the first comes back.
    let second = views.duplicate(views.first(kind("cartesian")).unwrap());
    set(&mut views, second.unwrap(), at(20.0));
    views.show_ready(start, ROOM);
    views.add(kind("cartesian"), ROOM).unwrap();
    views.add(kind("cartesian"), ROOM).unwrap();
    assert_eq!(angles(&views), [10.0, 10.0]);
}

#[test]
fn a_ready_layout_takes_the_views_that_are_open() {
    let mut views = Views::default();
    let map = views.add(kind("hemisphere"), ROOM).unwrap();
    let own = hemisphere::Options {
        is_lower: true,
        ..hemisphere::Options::default()
    };
    *views.get_mut(map).unwrap() = own.into();
    let before = views.ids();
    let sampling = READY_LAYOUTS.iter().find(|ready| ready.name == "Sampling");
    views.show_ready(sampling.unwrap(), ROOM);
    assert_eq!(kinds(&views), ["sampling", "hemisphere", "cartesian"]);
    assert!(views.options::<hemisphere::Options>().is_lower);
    let [first, second, third] = views.ids()[..] else {
        panic!("three views")
    };
    assert_eq!(second, map);
    assert!(!before.contains(&first) && !before.contains(&third));
}

#[test]
fn all_of_a_kind_change_and_the_next_one_too() {
    let mut views = Views::default();
    views.each(|plot: &mut cartesian::Options| plot.is_residual = true);
    assert!(views.options::<cartesian::Options>().is_residual);
    let first = views.add(kind("cartesian"), ROOM).unwrap();
    views.duplicate(first).unwrap();
    views.each(|plot: &mut cartesian::Options| plot.fixed_deg = 5.0);
    assert_eq!(angles(&views), [5.0, 5.0]);
    assert!(views.all::<polar::Options>().len() == 1);
}

#[test]
fn the_first_of_a_kind_changes_alone_or_the_next_one() {
    let mut views = Views::default();
    views.first_of(|plot: &mut cartesian::Options| plot.is_residual = true);
    let first = views.add(kind("cartesian"), ROOM).unwrap();
    assert!(views.options::<cartesian::Options>().is_residual);
    views.duplicate(first).unwrap();
    views.first_of(|plot: &mut cartesian::Options| plot.fixed_deg = 5.0);
    assert_eq!(angles(&views), [5.0, 30.0]);
}

#[test]
fn equal_views_are_equal_whatever_their_numbers() {
    let mut views = Views::default();
    let added = views.add(kind("cartesian"), ROOM).unwrap();
    let one = views.clone();
    let without = one
        .layout()
        .filter_map(&mut |id| (*id != added).then_some(*id));
    views.arrange(&without.unwrap());
    let again = views.add(kind("cartesian"), ROOM).unwrap();
    let last = views.duplicate(again).unwrap();
    assert_ne!(views, one);
    let layout = one
        .layout()
        .filter_map(&mut |id| Some(if *id == added { last } else { *id }));
    views.arrange(&layout.unwrap());
    assert!(last != added && views == one);
}

#[test]
fn there_is_a_limit() {
    let mut views = Views::default();
    while views.has_room() {
        views.add(&VIEWS[0], ROOM).unwrap();
    }
    assert_eq!(views.ids().len(), MAX_VIEWS);
    for result in [
        views.clone().add(&VIEWS[0], ROOM),
        views.clone().duplicate(ViewId(1)),
    ] {
        let line = result.unwrap_err().to_string();
        assert_eq!(line, "the number of views is 33; the limit is 1 to 32");
    }
    assert_eq!(views.layout().validate(), Ok(()));
}
