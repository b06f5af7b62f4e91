//! What of the bar fits into a narrow window.

use crate::widgets::directions::Angle;

/// A part of the bar.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Part {
    /// Which direction is fixed.
    Fixed,
    /// What the lobe shows, in words.
    Shown,
    /// An angle, as a number.
    Of(Angle),
    /// The sliders of the angles.
    Rails,
    /// What turning the surface does, in words.
    Turning,
    /// The bar of shares.
    Energy,
    /// The shares in words.
    Words,
    /// The value under the pointer.
    Value,
}

/// In which order parts go where there is too little room: first what is said elsewhere too, then what has another control, then
/// numbers that the views show as well. Which direction is fixed stays.
pub(super) const LEAVING: [Part; 9] = [
    Part::Turning,
    Part::Shown,
    Part::Rails,
    Part::Words,
    Part::Of(Angle::Turn),
    Part::Value,
    Part::Energy,
    Part::Of(Angle::Phi),
    Part::Of(Angle::Theta),
];

/// The parts that do not fit into `room`, and how much room is left; where one does not, a button of the width `more` shows it.
/// `width`: what a part takes.
pub(super) fn left_out(
    width: impl Fn(Part) -> f32,
    room: f32,
    more: f32,
) -> (&'static [Part], f32) {
    let widths = LEAVING.map(&width);
    let whole = width(Part::Fixed) + widths.iter().sum::<f32>();
    let (mut count, mut rest) = (0, room - whole);
    for width in widths {
        if rest >= 0.0 {
            break;
        }
        if count == 0 {
            rest -= more;
        }
        (count, rest) = (count + 1, rest + width);
    }
    (LEAVING.get(..count).unwrap_or_default(), rest)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_leave_one_after_the_other_and_the_rest_fits() {
        let width = |part: Part| if part == Part::Value { 50.0 } else { 10.0 };
        let (gone, rest) = left_out(width, 140.0, 5.0);
        assert!(gone.is_empty() && rest == 0.0);
        let (gone, rest) = left_out(width, 139.0, 5.0);
        assert_eq!((gone, rest), (&LEAVING[..1], 4.0));
        let mut before = 0;
        for room in (0..140).rev() {
            let (gone, rest) = left_out(width, room as f32, 5.0);
            assert!(gone.len() >= before);
            before = gone.len();
            assert!(rest >= 0.0 || gone.len() == LEAVING.len(), "{room}");
        }
        assert_eq!(before, LEAVING.len());
    }
}
