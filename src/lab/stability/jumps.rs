//! Steps of a value where a formula changes over to another.
//!
//! The reference precision runs the same source, changes over at the same places, and shows no error there. But it shows
//! the step: along a line of an angle or a parameter a smooth function is a cubic between places close enough, and where it
//! is not, however close they are, it jumps.

use glam::DVec3;
use xprec::Df64;

use super::ExtremeKind;
use super::extreme_tally::{Finding, Tally};
use crate::rounding::{quantities, stability_bound};
use crate::specimen::Specimen;
use bxdf::ModelSpec;
use bxdf::math::{Real, Vec3};
use bxdf::param::{Kind, ParamSet, ParamSpec, Value};

/// The relative step that is looked for: what the stability law allows in f64 where the condition number is 4.
const TOLERANCE: f64 = 1e-14;

/// Stretches of a line to begin with.
const STRETCHES: usize = 16;

/// How often a stretch is halved.
const DEPTH: u32 = 47;

/// Halvings after which what is no jump has shrunk: a root's rise to a 32nd.
const SHRINKING: u32 = 10;

/// By how much less than half a rise must shrink in them to be no jump.
const JUMPS: f64 = 0.5;

/// Relative step of a derivative along a line: small beside where roots begin to bend, large beside the last stretches.
const STEP: f64 = 1e-13;

/// A value this much below the largest of its line is held against that: a lobe may end in a corner.
const FLOOR: f64 = 1e-6;

/// Most places that are looked at along a line.
const BUDGET: u32 = 60_000;

/// wo of the lines of wi, and the azimuth between, in degrees.
const LINES_DEG: [(f64, f64); 3] = [(35.0, 180.0), (80.0, 20.0), (145.0, 33.0)];

/// Looks along lines of wi.
pub(super) fn jumps(specimen: &Specimen, tally: &mut Tally) {
    for (theta_o, azimuth) in LINES_DEG {
        let wo = direction(Df64::of(theta_o), 0.0);
        for [from, to] in [[1e-3, 89.999], [90.001, 179.999]] {
            let line = |theta: f64| {
                let wi = direction(Df64::of(theta), azimuth);
                Some(quantities(&*specimen.reference, wo, wi))
            };
            let stretches = linear(from, to);
            let found = largest_jump(&line, &stretches);
            record(found, tally, |theta| {
                let beside = direction(Df64::of(theta * (1.0 - BESIDE)), azimuth);
                (specimen, wo.into(), beside.into())
            });
        }
    }
}

/// Looks along lines of each parameter of `model` from `params`.
pub(super) fn along_parameters(model: &ModelSpec, params: &ParamSet, tally: &mut Tally) {
    let pairs = LINES_DEG.map(|(theta_o, azimuth)| {
        let wo = direction(Df64::of(theta_o), 0.0);
        let near_mirror = direction(
            Df64::of((theta_o - 180.0).abs().min(theta_o) + 3.0),
            azimuth,
        );
        (wo, near_mirror)
    });
    for (spec, _) in params.iter().filter(|(spec, _)| params.is_relevant(spec)) {
        let Some(stretches) = stretches_of(spec) else {
            continue;
        };
        for (wo, wi) in pairs {
            let line = |x: f64| {
                let bxdf = model.build::<Df64>(&moved(model, params, spec, x)?);
                Some(quantities(&*bxdf, wo, wi))
            };
            let found = largest_jump(&line, &stretches);
            let at = found
                .jump
                .and_then(|jump| moved(model, params, spec, jump.x * (1.0 - BESIDE)));
            let specimen = Specimen::new(model, at.as_ref().unwrap_or(params));
            record(found, tally, |_| (&specimen, wo.into(), wi.into()));
        }
    }
}

/// Beside a jump by this share of where it is the condition number is that of the smooth part.
const BESIDE: f64 = 1e-6;

/// `params` with the number at `x`; `None` where the model refuses it.
fn moved(model: &ModelSpec, params: &ParamSet, spec: &ParamSpec, x: f64) -> Option<ParamSet> {
    let value = match spec.kind {
        Kind::Number => Value::Number(x),
        Kind::Rgb => Value::Rgb([x; 3]),
        Kind::Choice | Kind::Bool | Kind::Data => return None,
    };
    let moved = params.with(&[(spec.name, value)])?;
    (model.validate)(&moved).ok()?;
    Some(moved)
}

