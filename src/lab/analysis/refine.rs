//! Adaptive curves: intervals are halved until the chords between the points follow the curve.

use super::scale::RadialScale;

/// A chord may leave the curve by this much of the plot's size: a third of a pixel at 300 pixels.
pub(super) const CHORD_TOLERANCE: f64 = 1e-3;

/// Intervals narrower than this, in radians, are not halved: two thousand times finer than the narrowest lobe.
const NARROWEST: f64 = 5e-8;

/// A curve stops growing at this many points; a lobe needs some hundreds.
const MAX_POINTS: usize = 20_000;

/// Of the places where something is known to be, at most about this many are looked at to begin with: some stand in
/// each lobe, however narrow, and halving finds the rest.
const MAX_KNOWN: usize = 160;

/// Places and values, by place.
pub(super) type Curve<V> = Vec<(f64, V)>;

/// Where a curve over `range`, in radians, is looked at first: `steps` equal intervals, and those of `known` within the
/// range, where the curve is known to have something.
pub(super) fn first_places(
    range: [f64; 2],
    steps: u32,
    known: impl IntoIterator<Item = f64>,
) -> Vec<f64> {
    let [low, high] = range;
    let uniform = (0..=steps).map(|i| low + (high - low) * (f64::from(i) / f64::from(steps)));
    // What all but coincides with an end would take its place.
    let is_inside = |place: &f64| place - low >= NARROWEST && high - place >= NARROWEST;
    let mut known: Vec<f64> = known.into_iter().filter(is_inside).collect();
    known.sort_by(f64::total_cmp);
    let every = known.len().div_ceil(MAX_KNOWN).max(1);
    let mut places: Vec<f64> = known.into_iter().step_by(every).chain(uniform).collect();
    places.sort_by(f64::total_cmp);
    places.dedup_by(|a, b| *a - *b < NARROWEST);
    places
}

/// The curve whose values `at` gives, many places at once, from `places` on, in ascending order.
///
/// `looks`: where an interval is looked at, one after the other while it is good, as parts of its length. `measure`: by
/// what the points found so far are to be judged, `None` where there is nothing to follow; `is_good`: whether the middle
/// one of three points lies where the chord between the others passes it.
pub(super) fn refine<V: Clone, M>(
    places: Vec<f64>,
    looks: &[f64],
    at: impl Fn(&[f64]) -> Vec<V>,
    measure: impl Fn(&[(f64, V)]) -> Option<M>,
    is_good: impl Fn(&M, [&(f64, V); 3]) -> bool,
) -> Curve<V> {
    let values = at(&places);
    let mut curve: Curve<V> = places.into_iter().zip(values).collect();
    // By index of its first end: how many looks have found an interval's chord good. A later round, with a larger peak,
    // only makes it better.
    let mut passed = vec![0_usize; curve.len()];
    loop {
        let Some(extent) = measure(&curve).filter(|_| curve.len() <= MAX_POINTS) else {
            return curve;
        };
        let next_look = |a: f64, b: f64, passed: usize| {
            let part = looks.get(passed).filter(|_| b - a >= NARROWEST)?;
            Some(a + (b - a) * part)
        };
        let intervals = curve.windows(2).zip(&passed);
        let places: Vec<f64> = intervals
            .filter_map(|(pair, passed)| match pair {
                [(a, _), (b, _)] => next_look(*a, *b, *passed),
                _ => None,
            })
            .collect();
        let mut looked_at = places.iter().copied().zip(at(&places));
        let (mut finer, mut finer_passed) = (
            Vec::with_capacity(2 * curve.len()),
            Vec::with_capacity(2 * curve.len()),
        );
        for (pair, passed) in curve.windows(2).zip(&passed) {
            let [first, second] = pair else {
                continue;
            };
            finer.push(first.clone());
            let look = next_look(first.0, second.0, *passed);
            let Some(point) = look.and_then(|_| looked_at.next()) else {
                finer_passed.push(*passed);
                continue;
            };
            if is_good(&extent, [first, &point, second]) {
                finer_passed.push(*passed + 1);
            } else {
                finer.push(point);
                finer_passed.extend([0, 0]);
            }
        }
        finer.extend(curve.last().cloned());
        finer_passed.push(0);
        (curve, passed) = (finer, finer_passed);
        if places.is_empty() {
            return curve;
        }
    }
}

/// The largest magnitude of each of the numbers that the values of `curve` consist of; `None` where all are 0.
pub(super) fn peaks<V: AsRef<[f64]>>(curve: &[(f64, V)]) -> Option<Vec<f64>> {
    let first = curve.first()?.1.as_ref();
    let mut peaks = vec![0.0_f64; first.len()];
    for (_, value) in curve {
        for (peak, value) in peaks.iter_mut().zip(value.as_ref()) {
            *peak = peak.max(value.abs());
        }
    }
    peaks.iter().any(|peak| *peak > 0.0).then_some(peaks)
}

/// Where a chord is held against its curve: in the middle, and beside it, as a curve that bends both ways may meet the
/// middle by chance.
pub(super) const MIDDLE_AND_BESIDE: [f64; 2] = [0.5, 0.25];

/// Whether each number of the middle one of three points lies on the chord between the others, in a plot over the place
/// that is as high as the number's peak, or goes by decades below it.
pub(super) fn is_on_chord<V: AsRef<[f64]>>(
    scale: RadialScale,
    peaks: &[f64],
    [a, middle, b]: [&(f64, V); 3],
) -> bool {
    let part = (middle.0 - a.0) / (b.0 - a.0);
    let height = |value: f64, peak: f64| scale.radius(value.abs(), peak).copysign(value);
    let ends = a.1.as_ref().iter().zip(b.1.as_ref());
    let mut numbers = ends.zip(middle.1.as_ref()).zip(peaks);
    numbers.all(|(((a, b), middle), peak)| {
        let (a, b) = (height(*a, *peak), height(*b, *peak));
        (height(*middle, *peak) - (a + (b - a) * part)).abs() <= CHORD_TOLERANCE
    })
}
