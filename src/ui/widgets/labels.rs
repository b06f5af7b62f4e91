//! Labels in a picture: each beside what it names, clear of handles, buttons and one another.

use egui::{Pos2, Rect, Vec2};

/// Room between what is named and its label, in points.
const GAP: f32 = 4.0;

/// How much further out each next round of places lies, in points.
const STEP: f32 = 9.0;

/// A label further than this from what it names is joined to it by a line, in points.
const NEAR: f32 = 26.0;

/// The room that a line takes at a point of it, and how far apart these points are, in points.
const LINE: Vec2 = Vec2::splat(7.0);
/// See [`LINE`].
const LINE_STEP: f32 = 5.0;

/// How far a label may stand from what it names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reach {
    /// Just where it is wanted: it is left out if something stands there.
    There,
    /// Beside it, else it is left out: the name stands elsewhere too.
    Near,
    /// Wherever there is room.
    Far,
}

/// Which way a label stands from what it names, in eighths of a turn from the wanted one, in the order in which they are
/// tried.
const TURNS: [f32; 8] = [0.0, 1.0, -1.0, 2.0, -2.0, 3.0, -3.0, 4.0];

/// Where labels stand in a picture.
#[derive(Clone, Debug)]
pub struct Labels {
    bounds: Rect,
    taken: Vec<Rect>,
}

/// The place of a label.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// What it covers.
    pub rect: Rect,
    /// The ends of the line that joins it to what it names, where that is not beside it.
    pub leader: Option<[Pos2; 2]>,
}

impl Labels {
    /// None so far, within `bounds`.
    #[must_use]
    pub fn within(bounds: Rect) -> Self {
        Self {
            bounds,
            taken: Vec::new(),
        }
    }

    /// Keeps labels off `rect`.
    pub fn keep_off(&mut self, rect: Rect) {
        self.taken.push(rect);
    }

    /// Keeps labels off a line between these points.
    pub fn keep_off_line(&mut self, [from, to]: [Pos2; 2]) {
        let steps = ((to - from).length() / LINE_STEP).ceil().max(1.0);
        let along = |step: f32| Rect::from_center_size(from.lerp(to, step / steps), LINE);
        self.taken
            .extend((0..=steps as usize).map(|step| along(step as f32)));
    }

    /// A place for a label of this size beside `point`, on the side `towards` if there is room; over the point if that has
    /// no length. `None` where there is none within `reach`.
    pub fn place(&mut self, point: Pos2, size: Vec2, towards: Vec2, reach: Reach) -> Option<Place> {
        let is_over = towards == Vec2::ZERO;
        let wanted = if is_over {
            Vec2::DOWN
        } else {
            towards.normalized()
        };
        let (rounds, turns) = match reach {
            Reach::There => (u8::from(!is_over), 1),
            Reach::Near => (3, TURNS.len()),
            Reach::Far => (30, TURNS.len()),
        };
        let over = Some(Rect::from_center_size(point, size)).filter(|_| is_over);
        let beside = (0..rounds).flat_map(|round| {
            let gap = GAP + STEP * f32::from(round);
            TURNS.into_iter().take(turns).map(move |turn| {
                let (sin, cos) = (turn * std::f32::consts::FRAC_PI_4).sin_cos();
                let way = Vec2::new(
                    cos * wanted.x - sin * wanted.y,
                    sin * wanted.x + cos * wanted.y,
                );
                Rect::from_center_size(point + way * (gap + reach_of(size, way)), size)
            })
        });
        let rect = over
            .into_iter()
            .chain(beside)
            .find(|rect| self.is_free(*rect))?;
        self.taken.push(rect);
        let end = rect.clamp(point);
        let leader = (end.distance(point) > NEAR).then_some([point, end]);
        Some(Place { rect, leader })
    }

    fn is_free(&self, rect: Rect) -> bool {
        self.bounds.contains_rect(rect) && !self.taken.iter().any(|other| other.intersects(rect))
    }
}

