use super::*;
use crate::Material;
use crate::math::frame::direction_from_degrees;
use crate::resource::{Decoded, Resource};

const LIMIT: u64 = 1 << 26;

fn baked(text: &str, n: usize) -> Table {
    let material: Material = text.parse().unwrap();
    let shape = Shape::of(n, material.is_isotropic()).unwrap();
    Table::bake(&*material.build::<f64>(), shape, LIMIT).unwrap()
}

fn at(table: &Table, [theta_o, phi_o, theta_i, phi_i]: [f64; 4]) -> [f64; 3] {
    let wo: Vec3<f64> = direction_from_degrees(theta_o, phi_o).into();
    let wi: Vec3<f64> = direction_from_degrees(theta_i, phi_i).into();
    table.value(wo, wi, (wo + wi).unit()).0
}

#[test]
fn the_law_of_lommel_and_seeliger_is_the_same_everywhere() {
    let table = Table::even(0.1);
    for angles in [
        [0.0, 0.0, 0.0, 0.0],
        [30.0, 10.0, 60.0, 200.0],
        [89.9, 0.0, 89.9, 90.0],
    ] {
        let [theta_o, _, theta_i, _] = angles.map(f64::to_radians);
        let exact = f64::from(0.1_f32) / (theta_o.cos() + theta_i.cos());
        let value = at(&table, angles);
        assert!(
            value.iter().all(|x| (x / exact - 1.0).abs() < 1e-12),
            "{value:?}"
        );
    }
}

#[test]
fn colours_are_kept_and_a_diffuse_surface_is_wide() {
    let table = baked("lambertian_reflection:reflectance=.1/.5/.9", 64);
    let [r, g, b] = at(&table, [30.0, 10.0, 60.0, 200.0]);
    assert!((g / r - 5.0).abs() < 1e-5 && (b / r - 9.0).abs() < 1e-5);
    assert!((r * std::f64::consts::PI - 0.1).abs() < 1e-4, "{r}");
    assert!(table.alpha() > 0.7);
}

#[test]
fn finer_tables_are_nearer_and_reciprocal() {
    for (text, angles) in [
        ("rough_conductor:alpha=.3", [40.0, 20.0, 30.0, 170.0]),
        (
            "rough_conductor:alpha_x=.5,alpha_y=.25",
            [40.0, 20.0, 35.0, 230.0],
        ),
    ] {
        let material: Material = text.parse().unwrap();
        let [theta_o, phi_o, theta_i, phi_i] = angles;
        let exact = material.build::<f64>().f(
            direction_from_degrees(theta_o, phi_o).into(),
            direction_from_degrees(theta_i, phi_i).into(),
        );
        let errors = [8, 16, 32].map(|n| {
            let table = baked(text, n);
            let back = at(&table, [theta_i, phi_i, theta_o, phi_o]);
            let value = at(&table, angles);
            assert!((back[0] / value[0] - 1.0).abs() < 1e-12);
            (value[0] / exact.0[0] - 1.0).abs()
        });
        // Straight lines: a quarter of the error for half the distance; at a single pair some luck is allowed for.
        assert!(
            errors[2] < 0.02 && errors[2] < 0.3 * errors[0],
            "{text} {errors:?}"
        );
    }
}

#[test]
fn the_width_of_a_lobe_is_found() {
    for alpha in [0.05, 0.2, 0.5] {
        let found = baked(&format!("rough_conductor:fresnel=one,alpha={alpha}"), 64).alpha();
        assert!((found / alpha - 1.0).abs() < 0.15, "{alpha}: {found}");
    }
}

#[test]
fn what_would_take_too_much_is_refused_before_it_is_made() {
    let material: Material = "lambertian_reflection".parse().unwrap();
    let bxdf = material.build::<f64>();
    let huge = Shape::of(4096, false).unwrap();
    let line = Table::bake(&*bxdf, huge, LIMIT).unwrap_err().to_string();
    assert_eq!(
        line,
        "the table is of 4096x4096x4096x4096 nodes, 3221225472.0 MiB; the limit is 64.0 MiB"
    );
    assert!(Shape::of(1, true).is_err() && Shape::of(5000, true).is_err());
}

#[test]
fn text_brings_a_table_back() {
    for text in ["oren_nayar:sigma=30", "ward:alpha_x=.1,alpha_y=.3"] {
        let table = baked(text, 5);
        let text = table.to_string();
        assert_eq!(table.text_bytes(), text.len() as u64);
        let read: Table = text.parse().unwrap();
        assert!(read == table);
    }
    for (text, expected) in [
        ("2x2x2", "HALVES"),
        ("2x2;AAAA", "three or four numbers"),
        ("2x2x2;AAAA", "3 bytes of values for 2x2x2 nodes"),
        ("1x2x2;", "from 2 to 4096"),
        ("2x2x2;A?", "values: "),
    ] {
        let line = text.parse::<Table>().unwrap_err().to_string();
        assert!(line.contains(expected) && !line.contains('\n'), "{line}");
    }
    let bad = Table::even(1.0).to_string().replace("AACAP", "AADAf");
    let line = bad.parse::<Table>().unwrap_err().to_string();
    assert!(line.contains("a value of NaN"), "{line}");
}

#[test]
fn a_material_with_a_table_is_printed_and_read() {
    let mut component: crate::Component = "table".parse().unwrap();
    let decoded = std::sync::Arc::new(Decoded::table(baked("phong", 3)));
    component
        .set_resource("data", Resource::inline(decoded))
        .unwrap();
    let mut material = Material::from(component);
    material.name = "Baked".to_owned();
    let file = crate::material::file::print(&material);
    let read = crate::material::file::parse(&file, "baked.toml").unwrap();
    assert_eq!(read, material);
    assert_ne!(
        read.components(),
        Material::from("table".parse::<crate::Component>().unwrap()).components()
    );
    let line = "phong:data=2x2x2;AAAA".parse::<Material>().unwrap_err();
    assert!(line.to_string().contains("unknown parameter 'data'"));
}
