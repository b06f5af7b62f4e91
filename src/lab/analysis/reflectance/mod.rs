//! Directional-hemispherical reflectance by adaptive quadrature, lobe by lobe.

use glam::DVec3;

use super::lobe::{HeldLobe, Hold};
use super::quadrature::Integral;
use super::{Detail, IsWanted, Query, Subject};
use bxdf::{Category, Lobe, Scatterer, Side};

pub use curve::{Curve, CurveRequest, GRAZING_DEG, Hemispherical, Row};

mod curve;

/// What becomes of the light arriving along one direction, per channel, as shares of its flux.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Reflectance {
    /// The share that leaves on the side it came from, deltas included.
    pub reflection: [f64; 3],
    /// The share that leaves on the other side, deltas included.
    pub transmission: [f64; 3],
    /// The estimated absolute error of the worst of these numbers.
    pub error: f64,
}

impl Reflectance {
    /// The sum of what the lobes of a surface do.
    #[must_use]
    pub fn of(shares: &[LobeShare]) -> Self {
        let mut sum = Self {
            reflection: [0.0; 3],
            transmission: [0.0; 3],
            error: 0.0,
        };
        for share in shares {
            let side = match share.lobe.side {
                Side::Reflection => &mut sum.reflection,
                Side::Transmission => &mut sum.transmission,
            };
            side.iter_mut()
                .zip(share.value)
                .for_each(|(side, value)| *side += value);
            sum.error += share.error;
        }
        sum
    }

    /// The share that does not leave: 1 less what does. Negative where a model creates energy.
    #[must_use]
    pub fn absorbed(&self) -> [f64; 3] {
        let [[r0, r1, r2], [t0, t1, t2]] = [self.reflection, self.transmission];
        [1.0 - r0 - t0, 1.0 - r1 - t1, 1.0 - r2 - t2]
    }

    /// The share that leaves, on both sides together.
    #[must_use]
    pub fn leaving(&self) -> [f64; 3] {
        let [[r0, r1, r2], [t0, t1, t2]] = [self.reflection, self.transmission];
        [r0 + t0, r1 + t1, r2 + t2]
    }

    /// The share that leaves, in the channel where it is largest: above 1 energy is created.
    #[must_use]
    pub fn largest(&self) -> f64 {
        let [r, g, b] = self.absorbed();
        1.0 - r.min(g).min(b)
    }
}

/// How many evaluations a lobe may take, where nothing waits for it: about a second.
pub const MAX_EVALUATIONS: usize = 4_000_000;

/// What one lobe does with the light arriving along one direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LobeShare {
    /// The lobe.
    pub lobe: Lobe,
    /// The share of the arriving flux that leaves through it, per channel.
    pub value: [f64; 3],
    /// The estimated absolute error of the worst channel.
    pub error: f64,
}

impl LobeShare {
    /// What both lobes do, as one of the first one's kind.
    fn with(self, other: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self.value, other.value);
        Self {
            lobe: self.lobe.named(""),
            value: [a + x, b + y, c + z],
            error: self.error + other.error,
        }
    }
}

/// Whether light along the unit vector `w` crosses the surface: in the surface plane itself, at a polar angle of exactly 90
/// degrees, its cosine is 0, no flux arrives, and a share of it is 0 over 0.
#[must_use]
pub fn has_flux(w: DVec3) -> bool {
    w.z != 0.0
}

/// What each lobe of `bxdf` does with the light arriving along `wi`; `None` where that carries none ([`has_flux`]). The lobes of [`Lobes::lobes`](bxdf::Lobes::lobes) in their order, then the
/// Dirac deltas. Arguments as for [`directional_hemispherical_within`].
#[must_use]
pub fn lobe_shares(
    bxdf: &dyn Scatterer<f64>,
    wi: DVec3,
    tolerance: f64,
    max_evaluations: usize,
) -> Option<Vec<LobeShare>> {
    if !has_flux(wi) {
        return None;
    }
    let held = HeldLobe::new(bxdf, Hold::Light, wi);
    let lobes = held.lobes();
    let tolerance = tolerance / lobes.len().max(1) as f64;
    let integrals = held.integrals(tolerance, max_evaluations);
    let continuous = lobes
        .iter()
        .zip(integrals)
        .map(|(lobe, Integral { value, error, .. })| LobeShare {
            lobe: *lobe,
            value,
            error,
        });
    let deltas = held.arrows().into_iter().map(|arrow| LobeShare {
        lobe: Lobe {
            category: Category::PerfectSpecular,
            side: arrow.side,
            name: "",
        },
        value: arrow.flux,
        error: 0.0,
    });
    Some(continuous.chain(deltas).collect())
}

