//! Views as instances: a kind stands twice, each view with what is its own.

use brdf_explorer::analysis::cartesian::Abscissa;
use brdf_explorer::analysis::hemisphere::Quantity;
use brdf_explorer::study::export::Format;
use brdf_explorer::study::session::{MAX_VIEWS, Place, READY_LAYOUTS, Session, ViewId};
use brdf_explorer::study::views::{
    Options, OwnSection, Scale, VIEWS, cartesian, hemisphere, polar,
};
use brdf_explorer::ui::app::App;
use brdf_explorer::ui::export;
use brdf_explorer::ui::headless::Picture;
use egui::{Event, Key, Modifiers, PointerButton, Pos2, Rect, Role, Theme, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable};

use super::{choose, picture, session};

const HELD: &str = "Light in the polar plot";

/// Views with these options side by side.
fn beside(material: &str, views: impl IntoIterator<Item = Options>) -> Session {
    let mut shown = session(&[material]);
    let views = views.into_iter().map(Place::View);
    shown.views = Place::row(views.collect()).into();
    shown
}

fn window(shown: Session) -> Harness<'static, App> {
    let picture = picture(shown, None, [1280, 800], Theme::Dark);
    picture.harness().unwrap()
}

/// A Cartesian plot over this angle.
fn over(abscissa: Abscissa) -> Options {
    let plot = cartesian::Options {
        abscissa,
        ..cartesian::Options::default()
    };
    plot.into()
}

/// A polar plot with a section of its own, or without.
fn section(azimuth: Option<f64>) -> Options {
    let plot = polar::Options {
        own_section_deg: OwnSection(azimuth),
        ..polar::Options::default()
    };
    plot.into()
}

fn ids(harness: &Harness<'_, App>) -> Vec<ViewId> {
    harness.state().session.views.ids()
}

fn options(harness: &Harness<'_, App>) -> Vec<Options> {
    let views = &harness.state().session.views;
    let all = views.ids().into_iter();
    all.map(|id| views.get(id).unwrap().clone()).collect()
}

/// The places of all that has this name, from the left.
fn places(harness: &Harness<'_, App>, role: Role, name: &str) -> Vec<Rect> {
    let all = harness.query_all_by_role_and_label(role, name);
    let mut places: Vec<Rect> = all.map(|node| node.rect()).collect();
    places.sort_by(|a, b| a.left().total_cmp(&b.left()));
    places
}

/// The handles of the held direction in all polar plots, from the left.
fn handles_of(harness: &Harness<'_, App>) -> Vec<Pos2> {
    let all = harness.query_all_by_label(HELD);
    let mut all: Vec<Pos2> = all.map(|node| node.rect().center()).collect();
    all.sort_by(|a, b| a.x.total_cmp(&b.x));
    all
}

fn click_at(harness: &mut Harness<'_, App>, place: Pos2, button: PointerButton) {
    harness.hover_at(place);
    harness.run();
    for pressed in [true, false] {
        harness.event(Event::PointerButton {
            pos: place,
            button,
            pressed,
            modifiers: Modifiers::NONE,
        });
        harness.step();
    }
    harness.run();
}

fn drag(harness: &mut Harness<'_, App>, from: Pos2, to: Pos2) {
    harness.hover_at(from);
    harness.run();
    harness.drag_at(from);
    harness.step();
    harness.hover_at(to);
    harness.run_steps(2);
    harness.drop_at(to);
    harness.run();
}

/// The texts that are painted.
fn texts(harness: &Harness<'_, App>) -> Vec<String> {
    let shapes = harness.output().shapes.iter();
    let text = |clipped: &egui::epaint::ClippedShape| match &clipped.shape {
        egui::Shape::Text(text) => Some(text.galley.text().to_owned()),
        _ => None,
    };
    shapes.filter_map(text).collect()
}

/// How often a text with `part` in it is painted.
fn painted(harness: &Harness<'_, App>, part: &str) -> usize {
    let texts = texts(harness);
    texts.iter().filter(|text| text.contains(part)).count()
}

fn undo(harness: &mut Harness<'_, App>) {
    harness.get_by_label("Undo").click();
    harness.run();
}

/// Saves and opens.
fn reopened(session: &Session) -> Session {
    let text = session.to_toml().unwrap();
    Session::from_toml(&text, "saved").unwrap()
}

