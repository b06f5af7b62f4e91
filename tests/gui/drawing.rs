//! The drawing of each view has all that egui paints, and nothing else.

#![expect(
    clippy::indexing_slicing,
    clippy::panic,
    reason = "a failed step is a failed test"
)]

use std::collections::HashMap;

use brdf_explorer::study::views::VIEWS;
use brdf_explorer::ui::export::{shapes, svg};
use egui::epaint::{ClippedShape, TextShape};
use egui::{Color32, Mesh, Pos2, Rect, Shape, Stroke, Theme, pos2, vec2};

use super::{picture, session};

const SIZE: [u32; 2] = [640, 480];

/// A material of each kind, and several.
const KINDS: [(&str, &[&str]); 6] = [
    ("diffuse", &["oren_nayar:sigma=30"]),
    ("glossy", &["rough_conductor:alpha_x=0.1,alpha_y=0.3"]),
    ("mirror", &["specular_reflection"]),
    ("glass", &["fresnel_specular"]),
    ("retro", &["retro_reflector"]),
    (
        "several",
        &["rough_conductor", "fresnel_specular", "oren_nayar"],
    ),
];

/// What is seen of a shape, or of a part of one: its colours, and how far it reaches.
#[derive(Clone, Debug)]
struct Piece {
    /// Fill, stroke, and the text if it is one.
    look: (String, String, String),
    bounds: Rect,
    clip: Rect,
}

fn hex(color: Color32) -> String {
    if color == Color32::TRANSPARENT {
        return String::new();
    }
    let [r, g, b, _] = if color.is_additive() {
        // Grey is all that is added to a background here.
        [255; 4]
    } else {
        color.to_srgba_unmultiplied()
    };
    format!("#{r:02x}{g:02x}{b:02x}")
}

fn stroke_of(stroke: Stroke) -> String {
    if stroke.is_empty() {
        String::new()
    } else {
        hex(stroke.color)
    }
}

/// What stands for the colours of a triangle whose corners differ: many small ones in the drawing.
const GRADIENT: &str = "gradient";

fn pieces_of_mesh(mesh: &Mesh, is_picture: bool) -> Vec<(String, Rect)> {
    if is_picture {
        return vec![("picture".to_owned(), mesh.calc_bounds())];
    }
    let triangle = |corners: &[u32]| {
        let corners = corners.iter().map(|index| &mesh.vertices[*index as usize]);
        let corners: Vec<_> = corners.collect();
        let places: Vec<Pos2> = corners.iter().map(|corner| corner.pos).collect();
        let is_flat = corners
            .iter()
            .all(|corner| corner.color == corners[0].color);
        let look = if is_flat {
            hex(corners[0].color)
        } else {
            GRADIENT.to_owned()
        };
        (look, Rect::from_points(&places))
    };
    let all = mesh.indices.chunks_exact(3).map(triangle);
    all.filter(|(look, _)| !look.is_empty()).collect()
}

/// The stretches of one size in each row of a text, with the place where each begins on its baseline.
fn pieces_of_text(text: &TextShape) -> Vec<(String, Rect)> {
    let rotation = egui::emath::Rot2::from_angle(text.angle);
    let rows = text.galley.rows.iter().flat_map(|placed| {
        let stretches = placed
            .row
            .glyphs
            .chunk_by(|a, b| a.font_height == b.font_height);
        stretches.filter_map(|glyphs| {
            let words: String = glyphs.iter().map(|glyph| glyph.chr).collect();
            let first = glyphs.first()?.pos;
            let at = text.pos + rotation * (placed.pos.to_vec2() + first.to_vec2());
            let is_blank = words.trim().is_empty();
            (!is_blank).then(|| (words, Rect::from_pos(at)))
        })
    });
    rows.collect()
}

