//! What a clear interface does with light, exactly or approximated, as types: models are compiled for each.

use super::diffuse_fresnel;
use super::facet_fresnel::cosine_weighted_nodes;
use super::fresnel::{self, Dielectric, RelativeIndex};
use crate::math::{Real, Vec3};
use crate::param::{ParamSet, ParamSpec, Role, Value};
use crate::spec::StandIn;

/// The parameter that chooses an [`AnyInterface`].
pub const INTERFACE: ParamSpec = ParamSpec::choice(
    "fresnel",
    &["exact", "schlick", "lazanyi"],
    "Reflectance of a facet: exact, Schlick's power of the cosine, or that power with a term that makes it exact at 82 \
     degrees (Lazanyi)",
)
.role(Role::Fresnel);

/// What may replace the exact choice of [`INTERFACE`].
pub const SCHLICK: StandIn = StandIn {
    name: "Schlick for exact Fresnel",
    lost: "The reflectance is a power of the cosine, whatever the index: at eta 1.5 off by up to .036 near the horizon and \
           by 23 % of itself at 56 degrees, more for an index near 1 or above 2",
    replace: |params| approximated(params, "schlick"),
};

/// What may replace the exact choice of [`INTERFACE`] at somewhat more than [`SCHLICK`].
pub const LAZANYI: StandIn = StandIn {
    name: "Schlick with Lazanyi's term for exact Fresnel",
    lost: "The reflectance is exact at 0 and 82 degrees alone: at eta 1.5 off by up to .028 near the horizon, far less \
           than Schlick's for an index near 1 or above 2",
    replace: |params| approximated(params, "lazanyi"),
};

fn approximated(params: &ParamSet, fresnel: &'static str) -> Option<String> {
    let is_exact = params.choice("fresnel") == "exact" && params.number("eta") != 1.0;
    is_exact.then(|| params.replaced(&[("fresnel", Value::Choice(fresnel))]))?
}

/// The reflectance and transmittance of a clear interface.
pub trait Interface<R: Real>: Copy + Send + Sync + 'static {
    /// Whether loops over it can be compiled for wide registers.
    const VECTORISES: bool = true;

    /// What becomes of light that meets it at the cosine `cos_i`, the square of the sine being `s2`; see
    /// [`fresnel::dielectric_with_sine`].
    fn with_sine(&self, cos_i: R, s2: R, index: RelativeIndex<R>) -> Dielectric<R>;

    /// The transmittance between two directions that refract into each other; see [`fresnel::transmittance_between`].
    fn transmittance_between(&self, cos_i: R, cos_t: R, n: R) -> R;

    /// The share that crosses, of light that comes evenly from the side that has 1/`n` of the other's index.
    fn diffuse_transmittance(&self, n: R) -> R;

    /// [`Self::with_sine`] of the unit vector `w`.
    #[inline(always)]
    fn along(&self, w: Vec3<R>, index: RelativeIndex<R>) -> Dielectric<R> {
        self.with_sine(w.z.abs(), w.x * w.x + w.y * w.y, index)
    }
}

/// Fresnel's equations.
#[derive(Clone, Copy, Debug)]
pub struct Exact;

impl<R: Real> Interface<R> for Exact {
    #[inline(always)]
    fn with_sine(&self, cos_i: R, s2: R, index: RelativeIndex<R>) -> Dielectric<R> {
        fresnel::dielectric_with_sine(cos_i, s2, index)
    }

    #[inline(always)]
    fn transmittance_between(&self, cos_i: R, cos_t: R, n: R) -> R {
        fresnel::transmittance_between(cos_i, cos_t, n)
    }

    fn diffuse_transmittance(&self, n: R) -> R {
        diffuse_fresnel::diffuse_transmittance(n)
    }
}

/// Schlick's approximation, with or without Lazanyi's term: f0 + (1 - f0)(1 - c)^5 - a c (1 - c)^6 in 0..1, of the cosine
/// c on the side of the lower index, so that both ways through the interface let as much through.
#[derive(Clone, Copy, Debug)]
pub struct Approximate<R> {
    /// The reflectance at normal incidence, and the rest to 1: 4 n / (n + 1)^2, no difference.
    f0: R,
    rise: R,
    /// a; 0 without the term.
    error: R,
}

impl<R: Real> Approximate<R> {
    /// Schlick's approximation of the interface of relative index `eta`.
    pub fn schlick(eta: R) -> Self {
        let per_sum = R::one() / (eta + R::one());
        Self {
            f0: ((eta - R::one()) * per_sum).sqr(),
            rise: R::of(4.0) * eta * per_sum * per_sum,
            error: R::zero(),
        }
    }

