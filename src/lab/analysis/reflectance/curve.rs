//! The reflectance over the angle of incidence, and its mean over all directions.

use rayon::prelude::*;

use super::{LobeShare, Reflectance, lobe_shares};
use crate::analysis::{Basis, Detail, IsWanted, Pace, Query, Subject, isotropy};
use bxdf::Scatterer;
use bxdf::internals::gauss_legendre;
use bxdf::math::frame::direction_from_degrees;

/// Where the limit at grazing incidence is taken, in degrees: light in the horizon plane itself carries nothing.
pub const GRAZING_DEG: f64 = 89.999;

/// The query what becomes of light from above, over its angle of incidence.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurveRequest {
    /// The azimuth of the light, in degrees.
    pub phi_deg: f64,
    /// How many angles, from 0 to 90 degrees at equal steps; 91 is one a degree. At least two are taken.
    pub angles: usize,
    /// The absolute error aimed at, for each angle.
    pub tolerance: f64,
    /// How many evaluations a lobe may take at each angle.
    pub max_evaluations: usize,
}

/// What becomes of light from above, over its angle of incidence.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Curve {
    /// By angle.
    pub rows: Vec<Row>,
    /// Of light from all directions above; `None` in a coarse answer.
    pub hemispherical: Option<Hemispherical>,
}

/// What becomes of light at one angle of incidence.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The angle of incidence, 0..90 degrees; at 90 stands the limit, taken at [`GRAZING_DEG`].
    pub theta_deg: f64,
    /// What each lobe does: as many and in the same order in every row but for deltas, of which there may be fewer.
    pub shares: Vec<LobeShare>,
}

/// `rho_hh`, the cosine-weighted mean of `rho_dh` over all directions above: the share of evenly arriving light that
/// leaves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hemispherical {
    /// The share that leaves above, per channel.
    pub reflection: [f64; 3],
    /// The share that leaves below, per channel.
    pub transmission: [f64; 3],
    /// The estimated absolute error of the worst of these numbers: the difference of two rules, and the mean error of
    /// their summands.
    pub error: f64,
}

/// A coarse answer has one angle where a full one has this many, and this much more error.
const COARSE_ANGLES: usize = 6;
const COARSE_ERROR: f64 = 30.0;

/// Polar angles and azimuths of the two rules for `rho_hh`, coarse and fine. Odd numbers of azimuths meet as many
/// different places of a lobe that half a turn leaves as it is.
const RULES: [[usize; 2]; 2] = [[8, 5], [12, 9]];

/// The same where the azimuth makes no difference.
const ISOTROPIC_RULES: [[usize; 2]; 2] = [[10, 1], [16, 1]];

impl Query for CurveRequest {
    type Answer = Curve;

    const BASIS: Basis = Basis::Surface;
    const PACE: Pace = Pace::CoarseFirst;

    fn answer(
        &self,
        subject: &Subject<'_>,
        detail: Detail,
        is_wanted: IsWanted<'_>,
    ) -> Option<Curve> {
        let bxdf = subject.lobe.surface();
        match detail {
            Detail::Coarse => {
                let coarse = Self {
                    angles: self.angles / COARSE_ANGLES + 1,
                    tolerance: self.tolerance * COARSE_ERROR,
                    ..*self
                };
                Some(Curve {
                    rows: coarse.rows(bxdf, is_wanted)?,
                    hemispherical: None,
                })
            }
            Detail::Full => Some(Curve {
                rows: self.rows(bxdf, is_wanted)?,
                hemispherical: Some(self.hemispherical(bxdf, is_wanted)?),
            }),
        }
    }
}

impl CurveRequest {
    fn rows(&self, bxdf: &dyn Scatterer<f64>, is_wanted: IsWanted<'_>) -> Option<Vec<Row>> {
        let steps = self.angles.max(2) - 1;
        let angles = (0..steps + 1).into_par_iter().with_max_len(1);
        let rows = angles.map(|index| {
            let theta_deg = 90.0 * (index as f64 / steps as f64);
            is_wanted().then(|| Row {
                theta_deg,
                shares: self.shares(bxdf, theta_deg, self.phi_deg),
            })
        });
        rows.collect()
    }

    fn shares(&self, bxdf: &dyn Scatterer<f64>, theta_deg: f64, phi_deg: f64) -> Vec<LobeShare> {
        let wi = direction_from_degrees(theta_deg.min(GRAZING_DEG), phi_deg);
        lobe_shares(bxdf, wi, self.tolerance, self.max_evaluations).unwrap_or_default()
    }

    /// The mean by two product rules: Gauss-Legendre over the cosine, equal steps over the azimuth.
    fn hemispherical(
        &self,
        bxdf: &dyn Scatterer<f64>,
        is_wanted: IsWanted<'_>,
    ) -> Option<Hemispherical> {
        let rules = if isotropy::measured(bxdf) {
            ISOTROPIC_RULES
        } else {
            RULES
        };
        let places: Vec<_> = rules.into_iter().zip([0, 1]).flat_map(nodes).collect();
        let values = places.into_par_iter().with_max_len(1).map(|node| {
            is_wanted().then(|| {
                let phi_deg = self.phi_deg + node.phi_deg;
                (
                    node,
                    Reflectance::of(&self.shares(bxdf, node.theta_deg, phi_deg)),
                )
            })
        });
        let values: Vec<(Node, Reflectance)> = values.collect::<Option<_>>()?;
        let mut means = [Hemispherical {
            reflection: [0.0; 3],
            transmission: [0.0; 3],
            error: 0.0,
        }; 2];
        for (node, rho) in values {
            let Some(mean) = means.get_mut(node.rule) else {
                continue;
            };
            let sides = [
                (&mut mean.reflection, rho.reflection),
                (&mut mean.transmission, rho.transmission),
            ];
            for (sum, values) in sides {
                let channels = sum.iter_mut().zip(values);
                channels.for_each(|(sum, value)| *sum += node.weight * value);
            }
            mean.error += node.weight * rho.error;
        }
        let [coarse, fine] = means;
        let numbers = |mean: Hemispherical| [mean.reflection, mean.transmission];
        let pairs = numbers(fine).into_iter().zip(numbers(coarse));
        let gaps = pairs.flat_map(|(a, b)| a.into_iter().zip(b).map(|(a, b)| (a - b).abs()));
        Some(Hemispherical {
            error: fine.error + gaps.fold(0.0, f64::max),
            ..fine
        })
    }
}

