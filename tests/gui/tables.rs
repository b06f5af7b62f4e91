//! What the files of a view hold: what it shows, under its name.

#![expect(
    clippy::indexing_slicing,
    clippy::panic,
    reason = "a failed step is a failed test"
)]

use std::collections::HashMap;

use brdf_explorer::analysis::cartesian::Abscissa;
use brdf_explorer::analysis::hemisphere::Quantity;
use brdf_explorer::study::export::Format;
use brdf_explorer::study::session::Session;
use brdf_explorer::study::views::{
    TableKind, VIEWS, ViewKind, cartesian, hemisphere, lobe3d, polar, sampling, slice,
};
use brdf_explorer::ui::export;
use egui::Theme;

use super::{picture, session};

fn file(shown: &Session, view: &str, format: Format) -> String {
    let picture = picture(shown.clone(), Some(view), [480, 360], Theme::Light);
    String::from_utf8(export::bytes(picture, format).unwrap()).unwrap()
}

/// A table as its header and its rows.
struct Table {
    header: Vec<String>,
    rows: Vec<Vec<String>>,
}

impl Table {
    fn of(shown: &Session, view: &str) -> Self {
        let text = file(shown, view, Format::Csv);
        let mut reader = csv::Reader::from_reader(text.as_bytes());
        let header = reader.headers().unwrap().iter().map(str::to_owned);
        let header = header.collect();
        let row = |record: csv::Result<csv::StringRecord>| {
            record.unwrap().iter().map(str::to_owned).collect()
        };
        Self {
            header,
            rows: reader.records().map(row).collect(),
        }
    }

    fn column(&self, name: &str) -> Vec<String> {
        let index = self.header.iter().position(|column| column == name);
        let index = index.unwrap_or_else(|| panic!("{name} in {:?}", self.header));
        self.rows.iter().map(|row| row[index].clone()).collect()
    }

    /// The numbers of a column by the cells of others; empty cells are left out.
    fn by(&self, keys: &[&str], name: &str) -> HashMap<Vec<String>, f64> {
        let keys: Vec<Vec<String>> = keys.iter().map(|key| self.column(key)).collect();
        let values = self.column(name).into_iter().enumerate();
        let values = values.filter(|(_, cell)| !cell.is_empty());
        values
            .map(|(row, cell)| {
                let key = keys.iter().map(|column| column[row].clone()).collect();
                (key, cell.parse().unwrap())
            })
            .collect()
    }
}

/// A surface that light crosses, with deltas and values.
fn shown() -> Session {
    session(&["rough_conductor:alpha=0.4", "fresnel_specular:eta=1.5"])
}

/// `keys` name a place, `cosine` is |cos(theta)| there.
fn check_ratio(
    [without, with]: [&Table; 2],
    keys: &[&str],
    [f, f_cos]: [&str; 2],
    cosine: &dyn Fn(&[f64]) -> f64,
) {
    let (values, times) = (without.by(keys, f), with.by(keys, f_cos));
    let mut common = 0;
    for (key, value) in &values {
        let Some(product) = times.get(key) else {
            continue;
        };
        let numbers: Vec<f64> = key.iter().filter_map(|cell| cell.parse().ok()).collect();
        let expected = value * cosine(&numbers);
        let gap = (product - expected).abs();
        assert!(
            gap <= 1e-9 * value.abs() + 1e-12,
            "{key:?}: {product} {expected}"
        );
        common += usize::from(*value > 0.0);
    }
    assert!(common > 40, "{f}: {common} places in both");
}

/// The two tables of a view, without the cosine and with it.
fn both(view: &str, change: impl Fn(&mut Session)) -> [Table; 2] {
    [false, true].map(|with_cosine| {
        let mut shown = shown();
        change(&mut shown);
        shown.with_cosine = with_cosine;
        Table::of(&shown, view)
    })
}

