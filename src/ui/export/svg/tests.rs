//! Every kind of shape on one sheet.

use std::sync::Arc;

use egui::epaint::{
    BandShape, CubicBezierShape, EllipseShape, Mesh, QuadraticBezierShape, RectShape, StrokeKind,
    TextShape,
};
use egui::text::{LayoutJob, TextFormat};
use egui::{FontFamily, FontId, Shape, TextureId, pos2, vec2};

use super::*;
use crate::export::pieces::{self, WHOLE};

const RED: Color32 = Color32::RED;
const BLUE: Color32 = Color32::BLUE;

/// What the drawing has for `shape`, clipped by `clip`, on a page of 100 by 100 points.
fn drawn_in(clip: Rect, shape: Shape) -> String {
    let clipped = ClippedShape::new(clip, shape);
    let picture = Arc::new(ColorImage::new([2, 2], vec![RED, BLUE, BLUE, RED]));
    let image_of = |id: TextureId| (id == TextureId::User(7)).then(|| Arc::clone(&picture));
    let page = Page {
        size: vec2(100.0, 100.0),
        print_width_mm: None,
        background: Color32::WHITE,
    };
    let pictures = Pictures {
        of_texture: &image_of,
        of_scene: &|rect| (rect == square()).then(|| ColorImage::clone(&picture)),
    };
    let drawing = drawing(&[clipped], page, pictures).unwrap();
    let inner = drawing.lines().skip(2);
    let inner: Vec<&str> = inner.filter(|line| *line != "</svg>").collect();
    inner.join("\n")
}

fn drawn(shape: impl Into<Shape>) -> String {
    let everywhere = Rect::from_min_size(Pos2::ZERO, vec2(100.0, 100.0));
    let text = drawn_in(everywhere, shape.into());
    let start = text.find("<g ").unwrap();
    let (_, inner) = text[start..].split_once('\n').unwrap();
    inner.trim_end_matches("</g>").trim_end().to_owned()
}

fn square() -> Rect {
    Rect::from_min_max(pos2(10.0, 20.0), pos2(30.0, 50.0))
}

#[test]
fn a_band_is_its_outline() {
    // What a plot makes of a line that goes to the right: the half circles of the polar plot.
    let point = |x: f32, y: f32| egui::epaint::BandPoint::new(x, y..=y + 2.0);
    let mut points = vec![point(0.0, 10.0), point(5.0, 20.0), point(9.0, 10.0)];
    assert_eq!(
        drawn(BandShape::filled(points.clone(), RED)),
        "<path d=\"M0 10L5 20L9 10L9 12L5 22L0 12Z\" fill=\"#ff0000\"/>"
    );
    // A point that is no place, or not further on, breaks it.
    points.push(point(f32::NAN, 0.0));
    points.extend([point(20.0, 0.0), point(22.0, 0.0), point(21.0, 5.0)]);
    let broken = drawn(BandShape::filled(points, RED));
    assert_eq!(broken.matches('Z').count(), 2, "{broken}");
    assert!(!broken.contains("NaN"));
    let turned = BandShape::filled(vec![point(0.0, -1.0), point(4.0, -1.0)], RED)
        .with_angle_and_pivot(std::f32::consts::FRAC_PI_2, Pos2::ZERO);
    assert!(drawn(turned).contains("M1 0L1 4L-1 4L-1 0Z"));
}

#[test]
fn lines_of_one_stroke_are_joined_and_stop_before_what_lies_over_them() {
    let line = |x: f32| Shape::line_segment([pos2(x, 0.0), pos2(x, 9.0)], (2.0, RED));
    let all = drawn(Shape::Vec(vec![
        line(1.0),
        line(2.0),
        Shape::circle_filled(pos2(5.0, 5.0), 3.0, BLUE),
        line(3.0),
        Shape::line_segment([Pos2::ZERO, pos2(1.0, 1.0)], (0.0, RED)),
    ]));
    let kinds: Vec<&str> = all.lines().map(|l| l.split(' ').next().unwrap()).collect();
    assert_eq!(kinds, ["<path", "<circle", "<path"], "{all}");
    assert!(all.starts_with("<path d=\"M1 0L1 9M2 0L2 9\""));
    // A stroke without an end somewhere breaks, and the rest stays.
    let broken = [0.0, 1.0, f32::INFINITY, 3.0, 4.0].map(|x| pos2(x, 0.0));
    let broken = drawn(Shape::line(broken.to_vec(), Stroke::new(1.0, RED)));
    assert!(broken.contains("d=\"M0 0L1 0M3 0L4 0\""), "{broken}");
}

