//! What nothing beats, and how errors fall with the number of samples.

use super::report::{Point, Slopes};

/// Marks the points that no other one beats in cost and in error.
pub(super) fn mark(points: &mut [Point]) {
    let beats = |a: &Point, b: &Point| {
        let no_worse = a.cost_ns <= b.cost_ns && a.error_rms <= b.error_rms;
        no_worse && (a.cost_ns < b.cost_ns || a.error_rms < b.error_rms)
    };
    let front: Vec<bool> = points
        .iter()
        .map(|point| !points.iter().any(|other| beats(other, point)))
        .collect();
    points
        .iter_mut()
        .zip(front)
        .for_each(|(point, is_first)| point.pareto = is_first);
}

/// Errors below this are rounding: they follow no law of the number of samples.
const ROUNDING: f64 = 1e-13;

/// Points needed for a slope.
const FEWEST_FOR_SLOPE: usize = 3;

/// The slope of log error over log n of each choice that has numbers of samples, by least squares over the points whose
/// error is more than rounding.
pub(super) fn slopes(points: &[Point]) -> Slopes {
    let mut choices: Vec<&str> = points.iter().map(|point| point.choice.as_str()).collect();
    choices.dedup();
    let slope = |choice: &str| {
        let own = points.iter().filter(|point| point.choice == choice);
        let logs: Vec<[f64; 2]> = own
            .filter_map(|point| Some([(point.n? as f64).ln(), point.error_rms]))
            .take_while(|[_, error]| *error > ROUNDING)
            .map(|[n, error]| [n, error.ln()])
            .collect();
        (logs.len() >= FEWEST_FOR_SLOPE).then(|| least_squares(&logs))
    };
    let numbered = choices.into_iter().filter(|choice| {
        let mut own = points.iter().filter(|point| point.choice == *choice);
        own.any(|point| point.n.is_some())
    });
    numbered
        .map(|choice| (choice.to_owned(), slope(choice)))
        .collect()
}

/// The slope of the line nearest to `points`.
fn least_squares(points: &[[f64; 2]]) -> f64 {
    let n = points.len() as f64;
    let mean = |axis: usize| points.iter().filter_map(|p| p.get(axis)).sum::<f64>() / n;
    let (x0, y0) = (mean(0), mean(1));
    let (mut xy, mut xx) = (0.0, 0.0);
    for [x, y] in points {
        xy += (x - x0) * (y - y0);
        xx += (x - x0) * (x - x0);
    }
    xy / xx
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_front_has_what_nothing_beats() {
        let costs_and_errors = [(1.0, 0.5), (2.0, 0.1), (3.0, 0.2), (4.0, 0.1), (5.0, 0.0)];
        let mut points: Vec<Point> = costs_and_errors
            .iter()
            .map(|(cost_ns, error_rms)| Point {
                cost_ns: *cost_ns,
                error_rms: *error_rms,
                ..Point::new("")
            })
            .collect();
        mark(&mut points);
        let front: Vec<bool> = points.iter().map(|point| point.pareto).collect();
        assert_eq!(front, [true, true, false, false, true]);
    }

    #[test]
    fn slopes_are_those_of_powers() {
        let points: Vec<Point> = (4..10)
            .map(|k| Point {
                n: Some(1 << k),
                error_rms: 3.0 * 2_f64.powf(-1.5 * f64::from(k)),
                ..Point::new("a")
            })
            .collect();
        let slope = slopes(&points)["a"].unwrap();
        assert!((slope + 1.5).abs() < 1e-12, "{slope}");
        let exact = [Point {
            n: Some(16),
            ..Point::new("b")
        }];
        assert_eq!(slopes(&exact)["b"], None);
    }
}
