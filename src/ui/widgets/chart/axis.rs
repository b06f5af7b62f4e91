//! The axes of a chart.

use egui_plot::{AxisHints, GridMark};

use bxdf_study::format;

/// Room above the highest curve, as a share of the height.
pub(super) const TOP_ROOM: f64 = 0.12;

/// The angles at which an axis of degrees is marked: the closer ones where there is room.
const DEGREES: [f64; 3] = [15.0, 30.0, 90.0];

/// The decades between the marks of an axis that goes by them: the closer ones where there is room.
const DECADES: [f64; 4] = [1.0, 2.0, 4.0, 8.0];

/// An axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// What it measures, with its unit.
    pub name: String,
    /// What stands there where there is no room for its name; nothing where there is none for that either.
    pub short_name: String,
    /// Its ends, in that unit.
    pub range: [f64; 2],
    /// Whether it goes by decades: both ends are above 0 then.
    pub is_logarithmic: bool,
    /// Whether it measures an angle in degrees.
    pub is_angle: bool,
    /// Whether curves are cut off at its ends; else it reaches as far as there are values.
    pub is_cut: bool,
}

impl Axis {
    /// An axis in proportion.
    #[must_use]
    pub fn linear(name: impl Into<String>, range: [f64; 2]) -> Self {
        Self {
            name: name.into(),
            short_name: String::new(),
            range,
            is_logarithmic: false,
            is_angle: false,
            is_cut: false,
        }
    }

    /// An axis of angles in degrees.
    #[must_use]
    pub fn degrees(name: impl Into<String>, range: [f64; 2]) -> Self {
        Self {
            is_angle: true,
            ..Self::linear(name, range)
        }
    }

    /// An axis from 0, or by `decades` below it, to a little above `largest`; from as far below 0 as `least` lies.
    #[must_use]
    pub fn of_values(
        name: impl Into<String>,
        [least, largest]: [f64; 2],
        decades: Option<f64>,
    ) -> Self {
        let largest = if largest > least.max(0.0) {
            largest
        } else {
            least.max(0.0) + 1.0
        };
        let range = if let Some(decades) = decades {
            let top = largest * 10_f64.powf(TOP_ROOM * decades);
            [largest * 10_f64.powf(-decades), top]
        } else {
            let room = TOP_ROOM * (largest - least.min(0.0));
            let low = if least < 0.0 { least - room } else { 0.0 };
            [low, largest + room]
        };
        Self {
            name: name.into(),
            short_name: String::new(),
            range,
            is_logarithmic: decades.is_some(),
            is_angle: false,
            is_cut: false,
        }
    }

    /// The same axis, called so where there is no room for its name.
    #[must_use]
    pub fn or_short(self, short_name: impl Into<String>) -> Self {
        Self {
            short_name: short_name.into(),
            ..self
        }
    }

    /// The pieces of `line`, places of the plot, that lie between the ends, where curves are cut off there: each ends on them.
    pub(super) fn cut(&self, line: Vec<[f64; 2]>) -> Vec<Vec<[f64; 2]>> {
        let [low, high] = self.ends();
        if !self.is_cut || line.iter().all(|[_, y]| (low..=high).contains(y)) {
            return vec![line];
        }
        let (mut pieces, mut piece) = (Vec::new(), Vec::new());
        for pair in line.windows(2) {
            let [from, to] = pair else { continue };
            let Some([begin, end]) = between([*from, *to], [low, high]) else {
                continue;
            };
            if piece.is_empty() {
                piece.push(begin);
            }
            piece.push(end);
            if end != *to {
                pieces.push(std::mem::take(&mut piece));
            }
        }
        pieces.push(piece);
        pieces.retain(|piece| !piece.is_empty());
        pieces
    }

    /// Where a value lies in the plot.
    pub(super) fn place(&self, value: f64) -> f64 {
        let [low, high] = self.range;
        if self.is_logarithmic {
            value.clamp(low, high).log10()
        } else {
            value
        }
    }

    /// The value at a place of the plot.
    pub(super) fn value(&self, place: f64) -> f64 {
        if self.is_logarithmic {
            10_f64.powf(place)
        } else {
            place
        }
    }

    pub(super) fn ends(&self) -> [f64; 2] {
        self.range.map(|end| self.place(end))
    }

    /// How it is drawn, with numbers that are farther apart than `spacing`, in points; `fits`: whether there is room for a name.
    pub(super) fn hints(
        &self,
        hints: AxisHints<'static>,
        spacing: f32,
        fits: impl Fn(&str) -> bool,
    ) -> AxisHints<'static> {
        let is_logarithmic = self.is_logarithmic;
        let names = [&self.name, &self.short_name].into_iter();
        let name = names
            .filter(|name| !name.is_empty())
            .find(|name| fits(name));
        let hints = match name {
            Some(name) => hints.label(name.clone()),
            None => hints,
        };
        let hints = hints.label_spacing(spacing..=spacing);
        hints.formatter(move |mark, range| tick(mark, is_logarithmic, range.end() - range.start()))
    }
}