#[test]
fn the_cosine_is_in_the_header_and_in_the_values() {
    let of_angle = |numbers: &[f64]| numbers[0].to_radians().cos().abs();
    let of_z = |numbers: &[f64]| numbers[2].abs();
    for channel in ["r", "g", "b", "luminance"] {
        let names = [
            format!("f_{channel} (1/sr)"),
            format!("f_cos_{channel} (1/sr)"),
        ];
        let names = [names[0].as_str(), names[1].as_str()];
        for view in ["polar", "cartesian"] {
            let [without, with] = both(view, |_| {});
            let keys = ["material", "angle (degrees)"];
            check_ratio([&without, &with], &keys, names, &of_angle);
        }
        let [without, with] = both("lobe3d", |_| {});
        let keys = ["material", "w_x", "w_y", "w_z"];
        check_ratio([&without, &with], &keys, names, &of_z);
    }
    let [without, with] = both("decomposition", |_| {});
    let quantities = |table: &Table| {
        let all = table.column("quantity").into_iter();
        all.collect::<std::collections::BTreeSet<String>>()
    };
    assert!(quantities(&without).contains("f") && !quantities(&without).contains("f_cos"));
    assert!(quantities(&with).contains("f_cos") && !quantities(&with).contains("f"));
    let keys = ["angle (degrees)", "part", "material"];
    let name = ["value_g"; 2];
    let lobes = |table: Table, quantity: &str| {
        let index = table
            .header
            .iter()
            .position(|name| name == "quantity")
            .unwrap();
        let rows = table.rows.into_iter().filter(|row| row[index] == quantity);
        Table {
            header: table.header,
            rows: rows.collect(),
        }
    };
    let (without, with) = (lobes(without, "f"), lobes(with, "f_cos"));
    check_ratio([&without, &with], &keys, name, &of_angle);
    // The hemisphere has a choice of its own.
    let hemisphere = |quantity| {
        let mut shown = shown();
        shown.views.each(|map: &mut hemisphere::Options| {
            (map.quantity, map.is_logarithmic) = (quantity, false);
        });
        Table::of(&shown, "hemisphere")
    };
    let tables = [hemisphere(Quantity::F), hemisphere(Quantity::FCos)];
    let keys = ["material", "w_x", "w_y", "w_z"];
    let names = ["f_g (1/sr)", "f_cos_g (1/sr)"];
    check_ratio([&tables[0], &tables[1]], &keys, names, &of_z);
}

/// The kinds of views that have a table which is the same each time.
fn tables() -> impl Iterator<Item = &'static ViewKind> {
    let views = VIEWS.iter();
    views.filter(|view| view.table == TableKind::Computed)
}

#[test]
fn views_without_the_cosine_stay_as_they_are() {
    for view in tables().filter(|view| !view.with_cosine) {
        let view = view.id;
        let [without, with] = both(view, |_| {});
        assert_eq!(without.header, with.header, "{view}");
        assert_eq!(without.rows, with.rows, "{view}");
    }
}

#[test]
fn decades_are_written_as_linear_values_and_say_so() {
    type Set = fn(&mut Session, bool);
    let cases: [(&str, Set); 5] = [
        ("polar", |shown, is| {
            let views = &mut shown.views;
            views.each(|plot: &mut polar::Options| plot.scale.set_logarithmic(is));
        }),
        ("lobe3d", |shown, is| {
            let views = &mut shown.views;
            views.each(|lobe: &mut lobe3d::Options| lobe.scale.set_logarithmic(is));
        }),
        ("cartesian", |shown, is| {
            let views = &mut shown.views;
            views.each(|plot: &mut cartesian::Options| plot.scale.set_logarithmic(is));
        }),
        ("hemisphere", |shown, is| {
            let views = &mut shown.views;
            views.each(|map: &mut hemisphere::Options| map.is_logarithmic = is);
        }),
        ("slice", |shown, is| {
            let views = &mut shown.views;
            views.each(|map: &mut slice::Options| map.is_logarithmic = is);
        }),
    ];
    for (view, set) in cases {
        let tables = [false, true].map(|is_logarithmic| {
            let mut shown = shown();
            set(&mut shown, is_logarithmic);
            Table::of(&shown, view)
        });
        let keys = match view {
            "polar" | "cartesian" => vec!["material", "angle (degrees)"],
            "slice" => vec!["theta_h (degrees)", "theta_d (degrees)", "material"],
            _ => vec!["material", "w_x", "w_y", "w_z"],
        };
        let names = ["f_r (1/sr)", "f_r (1/sr, linear)"];
        check_ratio([&tables[0], &tables[1]], &keys, names, &|_| 1.0);
    }
}