/// What is seen of a shape; each kind of shape has its line here.
fn painted(shape: &Shape, clip: Rect, is_picture: &dyn Fn(egui::TextureId) -> bool) -> Vec<Piece> {
    let piece = |fill: String, stroke: String| Piece {
        look: (fill, stroke, String::new()),
        bounds: shape.visual_bounding_rect(),
        clip,
    };
    let one = match shape {
        Shape::Noop | Shape::Callback(_) => return Vec::new(),
        Shape::Vec(shapes) => {
            let all = shapes.iter();
            return all
                .flat_map(|shape| painted(shape, clip, is_picture))
                .collect();
        }
        Shape::LineSegment { stroke, .. } => piece(String::new(), stroke_of(*stroke)),
        Shape::Path(path) => {
            let egui::epaint::ColorMode::Solid(color) = path.stroke.color else {
                panic!("no view paints strokes of many colours");
            };
            piece(
                hex(path.fill),
                stroke_of(Stroke::new(path.stroke.width, color)),
            )
        }
        Shape::Band(band) => piece(hex(band.fill), stroke_of(band.stroke)),
        Shape::Circle(circle) => piece(hex(circle.fill), stroke_of(circle.stroke)),
        Shape::Ellipse(ellipse) => piece(hex(ellipse.fill), stroke_of(ellipse.stroke)),
        Shape::Rect(rect) => match &rect.brush {
            Some(brush) if is_picture(brush.fill_texture_id) => {
                piece("picture".to_owned(), String::new())
            }
            _ => piece(hex(rect.fill), stroke_of(rect.stroke)),
        },
        Shape::Text(text) => {
            let piece = |(words, bounds): (String, Rect)| Piece {
                look: (String::new(), String::new(), words),
                bounds,
                clip,
            };
            return pieces_of_text(text).into_iter().map(piece).collect();
        }
        Shape::Mesh(mesh) => {
            let piece = |(fill, bounds): (String, Rect)| Piece {
                look: (fill, String::new(), String::new()),
                bounds,
                clip,
            };
            let parts = pieces_of_mesh(mesh, is_picture(mesh.texture_id));
            return parts.into_iter().map(piece).collect();
        }
        Shape::QuadraticBezier(_) | Shape::CubicBezier(_) => {
            panic!("no view paints curves by their handles")
        }
    };
    let is_seen = one.look.0.len() + one.look.1.len() > 0 && one.bounds.is_finite();
    is_seen.then_some(one).into_iter().collect()
}

/// The value of an attribute of an element.
fn attribute<'a>(element: &'a str, name: &str) -> Option<&'a str> {
    let start = element.find(&format!(" {name}=\""))? + name.len() + 3;
    element[start..].split('"').next()
}

fn number(element: &str, name: &str) -> f32 {
    attribute(element, name).map_or(0.0, |text| text.parse().unwrap())
}

fn rect_of(element: &str) -> Rect {
    let [x, y, width, height] = ["x", "y", "width", "height"].map(|name| number(element, name));
    Rect::from_min_size(pos2(x, y), vec2(width, height))
}

/// The bounds of each stretch of a path.
fn stretches(d: &str) -> Vec<Rect> {
    let stretch = |part: &str| {
        let points = part.trim_end_matches('Z').split('L').map(|point| {
            let (x, y) = point.split_once(' ').unwrap();
            pos2(x.parse().unwrap(), y.parse().unwrap())
        });
        Rect::from_points(&points.collect::<Vec<_>>())
    };
    d.split('M').skip(1).map(stretch).collect()
}

/// Where `pos` comes to lie by the turn of an element.
fn turned(element: &str, pos: Pos2) -> Pos2 {
    let Some(turn) = attribute(element, "transform") else {
        return pos;
    };
    let numbers = turn.trim_start_matches("rotate(").trim_end_matches(')');
    let numbers: Vec<f32> = numbers.split(' ').map(|x| x.parse().unwrap()).collect();
    let pivot = pos2(numbers[1], numbers[2]);
    pivot + egui::emath::Rot2::from_angle(numbers[0].to_radians()) * (pos - pivot)
}

/// All that a drawing shows, but for its page.
fn drawn(drawing: &str) -> Vec<Piece> {
    let mut pieces = Vec::new();
    let mut clip = Rect::NOTHING;
    for line in drawing.lines().skip(2) {
        if let Some(inner) = line.strip_prefix("<clipPath") {
            let start = inner.find("<rect").unwrap();
            clip = rect_of(&inner[start..]);
            continue;
        }
        let kind = line.split([' ', '>']).next().unwrap_or("");
        let look = |name: &str| {
            let found = attribute(line, name).filter(|color| *color != "none");
            found.unwrap_or("").to_owned()
        };
        let half = 0.5 * number(line, "stroke-width");
        let bounds = match kind {
            "<path" => stretches(attribute(line, "d").unwrap()),
            "<rect" | "<image" => vec![rect_of(line)],
            "<circle" => {
                let centre = pos2(number(line, "cx"), number(line, "cy"));
                let side = 2.0 * number(line, "r");
                vec![Rect::from_center_size(centre, vec2(side, side))]
            }
            "<text" => {
                let at = pos2(number(line, "x"), number(line, "y"));
                vec![Rect::from_pos(turned(line, at))]
            }
            "<g" | "</g" | "</svg" => continue,
            _ => panic!("{line}"),
        };
        let words = if kind == "<text" {
            let inner = line.split_once('>').unwrap().1.trim_end_matches("</text>");
            let inner = inner.replace("&lt;", "<").replace("&gt;", ">");
            inner.replace("&amp;", "&")
        } else {
            String::new()
        };
        let look = match kind {
            "<image" => ("picture".to_owned(), String::new(), words),
            "<text" => (String::new(), String::new(), words),
            _ => (look("fill"), look("stroke"), words),
        };
        pieces.extend(bounds.into_iter().map(|bounds| Piece {
            look: look.clone(),
            bounds: bounds.expand(half),
            clip,
        }));
    }
    pieces
}