/// The file of a view of the session.
fn file(shown: &Session, view: ViewId, format: Format) -> Vec<u8> {
    let picture = Picture {
        session: shown.clone(),
        only: Some(view),
        size: [480, 360],
        scale: 1.0,
        theme: Theme::Light,
        figure: None,
    };
    export::bytes(picture, format).unwrap()
}

#[test]
fn two_cartesian_plots_are_set_by_themselves() {
    let shown = beside("gold", [over(Abscissa::Free), over(Abscissa::Half)]);
    let mut harness = window(shown.clone());
    assert_eq!(painted(&harness, "in the section at azimuth"), 1);
    assert_eq!(painted(&harness, "θh, the half vector's angle"), 1);
    for title in ["Cartesian plot", "Cartesian plot 2"] {
        assert_eq!(places(&harness, Role::Button, title).len(), 1, "{title}");
    }
    // One is set: the other is as it was.
    choose(
        &mut harness,
        "Scale of Cartesian plot 2",
        "Each to its peak",
    );
    let [first, second] = &options(&harness)[..] else {
        panic!("two views")
    };
    assert_eq!(*first, over(Abscissa::Free));
    let expected = cartesian::Options {
        abscissa: Abscissa::Half,
        scale: Scale {
            is_each_to_peak: true,
            ..Scale::default()
        },
        ..cartesian::Options::default()
    };
    assert_eq!(*second, expected.into());
    let session = harness.state().session.clone();
    assert_eq!(reopened(&session), session);
    // The files of each are its own.
    for format in [Format::Csv, Format::Svg] {
        let [one, two] = [0, 1].map(|index| file(&session, session.views.ids()[index], format));
        assert!(one != two && !one.is_empty());
    }
    // One is closed, and comes back with what is its own.
    harness.query_all_by_label("Close").last().unwrap().click();
    harness.run();
    assert_eq!(options(&harness), [over(Abscissa::Free)]);
    undo(&mut harness);
    assert_eq!(harness.state().session, session);
    undo(&mut harness);
    assert_eq!(harness.state().session, shown);
}

#[test]
fn two_polar_plots_show_two_sections() {
    let shown = beside("brushed_steel", [section(None), section(Some(90.0))]);
    let mut harness = window(shown.clone());
    let handles = handles_of(&harness);
    assert_eq!(handles.len(), 2);
    // In its own section the held direction does not lie: a drag there sets how far it is from n.
    let middle = handles[1];
    drag(&mut harness, middle, middle + vec2(-60.0, 40.0));
    let session = &harness.state().session;
    assert!(
        session.theta_deg > 55.0 && session.phi_deg == 180.0,
        "{}",
        session.theta_deg
    );
    assert_eq!(options(&harness), [section(None), section(Some(90.0))]);
    let tables = [0, 1].map(|index| file(session, session.views.ids()[index], Format::Csv));
    assert_ne!(tables[0], tables[1]);
    let session = session.clone();
    assert_eq!(reopened(&session), session);
    undo(&mut harness);
    assert_eq!(harness.state().session, shown);
    // In the section of the others it is dragged through n to the other side.
    let left = handles_of(&harness)[0];
    drag(&mut harness, left, left + vec2(200.0, 0.0));
    let session = &harness.state().session;
    assert!(session.phi_deg.abs() < 1.0, "{}", session.phi_deg);
}

#[test]
fn a_section_of_its_own_is_given_and_taken_by_hand() {
    let mut harness = window(beside("gold", [section(None), section(None)]));
    let tab = places(&harness, Role::Button, "Polar plot 2")[0].center();
    click_at(&mut harness, tab, PointerButton::Secondary);
    harness.get_by_label("Own section").click();
    harness.run();
    assert_eq!(options(&harness), [section(None), section(Some(0.0))]);
    harness
        .get_by_role_and_label(Role::SpinButton, "Own section")
        .set_text_value_accesskit("35");
    harness.run();
    assert_eq!(options(&harness), [section(None), section(Some(35.0))]);
    // The section of all others is another matter.
    assert_eq!(harness.state().session.section_phi_deg, None);
    harness.get_by_label("As the others").click();
    harness.run();
    assert_eq!(options(&harness), [section(None), section(None)]);
}