    /// [`Self::schlick`] with the term of Lazanyi & Szirmay-Kalos; see [`fresnel::lazanyi_factor`].
    pub fn lazanyi(eta: R) -> Self {
        let schlick = Self::schlick(eta);
        let above_1 = if eta < R::one() { R::one() / eta } else { eta };
        let at = fresnel::lazanyi_cosine();
        let exact = fresnel::dielectric(at, above_1);
        let [reflected, transmitted] = schlick.shares(at);
        // The difference of the smaller shares has more digits.
        let excess = if exact.reflectance < exact.transmittance {
            reflected - exact.reflectance
        } else {
            exact.transmittance - transmitted
        };
        Self {
            error: fresnel::lazanyi_factor(excess),
            ..schlick
        }
    }

    /// Reflectance and transmittance at the cosine `c` on the side of the lower index, neither 1 less the other.
    #[inline(always)]
    fn shares(&self, c: R) -> [R; 2] {
        let term = self.error * fresnel::lazanyi_term(c);
        let reflected = self.f0 + self.rise * fresnel::schlick_weight(c) - term;
        let transmitted = self.rise * fresnel::schlick_rest(c) + term;
        [reflected, transmitted].map(|share| share.at_least(R::zero()).at_most(R::one()))
    }
}

impl<R: Real> Interface<R> for Approximate<R> {
    #[inline(always)]
    fn with_sine(&self, cos_i: R, s2: R, index: RelativeIndex<R>) -> Dielectric<R> {
        let (c, zero) = (cos_i.min(R::one()), R::zero());
        let cos_t = fresnel::refracted_cosine(c, s2, index);
        let is_from_thinner = index.minus_1 > zero;
        let [reflectance, transmittance] = self.shares(if is_from_thinner { c } else { cos_t });
        if index.minus_1 == zero {
            fresnel::no_interface(c)
        } else if cos_t > zero {
            Dielectric {
                reflectance,
                transmittance,
                cos_t,
            }
        } else {
            fresnel::total_reflection()
        }
    }

    #[inline(always)]
    fn transmittance_between(&self, cos_i: R, cos_t: R, n: R) -> R {
        let [_, transmittance] = self.shares(if n > R::one() { cos_i } else { cos_t });
        transmittance
    }

    fn diffuse_transmittance(&self, n: R) -> R {
        let one = R::one();
        let from_thinner = cosine_weighted_nodes().fold(R::zero(), |sum, (c, weight)| {
            let [_, transmittance] = self.shares(c);
            sum + transmittance * weight
        });
        if n == one {
            one
        } else if n > one {
            from_thinner
        } else {
            // What crosses within the critical angle is as much, of n^-2 times as much light.
            from_thinner * n * n
        }
    }
}

/// One of them, chosen when the program runs.
#[derive(Clone, Copy, Debug)]
pub enum AnyInterface<R> {
    /// Fresnel's equations.
    Exact(Exact),
    /// An approximation of them.
    Approximate(Approximate<R>),
}

impl<R: Real> AnyInterface<R> {
    /// The choice in `params`, for the relative index there, `eta`.
    #[must_use]
    pub fn from_params(params: &ParamSet) -> Self {
        let eta = R::of(params.number("eta"));
        match params.choice("fresnel") {
            "schlick" => Self::Approximate(Approximate::schlick(eta)),
            "lazanyi" => Self::Approximate(Approximate::lazanyi(eta)),
            _ => Self::Exact(Exact),
        }
    }
}

impl<R: Real> Interface<R> for AnyInterface<R> {
    const VECTORISES: bool = false;

    #[inline(always)]
    fn with_sine(&self, cos_i: R, s2: R, index: RelativeIndex<R>) -> Dielectric<R> {
        match self {
            Self::Exact(exact) => exact.with_sine(cos_i, s2, index),
            Self::Approximate(approximate) => approximate.with_sine(cos_i, s2, index),
        }
    }

    #[inline(always)]
    fn transmittance_between(&self, cos_i: R, cos_t: R, n: R) -> R {
        match self {
            Self::Exact(exact) => exact.transmittance_between(cos_i, cos_t, n),
            Self::Approximate(approximate) => approximate.transmittance_between(cos_i, cos_t, n),
        }
    }

