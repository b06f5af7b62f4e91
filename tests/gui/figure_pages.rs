//! Pages of figures: what stands on them has room.

use brdf_explorer::study::export::figure::Use;
use brdf_explorer::study::views::tradeoff;
use brdf_explorer::ui::headless::Title;
use egui::Theme;
use egui::accesskit::Role;
use egui_kittest::kittest::Queryable as _;

use super::figures::{controls_and_texts, figure, texts_of, uses};
use super::{EIGHT, THREE, session};

#[test]
fn a_title_that_is_too_long_ends_in_an_ellipsis() {
    let mut own = figure(session(&["gold"]), "polar", Use::Column, Theme::Light);
    let (long, longer) = ("word ".repeat(30), "word ".repeat(100));
    for (title, ends_in) in [(long.trim(), "word"), (&longer, "…")] {
        own.figure.as_mut().unwrap().title = Title::Own(title.to_owned());
        let (_, texts) = controls_and_texts(&own.clone().shapes());
        let found = texts.iter().find(|text| text.starts_with("word")).unwrap();
        assert!(found.ends_with(ends_in), "{found}");
        assert_eq!(found == title, ends_in == "word");
    }
}

/// Long legends and verdicts leave a plot the height in which it is read: the page grows.
#[test]
fn plots_are_legible_under_long_legends() {
    for (id, canvas) in [
        ("reflectance", "Reflectance"),
        ("stability", "Map of f32"),
        ("tradeoff", "How to evaluate f"),
    ] {
        let mut picture = figure(session(&EIGHT), id, Use::Column, Theme::Light);
        picture
            .session
            .views
            .each(|options: &mut tradeoff::Options| {
                options.is_immediate = true;
            });
        let harness = picture.shapes();
        let rect = harness.get_by_role_and_label(Role::Canvas, canvas).rect();
        assert!(rect.height() > 0.4 * rect.width(), "{id}: {rect}");
        assert!(rect.height() > 110.0, "{id}: {rect}");
        let page = harness.ctx.content_rect();
        assert!(page.contains_rect(rect), "{id}: {rect} on {page}");
    }
}

/// What stands behind the names of a legend is there for every material, and the names stand once.
#[test]
fn the_legend_of_a_figure_has_the_numbers_of_all() {
    for purpose in uses() {
        let harness = figure(session(&EIGHT), "reflectance", purpose, Theme::Light).shapes();
        let texts = texts_of(&harness);
        let numbers = texts.iter().filter(|text| text.starts_with("ρ_hh"));
        assert_eq!(numbers.count(), EIGHT.len(), "{purpose:?}: {texts:?}");
    }
}

/// Title and view of a slide stand together in its middle where the view is lower than the slide.
#[test]
fn a_low_view_stands_under_its_title_in_the_middle_of_a_slide() {
    let image = figure(session(&THREE), "sphere", Use::Slide, Theme::Light)
        .image()
        .unwrap();
    let ground = *image.get_pixel(0, 0);
    let is_seen = |y: u32| (0..image.width()).any(|x| *image.get_pixel(x, y) != ground);
    let rows: Vec<u32> = (0..image.height()).filter(|y| is_seen(*y)).collect();
    let (above, below) = (rows[0], image.height() - rows[rows.len() - 1]);
    assert!(
        above.abs_diff(below) < image.height() / 8,
        "{above} {below}"
    );
    let widest = rows.windows(2).map(|two| two[1] - two[0]).max().unwrap();
    assert!(widest < image.height() / 12, "a band of {widest} rows");
}