#[test]
fn closed_shapes_have_fill_stroke_turn_and_corners() {
    let corners = vec![pos2(0.0, 0.0), pos2(4.0, 0.0), pos2(0.0, 4.0)];
    assert_eq!(
        drawn(Shape::convex_polygon(corners, RED, (1.0, BLUE))),
        "<path d=\"M0 0L4 0L0 4Z\" fill=\"#ff0000\" stroke=\"#0000ff\" stroke-width=\"1\"/>"
    );
    let mut ellipse = EllipseShape::filled(pos2(5.0, 6.0), vec2(3.0, 1.0), RED);
    ellipse.angle = std::f32::consts::FRAC_PI_2;
    let ellipse = drawn(Shape::Ellipse(ellipse));
    assert!(ellipse.contains("rx=\"3\" ry=\"1\" transform=\"rotate(90 5 6)\""));
    let rect = RectShape::new(square(), 3, RED, (2.0, BLUE), StrokeKind::Inside);
    assert_eq!(
        drawn(rect.clone()),
        "<rect x=\"11\" y=\"21\" width=\"18\" height=\"28\" rx=\"3\" fill=\"#ff0000\" stroke=\"#0000ff\" stroke-width=\"2\"/>"
    );
    let turned = drawn(rect.clone().with_angle(std::f32::consts::PI));
    assert!(turned.contains("transform=\"rotate(180 20 35)\""));
    let blurred = drawn(rect.clone().with_blur_width(4.0));
    assert!(blurred.contains("blur(2px)"));
    let mut uneven = rect;
    uneven.corner_radius = CornerRadius {
        nw: 5,
        ..CornerRadius::ZERO
    };
    assert!(drawn(uneven).contains("d=\"M16 21L29 21A0 0"));
    // What is added to the background, as behind every other row of a table.
    let veil = drawn(Shape::rect_filled(
        square(),
        0.0,
        Color32::from_additive_luminance(51),
    ));
    assert!(
        veil.contains("fill=\"#ffffff\" fill-opacity=\"0.2\""),
        "{veil}"
    );
    assert_eq!(
        drawn(Shape::rect_filled(square(), 0.0, Color32::TRANSPARENT)),
        ""
    );
}

#[test]
fn curves_are_lines_within_the_flatness() {
    let points = [pos2(0.0, 0.0), pos2(50.0, 80.0), pos2(99.0, 0.0)];
    let stroke = Stroke::new(1.0, RED);
    let open = QuadraticBezierShape::from_points_stroke(points, false, BLUE, stroke);
    let open = drawn(Shape::QuadraticBezier(open));
    assert!(
        open.matches('L').count() > 8 && !open.contains('Z'),
        "{open}"
    );
    let [a, b, c] = points;
    let closed = CubicBezierShape::from_points_stroke([a, b, b, c], true, BLUE, stroke);
    let closed = drawn(Shape::CubicBezier(closed));
    assert!(closed.contains('Z') && closed.contains("fill=\"#0000ff\""));
}

