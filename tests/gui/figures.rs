//! Figures: pictures of a view for slides, print and the web.

use std::collections::BTreeSet;

use brdf_explorer::study::colors;
use brdf_explorer::study::export::Format;
use brdf_explorer::study::export::figure::{FigureChoice, USES, Use};
use brdf_explorer::study::session::Session;
use brdf_explorer::study::store::{Answer, Disk, Store};
use brdf_explorer::study::views::{self, VIEWS};
use brdf_explorer::ui::app::App;
use brdf_explorer::ui::export;
use brdf_explorer::ui::headless::{OnScreen, Picture, Title};
use egui::accesskit::{Action, Role};
use egui::{FontFamily, Key, Modifiers, Shape, Theme};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT, Queryable};

use super::files::{press, work_in};
use super::{EIGHT, Folder, THREE, picture, session, window};

/// How large a view is on the screen.
const SCREEN: OnScreen = OnScreen {
    size: [480, 360],
    scale: 1.0,
};

/// One material, three of unlike lobes, and eight with transmission and deltas among them.
const SHOWN: [&[&str]; 3] = [&["gold"], &THREE, &EIGHT];

/// The first view of a kind as a figure.
pub(super) fn figure(mut shown: Session, id: &str, purpose: Use, theme: Theme) -> Picture {
    let view = shown.views.show_alone(views::find(id).unwrap());
    let theme = match theme {
        Theme::Dark => colors::Theme::Dark,
        Theme::Light => colors::Theme::Light,
    };
    Picture::of_figure(shown, view, (purpose, Title::Automatic, theme), SCREEN)
}

/// The uses that have a page of their own.
pub(super) fn uses() -> impl Iterator<Item = Use> {
    let sized = USES.iter().filter(|spec| spec.page.is_some());
    sized.map(|spec| spec.purpose)
}

/// What could be acted on in the accessibility tree, and what could be read there.
pub(super) fn controls_and_texts(harness: &Harness<'_, App>) -> (Vec<String>, BTreeSet<String>) {
    let (mut controls, mut texts) = (Vec::new(), BTreeSet::new());
    for node in harness.root().children_recursive() {
        let node = node.accesskit_node().data();
        let is_still = matches!(
            node.role(),
            Role::Window
                | Role::Pane
                | Role::GenericContainer
                | Role::Label
                | Role::Canvas
                | Role::Image
        );
        let acts = [Action::Click, Action::Focus].map(|action| node.supports_action(action));
        if !is_still || acts.contains(&true) {
            controls.push(format!("{:?} {:?}", node.role(), node.label()));
        }
        texts.extend(node.value().map(str::to_owned));
    }
    (controls, texts)
}

/// What is written in a picture.
pub(super) fn texts_of<'a>(harness: &'a Harness<'_, App>) -> Vec<&'a str> {
    let shapes = harness.output().shapes.iter();
    let text = |clipped: &'a egui::epaint::ClippedShape| match &clipped.shape {
        Shape::Text(text) => Some(text.galley.text()),
        _ => None,
    };
    shapes.filter_map(text).collect()
}

#[test]
fn no_figure_has_a_control_and_each_says_what_it_shows() {
    for kind in &VIEWS {
        for purpose in uses().chain([Use::Screen]) {
            // Eight take long, and are drawn alike in every size.
            let most = if purpose == Use::Slide { 3 } else { 2 };
            for shown in &SHOWN[..most] {
                let harness = figure(session(shown), kind.id, purpose, Theme::Light).shapes();
                let (controls, texts) = controls_and_texts(&harness);
                let id = kind.id;
                assert!(controls.is_empty(), "{id} {purpose:?}: {controls:?}");
                let says = |text: &String| text.starts_with(&format!("{}: ", kind.title));
                assert!(texts.iter().any(says), "{id} {purpose:?}: {texts:?}");
            }
        }
        // A copy of the tile as `render` draws it has none either.
        let copy = picture(session(SHOWN[1]), Some(kind.id), [480, 360], Theme::Dark);
        let copy = copy.shapes();
        let (controls, _) = controls_and_texts(&copy);
        assert!(controls.is_empty(), "{}: {controls:?}", kind.id);
        let is_caption = |text: &str| text.len() > 16 && kind.what_you_see.starts_with(text);
        let lines = texts_of(&copy);
        let starts = lines.iter().map(|text| text.trim_end_matches('…'));
        assert!(
            !starts.into_iter().any(is_caption),
            "{}: {lines:?}",
            kind.id
        );
    }
}

