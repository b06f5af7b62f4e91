//! The soft shadow that lobes cast straight down on the surface: dark where they touch it, and gone where they are high above.

use glam::{Vec2, Vec3};

/// Cells along either side of the square about the unit disc.
const CELLS: usize = 64;
/// The height above the surface, in world units, at which a lobe keeps 1 / e of the light from it that it keeps when it
/// touches it.
const FADING: f32 = 0.3;
/// How far the edges are softened to either side, in cells, in each of the passes.
const SOFTENING: usize = 2;
/// Passes of softening: the third makes a box nearly a bell.
const PASSES: usize = 3;
/// A triangle narrower than this, in cells, is drawn by its sides.
const NARROW: f32 = 2.0;
/// The share of the light that is kept from the surface where a lobe touches it.
const DARKEST: f32 = 0.62;

/// How much light is kept from places of the surface.
pub(super) struct Shadow {
    /// Row by row, from y = -1 on.
    cells: Vec<f32>,
}

impl Shadow {
    /// The shadow of triangles above the surface.
    pub(super) fn of(triangles: impl IntoIterator<Item = [Vec3; 3]>) -> Self {
        let mut shadow = Self {
            cells: vec![0.0; CELLS * CELLS],
        };
        for corners in triangles {
            shadow.cast(corners);
        }
        for _ in 0..PASSES {
            shadow.soften();
        }
        shadow
    }

    /// The share of the light that is kept from a place of the unit disc, 0 to 1.
    pub(super) fn at(&self, place: Vec2) -> f32 {
        let cell = to_cells(place) - 0.5;
        let low = cell.floor();
        let part = cell - low;
        let corner = |x: f32, y: f32| self.get(low.x + x, low.y + y);
        let lower = corner(0.0, 0.0) * (1.0 - part.x) + corner(1.0, 0.0) * part.x;
        let upper = corner(0.0, 1.0) * (1.0 - part.x) + corner(1.0, 1.0) * part.x;
        DARKEST * (lower * (1.0 - part.y) + upper * part.y)
    }

    fn get(&self, x: f32, y: f32) -> f32 {
        let index = index(x, y);
        index
            .and_then(|index| self.cells.get(index))
            .copied()
            .unwrap_or(0.0)
    }

    /// Darkens the cells below a triangle.
    fn cast(&mut self, corners: [Vec3; 3]) {
        let [a, b, c] = corners.map(|corner| to_cells(corner.truncate()).extend(corner.z));
        let sides = [[a, b], [b, c], [c, a]];
        let longest = sides
            .map(|[from, to]| from.distance(to))
            .into_iter()
            .fold(0.0, f32::max);
        let area = (b - a).truncate().perp_dot((c - a).truncate());
        // Of a narrow one, a fill would go through many cells to meet few.
        if area.abs() > NARROW * longest {
            self.fill([a, b, c], area);
        } else {
            for side in sides {
                self.draw(side);
            }
        }
    }

    /// Darkens the cells whose middle lies below a triangle of twice this area, in cells.
    fn fill(&mut self, [a, b, c]: [Vec3; 3], area: f32) {
        let [low, high] = [a.min(b).min(c), a.max(b).max(c)];
        for y in columns(low.y, high.y) {
            for x in columns(low.x, high.x) {
                let from_a = Vec2::new(x + 0.5, y + 0.5) - a.truncate();
                let of_b = from_a.perp_dot((c - a).truncate()) / area;
                let of_c = (b - a).truncate().perp_dot(from_a) / area;
                if of_b.min(of_c).min(1.0 - of_b - of_c) >= 0.0 {
                    self.darken(x, y, a.z + of_b * (b.z - a.z) + of_c * (c.z - a.z));
                }
            }
        }
    }

    /// Darkens the cells below a line.
    fn draw(&mut self, line: [Vec3; 2]) {
        let Some([from, to]) = within(line) else {
            return;
        };
        let steps = from.truncate().distance(to.truncate()).ceil().max(1.0);
        for step in 0..=steps as usize {
            let at = from.lerp(to, step as f32 / steps);
            self.darken(at.x.floor(), at.y.floor(), at.z);
        }
    }

    fn darken(&mut self, x: f32, y: f32, height: f32) {
        if let Some(cell) = index(x, y).and_then(|index| self.cells.get_mut(index)) {
            *cell = cell.max((-height.max(0.0) / FADING).exp());
        }
    }

