//! Categories as icons: a cloud, a drop, a mirror, a loop. Colours tell materials apart.

use std::f32::consts::{FRAC_PI_2, PI, TAU};

use egui::{Color32, Painter, Pos2, Rect, Shape, Stroke, Vec2, pos2, vec2};

use bxdf::Category;

/// The steps of a full turn in an outline: as smooth as a pixel shows.
const STEPS: usize = 24;

/// The width of lines, as a share of the icon.
const LINE: f32 = 0.1;

/// Draws the icon of `category`, as large as `rect` holds.
pub fn icon(painter: &Painter, rect: Rect, category: Category, color: Color32) {
    let side = rect.width().min(rect.height());
    let icon = Icon {
        painter,
        corner: rect.center() - Vec2::splat(0.5 * side),
        side,
        color,
    };
    match category {
        Category::Diffuse => icon.cloud(),
        Category::GlossySpecular => icon.drop(),
        Category::PerfectSpecular => icon.mirror(),
        Category::RetroReflective => icon.turn(),
    }
}

/// An icon that is drawn; its places run from 0 to 1, y downwards.
struct Icon<'a> {
    painter: &'a Painter,
    corner: Pos2,
    side: f32,
    color: Color32,
}

impl Icon<'_> {
    fn at(&self, x: f32, y: f32) -> Pos2 {
        self.corner + self.side * vec2(x, y)
    }

    fn stroke(&self) -> Stroke {
        Stroke::new(LINE * self.side, self.color)
    }

    fn ball(&self, x: f32, y: f32, radius: f32) {
        let centre = self.at(x, y);
        self.painter
            .circle_filled(centre, radius * self.side, self.color);
    }

    fn line(&self, places: &[(f32, f32)]) {
        let places = places.iter().map(|(x, y)| self.at(*x, *y)).collect();
        self.painter.add(Shape::line(places, self.stroke()));
    }

    /// Light that leaves everywhere alike.
    fn cloud(&self) {
        for (x, y, radius) in [(0.24, 0.62, 0.18), (0.5, 0.44, 0.26), (0.76, 0.6, 0.2)] {
            self.ball(x, y, radius);
        }
        let base = Rect::from_min_max(self.at(0.2, 0.56), self.at(0.8, 0.8));
        self.painter.rect_filled(base, 0.1 * self.side, self.color);
    }

    /// A lobe: light that leaves about one direction.
    fn drop(&self) {
        let (centre, radius) = (pos2(0.5, 0.62), 0.28);
        // The sides touch the round below where they are straight.
        let open = 0.5 * FRAC_PI_2;
        let round = (0..=STEPS).map(|step| {
            let angle = -FRAC_PI_2 + open + (TAU - 2.0 * open) * step as f32 / STEPS as f32;
            self.at(
                centre.x + radius * angle.cos(),
                centre.y + radius * angle.sin(),
            )
        });
        let tip = self.at(0.5, 0.06);
        let outline = std::iter::once(tip).chain(round).collect();
        self.painter
            .add(Shape::convex_polygon(outline, self.color, Stroke::NONE));
    }

    /// Light that leaves in exactly one direction.
    fn mirror(&self) {
        self.line(&[(0.08, 0.82), (0.92, 0.82)]);
        self.line(&[(0.14, 0.2), (0.5, 0.74), (0.86, 0.2)]);
        self.line(&[(0.6, 0.24), (0.86, 0.2), (0.9, 0.46)]);
    }

    /// Light that goes back where it came from.
    fn turn(&self) {
        let (centre, radius) = (pos2(0.4, 0.5), 0.24);
        let round = (0..=STEPS / 2).map(|step| {
            let angle = -FRAC_PI_2 - PI * step as f32 / (STEPS / 2) as f32;
            (
                centre.x + radius * angle.cos(),
                centre.y + radius * angle.sin(),
            )
        });
        let upper = std::iter::once((0.92, centre.y - radius));
        let lower = std::iter::once((0.88, centre.y + radius));
        let all: Vec<(f32, f32)> = upper.chain(round).chain(lower).collect();
        self.line(&all);
        let tip = (0.92, centre.y + radius);
        self.line(&[(0.7, tip.1 - 0.2), tip, (0.7, tip.1 + 0.2)]);
    }
}
