//! Every number that can be typed, key by key.

use std::collections::BTreeSet;

use brdf_explorer::analysis::cartesian::Abscissa;
use brdf_explorer::bxdf::models::MODELS;
use brdf_explorer::bxdf::param::{Kind, ParamSpec, Value};
use brdf_explorer::bxdf::{Component, Material, ModelSpec};
use brdf_explorer::ui::app::App;
use brdf_explorer::ui::session::{self, Session, folded_deg, wrapped_deg};
use brdf_explorer::ui::views::VIEWS;
use brdf_explorer::ui::widgets::components::Components;
use brdf_explorer::ui::widgets::params::Ties;
use brdf_explorer::ui::widgets::{directions, options};
use egui::{Event, Key, Modifiers, Role, Theme, Ui, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable};

use super::{picture, session, window, window_of};

/// What is typed anywhere, with the number that it stands for.
const TEXTS: [(&str, Option<f64>); 13] = [
    ("0.345", Some(0.345)),
    (".345", Some(0.345)),
    ("0,25", Some(0.25)),
    ("1e-3", Some(1e-3)),
    ("0.123456789", Some(0.123_456_789)),
    (" 7 ", Some(7.0)),
    ("", None),
    ("abc", None),
    ("NaN", None),
    ("inf", None),
    ("1e400", Some(f64::INFINITY)),
    ("1,5,0", None),
    ("1.234,5", None),
];

/// These, the ends of the range, and what lies beyond them.
fn texts([low, high]: [f64; 2]) -> Vec<(String, Option<f64>)> {
    let beyond = 0.001_f64.max(1e-6 * (high - low));
    let ends = [low, high, low - beyond, high + beyond];
    let ends = ends.map(|x| (x.to_string(), Some(x)));
    let texts = TEXTS.map(|(text, x)| (text.to_owned(), x));
    texts.into_iter().chain(ends).collect()
}

fn key(key: Key, modifiers: Modifiers) -> Event {
    Event::Key {
        key,
        physical_key: None,
        pressed: true,
        repeat: false,
        modifiers,
    }
}

/// Clicks a field and types over what stands there, one event a frame.
fn type_into<S>(harness: &mut Harness<'_, S>, name: &str, text: &str) {
    let field = harness.get_by_role_and_label(Role::SpinButton, name);
    field.click();
    harness.step();
    harness.event(key(Key::A, Modifiers::COMMAND));
    harness.event(key(Key::Delete, Modifiers::NONE));
    for letter in text.chars() {
        harness.event(Event::Text(letter.to_string()));
    }
    harness.step();
}

fn press<S>(harness: &mut Harness<'_, S>, pressed: Key) {
    harness.event(key(pressed, Modifiers::NONE));
    harness.step();
    harness.step();
}

fn enter<S>(harness: &mut Harness<'_, S>, name: &str, text: &str) {
    type_into(harness, name, text);
    press(harness, Key::Enter);
}

/// The text in a field, and why it is refused.
fn said<S>(harness: &Harness<'_, S>, name: &str) -> (String, Option<String>) {
    let field = harness.get_by_role_and_label(Role::SpinButton, name);
    let words = field.accesskit_node().description();
    (field.value().unwrap_or_default(), words)
}

/// The names of all fields.
fn fields<S>(harness: &Harness<'_, S>) -> BTreeSet<String> {
    let all = harness.query_all_by_role(Role::SpinButton);
    all.filter_map(|node| node.accesskit_node().label())
        .collect()
}

/// Types everything into a field. `expected`: what becomes of a number, `None` where it is to be refused.
fn try_all<S>(
    harness: &mut Harness<'_, S>,
    name: &str,
    texts: &[(String, Option<f64>)],
    expected: impl Fn(&S, f64) -> Option<f64>,
    value: impl Fn(&S) -> f64,
) {
    for (text, x) in texts {
        let before = value(harness.state());
        let wanted = x.and_then(|x| expected(harness.state(), x));
        type_into(harness, name, text);
        let case = format!("{name}: '{text}'");
        assert_eq!(
            value(harness.state()),
            before,
            "{case}: stored before Enter"
        );
        assert_eq!(
            said(harness, name).0,
            *text,
            "{case}: changed while it is typed"
        );
        press(harness, Key::Enter);
        assert_eq!(value(harness.state()), wanted.unwrap_or(before), "{case}");
        let (shown, words) = said(harness, name);
        if wanted.is_some() {
            assert_eq!(words, None, "{case}");
        } else {
            assert_eq!(shown, *text, "{case}: the text stays");
            let words = words.unwrap_or_default();
            assert!(
                words.contains("allowed") || !words.is_empty() && x.is_some(),
                "{case}: {words}"
            );
            // In words at the screen too.
            assert!(harness.query_by_label(&words).is_some(), "{case}: {words}");
        }
    }
    press(harness, Key::Escape);
}