/// The part of a segment whose heights lie between `low` and `high`.
fn between([from, to]: [[f64; 2]; 2], [low, high]: [f64; 2]) -> Option<[[f64; 2]; 2]> {
    let ([x, y], [dx, dy]) = (from, [to[0] - from[0], to[1] - from[1]]);
    let at = |height: f64| (height - y) / dy;
    let [first, last] = if dy == 0.0 {
        [0.0, if (low..=high).contains(&y) { 1.0 } else { -1.0 }]
    } else {
        let (a, b) = (at(low), at(high));
        [a.min(b).max(0.0), a.max(b).min(1.0)]
    };
    // The ends of the segment itself as they are, without rounding.
    let point = |share: f64| match share {
        0.0 => from,
        1.0 => to,
        _ => [x + share * dx, (y + share * dy).clamp(low, high)],
    };
    (first <= last).then(|| [point(first), point(last)])
}

/// The marks of an axis of degrees that shows these ends.
pub(super) fn angle_marks(ends: (f64, f64)) -> Vec<GridMark> {
    multiples(&DEGREES, ends)
}

/// The marks of an axis that goes by decades and shows these ends, logarithms to base 10.
pub(super) fn decade_marks(ends: (f64, f64)) -> Vec<GridMark> {
    multiples(&DECADES, ends)
}

/// Marks between `low` and `high` at the multiples of the first of `steps`, each as important as the largest one that
/// divides it.
fn multiples(steps: &[f64], (low, high): (f64, f64)) -> Vec<GridMark> {
    let Some(first) = steps.first() else {
        return Vec::new();
    };
    let mark = |index: i32| {
        let value = first * f64::from(index);
        let divides = |step: &&f64| (value / **step).fract() == 0.0;
        let step_size = steps.iter().rfind(divides).copied();
        step_size.map(|step_size| GridMark { value, step_size })
    };
    let [start, end] = [low, high].map(|bound| bound / first);
    // Rounding may leave an end just outside.
    let indices = (start - 1e-9).ceil() as i32..=(end + 1e-9).floor() as i32;
    indices.filter_map(mark).collect()
}

/// The text at a mark of an axis that shows `span` of its values.
fn tick(mark: GridMark, is_logarithmic: bool, span: f64) -> String {
    // Marks are sums of steps: what rounding leaves of 0 is 0.
    let value = if mark.value.abs() < 1e-9 * span {
        0.0
    } else {
        mark.value
    };
    if !is_logarithmic {
        return format::value(value);
    }
    // Between whole decades there is no round number to write.
    if (value - value.round()).abs() < 1e-6 {
        format::value(10_f64.powf(value.round()))
    } else {
        String::new()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn marks_are_multiples_and_the_rounder_the_more_important() {
        let marks = angle_marks((-20.0, 90.0));
        let found: Vec<[f64; 2]> = marks.iter().map(|m| [m.value, m.step_size]).collect();
        assert_eq!(found[..3], [[-15.0, 15.0], [0.0, 90.0], [15.0, 15.0]]);
        assert_eq!(found.last(), Some(&[90.0, 90.0]));
        let marks = decade_marks((-16.0, 0.2));
        let steps: Vec<f64> = marks.iter().map(|m| m.step_size).collect();
        assert_eq!(steps[..5], [8.0, 1.0, 2.0, 1.0, 4.0]);
        assert_eq!(steps.len(), 17);
    }

    #[test]
    fn curves_end_where_their_axis_does() {
        let open = Axis::linear("f", [0.0, 1.0]);
        let cut = Axis {
            is_cut: true,
            ..open.clone()
        };
        let line = vec![[0.0, 0.5], [1.0, 1.5], [2.0, 1.5], [3.0, 0.5], [4.0, -0.5]];
        assert_eq!(open.cut(line.clone()), std::slice::from_ref(&line));
        let pieces = cut.cut(line.clone());
        assert_eq!(
            pieces,
            [
                vec![[0.0, 0.5], [0.5, 1.0]],
                vec![[2.5, 1.0], [3.0, 0.5], [3.5, 0.0]]
            ]
        );
        assert_eq!(
            cut.cut(vec![[0.0, 2.0], [1.0, 3.0]]),
            Vec::<Vec<[f64; 2]>>::new()
        );
        assert_eq!(
            cut.cut(vec![[0.0, -1.0], [1.0, 2.0]]).len(),
            1,
            "through both ends"
        );
        let inside = vec![[0.0, 0.0], [1.0, 1.0]];
        assert_eq!(cut.cut(inside.clone()), [inside]);
    }

    #[test]
    fn axes_hold_their_values() {
        let linear = Axis::of_values("f", [0.0, 2.0], None);
        assert!(linear.range[0] == 0.0 && linear.range[1] > 2.0);
        let residual = Axis::of_values("f", [-1.0, 2.0], None);
        assert!(residual.range[0] < -1.0);
        let decades = Axis::of_values("f", [0.0, 100.0], Some(4.0));
        assert!((decades.range[0] - 0.01).abs() < 1e-12 && decades.range[1] > 100.0);
        assert!((decades.value(decades.place(3.0)) - 3.0).abs() < 1e-12);
        assert_eq!(decades.place(0.0), decades.place(0.01), "the floor");
        let nothing = Axis::of_values("f", [0.0, 0.0], Some(4.0));
        assert!(nothing.range[0] > 0.0 && nothing.range[1] > nothing.range[0]);
    }
}