/// Lengths in the drawing are rounded to a hundredth, half of them twice; texts are put on whole pixels.
fn is_same(a: &Piece, b: &Piece) -> bool {
    let most = if a.look.2.is_empty() { 0.03 } else { 0.6 };
    let is_near = |a: Rect, b: Rect, most: f32| {
        let gaps = [a.min - b.min, a.max - b.max];
        gaps.iter().all(|gap| gap.abs().max_elem() <= most)
    };
    is_near(a.bounds, b.bounds, most) && is_near(a.clip, b.clip, 0.03)
}

/// What is in `painted` and not in `drawn`, and the other way round.
fn unmatched(painted: Vec<Piece>, drawn: Vec<Piece>) -> (Vec<Piece>, Vec<Piece>) {
    let mut by_look: HashMap<_, Vec<Piece>> = HashMap::new();
    for piece in drawn {
        by_look.entry(piece.look.clone()).or_default().push(piece);
    }
    let mut missing = Vec::new();
    let (gradients, flat): (Vec<Piece>, Vec<Piece>) = painted
        .into_iter()
        .partition(|piece| piece.look.0 == GRADIENT);
    for piece in flat {
        let candidates = by_look.entry(piece.look.clone()).or_default();
        match candidates.iter().position(|other| is_same(&piece, other)) {
            Some(index) => {
                candidates.remove(index);
            }
            None => missing.push(piece),
        }
    }
    let mut surplus: Vec<Piece> = by_look.into_values().flatten().collect();
    for gradient in &gradients {
        let before = surplus.len();
        let place = gradient.bounds.expand(0.02);
        surplus.retain(|piece| !place.contains_rect(piece.bounds));
        // Two triangles that make up a rectangle have one place.
        let is_twin = |other: &Piece| !std::ptr::eq(other, gradient) && is_same(other, gradient);
        if surplus.len() == before && !gradients.iter().any(is_twin) {
            missing.push(gradient.clone());
        }
    }
    (missing, surplus)
}

#[test]
fn a_drawing_has_every_shape_that_is_painted_and_no_other() {
    let [width, height] = SIZE.map(|side| side as f32);
    let page = Rect::from_min_size(Pos2::ZERO, vec2(width, height));
    for view in VIEWS.iter().filter(|view| !view.is_mesh) {
        for (kind, shown) in KINDS {
            let picture = picture(session(shown), Some(view.id), SIZE, Theme::Light);
            let harness = picture.shapes();
            let shapes: &[ClippedShape] = &harness.output().shapes;
            let image_of = |id| harness.state().image(id);
            let sheet = svg::Page {
                size: page.size(),
                print_width_mm: None,
                background: Color32::WHITE,
            };
            let pictures = shapes::Pictures {
                of_texture: &image_of,
                of_scene: &|_| None,
            };
            let drawing = svg::drawing(shapes, sheet, pictures).unwrap();
            let is_picture = |id| image_of(id).is_some();
            let visible = shapes.iter().filter_map(|clipped| {
                let clip = clipped.clip_rect.intersect(page);
                clip.is_positive().then_some((&clipped.shape, clip))
            });
            let painted: Vec<Piece> = visible
                .flat_map(|(shape, clip)| painted(shape, clip, &is_picture))
                .collect();
            assert!(painted.len() > 1, "{} {kind}: {painted:?}", view.id);
            let (missing, surplus) = unmatched(painted, drawn(&drawing));
            assert!(
                missing.is_empty() && surplus.is_empty(),
                "{} {kind}: {} missing, {} too many: {:?} {:?}",
                view.id,
                missing.len(),
                surplus.len(),
                missing.iter().take(3).collect::<Vec<_>>(),
                surplus.iter().take(3).collect::<Vec<_>>()
            );
        }
    }
}
