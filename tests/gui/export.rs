//! Files of what is on the screen, from the command line and from the window.

use std::fs;
use std::process::{Command, Output};

use brdf_explorer::study::answers::Answers;
use brdf_explorer::study::colors;
use brdf_explorer::study::export::{FORMATS, Format};
use brdf_explorer::study::session::Session;
use brdf_explorer::study::views::{VIEWS, cartesian};
use brdf_explorer::ui::export;
use brdf_explorer::ui::headless::Picture;
use egui::Theme;

use super::{Folder, picture, session};

fn view(shown: Session, id: &str) -> Picture {
    picture(shown, Some(id), [480, 360], Theme::Light)
}

fn text(picture: Picture, format: Format) -> String {
    String::from_utf8(export::bytes(picture, format).unwrap()).unwrap()
}

/// The points of each path of the drawing with a stroke of this colour.
fn points_of(drawing: &str, stroke: &str) -> Vec<[f64; 2]> {
    let is_stroke = |line: &&str| line.starts_with("<path") && line.contains(stroke);
    let path = |line: &str| line.split('"').nth(1).unwrap().to_owned();
    let paths = drawing.lines().filter(is_stroke).map(path);
    let numbers = |point: &str| -> Option<[f64; 2]> {
        let (x, y) = point.split_once(' ')?;
        Some([x.parse().ok()?, y.parse().ok()?])
    };
    let points = paths.flat_map(|path| {
        let all: Vec<_> = path.split(['M', 'L']).filter_map(numbers).collect();
        all
    });
    points.collect()
}

/// The largest distance of `ys` from the line over `xs` that fits them best.
fn worst_misfit(xs: &[f64], ys: &[f64]) -> f64 {
    let n = xs.len() as f64;
    let mean = |values: &[f64]| values.iter().sum::<f64>() / n;
    let (x0, y0) = (mean(xs), mean(ys));
    let spread: f64 = xs.iter().map(|x| (x - x0).powi(2)).sum();
    let slope = xs
        .iter()
        .zip(ys)
        .map(|(x, y)| (x - x0) * (y - y0))
        .sum::<f64>()
        / spread;
    let misfits = xs
        .iter()
        .zip(ys)
        .map(|(x, y)| (y - y0 - slope * (x - x0)).abs());
    misfits.fold(0.0, f64::max)
}

#[test]
fn the_curve_of_a_drawing_is_that_of_the_data() {
    let shown = session(&["rough_conductor:alpha=0.05"]);
    let entry = shown.materials.selected();
    let curve =
        Answers::at_once().ask(&shown, entry, cartesian::Options::default().request(&shown));
    let [line] = &curve.lines[..] else {
        panic!("one line above the surface");
    };
    let drawing = text(view(shown.clone(), "cartesian"), Format::Svg);
    let [[r, g, b], ..] = colors::material_colors(colors::Theme::Light);
    let stroke = format!("stroke=\"#{r:02x}{g:02x}{b:02x}\" stroke-width=\"2\"");
    let drawn = points_of(&drawing, &stroke);
    assert_eq!(drawn.len(), line.len());
    let luminance = |rgb| brdf_explorer::analysis::Channel::Luminance.of(rgb);
    let pick = |index: usize| drawn.iter().map(|point| point[index]).collect::<Vec<_>>();
    let angles: Vec<f64> = line.iter().map(|point| point.x_deg).collect();
    let values: Vec<f64> = line.iter().map(|point| luminance(point.value)).collect();
    // Half a pixel of a picture that shows a point as a pixel.
    assert!(worst_misfit(&angles, &pick(0)) < 0.5);
    assert!(worst_misfit(&values, &pick(1)) < 0.5);
}

#[test]
fn text_stays_text_and_pictures_are_inside() {
    let drawing = text(view(session(&["gold"]), "reflectance"), Format::Svg);
    assert!(
        drawing.contains(">ρ, share that leaves</text>"),
        "{drawing}"
    );
    let map = text(view(session(&["gold"]), "hemisphere"), Format::Svg);
    assert!(map.contains("href=\"data:image/png;base64,iVBOR"));
    for drawing in [drawing, map] {
        assert!(drawing.starts_with("<svg ") && drawing.ends_with("</svg>\n"));
        let count = |part: &str| drawing.matches(part).count();
        assert_eq!(count("<g "), count("</g>"));
    }
}