/// The smallest text of a shape, in points; a subscript has the size of its line, and so have the scripts of a formula, whose
/// letters are set one by one.
fn smallest(shape: &Shape) -> f32 {
    match shape {
        Shape::Vec(shapes) => shapes.iter().map(smallest).fold(f32::INFINITY, f32::min),
        Shape::Text(text) => {
            let sections = text.galley.job.sections.iter();
            let sizes = sections.map(|section| match &section.format.font_id.family {
                FontFamily::Name(_) => f32::INFINITY,
                _ => section.format.font_id.size,
            });
            let largest = sizes.fold(0.0, f32::max);
            if largest > 0.0 {
                largest
            } else {
                f32::INFINITY
            }
        }
        _ => f32::INFINITY,
    }
}

#[test]
fn the_smallest_text_is_legible_where_it_is_shown() {
    for kind in &VIEWS {
        for purpose in uses() {
            for shown in &SHOWN[..2] {
                let page = purpose.spec().page.unwrap();
                let harness = figure(session(shown), kind.id, purpose, Theme::Light).shapes();
                let size = harness.ctx.content_rect().size();
                let shapes = harness.output().shapes.iter();
                let text = shapes
                    .map(|clipped| smallest(&clipped.shape))
                    .fold(f32::INFINITY, f32::min);
                let what = format!("{} {purpose:?}: {text} of {size:?}", kind.id);
                match page.print_width_mm {
                    Some(mm) => {
                        let printed = f64::from(text / size.x) * mm / 25.4 * 72.0;
                        assert!(printed >= 7.0, "{what}: {printed} printed points");
                    }
                    None => assert!(35.0 * text >= size.y, "{what}"),
                }
            }
        }
    }
}

/// The shares of the width and of the height in which something is seen.
fn filled(image: &image::RgbaImage) -> [f64; 2] {
    let ground = *image.get_pixel(0, 0);
    let seen = image.enumerate_pixels().filter(|(_, _, p)| **p != ground);
    let ends = seen.fold([u32::MAX, 0, u32::MAX, 0], |[l, r, t, b], (x, y, _)| {
        [l.min(x), r.max(x), t.min(y), b.max(y)]
    });
    let [left, right, top, bottom] = ends.map(f64::from);
    let (width, height) = (f64::from(image.width()), f64::from(image.height()));
    [(right - left) / width, (bottom - top) / height]
}

#[test]
fn pictures_have_the_size_of_their_use_and_no_wide_margins() {
    for kind in &VIEWS {
        for purpose in uses() {
            let figure = figure(session(SHOWN[1]), kind.id, purpose, Theme::Light);
            let image = figure.image().unwrap();
            let (size, what) = (
                [image.width(), image.height()],
                format!("{} {purpose:?}", kind.id),
            );
            match purpose {
                Use::Slide => assert_eq!(size, [1920, 1080], "{what}"),
                Use::Column => assert_eq!(size[0], 2079, "{what}"),
                _ => assert!(size[0] <= 1280 && size[1] <= 800, "{what}: {size:?}"),
            }
            let [across, down] = filled(&image);
            // A slide is as large as it is; what is cut has no third of it empty.
            if purpose != Use::Slide {
                assert!(across > 0.67 && down > 0.67, "{what}: {across} {down}");
            }
        }
    }
}

#[test]
fn a_column_is_as_wide_in_print_as_a_picture_and_as_a_drawing() {
    let bytes = |format| {
        let figure = figure(session(&["gold"]), "polar", Use::Column, Theme::Light);
        export::bytes(figure, format).unwrap()
    };
    let png = bytes(Format::Png);
    let at = png.windows(4).position(|part| part == b"pHYs").unwrap();
    let per_metre = u32::from_be_bytes(png[at + 4..at + 8].try_into().unwrap());
    let dots = f64::from(per_metre) * 0.0254;
    assert!((dots - 600.0).abs() < 0.5, "{dots} dots per inch");
    let svg = String::from_utf8(bytes(Format::Svg)).unwrap();
    assert!(svg.contains("width=\"88.00mm\""), "{svg:.300}");
}

#[test]
fn the_lobe_as_a_drawing_is_a_picture_with_text_and_lines_over_it() {
    for purpose in uses() {
        let figure = figure(session(SHOWN[1]), "lobe3d", purpose, Theme::Light);
        let svg = String::from_utf8(export::bytes(figure, Format::Svg).unwrap()).unwrap();
        let image = svg.find("<image ").unwrap();
        let (_, above) = svg.split_at(image);
        assert_eq!(svg.matches("<image ").count(), 1);
        for expected in [">light</text>", ">viewer</text>", ">n</text>", "<path "] {
            assert!(above.contains(expected), "{purpose:?}: {expected}");
        }
        // The axes are lines: n has the colour of the ink, s and t that of axes.
        let axes = ["#1e1e1e", "#787878"].map(|color| format!("stroke=\"{color}\""));
        for stroke in axes {
            assert!(above.contains(&stroke), "{purpose:?}: {stroke}");
        }
        let data = svg.split("base64,").nth(1).unwrap();
        let data = data.split('"').next().unwrap();
        assert!(
            data.starts_with("iVBOR") && data.len() > 10_000,
            "a surface"
        );
        let count = |part: &str| svg.matches(part).count();
        assert_eq!(count("<g "), count("</g>"));
        assert_eq!(count("<text "), count("</text>"));
    }
}