/// The parameters of the selected material, as the panel at the side has them.
fn panel(material: Material) -> Harness<'static, Session> {
    let mut components = Components::default();
    let show = move |ui: &mut Ui, session: &mut Session| {
        let Session {
            materials, locked, ..
        } = session;
        let before = materials.selected().clone();
        let mut edited = before.clone();
        let mut ties = Ties {
            has_linked_widths: &mut edited.has_linked_widths,
            locked,
            is_shared: &|_| false,
        };
        components.show(ui, &mut edited.material, &mut ties);
        if edited != before {
            *materials.selected_mut() = edited;
            materials.follow(&before, locked);
        }
    };
    Harness::builder()
        .with_size(vec2(292.0, 1600.0))
        .build_ui_state(show, Session::of(material))
}

/// A component for each choice of words that brings parameters into play.
fn variants(model: &'static ModelSpec) -> Vec<Component> {
    let mut all = vec![Component::of(model)];
    for (choice, words) in model
        .parameters
        .iter()
        .filter_map(|spec| spec.relevant_when)
    {
        for component in words.iter().filter_map(|word| {
            let mut component = Component::of(model);
            component.set_text(choice, word).ok().map(|()| component)
        }) {
            all.push(component);
        }
    }
    all
}

/// The names of the fields of a parameter, each with its channel.
fn names(spec: &ParamSpec) -> Vec<(String, Option<usize>)> {
    match spec.kind {
        Kind::Number => vec![(spec.label(), None)],
        Kind::Rgb => ["R", "G", "B"]
            .iter()
            .enumerate()
            .map(|(index, letter)| (format!("{} {letter}", spec.label()), Some(index)))
            .collect(),
        Kind::Choice | Kind::Bool => Vec::new(),
    }
}

fn only(session: &Session) -> &Component {
    &session.material().components()[0]
}

fn parameter(component: &Component, spec: &ParamSpec, channel: Option<usize>) -> f64 {
    match (component.params().get(spec.name).unwrap(), channel) {
        (Value::Number(x), None) => x,
        (Value::Rgb(rgb), Some(index)) => rgb[index],
        (other, _) => panic!("{}: {other:?}", spec.name),
    }
}

/// The component with `x` as that parameter, where its model allows it.
fn changed(component: &Component, spec: &ParamSpec, channel: Option<usize>, x: f64) -> Option<f64> {
    let mut value = component.params().get(spec.name)?;
    match (&mut value, channel) {
        (Value::Rgb(rgb), Some(index)) => rgb[index] = x,
        (value, _) => *value = Value::Number(x),
    }
    component.clone().set(spec.name, value).ok().map(|()| x)
}

#[test]
fn every_parameter_of_every_model_is_typed() {
    let mut tried = 0;
    for model in MODELS {
        let mut known: BTreeSet<String> = BTreeSet::new();
        let mut all: BTreeSet<String> = BTreeSet::new();
        for component in variants(model) {
            let mut harness = panel(Material::from(component));
            let found = fields(&harness);
            for spec in model.parameters {
                for (name, channel) in names(spec) {
                    all.insert(name.clone());
                    if !found.contains(&name) || !known.insert(name.clone()) {
                        continue;
                    }
                    tried += 1;
                    let expected = |session: &Session, x| changed(only(session), spec, channel, x);
                    let value = |session: &Session| parameter(only(session), spec, channel);
                    try_all(&mut harness, &name, &texts(spec.hard), expected, value);
                }
            }
            assert!(found.is_subset(&all), "{}: {found:?}", model.id);
        }
        assert_eq!(known, all, "{}", model.id);
    }
    assert!(tried > 100, "{tried}");
}

/// A number of the session: the view it stands in, its name, its range, what is stored for a number within it, and where.
type Field = (
    &'static str,
    &'static str,
    [f64; 2],
    fn(f64) -> Option<f64>,
    fn(&Session) -> f64,
);

fn same(x: f64) -> Option<f64> {
    Some(x)
}

