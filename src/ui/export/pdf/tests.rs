//! What a page holds.

use egui::epaint::ClippedShape;
use egui::text::{LayoutJob, TextFormat};
use egui::{Color32, FontFamily, FontId, Rect, Shape, Stroke, pos2, vec2};

use super::*;

const PAPER: Paper = Paper {
    size_mm: vec2(100.0, 50.0),
    points_per_mm: 2.0,
};

/// A text with a fallback, italics and a line under it, and shapes of every kind that pages draw in a way of their own.
fn painted() -> Painted {
    let context = egui::Context::default();
    crate::theme::apply(&context);
    let input = egui::RawInput::default();
    let mut output = context.run_ui(input, |ui| {
        let format = |family, italics| TextFormat {
            font_id: FontId::new(12.0, family),
            color: Color32::BLACK,
            italics,
            underline: Stroke::new(1.0, Color32::BLACK),
            ..TextFormat::default()
        };
        let mut job = LayoutJob::default();
        job.append("a find ⁻³ ", 0.0, format(FontFamily::Proportional, true));
        job.append("fn", 0.0, format(FontFamily::Monospace, false));
        let galley = ui.painter().layout_job(job);
        ui.painter().galley(pos2(5.0, 5.0), galley, Color32::BLACK);
        let stroke = Stroke::new(1.0, Color32::RED);
        ui.painter()
            .circle(pos2(50.0, 50.0), 9.0, Color32::BLUE, stroke);
        let rect = Rect::from_min_size(pos2(60.0, 10.0), vec2(20.0, 9.0));
        ui.painter().rect_filled(rect, 3.0, Color32::GREEN);
        ui.painter()
            .line_segment([pos2(0.0, 0.0), pos2(f32::NAN, 3.0)], stroke);
    });
    // Nothing draws the letters.
    output.textures_delta.clear();
    let nothing = |clipped: &ClippedShape| matches!(clipped.shape, Shape::Noop);
    output.shapes.retain(|clipped| !nothing(clipped));
    Painted::of_shapes(vec2(200.0, 100.0), output.shapes)
}

#[test]
fn a_document_has_its_pages_and_is_the_same_each_time() {
    let painted = painted();
    let pages = || {
        vec![
            vec![(Pos2::ZERO, &painted)],
            vec![(pos2(9.0, 9.0), &painted)],
        ]
    };
    let made = || document("Two pages", PAPER, &pages()).unwrap();
    let bytes = made();
    assert!(bytes.starts_with(b"%PDF-"));
    assert_eq!(bytes, made());
    let text = String::from_utf8_lossy(&bytes);
    assert_eq!(text.matches("/Type/Page/").count(), 2);
    let flat = Paper {
        size_mm: vec2(0.0, 50.0),
        ..PAPER
    };
    let refused = document("None", flat, &pages()).unwrap_err().to_string();
    assert!(refused.contains("it has no area"), "{refused}");
}

#[test]
fn letters_are_of_the_first_font_that_has_them() {
    let mut faces = Faces::new();
    let mut letter = |letter| faces.letter(&FontFamily::Proportional, letter);
    let [a, b, minus] = ['a', 'b', '⁻'].map(|one| letter(one).unwrap());
    assert!(a.font == b.font && a.font != minus.font && a.glyph != b.glyph);
    assert!(letter('\u{10ffff}').is_none());
}