/// A direction of light of a rule for `rho_hh`.
#[derive(Clone, Copy)]
struct Node {
    /// The index of the rule.
    rule: usize,
    theta_deg: f64,
    phi_deg: f64,
    weight: f64,
}

/// The nodes of the rule of so many polar angles and azimuths.
fn nodes(([angles, azimuths], rule): ([usize; 2], usize)) -> impl Iterator<Item = Node> {
    let angles = gauss_legendre(angles).into_iter();
    angles.flat_map(move |(x, weight)| {
        let mu = 0.5 * (1.0 + x);
        let theta = (1.0 - mu * mu).sqrt().atan2(mu);
        (0..azimuths).map(move |index| Node {
            rule,
            theta_deg: theta.to_degrees(),
            phi_deg: 360.0 * (index as f64 / azimuths as f64),
            // 2 mu dmu over 0..1.
            weight: weight * mu / azimuths as f64,
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::{HeldLobe, Hold};
    use bxdf::Material;
    use bxdf::internals::diffuse_transmittance;
    use glam::DVec3;

    const REQUEST: CurveRequest = CurveRequest {
        phi_deg: 20.0,
        angles: 19,
        tolerance: 1e-6,
        max_evaluations: 100_000,
    };

    fn answer(text: &str, detail: Detail) -> Curve {
        let surface = text.parse::<Material>().unwrap().build();
        let lobe = HeldLobe::new(&*surface, Hold::Light, DVec3::Z);
        REQUEST
            .answer(&Subject::of(lobe), detail, &|| true)
            .unwrap()
    }

    fn mean(text: &str) -> Hemispherical {
        answer(text, Detail::Full).hemispherical.unwrap()
    }

    #[test]
    fn a_diffuse_surface_is_level_and_its_mean_itself() {
        let curve = answer("lambertian_reflection:reflectance=0.5/0.25/1", Detail::Full);
        assert_eq!(curve.rows.len(), 19);
        for (index, row) in curve.rows.iter().enumerate() {
            assert!((row.theta_deg - 5.0 * index as f64).abs() < 1e-13);
            let gaps = row.shares[0].value.iter().zip([0.5, 0.25, 1.0]);
            assert!(gaps.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) < 1e-9);
        }
        let mean = curve.hemispherical.unwrap();
        assert!((mean.reflection[0] - 0.5).abs() < 1e-9 && mean.transmission == [0.0; 3]);
        assert!((mean.reflection[2] - 1.0).abs() < 1e-9 && mean.error < 1e-6);
    }

    #[test]
    fn the_mean_of_a_smooth_interface_is_the_diffuse_fresnel_reflectance() {
        // The closed form (`walsh1926`); the difference of the two rules is above the true error of the finer.
        let mean = mean("fresnel_specular:eta=1.5");
        let exact = 1.0 - diffuse_transmittance(1.5_f64);
        let gap = (mean.reflection[0] - exact).abs();
        assert!(gap < 1e-6 && gap <= mean.error + 1e-8, "{mean:?}");
        let total = mean.reflection[1] + mean.transmission[1];
        assert!((total - 1.0).abs() < 1e-12 && mean.error < 1e-3);
    }

    #[test]
    fn the_mean_goes_over_the_azimuth_where_it_matters() {
        // The same by 24 angles and 16 azimuths.
        let text = "rough_conductor:fresnel=one,alpha_x=0.1,alpha_y=0.8";
        let found = mean(text);
        let surface = text.parse::<Material>().unwrap().build();
        let fine = nodes(([24, 16], 0)).map(|node| {
            let wi = direction_from_degrees(node.theta_deg, node.phi_deg);
            let rho = super::super::directional_hemispherical_within(&*surface, wi, 1e-5, 10_000);
            node.weight * rho.reflection[0]
        });
        let gap = (found.reflection[0] - fine.sum::<f64>()).abs();
        assert!(
            gap <= found.error && found.error < 2e-3,
            "{gap:e} {found:?}"
        );
        let along = answer(text, Detail::Full).rows;
        let shares: f64 = along[12].shares[0].value[0];
        assert!((shares - found.reflection[0]).abs() > found.error);
    }

    #[test]
    fn grazing_incidence_has_its_limit() {
        let curve = answer("specular_reflection:reflectance=0.9", Detail::Coarse);
        let last = curve.rows.last().unwrap();
        assert_eq!(
            (curve.rows.len(), last.theta_deg, curve.hemispherical),
            (4, 90.0, None)
        );
        assert_eq!(last.shares[0].value, [0.9; 3]);
        let glass = answer("fresnel_specular:eta=1.5", Detail::Full);
        assert!(glass.rows[18].shares[0].value[0] > 0.9998);
    }

    #[test]
    fn what_is_not_wanted_is_given_up() {
        let surface = "oren_nayar".parse::<Material>().unwrap().build();
        let subject = Subject::of(HeldLobe::new(&*surface, Hold::Light, DVec3::Z));
        assert!(REQUEST.answer(&subject, Detail::Full, &|| false).is_none());
    }
}