/// Whole numbers only.
fn whole(x: f64) -> Option<f64> {
    (x.fract() == 0.0).then_some(x)
}

fn power_of_2(x: f64) -> Option<f64> {
    (x.log2().fract() == 0.0).then_some(x)
}

fn try_field<S>(harness: &mut Harness<'_, S>, field: &Field, session: impl Fn(&S) -> &Session) {
    let (_, name, range, stored, value) = *field;
    let [low, high] = range;
    let mut texts = texts(range);
    if range[1] % 90.0 == 0.0 {
        for text in ["30°", "30 deg", "30"] {
            texts.push((text.to_owned(), Some(30.0)));
        }
    }
    let within = |_: &S, x: f64| {
        Some(x)
            .filter(|x| (low..=high).contains(x))
            .and_then(stored)
    };
    try_all(harness, name, &texts, within, |state| value(session(state)));
}

#[test]
fn every_number_of_every_view_is_typed() {
    let listed: [Field; 7] = [
        ("cartesian", "at θd", [0.0, 90.0], same, |s| {
            s.views.cartesian.fixed_deg
        }),
        ("cartesian", "at θh", [0.0, 90.0], same, |s| {
            s.views.cartesian.fixed_deg
        }),
        ("slice", "φd", [0.0, 180.0], same, |s| {
            s.views.slice.phi_d_deg
        }),
        ("sphere", "Exposure", [-6.0, 6.0], same, |s| {
            s.views.sphere.exposure
        }),
        ("sampling", "Samples", [64.0, 65536.0], power_of_2, |s| {
            f64::from(s.views.sampling.count_log2).exp2()
        }),
        ("sampling", "Seed", [0.0, 4_294_967_295.0], whole, |s| {
            f64::from(s.views.sampling.seed)
        }),
        ("tradeoff", "Tolerance", [1e-12, 1.0], same, |s| {
            s.views.tradeoff.tolerance
        }),
    ];
    let mut found: BTreeSet<(&str, String)> = BTreeSet::new();
    for view in &VIEWS {
        for abscissa in Abscissa::ALL {
            if view.id != "cartesian" && abscissa != Abscissa::default() {
                continue;
            }
            let mut shown = session(&["lambertian_reflection"]);
            // Nothing is computed where nothing is shown; the controls are there.
            shown.materials.selected_mut().is_visible = false;
            shown.views.cartesian.abscissa = abscissa;
            let mut harness = picture(shown, Some(view.id), [640, 480], Theme::Dark).shapes();
            for name in fields(&harness) {
                let is_it = |field: &&Field| field.0 == view.id && field.1 == name;
                let field = listed.iter().find(is_it);
                let field = field.unwrap_or_else(|| panic!("{} of {}", name, view.id));
                try_field(&mut harness, field, |app: &App| &app.session);
                found.insert((view.id, name));
            }
        }
    }
    assert_eq!(found.len(), listed.len(), "{found:?}");
}

#[test]
fn every_number_of_the_panels_is_typed() {
    let listed: [Field; 4] = [
        ("", "θ from n", [0.0, 90.0], same, |s| s.theta_deg),
        (
            "",
            "φ from s",
            [-360.0, 360.0],
            |x| Some(wrapped_deg(x)),
            |s| s.phi_deg,
        ),
        (
            "",
            "Rotate surface about n",
            [-360.0, 360.0],
            |x| Some(wrapped_deg(x)),
            |s| s.rotation_deg,
        ),
        (
            "",
            "Section azimuth",
            [-360.0, 360.0],
            |x| Some(folded_deg(x)),
            |s| s.section_phi_deg.unwrap(),
        ),
    ];
    let shown = Session {
        section_phi_deg: Some(30.0),
        ..session(&["ward"])
    };
    let show = |ui: &mut Ui, session: &mut Session| {
        options::show(ui, session);
        directions::show(ui, session);
    };
    let size = vec2(1280.0, 300.0);
    let mut harness = Harness::builder()
        .with_size(size)
        .build_ui_state(show, shown);
    let names: BTreeSet<String> = listed.iter().map(|field| field.1.to_owned()).collect();
    assert_eq!(fields(&harness), names);
    for field in &listed {
        try_field(&mut harness, field, |session: &Session| session);
    }
    // Where light passes through, it may come from below.
    harness
        .state_mut()
        .materials
        .selected_mut()
        .replace("thin_dielectric".parse().unwrap());
    harness.step();
    enter(&mut harness, "θ from n", "120");
    assert_eq!(harness.state().theta_deg, 120.0);
    enter(&mut harness, "φ from s", "230");
    assert_eq!(harness.state().phi_deg, -130.0, "a full turn wraps");
}

