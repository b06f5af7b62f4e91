//! One integral in several coordinates: the ones in which it converges first give it.

use super::{Cubature, Integral, Integrand, largest};

/// Cells that are bisected before the next look at who is ahead.
const TURN: usize = 4;

/// Turns that each takes before its progress is judged by them, the first cells counted as one.
const FIRST_TURNS: usize = 2;

/// In each so many turns, one goes to whoever has had fewest evaluations: progress may be misjudged.
const EXPLORED: usize = 8;

/// The slowest decay of the error with the evaluations, as a power of their number, that is reckoned with.
const SLOWEST: f64 = 0.5;

/// A rival is believed where it is no further from the trusted integral than its own error and so many times the trusted
/// one's, which an edge across the square makes too small...
const DOUBT: f64 = 4.0;

/// ... or this part of the value, if that is less: the error may be far too large as well, and hide what a rival misses.
const MISSED: f64 = 0.01;

/// What a value of the trusted integrand costs, in values of a rival: it is drawn, and its density is found too.
const COST: f64 = 2.0;

/// The integral over the unit square of `trusted`, or of any one of `rivals`, which give the same integral in other
/// coordinates and need not be defined so well: whichever reaches `tolerance` first.
///
/// Each is refined in turn, most often the one that is expected to be done with the fewest further evaluations. Lobes that
/// are no wider than a node's distance may be missed in the rivals' coordinates; `trusted` must not miss any. A rival
/// whose value is out of reach of `trusted` waits until that has come nearer, or is done itself. Arguments else as for
/// [`integrate_square`](super::integrate_square); `trusted` alone has its sides graded.
#[must_use]
pub fn best_of(
    trusted: Integrand<'_>,
    rivals: &[Integrand<'_>],
    tolerance: f64,
    max_evaluations: usize,
) -> Integral {
    let mut trusted = Runner::new(Cubature::new(trusted, true), COST);
    // What is nearly done needs no rivals.
    while trusted.course.len() < FIRST_TURNS && !trusted.is_within(tolerance) {
        trusted.take_turn(tolerance);
    }
    if trusted.is_within(tolerance) {
        return trusted.cubature.total();
    }
    let rivals = rivals
        .iter()
        .map(|f| Runner::new(Cubature::new(*f, false), 1.0));
    let mut rivals: Vec<Runner<'_>> = rivals.collect();
    let mut turn = 0_usize;
    loop {
        if let Some(integral) = outcome(&trusted, &rivals, tolerance, max_evaluations) {
            return integral;
        }
        if rivals.iter().any(|rival| rival.is_within(tolerance)) {
            trusted.take_turn(tolerance);
            continue;
        }
        let key = |runner: &Runner<'_>| {
            let evaluations = if turn % EXPLORED == EXPLORED - 1 {
                runner.cubature.evaluations as f64
            } else {
                runner.evaluations_left(tolerance)
            };
            runner.cost * evaluations
        };
        let everyone = rivals.iter_mut().chain([&mut trusted]);
        if let Some(next) = everyone.min_by(|a, b| key(a).total_cmp(&key(b))) {
            next.take_turn(tolerance);
        }
        turn += 1;
    }
}

/// The integral, as soon as one has it or all may ask for no more.
fn outcome(
    trusted: &Runner<'_>,
    rivals: &[Runner<'_>],
    tolerance: f64,
    max_evaluations: usize,
) -> Option<Integral> {
    let reference = trusted.cubature.sum;
    let all = || rivals.iter().chain([trusted]);
    let spent: usize = all().map(|runner| runner.cubature.evaluations).sum();
    let mut believed = all().filter(|runner| runner.is_near(&reference));
    let found = if spent >= max_evaluations {
        believed.min_by(|a, b| {
            let [a, b] = [a, b].map(|runner| runner.cubature.sum.error);
            a.total_cmp(&b)
        })
    } else {
        believed.find(|runner| runner.is_within(tolerance))
    };
    found.map(|runner| runner.result(spent))
}

/// One of the integrands, and how it got on.
struct Runner<'a> {
    cubature: Cubature<'a>,
    /// What a value costs, in those of a rival.
    cost: f64,
    /// Evaluations and error after each turn.
    course: Vec<[f64; 2]>,
}