/// The range of a number, its ends left out: evenly, or where it spans decades evenly over them.
fn stretches_of(spec: &ParamSpec) -> Option<Vec<f64>> {
    /// The smallest number looked at where a range begins at 0 and spans decades.
    const LEAST: f64 = 1e-3;
    if !matches!(spec.kind, Kind::Number | Kind::Rgb) {
        return None;
    }
    let [min, max] = spec.hard;
    let margin = 1e-6 * (max - min);
    if max - min <= 3.0 && min.abs() < LEAST || min < 0.0 {
        return Some(linear(min + margin.max(1e-4), max - margin));
    }
    let (low, high) = (min.max(LEAST) * (1.0 + 1e-6), max * (1.0 - 1e-6));
    let steps = STRETCHES * (high / low).log10().ceil().max(1.0) as usize;
    let place = |index: usize| low * (high / low).powf(index as f64 / steps as f64);
    Some((0..=steps).map(place).collect())
}

fn linear(from: f64, to: f64) -> Vec<f64> {
    let place = |index: usize| from + (to - from) * index as f64 / STRETCHES as f64;
    (0..=STRETCHES).map(place).collect()
}

/// The direction at these angles in degrees, a unit vector to the last digit of the reference.
fn direction(theta_deg: Df64, phi_deg: f64) -> Vec3<Df64> {
    let radians = |degrees: Df64| degrees * Df64::pi() / Df64::of(180.0);
    let (sin, cos) = radians(theta_deg).sin_cos();
    let (sin_phi, cos_phi) = radians(Df64::of(phi_deg)).sin_cos();
    Vec3::new(sin * cos_phi, sin * sin_phi, cos)
}

/// A step along a line.
#[derive(Clone, Copy, Debug)]
struct Jump {
    /// Where.
    x: f64,
    /// Over the larger of the values on its sides.
    size: f64,
    /// Of which quantity: its index.
    quantity: usize,
}

/// What a scan of a line found.
#[derive(Clone, Copy, Debug, Default)]
struct Scan {
    jump: Option<Jump>,
    /// Values below these are not told from 0, by quantity.
    floors: [f64; 4],
    /// Places looked at.
    places: u32,
}

/// What a line gives at a place; `None` where it has no value.
type Line<'a> = dyn Fn(f64) -> Option<[Df64; 4]> + 'a;

/// A place of a line: the quantities, and their slopes.
#[derive(Clone, Copy)]
struct Place {
    x: f64,
    values: [Df64; 4],
    slopes: [Df64; 4],
}

impl Place {
    fn new(line: &Line<'_>, x: f64) -> Option<Self> {
        let [up, down] = [x * (1.0 + STEP), x * (1.0 - STEP)];
        let [above, below] = [line(up)?, line(down)?];
        let mut slopes = above;
        let width = Df64::of(up) - Df64::of(down);
        for (slope, below) in slopes.iter_mut().zip(below) {
            *slope = (*slope - below) / width;
        }
        Some(Self {
            x,
            values: line(x)?,
            slopes,
        })
    }
}

/// The largest step along `line`, between the first of `ends` and the last.
fn largest_jump(line: &Line<'_>, ends: &[f64]) -> Scan {
    let mut scan = Scan::default();
    let places: Vec<_> = ends.iter().map(|x| Place::new(line, *x)).collect();
    for place in places.iter().flatten() {
        for (floor, value) in scan.floors.iter_mut().zip(place.values) {
            *floor = floor.max(FLOOR * value.abs().as_f64());
        }
    }
    for pair in places.windows(2) {
        if let [Some(a), Some(b)] = pair {
            halve(line, (a, b), &mut Vec::new(), &mut scan);
        }
    }
    scan
}