/// The query what each lobe does with the light that arrives along the held direction, whichever is held; it has no answer
/// where that carries none ([`has_flux`]).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SharesRequest {
    /// The absolute error aimed at.
    pub tolerance: f64,
    /// How many evaluations a lobe may take.
    pub max_evaluations: usize,
}

impl Query for SharesRequest {
    type Answer = Option<Vec<LobeShare>>;

    fn answer(&self, subject: &Subject<'_>, _: Detail, _: IsWanted<'_>) -> Option<Self::Answer> {
        let lobe = &subject.lobe;
        let (tolerance, evaluations) = (self.tolerance, self.max_evaluations);
        Some(lobe_shares(
            lobe.surface(),
            lobe.held(),
            tolerance,
            evaluations,
        ))
    }
}

/// The sums of `shares` by category and side: reflection first, the categories of each side in their order. Kinds that no
/// lobe has are left out.
#[must_use]
pub fn by_kind(shares: &[LobeShare]) -> Vec<LobeShare> {
    let kinds = [Side::Reflection, Side::Transmission]
        .into_iter()
        .flat_map(|side| Category::ALL.map(|category| (category, side)));
    let sum = |kind| {
        let of_kind = shares
            .iter()
            .filter(|share| (share.lobe.category, share.lobe.side) == kind);
        of_kind.copied().reduce(LobeShare::with)
    };
    kinds.filter_map(sum).collect()
}

/// `rho_dh(wi)`: the integral of f(wo, wi) |cos(theta_o)| over all `wo`, and the flux of the deltas.
///
/// `wi` is a unit vector, above or below the surface; one in the surface plane carries nothing and gives 0, where the share is
/// undefined ([`has_flux`]).
/// `tolerance`: absolute error wanted; the error reached is returned.
#[must_use]
pub fn directional_hemispherical(
    bxdf: &dyn Scatterer<f64>,
    wi: DVec3,
    tolerance: f64,
) -> Reflectance {
    directional_hemispherical_within(bxdf, wi, tolerance, MAX_EVALUATIONS)
}

/// [`directional_hemispherical`] with at most about `max_evaluations` of f for each lobe.
#[must_use]
pub fn directional_hemispherical_within(
    bxdf: &dyn Scatterer<f64>,
    wi: DVec3,
    tolerance: f64,
    max_evaluations: usize,
) -> Reflectance {
    Reflectance::of(&lobe_shares(bxdf, wi, tolerance, max_evaluations).unwrap_or_default())
}

#[cfg(test)]
mod tests {
    use super::*;
    use bxdf::Material;
    use bxdf::math::frame::direction_from_degrees;

    fn rho(material: &str, wi: DVec3) -> Reflectance {
        directional_hemispherical(&*material.parse::<Material>().unwrap().build(), wi, 1e-10)
    }

    fn at_cosine(cos: f64) -> DVec3 {
        DVec3::new((1.0 - cos * cos).sqrt(), 0.0, cos)
    }

    #[test]
    fn white_furnace_values_of_ggx() {
        // By an independent quadrature to 12 digits, printed to 8; at alpha 1, cos 1 exactly 1 - ln 2.
        let table = [
            (0.1, "separable", [0.885_970_36, 0.969_115_12, 0.988_304_06]),
            (0.5, "separable", [0.792_276_45, 0.686_007_25, 0.687_848_52]),
            (1.0, "separable", [0.584_481_56, 0.409_137_09, 0.306_852_82]),
            (
                0.1,
                "correlated",
                [0.911_762_51, 0.969_204_98, 0.988_304_06],
            ),
            (
                0.5,
                "correlated",
                [0.912_547_80, 0.698_250_70, 0.687_848_52],
            ),
            (
                1.0,
                "correlated",
                [0.847_773_88, 0.450_693_86, 0.306_852_82],
            ),
        ];
        for (alpha, masking, expected) in table {
            for (cos, expected) in [0.05, 0.5, 1.0].into_iter().zip(expected) {
                let material =
                    format!("rough_conductor:fresnel=one,alpha={alpha},masking={masking}");
                let found = rho(&material, at_cosine(cos));
                // Half a unit of the table's last digit, and the quadrature's own error.
                assert!(
                    (found.reflection[0] - expected).abs() < 6e-9,
                    "{material} {cos}: {found:?}"
                );
                assert!(found.error <= 1e-9, "{found:?}");
            }
        }
    }