#[test]
fn the_value_stands_beside_the_density() {
    let of = |quantity| {
        let map = hemisphere::Options {
            quantity,
            ..hemisphere::Options::default()
        };
        Options::from(map)
    };
    let shown = beside("gold", [of(Quantity::F), of(Quantity::Pdf)]);
    let mut harness = window(shown);
    for quantity in [Quantity::F, Quantity::Pdf] {
        let name = format!("{}, {}", quantity.title(), quantity.unit());
        let is_it = |text: &&String| **text == name;
        assert_eq!(texts(&harness).iter().filter(is_it).count(), 1, "{name}");
    }
    // What is computed and drawn once stays, though the two take turns.
    let textures = |harness: &Harness<'_, App>| harness.output().textures_delta.set.len();
    harness.step();
    harness.step();
    assert_eq!(textures(&harness), 0);
}

#[test]
fn a_view_is_duplicated_by_its_menu_and_by_keys() {
    let mut harness = window(session(&["gold"]));
    let tab = places(&harness, Role::Button, "Polar plot")[0].center();
    click_at(&mut harness, tab, PointerButton::Secondary);
    harness.get_by_label("Duplicate").click();
    harness.run();
    let kinds = |harness: &Harness<'_, App>| -> Vec<&str> {
        let views = &harness.state().session.views;
        let ids = views.ids().into_iter();
        ids.map(|id| views.kind(id).unwrap().id).collect()
    };
    assert_eq!(kinds(&harness), ["lobe3d", "polar", "polar"]);
    let dome = places(&harness, Role::Canvas, "3D lobe")[0].center();
    click_at(&mut harness, dome, PointerButton::Primary);
    let keys = Modifiers::COMMAND.plus(Modifiers::SHIFT);
    harness.key_press_modifiers(keys, Key::D);
    harness.run();
    assert_eq!(kinds(&harness), ["lobe3d", "lobe3d", "polar", "polar"]);
    undo(&mut harness);
    undo(&mut harness);
    assert_eq!(kinds(&harness), ["lobe3d", "polar"]);
    // Closed, the second is gone, and the first keeps its name.
    harness.get_by_label("Redo").click();
    harness.run();
    let close = harness.query_all_by_label("Close").last().unwrap();
    close.click();
    harness.run();
    assert_eq!(kinds(&harness), ["lobe3d", "polar"]);
    assert_eq!(places(&harness, Role::Button, "Polar plot").len(), 1);
}

#[test]
fn every_view_stands_beside_itself() {
    for view in &VIEWS {
        let shown = beside("plastic", [Options::of(view), Options::of(view)]);
        let mut harness = window(shown);
        // Clashes of ids are painted as a warning.
        assert_eq!(painted(&harness, "use of"), 0, "{}", view.id);
        let [first, second] = ids(&harness)[..] else {
            panic!("two views")
        };
        assert_ne!(first, second);
        harness.hover_at(Pos2::new(600.0, 400.0));
        harness.run();
        assert_eq!(painted(&harness, "use of"), 0, "{}", view.id);
    }
}

#[test]
fn no_more_views_are_opened_than_there_may_be() {
    let many = (0..MAX_VIEWS).map(|_| over(Abscissa::Free));
    let mut shown = session(&["gold"]);
    shown.views = Place::Tabs {
        views: many.collect(),
        active: 0,
    }
    .into();
    let mut harness = window(shown);
    harness.get_by_label("Views").click();
    harness.run();
    let add = harness.get_by_label("Add Polar plot");
    assert!(add.accesskit_node().is_disabled());
    harness.key_press(egui::Key::Escape);
    harness.run();
    // A ready layout is always open.
    harness.get_by_label("Compare").click();
    harness.run();
    let compare = READY_LAYOUTS.iter().find(|ready| ready.name == "Compare");
    assert!(
        harness
            .state()
            .session
            .views
            .is_ready(compare.unwrap(), harness.state().room_of_views())
    );
}

#[test]
fn what_is_left_out_is_said_and_the_rest_opens() {
    let mut harness = window(session(&["gold"]));
    let text = "material = \"phong\"\nlayout.row = [{ place.view = \"pola\" }, { place.view = \"slice\" }]\n";
    harness.event(Event::Paste(text.to_owned()));
    harness.run();
    let line = "clipboard: unknown view 'pola'; nearest: polar";
    assert!(harness.query_by_label_contains(line).is_some());
    assert!(harness.query_by_label_contains(": left out").is_some());
    let views = &harness.state().session.views;
    assert_eq!(views.kind(views.ids()[0]).unwrap().id, "slice");
}