#[test]
fn tables_have_every_digit_and_their_units() {
    let shown = session(&["rough_conductor", "plastic"]);
    let table = text(view(shown.clone(), "cartesian"), Format::Csv);
    let mut lines = table.lines();
    assert_eq!(
        lines.next(),
        Some(
            "material,angle (degrees),f_r (1/sr),f_g (1/sr),f_b (1/sr),f_luminance (1/sr),\
             delta_r,delta_g,delta_b,delta_luminance"
        )
    );
    let mut answers = Answers::at_once();
    for entry in shown.materials.iter() {
        let curve = answers.ask(&shown, entry, cartesian::Options::default().request(&shown));
        for point in curve.lines.iter().flatten() {
            let mut cells = lines.next().unwrap().split(',');
            assert_eq!(cells.next(), Some(shown.materials.title(entry).as_str()));
            let (numbers, empty): (Vec<&str>, Vec<&str>) = cells.partition(|cell| !cell.is_empty());
            assert_eq!(empty.len(), 4, "no delta");
            let numbers = numbers.into_iter();
            let numbers = numbers.map(|cell| cell.parse::<f64>().unwrap().to_bits());
            let [r, g, b] = point.value;
            let y = brdf_explorer::analysis::Channel::Luminance.of(point.value);
            let expected = [point.x_deg, r, g, b, y].map(f64::to_bits);
            assert_eq!(numbers.collect::<Vec<u64>>(), expected);
        }
    }
    assert_eq!(lines.next(), None);
}

#[test]
fn every_view_has_the_files_it_offers_and_no_others() {
    for view_spec in &VIEWS {
        for format in &FORMATS {
            if matches!(format.format, Format::Png | Format::Toml) {
                continue;
            }
            let made = export::bytes(
                view(session(&["frosted_glass"]), view_spec.id),
                format.format,
            );
            // Meshes are those of the materials, whatever the view.
            let is_mesh = matches!(format.format, Format::Obj | Format::Gltf);
            let expected = is_mesh || view_spec.has_file(format.format);
            assert_eq!(
                made.is_ok(),
                expected,
                "{} {}",
                view_spec.id,
                format.extension
            );
        }
    }
}

#[test]
fn a_material_comes_back_from_its_file() {
    let file = text(view(session(&["car_paint"]), "polar"), Format::Toml);
    let shown = brdf_explorer::study::session::read(&file, "exported").unwrap();
    let brdf_explorer::study::session::Opened::Material(material) = shown else {
        panic!("a material");
    };
    assert_eq!(
        *material,
        session(&["car_paint"]).materials.selected().material
    );
}

fn run(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_brdf-explorer"));
    command.arg("export").args(arguments).output().unwrap()
}

#[test]
fn the_command_line_exports_by_the_end_of_the_name() {
    let folder = Folder::new("export");
    for (name, start) in [
        ("a.svg", "<svg"),
        ("a.CSV", "material,"),
        ("a.obj", "# Lobes"),
        ("a.gltf", "{"),
        ("a.toml", ""),
    ] {
        let path = folder.file(name);
        let output = run(&[
            "--material",
            "phong",
            "--material",
            "gold",
            "--view",
            "polar",
            "-o",
            path.to_str().unwrap(),
        ]);
        assert!(
            output.status.success(),
            "{name}: {}",
            String::from_utf8_lossy(&output.stderr)
        );
        assert!(
            fs::read_to_string(&path).unwrap().starts_with(start),
            "{name}"
        );
    }
}

#[test]
fn what_cannot_be_exported_is_said_in_a_line() {
    let folder = Folder::new("refused");
    let path = |name: &str| folder.file(name).to_str().unwrap().to_owned();
    let (good, unwritable) = (path("a.csv"), path("none/a.csv"));
    for (arguments, expected) in [
        (
            vec!["-o", "a.pdf"],
            "expected a name that ends in one of: png, svg, csv",
        ),
        (vec!["-o", &unwritable], "No such file or directory"),
        (
            vec!["--view", "pola", "-o", &good],
            "unknown view 'pola'; nearest: polar",
        ),
        (
            vec!["--view", "inspector", "-o", &good],
            "view 'inspector': no table",
        ),
        (
            vec![
                "--material",
                "specular_reflection:reflectance=0",
                "--view",
                "lobe3d",
                "-o",
                &good,
            ],
            "view 'lobe3d': nothing to show: All light is in Dirac deltas",
        ),
        (
            vec!["--material", "specular_reflection", "-o", &path("a.obj")],
            "no mesh: All light is in Dirac deltas",
        ),
        (vec!["--size", "0x5", "-o", &good], "expected WxH"),
        (
            vec!["--size", "8000x8000", "--scale", "2", "-o", &path("a.png")],
            "the limit is 1 to 8192",
        ),
    ] {
        let output = run(&arguments);
        let line = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {line}");
        assert!(
            line.contains(expected) && line.trim_end().lines().count() == 1,
            "{arguments:?}: {line}"
        );
    }
    assert!(
        fs::read_dir(folder.file("")).unwrap().next().is_none(),
        "nothing is left behind"
    );
}
