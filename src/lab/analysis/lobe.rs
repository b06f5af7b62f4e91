//! The lobe of a surface at one held direction: a function of the direction that is left free.

use glam::DVec3;

use super::chart::Chart;
use super::quadrature::{Integral, Integrand, best_of};
use bxdf::batch::{Columns, Job, Path};
use bxdf::{Lobe, Scatterer, Side};

/// Which of the two directions is held while the lobe is drawn over the other.
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize,
)]
#[serde(rename_all = "snake_case")]
pub enum Hold {
    /// `wi` is held: the lobe is f(wo, wi) over `wo`, where the light of one lamp goes.
    #[default]
    #[serde(alias = "wi")]
    Light,
    /// `wo` is held: the lobe is f(wo, wi) over `wi`: where the light comes from that one viewer sees.
    #[serde(alias = "wo")]
    Viewer,
}

/// How many directions mark an inner lobe out, along each side of the unit square.
const SEEDS_PER_SIDE: u32 = 24;

/// How far above the horizon plane the limit of a value is taken, as a cosine: the plane itself carries nothing, but a
/// drawn lobe ends at its limit there. Too small to change a value on the screen, large enough not to lose digits.
pub const HORIZON_LIFT: f64 = 1e-6;

/// A surface with one direction held, in the fixed frame.
#[derive(Clone, Copy)]
pub struct HeldLobe<'a> {
    bxdf: &'a dyn Scatterer<f64>,
    hold: Hold,
    held: DVec3,
}

/// A Dirac delta of a lobe: where it points, and the share of the flux it carries.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arrow {
    /// The direction, a unit vector.
    pub direction: DVec3,
    /// The share of the flux arriving along the held direction that leaves along `direction`, per channel.
    pub flux: [f64; 3],
    /// What a sample of it weighs if it is the only one: radiance along the held direction over that along `direction`.
    pub weight: [f64; 3],
    /// The probability with which [`Bxdf::sample_f`](bxdf::Bxdf::sample_f) chooses it for the held direction in wo's place.
    pub probability: f64,
    /// To which side it goes.
    pub side: Side,
}

impl<'a> HeldLobe<'a> {
    /// The lobe of `bxdf` with the unit vector `held` held.
    #[must_use]
    pub fn new(bxdf: &'a dyn Scatterer<f64>, hold: Hold, held: DVec3) -> Self {
        Self { bxdf, hold, held }
    }