#[test]
fn what_is_divided_or_taken_off_is_named() {
    let mut shown = shown();
    let set = |shown: &mut Session, set: fn(&mut cartesian::Options)| shown.views.each(set);
    set(&mut shown, |plot| plot.scale.is_each_to_peak = true);
    let table = Table::of(&shown, "cartesian");
    for name in ["f_over_peak_r", "f_over_peak_luminance"] {
        let values = table.column(name).into_iter();
        let values = values.filter_map(|cell| cell.parse::<f64>().ok());
        let peak = values.fold(0.0, f64::max);
        assert!((peak - 1.0).abs() < 1e-12, "{name}: {peak}");
    }
    let first = shown.materials.iter().next().unwrap().id();
    shown.materials.compare_with(first);
    set(&mut shown, |plot| {
        (plot.scale.is_each_to_peak, plot.is_residual) = (false, true);
    });
    let table = Table::of(&shown, "cartesian");
    assert!(table.header.contains(&"f_difference_r (1/sr)".to_owned()));
    assert!(table.header.contains(&"delta_difference_r".to_owned()));
    set(&mut shown, |plot| plot.abscissa = Abscissa::Half);
    let header = Table::of(&shown, "cartesian").header;
    assert_eq!(header[1], "theta_h (degrees)");
}

#[test]
fn deltas_have_rows_of_their_own() {
    for (view, keys) in [
        ("polar", &["angle (degrees)"][..]),
        ("cartesian", &["angle (degrees)"]),
        ("lobe3d", &["w_x", "w_y", "w_z"]),
        ("hemisphere", &["w_x", "w_y", "w_z"]),
        ("slice", &["theta_h (degrees)", "theta_d (degrees)"]),
    ] {
        let mirror = session(&["specular_reflection:reflectance=0.9"]);
        let table = Table::of(&mirror, view);
        let shares = table.by(keys, "delta_luminance");
        assert!(!shares.is_empty(), "{view}");
        for (place, share) in shares {
            assert!((share - 0.9).abs() < 1e-12, "{view}: {share}");
            let place: Vec<f64> = place.iter().map(|cell| cell.parse().unwrap()).collect();
            match place[..] {
                // Held from the left at 50 degrees.
                [angle] => assert!((angle - 50.0).abs() < 1e-9, "{view}: {angle}"),
                [x, _, z] => {
                    assert!((z - 50.0_f64.to_radians().cos()).abs() < 1e-9 && x > 0.0);
                }
                [theta_h, _] => assert!(theta_h == 0.0),
                _ => unreachable!(),
            }
        }
    }
    let parts = Table::of(&session(&["fresnel_specular"]), "decomposition");
    let quantities = parts.column("quantity");
    assert_eq!(quantities.iter().filter(|name| *name == "delta").count(), 2);
}

#[test]
fn meshes_hold_what_the_table_of_the_lobe_does() {
    for with_cosine in [false, true] {
        let mut shown = session(&["rough_dielectric:alpha=0.4"]);
        shown.with_cosine = with_cosine;
        let name = if with_cosine {
            "f_cos_luminance (1/sr)"
        } else {
            "f_luminance (1/sr)"
        };
        let table = Table::of(&shown, "lobe3d");
        let lengths = table.column(name);
        let mesh = file(&shown, "lobe3d", Format::Obj);
        assert!(mesh.lines().next().unwrap().contains(name));
        let vertices: Vec<&str> = mesh.lines().filter(|line| line.starts_with("v ")).collect();
        assert_eq!(vertices.len(), lengths.len());
        for (vertex, length) in vertices.iter().zip(&lengths) {
            let numbers = vertex[2..].split(' ').map(|x| x.parse::<f64>().unwrap());
            let square: f64 = numbers.map(|x| x * x).sum();
            let expected: f64 = length.parse().unwrap();
            assert!((square.sqrt() - expected).abs() < 1e-9 * expected + 1e-15);
        }
        assert!(file(&shown, "lobe3d", Format::Gltf).contains(name));
    }
    let mixed = shown();
    let mesh = file(&mixed, "lobe3d", Format::Obj);
    assert_eq!(mesh.matches("# Delta of ").count(), 2, "those of glass");
}

#[test]
fn every_plot_of_the_sampling_has_its_table() {
    let mut headers = std::collections::HashSet::new();
    for plot in sampling::Plot::ALL {
        let mut shown = session(&["rough_conductor"]);
        shown
            .views
            .each(|shown: &mut sampling::Options| shown.plot = *plot);
        let table = Table::of(&shown, "sampling");
        assert!(headers.insert(table.header), "{}", plot.title());
        assert!(!table.rows.is_empty());
    }
}

#[test]
fn columns_are_named_once_and_rows_are_as_long() {
    for view in tables() {
        let table = Table::of(&shown(), view.id);
        let mut names = table.header.clone();
        names.sort();
        names.dedup();
        assert_eq!(names.len(), table.header.len(), "{}", view.id);
        let is_as_long = |row: &Vec<String>| row.len() == table.header.len();
        assert!(table.rows.iter().all(is_as_long), "{}", view.id);
    }
}