    #[test]
    fn the_narrowest_lobe_at_grazing_incidence_is_not_missed() {
        for alpha in ["0.001", "0.0001"] {
            for model in [
                "rough_conductor:fresnel=one,",
                "retro_reflector:reflectance=1,",
            ] {
                let found = rho(
                    &format!("{model}alpha={alpha}"),
                    direction_from_degrees(85.0, 30.0),
                );
                assert!(
                    found.reflection[0] > 0.99 && found.reflection[0] <= 1.0 + 1e-9,
                    "{model} {alpha}: {found:?}"
                );
            }
        }
        let needle = rho(
            "rough_conductor:fresnel=one,alpha_x=0.0001,alpha_y=1",
            direction_from_degrees(40.0, 30.0),
        );
        // A blade 1:10000; by a stratified integral over visible normals, independent of this program, it is .54697.
        assert!(
            (needle.reflection[0] - 0.54697).abs() < 5e-6 && needle.error < 1e-7,
            "{needle:?}"
        );
    }

    #[test]
    fn the_kink_where_both_directions_graze_alike_is_seen() {
        // A + B 2/pi times an integral of max(0, s)/max(mu_i, mu_o), split at its kink: 1.0150653.
        let found = rho(
            "oren_nayar:reflectance=1,sigma=11",
            direction_from_degrees(89.9, 0.0),
        );
        assert!(
            (found.reflection[0] - 1.015_065_3).abs() < 1e-6,
            "{found:?}"
        );
    }

    #[test]
    fn deltas_and_sides_are_counted() {
        let glass = rho("fresnel_specular", DVec3::Z);
        assert!(
            (glass.reflection[0] - 0.04).abs() < 1e-15
                && (glass.transmission[0] - 0.96).abs() < 1e-15
        );
        assert!(glass.absorbed()[0].abs() < 1e-15);
        let leaf = rho(
            "lambertian_transmission:transmittance=0.3",
            direction_from_degrees(150.0, 0.0),
        );
        assert!((leaf.transmission[1] - 0.3).abs() < 1e-12 && leaf.reflection[1] == 0.0);
        assert_eq!(rho("lambertian_reflection", DVec3::X).reflection, [0.0; 3]);
    }

    #[test]
    fn light_in_the_surface_plane_has_no_shares() {
        for material in [
            "lambertian_reflection",
            "specular_reflection",
            "rough_conductor",
        ] {
            let bxdf = material.parse::<Material>().unwrap().build();
            let shares = |theta| {
                let wi = direction_from_degrees(theta, 30.0);
                lobe_shares(&*bxdf, wi, 1e-3, 10_000)
            };
            assert_eq!(shares(90.0), None, "{material}");
            let grazing = Reflectance::of(&shares(GRAZING_DEG).unwrap());
            assert!(grazing.reflection[0] > 0.5, "{material}: {grazing:?}");
        }
    }

    #[test]
    fn shares_of_one_kind_count_together() {
        let share = |lobe, value| LobeShare {
            lobe,
            value: [value; 3],
            error: 0.125,
        };
        let shares = [
            share(Lobe::transmission(Category::Diffuse), 0.125),
            share(Lobe::reflection(Category::GlossySpecular), 0.25),
            share(Lobe::reflection(Category::Diffuse).named("ground"), 0.5),
            share(Lobe::reflection(Category::Diffuse).named("sheen"), 0.25),
        ];
        let diffuse = LobeShare {
            error: 0.25,
            ..share(Lobe::reflection(Category::Diffuse), 0.75)
        };
        let [transmitted, glossy, ..] = shares;
        assert_eq!(by_kind(&shares), [diffuse, glossy, transmitted]);
        assert_eq!(Reflectance::of(&shares).largest(), 1.125);
    }

    #[test]
    fn kulla_and_conty_close_the_white_furnace() {
        for alpha in ["0.0001", "0.05", "0.3", "1"] {
            for kind in [
                "distribution=ggx",
                "distribution=beckmann",
                "masking=separable",
            ] {
                for cos in [2e-3, 0.05, 0.5, 1.0] {
                    let material = format!(
                        "rough_conductor:fresnel=one,compensation=kulla_conty,alpha={alpha},{kind}"
                    );
                    let model = material.parse::<Material>().unwrap().build();
                    let found = directional_hemispherical(&*model, at_cosine(cos), 1e-7);
                    assert!(found.error <= 1e-6, "{material} {cos}: {found:?}");
                    let found = found.reflection[0];
                    // The error of the table, which never gives back too much.
                    assert!(
                        found > 1.0 - 1e-5 && found < 1.0 + 2e-6,
                        "{material} {cos}: {found}"
                    );
                }
            }
        }
    }

    #[test]
    fn a_faint_narrow_lobe_is_not_missed() {
        // .01235 of the light is mirrored by a lobe of 1e-4 that hardly any seed meets.
        let found = rho(
            "rough_dielectric:eta=0.8,distribution=beckmann,alpha=0.0001",
            DVec3::Z,
        );
        assert!((found.reflection[0] - 1.0 / 81.0).abs() < 1e-8, "{found:?}");
    }
}