impl<'a> Runner<'a> {
    fn new(cubature: Cubature<'a>, cost: f64) -> Self {
        let mut runner = Self {
            cubature,
            cost,
            course: Vec::new(),
        };
        runner.note();
        runner
    }

    /// Its integral, after so many evaluations of all.
    fn result(&self, evaluations: usize) -> Integral {
        Integral {
            evaluations,
            ..self.cubature.total()
        }
    }

    fn note(&mut self) {
        let cubature = &self.cubature;
        let stand = [cubature.evaluations as f64, cubature.sum.error];
        self.course.push(stand);
    }

    fn is_within(&self, tolerance: f64) -> bool {
        self.cubature.is_within(tolerance)
    }

    fn take_turn(&mut self, tolerance: f64) {
        for _ in 0..TURN {
            if !self.is_within(tolerance) {
                self.cubature.halve_worst();
            }
        }
        self.note();
    }

    /// Whether the value is that of `trusted`, as far as that is known.
    fn is_near(&self, trusted: &Integral) -> bool {
        let own = self.cubature.sum;
        let doubt = (DOUBT * trusted.error).min(MISSED * largest(trusted.value));
        own.distance(trusted) <= own.error + doubt
    }

    /// The evaluations to come until the error is `tolerance`, if it goes on to fall as it did since there were half as
    /// many; before that is known, none.
    fn evaluations_left(&self, tolerance: f64) -> f64 {
        let Some([now, error]) = self.course.last().copied() else {
            return 0.0;
        };
        if self.course.len() < FIRST_TURNS {
            return 0.0;
        }
        let half = self.course.iter().rfind(|[then, _]| *then <= 0.6 * now);
        let Some([then, before]) = half.or(self.course.first()) else {
            return 0.0;
        };
        let power = (before / error).ln() / (now / then).ln();
        now * ((error / tolerance).powf(1.0 / power.max(SLOWEST)) - 1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_coordinates_without_a_kink_win() {
        // The same disc's share of the square, by area and by polar angle.
        let asked = std::cell::Cell::new(0);
        let cut = |points: &[[f64; 2]]| -> Vec<[f64; 3]> {
            asked.set(asked.get() + points.len());
            let inside = |[u, v]: &[f64; 2]| if u * u + v * v < 1.0 { 1.0 } else { 0.0 };
            points.iter().map(|point| [inside(point); 3]).collect()
        };
        let polar = |points: &[[f64; 2]]| -> Vec<[f64; 3]> {
            let ring = |[r, _]: &[f64; 2]| [r * std::f64::consts::FRAC_PI_2; 3];
            points.iter().map(ring).collect()
        };
        let found = best_of(&cut, &[&polar], 1e-10, 1_000_000);
        assert!((found.value[0] - std::f64::consts::FRAC_PI_4).abs() < 1e-10);
        assert!(found.error <= 1e-10 && asked.get() < 10_000);
    }

    #[test]
    fn what_misses_a_needle_is_not_believed() {
        let needle = |points: &[[f64; 2]]| -> Vec<[f64; 3]> { vec![[1.0; 3]; points.len()] };
        let kinked = |points: &[[f64; 2]]| -> Vec<[f64; 3]> {
            let mut values = needle(points);
            for (value, [u, v]) in values.iter_mut().zip(points) {
                *value = value.map(|x| x + (u + v - 1.0 / 3.0).abs());
            }
            values
        };
        let missed = |points: &[[f64; 2]]| vec![[0.0; 3]; points.len()];
        let found = best_of(&kinked, &[&missed], 1e-7, 1_000_000);
        // The integral of |u + v - 1/3|: 2/3 + 2 (1/3)^3 / 6.
        let exact = 1.0 + 2.0 / 3.0 + 1.0 / 81.0;
        assert!((found.value[0] - exact).abs() <= 1e-7, "{found:?}");
    }
}