/// Halves the stretch between two places until it is a cubic, or no wider than the numbers are apart.
fn halve(line: &Line<'_>, (a, b): (&Place, &Place), rises: &mut Vec<[f64; 4]>, scan: &mut Scan) {
    scan.places += 1;
    let middle = a.x + 0.5 * (b.x - a.x);
    let Some(m) = Place::new(line, middle).filter(|_| scan.places < BUDGET) else {
        return;
    };
    let width = Df64::of(b.x) - Df64::of(a.x);
    let mut worst = None;
    let mut rise = [0.0; 4];
    for index in 0..4 {
        let of = |all: &[Df64; 4]| all.get(index).copied().unwrap_or(Df64::of(0.0));
        let (left, right) = (of(&a.values), of(&b.values));
        let largest = left
            .abs()
            .max(right.abs())
            .max(of(&m.values).abs())
            .as_f64();
        let floor = scan.floors.get(index).copied().unwrap_or(0.0);
        let largest = largest.max(floor).max(f64::MIN_POSITIVE);
        let cubic = (left + right) * Df64::of(0.5)
            + width * (of(&a.slopes) - of(&b.slopes)) * Df64::of(0.125);
        let off = (cubic - of(&m.values)).abs().as_f64() / largest;
        // What the slopes do not explain.
        let sloped = width * (of(&a.slopes) + of(&b.slopes)) * Df64::of(0.5);
        let risen = (right - left - sloped).abs().as_f64() / largest;
        if let Some(slot) = rise.get_mut(index) {
            *slot = risen;
        }
        if off > TOLERANCE {
            worst = Some(index);
        }
    }
    let Some(index) = worst else { return };
    if rises.len() < DEPTH as usize {
        rises.push(rise);
        halve(line, (a, &m), rises, scan);
        halve(line, (&m, b), rises, scan);
        rises.pop();
        return;
    }
    let of = |all: &[f64; 4]| all.get(index).copied().unwrap_or(0.0);
    let of_place = |place: &Place| place.values.get(index).map_or(0.0, |value| value.as_f64());
    let before = rises.iter().rev().nth(SHRINKING as usize).map_or(0.0, of);
    let size = of(&rise);
    // Where a lobe ends at 0 is its edge, no change of formulas.
    let ends = of_place(a).min(of_place(b)) == 0.0;
    let is_jump = !ends && size > JUMPS * before && size > TOLERANCE;
    if is_jump && scan.jump.is_none_or(|jump| size > jump.size) {
        let (x, quantity) = (a.x, index);
        scan.jump = Some(Jump { x, size, quantity });
    }
}

/// Counts a line that was looked at to its end; `beside` gives a point next to the step.
fn record<'a>(
    found: Scan,
    tally: &mut Tally,
    beside: impl Fn(f64) -> (&'a Specimen, DVec3, DVec3),
) {
    if found.places >= BUDGET && found.jump.is_none() {
        return;
    }
    let x = found.jump.map_or(1.0, |jump| jump.x);
    let (specimen, wo, wi) = beside(x);
    let mut finding = Finding {
        what: "f",
        ..Finding::default()
    };
    if let Some(jump) = found.jump {
        let kappas = specimen.condition_numbers((wo, wi), f64::UNIT_ROUNDOFF);
        let kappa = kappas.get(jump.quantity).copied().unwrap_or(0.0);
        finding.relative_error = jump.size;
        finding.ratio = jump.size / stability_bound(kappa, f64::UNIT_ROUNDOFF);
    }
    tally.add(&[ExtremeKind::Jumps], Df64::NAME, finding, || {
        (specimen.name.clone(), wo, wi)
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A line of one quantity.
    fn scan(f: impl Fn(Df64) -> Df64) -> Scan {
        let line = |x: f64| Some([f(Df64::of(x)); 4]);
        largest_jump(&line, &linear(0.1, 1.0))
    }

    #[test]
    fn small_steps_are_found_and_roots_and_kinks_are_none() {
        let half = Df64::of(0.437);
        for step in [1e-13, 1e-9, 0.1] {
            let stepped = |x: Df64| {
                let smooth = (x * Df64::of(3.0)).exp();
                if x > half {
                    smooth * Df64::of(1.0 + step)
                } else {
                    smooth
                }
            };
            let jump = scan(stepped).jump.expect("a jump");
            assert!(
                (jump.x - 0.437).abs() < 1e-12 && (jump.size / step - 1.0).abs() < 0.15,
                "{jump:?}"
            );
        }
        let smooth = scan(|x| (x * Df64::of(3.0)).exp());
        let kink = scan(|x| Df64::of(2.0) + (x - half).abs());
        let root = scan(|x| Df64::of(2.0) + (x - half).max(Df64::of(0.0)).sqrt());
        for found in [smooth, kink, root] {
            assert!(found.jump.is_none() && found.places < BUDGET, "{found:?}");
        }
    }
}