#[test]
fn pictures_are_cut_and_tinted_and_triangles_keep_their_colours() {
    let whole = drawn(Shape::image(
        TextureId::User(7),
        square(),
        WHOLE,
        Color32::WHITE,
    ));
    assert!(whole.starts_with("<image x=\"10\" y=\"20\" width=\"20\" height=\"30\""));
    let textured =
        RectShape::filled(square(), 0, Color32::WHITE).with_texture(TextureId::User(7), WHOLE);
    assert_eq!(drawn(textured), whole);
    let corner = Rect::from_min_max(Pos2::ZERO, pos2(0.5, 0.5));
    let image = ColorImage::new([2, 2], vec![RED, BLUE, BLUE, RED]);
    let cut = pieces::cropped(&image, corner, Color32::WHITE);
    assert_eq!((cut.size, cut.pixels), ([1, 1], vec![RED]));
    let dark = pieces::cropped(&image, WHOLE, Color32::BLACK);
    assert_eq!(dark.pixels, [Color32::BLACK; 4]);
    let mut mesh = Mesh::default();
    for (x, color) in [(0.0, RED), (10.0, RED), (20.0, RED), (30.0, BLUE)] {
        mesh.colored_vertex(pos2(x, x), color);
    }
    mesh.add_triangle(0, 1, 2);
    mesh.add_triangle(1, 2, 3);
    let triangles = drawn(Shape::mesh(mesh));
    // The first is red; the second goes from red to blue in 64 parts.
    assert!(triangles.starts_with("<path d=\"M0 0L10 10L20 20Z"));
    assert_eq!(triangles.matches('Z').count(), 65, "{triangles}");
    let colours = triangles.lines().count();
    assert!(colours > 6, "{triangles}");
}

#[test]
fn text_keeps_its_looks_and_turns() {
    let format = |color, family| TextFormat {
        color,
        font_id: FontId::new(10.0, family),
        ..TextFormat::default()
    };
    let mut job = LayoutJob::default();
    job.append("a < ", 0.0, format(RED, FontFamily::Proportional));
    let mut second = format(BLUE, FontFamily::Monospace);
    (second.italics, second.underline) = (true, Stroke::new(1.0, BLUE));
    second.background = Color32::YELLOW;
    job.append("b\nc\u{7}", 0.0, second);
    let mut found = String::new();
    let context = egui::Context::default();
    let mut output = context.run_ui(egui::RawInput::default(), |ui| {
        let galley = ui.painter().layout_job(job.clone());
        let shape = TextShape::new(pos2(10.0, 20.0), galley, RED);
        found = drawn(shape.with_angle(-std::f32::consts::FRAC_PI_2));
    });
    // Nothing draws the letters.
    output.textures_delta.clear();
    let rows: Vec<&str> = found.lines().filter(|l| l.starts_with("<text")).collect();
    assert_eq!(rows.len(), 3, "{found}");
    assert!(
        rows[0].contains("fill=\"#ff0000\">a &lt; </text>"),
        "{found}"
    );
    assert!(rows[1].contains("font-style=\"italic\" text-decoration=\"underline\""));
    assert!(rows[1].contains("monospace") && rows[1].ends_with(">b</text>"));
    assert!(
        rows[2].ends_with(">c </text>"),
        "no control characters: {found}"
    );
    assert!(rows.iter().all(|row| row.contains("rotate(-90 10 20)")));
    assert_eq!(
        found.matches("<rect").count(),
        2,
        "the background of each row"
    );
}

#[test]
fn a_scene_is_a_picture_and_clips_are_kept() {
    let callback = egui::PaintCallback {
        rect: square(),
        callback: Arc::new(()),
    };
    let scene = drawn(Shape::Callback(callback));
    assert!(
        scene.starts_with("<image x=\"10\" y=\"20\" width=\"20\" height=\"30\""),
        "{scene}"
    );
    let circle = Shape::circle_filled(pos2(5.0, 5.0), 3.0, BLUE);
    let clipped = drawn_in(square(), circle.clone());
    assert!(
        clipped
            .contains("<clipPath id=\"c0\"><rect x=\"10\" y=\"20\" width=\"20\" height=\"30\"/>")
    );
    let outside = square().translate(vec2(500.0, 0.0));
    assert_eq!(drawn_in(outside, circle), "");
}

#[test]
fn a_page_has_its_size_in_print() {
    let page = |print_width_mm| Page {
        size: vec2(400.0, 300.0),
        print_width_mm,
        background: Color32::WHITE,
    };
    let pictures = Pictures {
        of_texture: &|_| None,
        of_scene: &|_| None,
    };
    let sized = |mm| drawing(&[], page(mm), pictures).unwrap();
    let printed = sized(Some(88.0));
    assert!(
        printed.contains("width=\"88.00mm\" height=\"66.00mm\" viewBox=\"0 0 400 300\""),
        "{printed}"
    );
    assert!(sized(None).contains("width=\"400\" height=\"300\""));
}