    fn diffuse_transmittance(&self, n: R) -> R {
        match self {
            Self::Exact(exact) => exact.diffuse_transmittance(n),
            Self::Approximate(approximate) => approximate.diffuse_transmittance(n),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Cosines from 1e-4 to 1.
    fn cosines() -> impl Iterator<Item = f64> {
        (1..=10_000).map(|i| f64::from(i) * 1e-4)
    }

    fn reflectance(interface: impl Interface<f64>, cos: f64, n: f64) -> f64 {
        interface
            .with_sine(cos, (1.0 - cos) * (1.0 + cos), RelativeIndex::new(n))
            .reflectance
    }

    #[test]
    fn schlick_is_off_at_eta_1_5_by_what_a_scan_of_the_textbook_forms_finds() {
        // Fresnel's amplitudes (c - g)/(c + g) and (n^2 c - g)/(n^2 c + g), scanned in 20000 steps: .035693 at the cosine
        // .0876, and relative to themselves -.232445 at .5658.
        let schlick = Approximate::schlick(1.5);
        let (mut largest, mut relative) = ((0.0_f64, 0.0), (0.0_f64, 0.0));
        for cos in cosines() {
            let exact = reflectance(Exact, cos, 1.5);
            let error = reflectance(schlick, cos, 1.5) - exact;
            if error.abs() > largest.0.abs() {
                largest = (error, cos);
            }
            if (error / exact).abs() > relative.0.abs() {
                relative = (error / exact, cos);
            }
        }
        assert!((largest.0 - 0.035_693).abs() < 1e-6 && (largest.1 - 0.0876).abs() < 2e-3);
        assert!((relative.0 + 0.232_445).abs() < 1e-6 && (relative.1 - 0.5658).abs() < 2e-3);
    }

    #[test]
    fn lazanyis_term_makes_it_exact_at_a_seventh_and_helps_far_from_glass() {
        for (eta, gain) in [
            (1.1, 8.0),
            (1.33, 2.1),
            (1.5, 1.0),
            (2.42, 1.7),
            (10.0, 3.4),
        ] {
            let [schlick, lazanyi] = [Approximate::schlick(eta), Approximate::lazanyi(eta)];
            let at = 1.0 / 7.0;
            let error = reflectance(lazanyi, at, eta) - reflectance(Exact, at, eta);
            assert!(error.abs() < 1e-15, "{eta}: {error}");
            let squares = |approximate| {
                let error = |cos| reflectance(approximate, cos, eta) - reflectance(Exact, cos, eta);
                cosines().map(|cos| error(cos).powi(2)).sum::<f64>()
            };
            let found = (squares(schlick) / squares(lazanyi)).sqrt();
            assert!(found > gain, "{eta}: {found}");
        }
    }

    #[test]
    fn shares_sum_to_one_and_are_the_same_both_ways() {
        for eta in [0.25_f64, 0.7, 1.0 - 1e-6, 1.0 + 1e-6, 1.05, 1.5, 1000.0] {
            for interface in [Approximate::schlick(eta), Approximate::lazanyi(eta)] {
                for cos in [1e-9, 1e-3, 0.2, 0.6, 0.999, 1.0] {
                    let there = interface.with_sine(
                        cos,
                        (1.0 - cos) * (1.0 + cos),
                        RelativeIndex::new(eta),
                    );
                    let Dielectric {
                        reflectance,
                        transmittance,
                        cos_t,
                    } = there;
                    assert!(
                        (reflectance + transmittance - 1.0).abs() < 2e-15,
                        "{there:?}"
                    );
                    let between = interface.transmittance_between(cos, cos_t, eta);
                    let back = interface.transmittance_between(cos_t, cos, 1.0 / eta);
                    let is_total = cos_t == 0.0;
                    assert!(
                        is_total || between == transmittance && between == back,
                        "{eta} {cos}"
                    );
                }
            }
        }
        assert_eq!(
            Approximate::schlick(1.0)
                .along(Vec3::new(1.0_f32, 0.0, 1e-38), RelativeIndex::new(1.0))
                .transmittance,
            1.0
        );
    }

    #[test]
    fn the_diffuse_transmittance_is_the_closed_form() {
        // 2 int (1 - (1 - c)^5) c dc = 20/21, and 2 int c^2 (1 - c)^6 dc = 1/126.
        for eta in [1.3_f64, 1.5, 2.4, 10.0] {
            let [schlick, lazanyi] = [Approximate::schlick(eta), Approximate::lazanyi(eta)];
            let expected = 4.0 * eta / (eta + 1.0).powi(2) * 20.0 / 21.0;
            assert!((schlick.diffuse_transmittance(eta) - expected).abs() < 1e-14);
            let expected = expected + lazanyi.error / 126.0;
            assert!((lazanyi.diffuse_transmittance(eta) - expected).abs() < 1e-14);
            let back = Approximate::schlick(1.0 / eta).diffuse_transmittance(1.0 / eta);
            assert!((back * eta * eta - schlick.diffuse_transmittance(eta)).abs() < 1e-14);
        }
        assert_eq!(
            Approximate::lazanyi(1.0_f64).diffuse_transmittance(1.0),
            1.0
        );
    }
}
