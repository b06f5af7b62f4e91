//! Whether colours can be read, and told apart by eyes of every common kind.

use palette::color_difference::Ciede2000 as _;
use palette::white_point::D65;
use palette::{FromColor as _, Lab, LinSrgb, Srgb};

use super::*;

const THEMES: [Theme; 2] = [Theme::Dark, Theme::Light];

/// The contrast of lines and marks that WCAG 2.1 asks for (success criterion 1.4.11).
const LINE_CONTRAST: f32 = 3.0;

/// The enhanced contrast of text of the same guidelines (1.4.6).
const FIGURE_CONTRAST: f32 = 7.0;

/// The least CIEDE2000 between colours that mean different things.
const APART: f64 = 12.0;

/// The same between those that icons, names and dashes tell apart besides.
const NAMED_APART: f64 = 7.0;

/// What eyes make of linear RGB: normal sight, protanopia, deuteranopia; the latter at severity 1.0 by `machado2009`, table 1.
const SIGHTS: [(&str, [[f64; 3]; 3]); 3] = [
    (
        "normal",
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
    ),
    (
        "protan",
        [
            [0.152_286, 1.052_583, -0.204_868],
            [0.114_503, 0.786_281, 0.099_216],
            [-0.003_882, -0.048_116, 1.051_998],
        ],
    ),
    (
        "deutan",
        [
            [0.367_322, 0.860_646, -0.227_968],
            [0.280_085, 0.672_501, 0.047_413],
            [-0.011_820, 0.042_940, 0.968_881],
        ],
    ),
];

fn linear(color: Color32) -> [f64; 3] {
    let [r, g, b, alpha] = color.to_array();
    assert_eq!(alpha, 255, "{color:?} lets through what is behind it");
    Srgb::new(r, g, b).into_format::<f64>().into_linear().into()
}

fn seen(color: Color32, [r, g, b]: [[f64; 3]; 3]) -> Lab<D65, f64> {
    let light = linear(color);
    let channel = |row: [f64; 3]| {
        let sum: f64 = row
            .iter()
            .zip(light)
            .map(|(weight, own)| weight * own)
            .sum();
        sum.clamp(0.0, 1.0)
    };
    Lab::from_color(LinSrgb::new(channel(r), channel(g), channel(b)))
}

/// The least difference of two colours to any eyes, and to which.
fn difference(one: Color32, other: Color32) -> (f64, &'static str) {
    let to = |(name, sight)| (seen(one, sight).difference(seen(other, sight)), name);
    let found = SIGHTS.map(to);
    found
        .into_iter()
        .min_by(|a, b| a.0.total_cmp(&b.0))
        .unwrap()
}

fn roles(palette: &Palette) -> [(&'static str, Color32); 4] {
    [
        ("light", palette.light),
        ("viewer", palette.viewer),
        ("mirror", palette.mirror),
        ("ink", palette.ink),
    ]
}

#[test]
fn text_and_handles_can_be_read_on_everything_behind_them() {
    for theme in THEMES {
        let palette = Palette::of(theme);
        let ctx = egui::Context::default();
        crate::theme::apply(&ctx);
        let visuals = ctx.style_of(theme).visuals.clone();
        let grounds = [
            ("views", palette.background),
            ("backdrop", palette.backdrop),
            ("panels", visuals.panel_fill),
            ("windows", visuals.window_fill),
            ("fields", visuals.extreme_bg_color),
        ];
        let texts = [
            ("faint", palette.faint_ink),
            ("weak", visuals.weak_text_color()),
            ("warning", palette.warning),
            ("error", visuals.error_fg_color),
            ("kept", palette.kept),
            ("angles", palette.geometry),
            ("red", palette.red),
            ("green", palette.green),
            ("blue", palette.blue),
            ("focus", palette.accent_line),
        ];
        for (text, color) in roles(&palette).into_iter().chain(texts) {
            for (ground, behind) in grounds {
                let found = contrast(color, behind);
                assert!(
                    found >= TEXT_CONTRAST,
                    "{theme:?}: {text} on {ground}: {found:.2}"
                );
            }
        }
        let widgets = [
            visuals.widgets.inactive,
            visuals.widgets.hovered,
            visuals.widgets.active,
            visuals.widgets.open,
        ];
        let mut fills: Vec<Color32> = widgets.iter().map(|widget| widget.weak_bg_fill).collect();
        fills.push(visuals.selection.bg_fill);
        for fill in fills {
            let found = contrast(visuals.text_color(), fill);
            assert!(
                found >= TEXT_CONTRAST,
                "{theme:?}: text on {fill:?}: {found:.2}"
            );
        }
    }
}

#[test]
fn secondary_text_of_figures_is_read_from_afar() {
    for theme in THEMES {
        let palette = Palette::of(theme).of_figure();
        let found = contrast(palette.faint_ink, palette.background);
        assert!(found >= FIGURE_CONTRAST, "{theme:?}: {found:.2}");
    }
}

#[test]
fn lines_and_areas_are_seen() {
    for theme in THEMES {
        let palette = Palette::of(theme);
        let materials = palette.materials.into_iter().chain(palette.categories);
        for color in materials {
            for behind in [palette.background, palette.panel] {
                let found = contrast(color, behind);
                assert!(found >= LINE_CONTRAST, "{theme:?}: {color:?}: {found:.2}");
            }
            let found = contrast(palette.text_in(color), palette.background);
            assert!(found >= TEXT_CONTRAST, "{theme:?}: {color:?}: {found:.2}");
        }
    }
}

#[test]
fn materials_and_roles_are_told_apart_by_all_eyes() {
    for theme in THEMES {
        let palette = Palette::of(theme);
        for (index, one) in palette.materials.into_iter().enumerate() {
            let others = palette.materials.into_iter().take(index);
            let others = others.map(|color| ("another material", color));
            for (name, other) in others.chain(roles(&palette)) {
                let (found, sight) = difference(one, other);
                assert!(
                    found >= APART,
                    "{theme:?}: material {index} and {name}: {found:.1} to {sight} eyes"
                );
            }
        }
    }
}

#[test]
fn a_category_has_the_colour_of_no_material() {
    for theme in THEMES {
        let palette = Palette::of(theme);
        for (index, one) in palette.categories.into_iter().enumerate() {
            let others = palette.categories.into_iter().take(index);
            for other in others.chain(palette.materials).chain([palette.absorbed]) {
                let found = seen(one, SIGHTS[0].1).difference(seen(other, SIGHTS[0].1));
                assert!(
                    found >= NAMED_APART,
                    "{theme:?}: category {index} {one:?} and {other:?}: {found:.1}"
                );
            }
        }
    }
}