    /// The surface.
    #[must_use]
    pub fn surface(&self) -> &'a dyn Scatterer<f64> {
        self.bxdf
    }

    /// Which direction is held.
    #[must_use]
    pub fn hold(&self) -> Hold {
        self.hold
    }

    /// The held direction.
    #[must_use]
    pub fn held(&self) -> DVec3 {
        self.held
    }

    /// f in 1/sr with the unit vector `free` as the other direction.
    #[must_use]
    pub fn value(&self, free: DVec3) -> [f64; 3] {
        let (wo, wi) = self.pair(free);
        self.bxdf.f(wo.into(), wi.into()).to_f64()
    }

    /// The pair (wo, wi) with the unit vector `free` as the other direction.
    #[must_use]
    pub fn pair(&self, free: DVec3) -> (DVec3, DVec3) {
        match self.hold {
            Hold::Light => (free, self.held),
            Hold::Viewer => (self.held, free),
        }
    }

    /// [`Self::value`], or its limit from the side `is_upper` where `free` lies in the horizon plane.
    #[must_use]
    pub fn value_or_limit(&self, free: DVec3, is_upper: bool) -> [f64; 3] {
        self.value(off_horizon(free, is_upper))
    }

    /// [`Self::value_or_limit`] for all directions of `free`.
    #[must_use]
    pub fn values_or_limits(&self, free: &[DVec3], is_upper: bool) -> Vec<[f64; 3]> {
        self.each(None, &lifted(free, is_upper))
    }

    /// f in 1/sr of the inner lobe at `index` alone, with each unit vector of `free` as the other direction.
    #[must_use]
    pub fn lobe_values(&self, index: usize, free: &[DVec3]) -> Vec<[f64; 3]> {
        self.each(Some(index), &Columns::directions(free.iter().copied()))
    }

    /// f with each direction of `free`: of one lobe alone, or of all.
    fn each(&self, lobe: Option<usize>, free: &Columns<f64, 3>) -> Vec<[f64; 3]> {
        let held = self.held_columns(free.len());
        let (wo, wi) = match self.hold {
            Hold::Light => (free.slices(), held.slices()),
            Hold::Viewer => (held.slices(), free.slices()),
        };
        let mut values = Columns::filled(0.0, free.len());
        let f = values.slices_mut();
        let job = match lobe {
            Some(index) => Job::LobeF { index, wo, wi, f },
            None => Job::F { wo, wi, f },
        };
        self.bxdf.batch(Path::Dispatched, job);
        values.rows().collect()
    }

    /// The held direction, once for each of `n` elements of a batch.
    fn held_columns(&self, n: usize) -> Columns<f64, 3> {
        Columns::repeated(self.held.to_array(), n)
    }

    /// The density in 1/sr with which [`Bxdf::sample_f`](bxdf::Bxdf::sample_f) draws each direction of `free` for the held one in wo's place,
    /// whichever is held; its limit from the side `is_upper` at the horizon.
    #[must_use]
    pub fn densities_or_limits(&self, free: &[DVec3], is_upper: bool) -> Vec<f64> {
        let (held, free) = (self.held_columns(free.len()), lifted(free, is_upper));
        self.bxdf.densities(&held, &free)
    }

    /// The lobe of the same surface with the same direction held, as its sampler sees it: in wo's place.
    #[must_use]
    pub fn as_sampled(self) -> Self {
        Self {
            hold: Hold::Viewer,
            ..self
        }
    }

    /// The Dirac deltas, by the flux they carry; those that carry nothing are none.
    #[must_use]
    pub fn arrows(&self) -> Vec<Arrow> {
        let deltas = self.bxdf.deltas(self.held.into());
        let arrow = |delta: bxdf::Delta<f64>| Arrow {
            direction: delta.direction.into(),
            flux: delta.flux.to_f64(),
            weight: delta.weight.to_f64(),
            probability: delta.probability,
            side: delta.side,
        };
        let arrows = deltas.into_iter().flatten().map(arrow);
        arrows.filter(|arrow| arrow.flux != [0.0; 3]).collect()
    }

    /// The inner lobes of the surface; see [`Lobes::lobes`](bxdf::Lobes::lobes).
    #[must_use]
    pub fn lobes(&self) -> &[Lobe] {
        self.bxdf.lobes()
    }

    /// The free directions that the inner lobe at `index` maps the points `u` of the unit square to, with their weights.
    ///
    /// The maps are made for a held `wo`; they follow the lobe of a held `wi` as well, whatever their density.
    #[must_use]
    pub fn drawn(&self, index: usize, u: &[[f64; 2]]) -> Drawn {
        let held = self.held_columns(u.len());
        let numbers = Columns::from_rows(u.iter().copied());
        let (mut free, mut weight) = (Columns::filled(0.0, u.len()), Columns::filled(0.0, u.len()));
        let job = Job::Lobe {
            index,
            is_incident: self.hold == Hold::Light,
            held: held.slices(),
            u: numbers.slices(),
            free: free.slices_mut(),
            weight: weight.slices_mut(),
        };
        self.bxdf.batch(Path::Dispatched, job);
        Drawn {
            directions: free.rows().map(DVec3::from).collect(),
            weights: weight.rows().collect(),
        }
    }

    /// The integral of f |cos(theta)| of the free direction over the sphere, for each of [`Self::lobes`] alone.
    ///
    /// By whichever converges first of its own map and the charts of its side.
    ///
    /// `tolerance`: absolute error wanted in each. `max_evaluations`: how many values each may take.
    #[must_use]
    pub fn integrals(&self, tolerance: f64, max_evaluations: usize) -> Vec<Integral> {
        let integral = |(index, lobe): (usize, &Lobe)| {
            let drawn = |u: &[[f64; 2]]| self.drawn(index, u).weights;
            let charts = Chart::of_side(self.held, lobe.side);
            let charted = charts
                .iter()
                .map(|chart| move |points: &[[f64; 2]]| self.charted(index, chart, points));
            let charted: Vec<_> = charted.collect();
            let rivals: Vec<Integrand<'_>> = charted.iter().map(|f| f as Integrand<'_>).collect();
            best_of(&drawn, &rivals, tolerance, max_evaluations)
        };
        self.lobes().iter().enumerate().map(integral).collect()
    }

    /// f |cos(theta)| of the inner lobe at `index` at `points` of a chart, times the solid angle there.
    fn charted(&self, index: usize, chart: &Chart, points: &[[f64; 2]]) -> Vec<[f64; 3]> {
        let (free, weights) = chart.places(points);
        let mut values = self.lobe_values(index, &free);
        for (value, weight) in values.iter_mut().zip(weights) {
            *value = value.map(|x| x * weight);
        }
        values
    }

    /// Directions where the lobe is, denser where it is higher: the images of a regular grid under the map of each inner
    /// lobe. They tell the adaptive curve and mesh where a narrow lobe hides.
    #[must_use]
    pub fn seeds(&self) -> Seeds {
        let n = SEEDS_PER_SIDE;
        let centre = |index: u32| (f64::from(index) + 0.5) / f64::from(n);
        let mut seeds = Seeds {
            directions: Vec::with_capacity(self.lobes().len() * (n * n) as usize),
            integral: 0.0,
        };
        for index in 0..self.lobes().len() {
            let grid = (0..n).flat_map(|i| (0..n).map(move |j| [centre(i), centre(j)]));
            let drawn = self.drawn(index, &grid.collect::<Vec<_>>());
            let lost = DVec3::ZERO;
            for (direction, weight) in drawn.directions.into_iter().zip(drawn.weights) {
                if direction != lost {
                    seeds.directions.push(direction);
                    seeds.integral += weight.into_iter().fold(0.0, f64::max) / f64::from(n * n);
                }
            }
        }
        seeds
    }
}