fn alpha(harness: &Harness<'_, App>) -> [f64; 2] {
    let params = only(&harness.state().session).params();
    ["alpha_x", "alpha_y"].map(|name| params.number(name))
}

fn is_undo_on(harness: &Harness<'_, App>) -> bool {
    !harness.get_by_label("Undo").accesskit_node().is_disabled()
}

#[test]
fn an_accepted_number_is_one_step_and_a_refused_one_is_none() {
    let mut harness = window("rough_conductor");
    enter(&mut harness, "Alpha x", "0.345");
    assert_eq!(alpha(&harness), [0.345; 2], "linked");
    enter(&mut harness, "Alpha x", "0.5");
    enter(&mut harness, "Alpha x", "7");
    assert_eq!(alpha(&harness), [0.5; 2]);
    press(&mut harness, Key::Escape);
    for before in [0.345, 0.3] {
        harness.get_by_label("Undo").click();
        harness.run();
        assert_eq!(alpha(&harness), [before; 2]);
    }
    assert!(!is_undo_on(&harness));
}

#[test]
fn a_locked_parameter_follows_what_is_typed() {
    let mut harness = window_of(&["rough_conductor", "ward"]);
    harness.get_by_label("Lock Alpha x").click();
    harness.run();
    enter(&mut harness, "Alpha x", "0,123456");
    let widths = harness.state().session.materials.iter().map(|entry| {
        let params = entry.material.components()[0].params();
        params.number("alpha_x")
    });
    assert_eq!(widths.collect::<Vec<_>>(), [0.123_456; 2]);
}

#[test]
fn leaving_the_field_stores_what_is_allowed_and_marks_the_rest() {
    let mut harness = window("rough_conductor");
    let elsewhere = harness.get_by_label("Your materials").rect().center();
    for leave in ["Tab", "click"] {
        let away = |harness: &mut Harness<'_, App>| {
            if leave == "Tab" {
                press(harness, Key::Tab);
            } else {
                harness.hover_at(elsewhere);
                harness.drag_at(elsewhere);
                harness.drop_at(elsewhere);
                harness.run();
            }
        };
        type_into(&mut harness, "Alpha x", "0.25");
        assert_eq!(
            alpha(&harness),
            [if leave == "Tab" { 0.3 } else { 0.125 }; 2]
        );
        away(&mut harness);
        assert_eq!(alpha(&harness), [0.25; 2], "{leave}");
        type_into(&mut harness, "Alpha x", "2.5");
        away(&mut harness);
        let (text, words) = said(&harness, "Alpha x");
        assert_eq!(
            (alpha(&harness), text.as_str()),
            ([0.25; 2], "2.5"),
            "{leave}"
        );
        assert_eq!(
            words.as_deref(),
            Some("2.5 is out of range; allowed is 0.0001 to 1"),
            "{leave}"
        );
        assert!(
            !harness
                .get_by_role_and_label(Role::SpinButton, "Alpha x")
                .is_focused()
        );
        // A correction is taken, and Escape gives the value back.
        enter(&mut harness, "Alpha x", "0.125");
        assert_eq!(
            (alpha(&harness), said(&harness, "Alpha x").1),
            ([0.125; 2], None)
        );
        type_into(&mut harness, "Alpha x", "0.9");
        press(&mut harness, Key::Escape);
        assert_eq!(alpha(&harness), [0.125; 2]);
        assert_eq!(said(&harness, "Alpha x").0, "0.125");
    }
}

#[test]
fn what_is_typed_is_stored_when_another_material_is_chosen() {
    let mut harness = window_of(&["rough_conductor", "oren_nayar"]);
    type_into(&mut harness, "Alpha x", "0.25");
    harness.get_by_label("Oren-Nayar").click();
    harness.run();
    let first = harness.state().session.materials.iter().next().unwrap();
    assert_eq!(
        first.material.to_string(),
        "rough_conductor:alpha_x=0.25,alpha_y=0.25"
    );
}