#[test]
fn curves_are_named_where_they_are() {
    for id in ["polar", "cartesian", "reflectance"] {
        let harness = figure(session(SHOWN[1]), id, Use::Slide, Theme::Light).shapes();
        let room = harness.state().room_of_view();
        let shapes = harness.output().shapes.iter();
        let names: Vec<&str> = shapes
            .filter(|clipped| room.contains_rect(clipped.shape.visual_bounding_rect()))
            .filter_map(|clipped| match &clipped.shape {
                Shape::Text(text) => Some(text.galley.text()),
                _ => None,
            })
            .collect();
        for name in ["Rough conductor", "Plastic", "Oren-Nayar"] {
            assert!(names.contains(&name), "{id}: {name} in {names:?}");
        }
    }
}

/// The window of the figure of the view that was opened first.
fn dialog(folder: &Folder) -> Harness<'static, App> {
    let mut harness = window("gold");
    work_in(&mut harness, folder);
    press(&mut harness, Modifiers::COMMAND, Key::E);
    harness.run();
    harness
}

#[test]
fn a_figure_is_chosen_by_keys_and_shown_before_it_is_made() {
    let folder = Folder::new("figure-dialog");
    let mut harness = dialog(&folder);
    assert!(harness.query_by_label("Figure of 3D lobe").is_some());
    assert!(harness.query_by_label("Preview").is_some());
    harness.get_by_label("Slide").click();
    harness.run();
    assert!(
        harness
            .query_by_label("1920 × 1080 pixels, for a projector")
            .is_some()
    );
    // A letter is no command here.
    let before = harness.state().session.clone();
    press(&mut harness, Modifiers::NONE, Key::H);
    assert!(harness.state().session == before);
    press(&mut harness, Modifiers::NONE, Key::Escape);
    harness.run();
    assert!(!harness.state().is_choosing_figure());
    // The choice is kept for the next time, and for the next run.
    let kept = Store::new(std::sync::Arc::new(Disk), Some(folder.file("data")));
    let expected = FigureChoice {
        purpose: Use::Slide,
        ..FigureChoice::default()
    };
    assert_eq!(kept.figure(), expected);
}

#[test]
fn a_title_of_one_s_own_stands_in_its_place() {
    let mut own = figure(session(&["gold"]), "polar", Use::Web, Theme::Light);
    let figure = own.figure.as_mut().unwrap();
    figure.title = Title::Own("A lobe".to_owned());
    let (_, texts) = controls_and_texts(&own.clone().shapes());
    assert!(texts.contains("A lobe") && !texts.iter().any(|text| text.starts_with("Polar plot")));
    own.figure.as_mut().unwrap().title = Title::None;
    let (_, texts) = controls_and_texts(&own.shapes());
    assert!(texts.is_empty(), "{texts:?}");
}

/// People name their materials in scripts that no font of the program has.
#[test]
fn a_name_without_glyphs_is_drawn_as_boxes() {
    let mut shown = session(&["brass"]);
    shown.materials.selected_mut().name = "\u{65e5}\u{672c}".to_owned();
    for purpose in uses() {
        let image = figure(shown.clone(), "polar", purpose, Theme::Light).image();
        assert!(image.is_ok());
    }
}

/// The window of a figure closes, and where the system has no dialogs a path is typed: keys are for it alone.
#[test]
fn a_path_is_typed_after_the_window_of_a_figure() {
    let folder = Folder::new("figure-path");
    let mut harness = window("gold");
    let script = work_in(&mut harness, &folder);
    for name in ["first.svg", "second.png"] {
        press(&mut harness, Modifiers::COMMAND, Key::E);
        script.borrow_mut().answers.push(Answer::NoDialog);
        harness.get_by_label("Picture (PNG)…").click();
        harness.run_steps(4);
        let before = harness.state().session.clone();
        let field = harness.get_by_label("Path of the file");
        assert!(field.is_focused(), "{name}");
        let path = folder.file(name).display().to_string();
        press(&mut harness, Modifiers::COMMAND, Key::A);
        harness.get_by_label("Path of the file").type_text(&path);
        harness.run_steps(2);
        press(&mut harness, Modifiers::NONE, Key::Enter);
        assert!(harness.state().session == before, "no letter was a command");
        let is_refused = name.ends_with("svg");
        let said = harness.query_by_label_contains("the name of another kind of file");
        assert_eq!(said.is_some(), is_refused, "{name}");
        if is_refused {
            press(&mut harness, Modifiers::NONE, Key::Escape);
        }
        while harness.state().is_exporting() {
            harness.step();
        }
        assert_eq!(folder.file(name).exists(), !is_refused);
    }
}
