//! Every number that can be typed, key by key.

use std::collections::BTreeSet;

use brdf_explorer::analysis::cartesian::Abscissa;
use brdf_explorer::bxdf::models::MODELS;
use brdf_explorer::bxdf::param::{Kind, ParamSpec, Value};
use brdf_explorer::bxdf::{Component, Material, ModelSpec};
use brdf_explorer::study::answers::Progress;
use brdf_explorer::study::parameters::labels;
use brdf_explorer::study::session::{Session, folded_deg, wrapped_deg};
use brdf_explorer::study::store::Side;
use brdf_explorer::study::views::{VIEWS, cartesian, integral, sampling, slice, sphere, tradeoff};
use brdf_explorer::ui::app::App;
use brdf_explorer::ui::theme::{self, Palette};
use brdf_explorer::ui::widgets::bottom::Bar;
use brdf_explorer::ui::widgets::components::Components;
use brdf_explorer::ui::widgets::options;
use brdf_explorer::ui::widgets::params::Ties;
use brdf_explorer::ui::widgets::shares::Energy;
use egui::{Key, Theme, Ui, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;

use super::typing::{enter, fields, press, said, type_into};
use super::{picture, session};

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

/// The parameters of the selected material, as the panel at the side has them with nothing folded away.
fn panel(material: Material) -> Harness<'static, Session> {
    let mut components = Components::default();
    let show = move |ui: &mut Ui, session: &mut Session| {
        let Session {
            materials,
            locked,
            pinned,
            ..
        } = session;
        let before = materials.selected().clone();
        let mut edited = before.clone();
        let mut ties = Ties {
            has_linked_widths: &mut edited.has_linked_widths,
            locked,
            pinned,
            is_shared: &|_| false,
        };
        let mut side = Side {
            shows_more: true,
            shows_indices: true,
            ..Side::default()
        };
        components.show(ui, &mut edited.material, &mut ties, &mut side);
        if edited != before {
            *materials.selected_mut() = edited;
            materials.follow(&before, locked);
        }
    };
    Harness::builder()
        .with_size(vec2(theme::SIDE_WIDTH, 1600.0))
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
    let is_colour = spec.kind == Kind::Rgb;
    let names = labels(spec).into_iter().enumerate();
    names
        .map(|(index, name)| (name, is_colour.then_some(index)))
        .collect()
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
    let listed: [Field; 9] = [
        ("cartesian", "at θd", [0.0, 90.0], Some, |s| {
            s.views.options::<cartesian::Options>().fixed_deg
        }),
        ("cartesian", "at θh", [0.0, 90.0], Some, |s| {
            s.views.options::<cartesian::Options>().fixed_deg
        }),
        ("integral", "Patches", [16.0, 4096.0], power_of_2, |s| {
            f64::from(s.views.options::<integral::Options>().count_log2).exp2()
        }),
        ("integral", "Duration", [1.0, 60.0], Some, |s| {
            s.views.options::<integral::Options>().seconds
        }),
        ("slice", "φd", [0.0, 180.0], Some, |s| {
            s.views.options::<slice::Options>().phi_d_deg
        }),
        ("sphere", "Exposure", [-6.0, 6.0], Some, |s| {
            s.views.options::<sphere::Options>().exposure
        }),
        ("sampling", "Samples", [64.0, 65536.0], power_of_2, |s| {
            f64::from(s.views.options::<sampling::Options>().count_log2).exp2()
        }),
        ("sampling", "Seed", [0.0, 4_294_967_295.0], whole, |s| {
            f64::from(s.views.options::<sampling::Options>().seed)
        }),
        ("tradeoff", "Tolerance", [1e-12, 1.0], Some, |s| {
            s.views.options::<tradeoff::Options>().tolerance
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
            shown
                .views
                .each(|plot: &mut cartesian::Options| plot.abscissa = abscissa);
            let mut harness = picture(shown, Some(view.id), [640, 480], Theme::Dark).controls();
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

/// The azimuth of the own section of the first view.
fn own_section(session: &Session) -> f64 {
    let views = &session.views;
    let mut options = views.get(views.ids()[0]).unwrap().clone();
    options.own_section().unwrap().0.unwrap()
}

#[test]
fn the_own_section_of_every_view_that_has_one_is_typed() {
    let stored = |x| Some(folded_deg(x));
    let field: Field = ("", "Own section", [-360.0, 360.0], stored, own_section);
    let mut found = 0;
    for view in &VIEWS {
        let mut shown = session(&["lambertian_reflection"]);
        shown.materials.selected_mut().is_visible = false;
        let id = shown.views.show_alone(view);
        let options = shown.views.get_mut(id).unwrap();
        if let Some(section) = options.own_section() {
            section.0 = Some(10.0);
            let mut harness = picture(shown, Some(view.id), [640, 480], Theme::Dark).controls();
            try_field(&mut harness, &field, |app: &App| &app.session);
            found += 1;
        }
    }
    assert!(found >= 4, "{found}");
}

#[test]
fn every_number_of_the_panels_is_typed() {
    let listed: [Field; 4] = [
        ("", "θ from n", [0.0, 90.0], Some, |s| s.theta_deg),
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
        options::section(ui, session);
        let palette = Palette::of(Theme::Dark);
        let bar = Bar {
            cursor: None,
            energy: Energy::of(glam::DVec3::Z, Some(&[]), &palette),
            progress: Progress::Complete(None),
        };
        bar.show(ui, session);
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