    /// Replaces each cell by the mean of those about it.
    fn soften(&mut self) {
        let mean = |window: &[f32]| window.iter().sum::<f32>() / window.len() as f32;
        let turned = |cells: &[f32]| -> Vec<f32> {
            let softened: Vec<Vec<f32>> = cells
                .chunks(CELLS)
                .map(|row| {
                    let about = |x: usize| {
                        row.get(x.saturating_sub(SOFTENING)..row.len().min(x + SOFTENING + 1))
                    };
                    (0..row.len()).map(|x| about(x).map_or(0.0, mean)).collect()
                })
                .collect();
            let column = |x: usize| softened.iter().filter_map(move |row| row.get(x).copied());
            (0..CELLS).flat_map(column).collect()
        };
        // Once along the rows and once along the columns, which turning makes rows.
        self.cells = turned(&turned(&self.cells));
    }
}

/// The columns, or rows, of the square between two places.
fn columns(low: f32, high: f32) -> impl Iterator<Item = f32> {
    let edge = CELLS as f32 - 1.0;
    let [low, high] = [low, high].map(f32::floor);
    // What lies beyond is not walked through, however far it reaches: a lobe may still be as large as an older scale has it.
    let all = (low <= edge && high >= 0.0).then(|| low.max(0.0) as usize..=high.min(edge) as usize);
    all.into_iter().flatten().map(|column| column as f32)
}

/// The part of a line that lies above the square.
fn within([from, to]: [Vec3; 2]) -> Option<[Vec3; 2]> {
    let way = to - from;
    let mut part = [0.0_f32, 1.0];
    for (start, way) in [(from.x, way.x), (from.y, way.y)] {
        let mut ends = [-start / way, (CELLS as f32 - start) / way];
        if way == 0.0 {
            let is_within = (0.0..=CELLS as f32).contains(&start);
            ends = if is_within { part } else { return None };
        }
        ends.sort_by(f32::total_cmp);
        part = [part[0].max(ends[0]), part[1].min(ends[1])];
    }
    let is_finite = from.is_finite() && to.is_finite();
    (is_finite && part[0] <= part[1]).then(|| part.map(|part| from + way * part))
}

/// A place of the surface in cells from the corner of the square.
fn to_cells(place: Vec2) -> Vec2 {
    0.5 * CELLS as f32 * (place + 1.0)
}

/// The index of the cell in this column and row; `None` outside the square.
fn index(x: f32, y: f32) -> Option<usize> {
    let inside = 0.0..CELLS as f32;
    (inside.contains(&x) && inside.contains(&y)).then_some(y as usize * CELLS + x as usize)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_reaches_far_beyond_the_surface_is_cast_in_no_time() {
        for far in [1e3, 1e8, 1e20, 1e38, f32::INFINITY, f32::NAN] {
            let corners = [
                Vec3::new(-far, -far, 0.1),
                Vec3::new(far, -far, 0.1),
                Vec3::new(0.0, far, 0.1),
            ];
            let blade = [
                Vec3::ZERO,
                Vec3::new(far, 0.0, 0.0),
                Vec3::new(far, 1e-3, 0.0),
            ];
            let shadow = Shadow::of([corners, blade]);
            let dark = shadow.at(Vec2::new(0.5, 0.0));
            assert!((0.0..=1.0).contains(&dark), "{far}: {dark}");
            assert!(far != 1e3 || dark > 0.1, "{far}: {dark}");
        }
    }

    /// A square parallel to the surface, about this place of it.
    fn plate(middle: Vec2, half: f32, height: f32) -> [[Vec3; 3]; 2] {
        let corner = |x: f32, y: f32| (middle + half * Vec2::new(x, y)).extend(height);
        let [a, b, c, d] = [
            corner(-1.0, -1.0),
            corner(1.0, -1.0),
            corner(1.0, 1.0),
            corner(-1.0, 1.0),
        ];
        [[a, b, c], [a, c, d]]
    }

    #[test]
    fn what_is_nearer_to_the_surface_darkens_it_more() {
        let middle = Vec2::new(0.3, -0.2);
        let [low, high] = [0.05, 0.5].map(|height| Shadow::of(plate(middle, 0.3, height)));
        assert!(low.at(middle) > 0.4 && low.at(middle) < 0.62);
        assert!(high.at(middle) < 0.3 * low.at(middle));
        for shadow in [&low, &high] {
            assert_eq!(shadow.at(Vec2::new(-0.6, 0.5)), 0.0, "beside it");
            let edge = shadow.at(middle + Vec2::new(0.3, 0.0)) / shadow.at(middle);
            assert!((edge - 0.5).abs() < 0.15, "its edge is soft: {edge}");
        }
    }

    #[test]
    fn a_lobe_thinner_than_a_cell_has_a_shadow_too() {
        let needle = [
            Vec3::ZERO,
            Vec3::new(0.5, 1e-4, 0.1),
            Vec3::new(0.5, -1e-4, 0.1),
        ];
        assert!(Shadow::of([needle]).at(Vec2::new(0.5, 0.0)) > 0.005);
    }
}
