//! The integral: what is chosen, typed and played, and what its file holds.

use brdf_explorer::analysis::integral::Integrand;
use brdf_explorer::study::export::Format;
use brdf_explorer::study::session::Session;
use brdf_explorer::study::views::integral::Options;
use brdf_explorer::ui::app::App;
use brdf_explorer::ui::export;
use egui::{Key, Role, Theme};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;

use super::{picture, session};

fn shown(materials: &[&str], set: impl Fn(&mut Options)) -> Session {
    let mut shown = session(materials);
    shown.views.each(set);
    shown
}

fn alone(shown: Session) -> Harness<'static, App> {
    let picture = picture(shown, Some("integral"), [900, 560], Theme::Dark);
    picture.harness().unwrap()
}

fn says(harness: &Harness<'_, App>, part: &str) -> bool {
    harness.query_all_by_label_contains(part).next().is_some()
}

/// Whether a text with `part` in it is painted.
fn paints(harness: &Harness<'_, App>, part: &str) -> bool {
    let shapes = harness.output().shapes.iter();
    shapes
        .map(|clipped| &clipped.shape)
        .any(|shape| matches!(shape, egui::Shape::Text(text) if text.galley.text().contains(part)))
}

fn choose(harness: &mut Harness<'_, App>, integrand: &str) {
    let combo = harness.get_by_role_and_label(Role::ComboBox, "Integrand");
    combo.click();
    harness.run();
    harness
        .get_by_role_and_label(Role::Button, integrand)
        .click();
    harness.run();
}

#[test]
fn each_integrand_has_its_exact_value_and_says_which_sum_it_is() {
    let mut harness = alone(session(&["lambertian_reflection:reflectance=0.5"]));
    assert!(says(&harness, "Exact ρ_dh = 0.5000") && says(&harness, "0.5000"));
    assert!(says(&harness, "share of the light arriving"));
    choose(&mut harness, "1");
    assert!(says(&harness, "Exact 2π = 6.2832") && says(&harness, "exactly, at every count"));
    choose(&mut harness, "cos θ");
    assert!(says(&harness, "Exact π = 3.1416") && says(&harness, "No error"));
    assert!(says(&harness, "area of the unit disc"));
    choose(&mut harness, "Density");
    assert!(says(&harness, "Exact P = 1.0000"));
    let options: Options = harness.state().session.views.options();
    assert_eq!(options.integrand, Integrand::Density);
}

#[test]
fn a_viewer_that_is_held_sees_the_other_reflectance() {
    let mut viewer = session(&["gold"]);
    viewer.hold = brdf_explorer::analysis::Hold::Viewer;
    let harness = alone(viewer);
    assert!(says(&harness, "Exact ρ_hd = ") && says(&harness, "even sky"));
}

#[test]
fn a_count_is_typed_and_what_is_none_is_refused() {
    let mut harness = alone(session(&["gold"]));
    let mut enter = |text: &str| {
        let field = harness.get_by_role_and_label(Role::SpinButton, "Patches");
        field.focus();
        harness.step();
        harness.event(egui::Event::Text(text.to_owned()));
        harness.step();
        harness.key_press(Key::Enter);
        harness.run();
        let options: Options = harness.state().session.views.options();
        options.count_log2
    };
    assert_eq!(enter("1024"), 10);
    assert_eq!(enter("1000"), 10, "no power of 2");
    assert!(says(&harness, "no power of 2"));
    let mut harness = alone(shown(&["gold"], |options| options.count_log2 = 6));
    assert!(says(&harness, "Sum of 64 patches"));
    harness.step();
}

#[test]
fn playing_fills_the_bar_and_then_rests() {
    let mut harness = alone(shown(&["chalk"], |options| {
        (options.count_log2, options.seconds) = (4, 2.0);
    }));
    assert!(says(&harness, "Sum of 16 patches"));
    harness.get_by_label("Play").click();
    harness.step();
    harness.step();
    assert!(says(&harness, "of 16 patches") && says(&harness, "to come"));
    assert!(!says(&harness, "Sum of 16 patches"));
    let mut frames = 0;
    while !says(&harness, "Sum of 16 patches") {
        harness.step();
        frames += 1;
        assert!(frames < 40, "it never ends");
    }
    assert!(frames > 2, "{frames}");
    // It settles: nothing asks for another frame.
    harness.run();
    assert!(harness.query_by_label("Play").is_some());
    harness.get_by_label("Play").click();
    harness.step();
    harness.step();
    harness.get_by_label("Stop").click();
    harness.run();
    assert!(says(&harness, "Sum of 16 patches"));
}

/// The sum of a column of the exported table.
fn column(shown: &Session, name: &str) -> f64 {
    let picture = picture(shown.clone(), Some("integral"), [480, 360], Theme::Light);
    let text = String::from_utf8(export::bytes(picture, Format::Csv).unwrap()).unwrap();
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let header = reader.headers().unwrap().clone();
    let index = header.iter().position(|column| column == name).unwrap();
    let cells = reader
        .records()
        .map(|record| record.unwrap()[index].to_owned());
    cells
        .filter(|cell| !cell.is_empty())
        .map(|cell| cell.parse::<f64>().unwrap())
        .sum()
}

#[test]
fn the_exported_parts_sum_to_the_number_shown() {
    for material in ["gold", "fresnel_specular:eta=1.5", "frosted_glass"] {
        for integrand in Integrand::ALL {
            let shown = shown(&[material], |options| options.integrand = integrand);
            let sum = column(&shown, "part_luminance");
            let harness = alone(shown);
            assert!(
                says(&harness, &format!("{sum:.4}")),
                "{material} {integrand:?}: {sum}"
            );
        }
    }
    let whole = shown(&["fresnel_specular"], |options| {
        options.integrand = Integrand::Cosine;
    });
    let shadows = column(&whole, "shadow");
    assert!((shadows - std::f64::consts::TAU).abs() < 1e-12, "two discs");
}

#[test]
fn what_there_is_nothing_of_is_said() {
    let mirror = alone(session(&["specular_reflection:reflectance=0.9"]));
    assert!(says(&mirror, "only points fall") && paints(&mirror, "delta 0.900"));
    let black = alone(session(&["lambertian_reflection:reflectance=0"]));
    assert!(says(&black, "nothing falls") && says(&black, "Error 0"));
    let needle = alone(shown(&["rough_conductor:alpha=0.001"], |options| {
        options.count_log2 = 4;
    }));
    assert!(says(&needle, "The patches miss the glossy specular lobe"));
    assert!(says(&needle, "million would find it"));
    let below = Session {
        theta_deg: 120.0,
        ..session(&["chalk"])
    };
    assert!(says(&alone(below), "Bring the light above"));
    // The solid angle is the same wherever the light is.
    let below = Session {
        theta_deg: 120.0,
        ..shown(&["chalk"], |options| options.integrand = Integrand::One)
    };
    assert!(!says(&alone(below), "Bring the light above"));
}

#[test]
fn a_count_out_of_range_in_a_file_is_refused() {
    for (line, expected) in [
        (
            "count_log2 = 30",
            "integral.count_log2 = 30: allowed is a whole number from 4 to 12",
        ),
        (
            "seconds = 0",
            "integral.seconds = 0: allowed is 1 to 60 seconds",
        ),
        ("integrand = \"sine\"", "unknown variant `sine`"),
    ] {
        let text = format!("[views.integral]\n{line}\n");
        let error = Session::from_toml(&text, "s.toml").unwrap_err().to_string();
        assert!(error.contains(expected), "{error}");
    }
}