#[test]
fn a_field_is_dragged_stepped_and_reached_by_tab() {
    let mut harness = window("rough_conductor");
    let at = harness
        .get_by_role_and_label(Role::SpinButton, "θ from n")
        .rect()
        .center();
    harness.hover_at(at);
    harness.run();
    harness.drag_at(at);
    for step in 1..=5 {
        harness.hover_at(at + vec2(8.0 * step as f32, 0.0));
        harness.step();
    }
    harness.drop_at(at + vec2(40.0, 0.0));
    harness.run();
    let dragged = harness.state().session.theta_deg;
    assert!(dragged > 55.0 && dragged <= 90.0, "{dragged}");
    harness.get_by_label("Undo").click();
    harness.run();
    assert_eq!(
        harness.state().session.theta_deg,
        50.0,
        "a drag is one step"
    );
    harness
        .get_by_role_and_label(Role::Slider, "θ from n")
        .focus();
    harness.run();
    press(&mut harness, Key::Tab);
    assert!(
        harness
            .get_by_role_and_label(Role::SpinButton, "θ from n")
            .is_focused()
    );
    // All is selected: what is typed takes its place.
    harness.event(Event::Text("3".to_owned()));
    harness.event(Event::Text("3,25".to_owned()));
    harness.step();
    press(&mut harness, Key::Enter);
    assert_eq!(harness.state().session.theta_deg, 33.25);
    let field = harness.get_by_role_and_label(Role::SpinButton, "θ from n");
    field.click();
    harness.step();
    press(&mut harness, Key::ArrowUp);
    assert!(harness.state().session.theta_deg > 33.25);
}

#[test]
fn no_tool_and_no_gesture_stores_what_is_no_number() {
    let mut harness = window("rough_conductor");
    for (role, name) in [
        (Role::Slider, "θ from n"),
        (Role::SpinButton, "θ from n"),
        (Role::Slider, "Alpha x"),
        (Role::SpinButton, "Alpha x"),
        (Role::SpinButton, "φ from s"),
    ] {
        let before = harness.state().session.clone();
        for value in [f64::NAN, f64::INFINITY] {
            harness
                .get_by_role_and_label(role, name)
                .set_value_accesskit(value);
            harness.run();
            let now = &harness.state().session;
            let theta = now.theta_deg;
            assert!(theta.is_finite() && (0.0..=90.0).contains(&theta), "{name}");
            assert!(
                alpha(&harness).iter().all(|x| (1e-4..=1.0).contains(x)),
                "{name}"
            );
            if role == Role::SpinButton || value.is_nan() {
                assert_eq!(*now, before, "{name} {value}");
            }
            harness.state_mut().session = before.clone();
            harness.run();
        }
    }
    harness
        .get_by_role_and_label(Role::SpinButton, "θ from n")
        .set_text_value_accesskit("12,5°");
    harness.run();
    assert_eq!(harness.state().session.theta_deg, 12.5);
    let mut harness = window("rough_conductor");
    harness.state_mut().session.theta_deg = f64::NAN;
    harness.state_mut().session.views.sphere.exposure = f64::INFINITY;
    harness.run();
    assert_eq!(harness.state().session, session(&["rough_conductor"]));
    assert!(!is_undo_on(&harness), "nothing was edited");
}

#[test]
fn a_light_below_opaque_materials_is_told_with_a_way_back() {
    let of_held = |view: &str| !["reflectance", "slice", "sphere", "tradeoff"].contains(&view);
    for view in &VIEWS {
        let below = Session {
            theta_deg: 120.0,
            ..session(&["oren_nayar"])
        };
        let text = "The light is below the surface, and nothing shown lets light through: \
            nothing is reflected";
        let mut harness = picture(below.clone(), Some(view.id), [640, 480], Theme::Dark).shapes();
        let is_told = harness.query_by_label(text).is_some();
        assert_eq!(is_told, of_held(view.id), "{}", view.id);
        assert_eq!(harness.state().session.theta_deg, 120.0, "{}", view.id);
        if is_told {
            harness.get_by_label("Bring the light above").click();
            harness.run();
            assert_eq!(harness.state().session.theta_deg, 60.0, "{}", view.id);
            assert!(harness.query_by_label(text).is_none(), "{}", view.id);
        }
        let clear = Session {
            materials: session(&["fresnel_specular"]).materials,
            ..below
        };
        let harness = picture(clear, Some(view.id), [640, 480], Theme::Dark).shapes();
        assert!(harness.query_by_label(text).is_none(), "{}", view.id);
    }
    assert_eq!(session::THETA.range, [0.0, 180.0]);
}
