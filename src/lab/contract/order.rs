//! Order statistics of points: what a chart is scaled and cut by.

/// The share of the samples that a narrow lobe beside a wide one may have without being missed.
const NARROW_SHARE: usize = 32;

/// The size below which one in [`NARROW_SHARE`] of the x or y of `points` lies. 0 without points.
///
/// For one lobe that is a fixed small part of its width; for a narrow lobe within a wide one it is of the size of the
/// narrow one, where the median would be of neither: linear across the narrow lobe, the chart is logarithmic from there on.
pub(super) fn narrow_scale(points: &mut [[f64; 2]], is_x: bool) -> f64 {
    let index = points.len() / NARROW_SHARE;
    let key = |[x, y]: &[f64; 2]| if is_x { *x } else { *y };
    if points.is_empty() {
        return 0.0;
    }
    let (_, at, _) = points.select_nth_unstable_by(index, |a, b| key(a).total_cmp(&key(b)));
    key(at)
}

/// The median of the x or y of `points`, which are left in two halves about it. 0 without points.
pub(super) fn median(points: &mut [[f64; 2]], is_x: bool) -> f64 {
    let key = |[x, y]: &[f64; 2]| if is_x { *x } else { *y };
    if points.is_empty() {
        return 0.0;
    }
    let (_, middle, _) =
        points.select_nth_unstable_by(points.len() / 2, |a, b| key(a).total_cmp(&key(b)));
    key(middle)
}