/// How far the middle of a box of this size is from its edge, along the unit vector `way`.
fn reach_of(size: Vec2, way: Vec2) -> f32 {
    let half = 0.5 * size;
    let [x, y] = [(half.x, way.x), (half.y, way.y)].map(|(half, part)| {
        if part.abs() > 1e-3 {
            half / part.abs()
        } else {
            f32::INFINITY
        }
    });
    x.min(y)
}

#[cfg(test)]
mod tests {
    use egui::{pos2, vec2};

    use super::*;

    const BOUNDS: Rect = Rect {
        min: Pos2::ZERO,
        max: pos2(300.0, 200.0),
    };

    #[test]
    fn many_labels_of_one_point_stand_apart() {
        let mut labels = Labels::within(BOUNDS);
        let handle = Rect::from_center_size(pos2(150.0, 100.0), vec2(20.0, 20.0));
        labels.keep_off(handle);
        let mut places = vec![handle];
        for _ in 0..12 {
            let place = labels.place(
                pos2(150.0, 100.0),
                vec2(60.0, 18.0),
                vec2(1.0, -1.0),
                Reach::Far,
            );
            let rect = place.unwrap().rect;
            assert!(BOUNDS.contains_rect(rect));
            assert!(places.iter().all(|other| !other.intersects(rect)));
            places.push(rect);
        }
    }

    #[test]
    fn a_label_stands_where_it_is_wanted_or_not_at_all() {
        let mut labels = Labels::within(BOUNDS);
        let (at, size) = (pos2(100.0, 100.0), vec2(30.0, 10.0));
        let right = labels.place(at, size, Vec2::RIGHT, Reach::Near).unwrap();
        assert_eq!(right.rect.left_center(), at + vec2(GAP, 0.0));
        assert_eq!(right.leader, None);
        assert_eq!(labels.place(at, size, Vec2::RIGHT, Reach::There), None);
        let over = labels.place(pos2(50.0, 50.0), size, Vec2::ZERO, Reach::There);
        assert_eq!(over.unwrap().rect.center(), pos2(50.0, 50.0));
        assert_eq!(
            labels.place(pos2(290.0, 50.0), size, Vec2::RIGHT, Reach::There),
            None
        );
    }

    #[test]
    fn a_label_far_away_has_a_line_to_what_it_names() {
        let mut labels = Labels::within(BOUNDS);
        labels.keep_off(Rect::from_center_size(
            pos2(150.0, 100.0),
            vec2(120.0, 120.0),
        ));
        let near = labels.place(pos2(150.0, 100.0), vec2(40.0, 16.0), Vec2::UP, Reach::Near);
        assert_eq!(near, None);
        let far = labels.place(pos2(150.0, 100.0), vec2(40.0, 16.0), Vec2::UP, Reach::Far);
        let [from, to] = far.unwrap().leader.unwrap();
        assert_eq!(from, pos2(150.0, 100.0));
        assert!(far.unwrap().rect.expand(0.1).contains(to));
    }

    /// The share at the tip of an arrow, where what lies beyond the tip is taken.
    #[test]
    fn no_label_lies_over_a_line() {
        let (foot, tip) = (pos2(100.0, 100.0), pos2(140.0, 60.0));
        for off_line in [false, true] {
            let mut labels = Labels::within(BOUNDS);
            labels.keep_off(Rect::from_center_size(
                tip + vec2(24.0, -24.0),
                vec2(40.0, 40.0),
            ));
            if off_line {
                labels.keep_off_line([foot, tip]);
            }
            let size = vec2(80.0, 20.0);
            let place = labels.place(tip, size, tip - foot, Reach::Far).unwrap();
            let covers = |step: u8| place.rect.contains(foot.lerp(tip, f32::from(step) / 40.0));
            assert_eq!((0..=40).any(covers), !off_line, "{place:?}");
        }
    }
}