/// What [`HeldLobe::drawn`] returns, in the order of the points.
#[derive(Clone, Debug)]
pub struct Drawn {
    /// The directions; 0 where one is lost.
    pub directions: Vec<DVec3>,
    /// f |cos(theta)| / pdf of the lobe alone, per channel; 0 where the direction is lost. Over the unit square it
    /// integrates to the integral of the lobe's f |cos(theta)| over the sphere.
    pub weights: Vec<[f64; 3]>,
}

/// `w`, or what stands for it where it lies in the horizon plane: just above it, or just below.
#[must_use]
pub fn off_horizon(w: DVec3, is_upper: bool) -> DVec3 {
    if w.z.abs() < HORIZON_LIFT {
        let lift = HORIZON_LIFT.copysign(if is_upper { 1.0 } else { -1.0 });
        DVec3::new(w.x, w.y, lift)
    } else {
        w
    }
}

/// f of `bxdf` in 1/sr at all `pairs` of unit vectors (wo, wi).
#[must_use]
pub fn pair_values(bxdf: &dyn Scatterer<f64>, pairs: &[(DVec3, DVec3)]) -> Vec<[f64; 3]> {
    let wo = Columns::directions(pairs.iter().map(|pair| pair.0));
    let wi = Columns::directions(pairs.iter().map(|pair| pair.1));
    bxdf.values(&wo, &wi).rows().collect()
}

/// The components of directions, those in the horizon plane lifted off it to the side `is_upper`.
fn lifted(free: &[DVec3], is_upper: bool) -> Columns<f64, 3> {
    Columns::directions(free.iter().map(|w| off_horizon(*w, is_upper)))
}

/// What [`HeldLobe::seeds`] returns.
#[derive(Clone, Debug)]
pub struct Seeds {
    /// The directions, lost ones left out.
    pub directions: Vec<DVec3>,
    /// An estimate, good to a few percent, of the integral of f |cos(theta)| over the sphere, largest channel.
    pub integral: f64,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::quadrature::integrate_square;
    use bxdf::Material;
    use bxdf::math::frame::direction_from_degrees;

    #[test]
    fn lobes_cut_by_the_horizon_have_one_integral_in_all_coordinates() {
        for (text, theta) in [
            ("rough_conductor:alpha=0.5", 60.0),
            ("rough_conductor:alpha_x=0.2,alpha_y=0.6", 0.0),
            ("cook_torrance", 60.0),
            ("rough_dielectric:alpha=0.4", 40.0),
        ] {
            let model = text.parse::<Material>().unwrap().build();
            let held = direction_from_degrees(theta, 20.0);
            let lobe = HeldLobe::new(&*model, Hold::Light, held);
            let all = lobe.integrals(1e-10, 4_000_000);
            for (index, found) in all.into_iter().enumerate() {
                assert!(found.error <= 1e-10, "{text}: {found:?}");
                let near = |other: Integral, error: f64| {
                    let gap = (found.value[1] - other.value[1]).abs();
                    assert!(gap <= error, "{text} {index}: {found:?} {other:?}");
                };
                for chart in Chart::of_side(held, lobe.lobes()[index].side) {
                    let charted = |points: &[[f64; 2]]| lobe.charted(index, &chart, points);
                    let other = integrate_square(&charted, 1e-10, 1_000_000);
                    near(other, found.error + other.error);
                }
                let drawn = |u: &[[f64; 2]]| lobe.drawn(index, u).weights;
                let other = integrate_square(&drawn, 1e-10, 200_000);
                // What the map loses beyond the horizon, it loses behind an edge: its error may be above what it says.
                assert!(other.error < 1e-4);
                near(other, 4.0 * other.error);
            }
        }
    }

    #[test]
    fn seeds_estimate_the_integral() {
        let material: Material = "lambertian_reflection:reflectance=0.6".parse().unwrap();
        let model = material.build();
        let lobe = HeldLobe::new(&*model, Hold::Light, direction_from_degrees(40.0, 10.0));
        assert!((lobe.seeds().integral - 0.6).abs() < 1e-12);
        assert_eq!(lobe.seeds().directions.len(), 576);
    }

    #[test]
    fn the_horizon_has_a_limit_on_either_side() {
        let material: Material = "lambertian_transmission".parse().unwrap();
        let model = material.build();
        let lobe = HeldLobe::new(&*model, Hold::Light, DVec3::Z);
        assert_eq!(lobe.value(DVec3::X), [0.0; 3]);
        assert_eq!(lobe.value_or_limit(DVec3::X, true), [0.0; 3]);
        assert!(lobe.value_or_limit(DVec3::X, false)[0] > 0.25);
    }
}
