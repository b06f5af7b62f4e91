//! The extremes of directions.

use glam::DVec3;

use super::ExtremeKind;
use crate::analysis::statistics::Random;
use crate::specimen::Specimen;
use bxdf::math::frame::{cos_sin_deg, direction_from_degrees};

/// Distances from the horizon, in degrees.
const FROM_HORIZON_DEG: [f64; 7] = [1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7];

/// Polar angles next to the normal, in degrees.
const NORMAL_DEG: [f64; 3] = [0.0, 1e-8, 1e-4];

/// Polar angles between.
const BETWEEN_DEG: [f64; 4] = [1.0, 30.0, 60.0, 85.0];

/// Differences of azimuths, in degrees: aligned, opposed, across, almost opposed, and neither.
const AZIMUTHS_DEG: [f64; 5] = [0.0, 180.0, 90.0, 180.0 - 1e-5, 33.0];

/// Distances of a direction from a notable one, in radians.
const NUDGES: [f64; 3] = [1e-7, 1e-5, 1e-3];

/// Cosines whose squares, or they themselves, are subnormal: in f32 the first three, in f64 the last three.
const SUBNORMAL: [f64; 7] = [1e-23, 1e-40, 1e-44, 1e-100, 1e-160, 1e-310, 5e-324];

/// The azimuth of wo, in degrees: no multiple of a symmetry.
const PHI_DEG: f64 = 20.0;

/// Random numbers drawn for each direction of [`sampled`].
const DRAWN: usize = 12;

/// wo and wi.
pub(super) type Pair = (DVec3, DVec3);

/// Pairs at the extremes of directions, the same for every model; those of [`about`] come on top.
pub(super) fn pairs() -> Vec<(ExtremeKind, Pair)> {
    let mut all = Vec::new();
    let grazing = || FROM_HORIZON_DEG.map(|degrees| 90.0 - degrees);
    let ladder: Vec<f64> = NORMAL_DEG
        .into_iter()
        .chain(BETWEEN_DEG)
        .chain(grazing())
        .collect();
    for theta_o in &ladder {
        for theta_i in &ladder {
            for difference in AZIMUTHS_DEG {
                let pair = (at(*theta_o, 0.0), at(*theta_i, difference));
                all.push((case_of(*theta_o, *theta_i), pair));
            }
            // To the other sides: two of the azimuths are enough.
            for (sign_o, sign_i, difference) in
                [(-1.0, -1.0, 33.0), (1.0, -1.0, 180.0), (-1.0, 1.0, 33.0)]
            {
                let on_side = |w: DVec3, sign: f64| DVec3::new(w.x, w.y, w.z * sign);
                let (wo, wi) = (at(*theta_o, 0.0), at(*theta_i, difference));
                all.push((
                    ExtremeKind::Ladder,
                    (on_side(wo, sign_o), on_side(wi, sign_i)),
                ));
            }
        }
    }
    for theta in &ladder {
        let wo = at(*theta, 0.0);
        let mirrored = DVec3::new(-wo.x, -wo.y, wo.z);
        for (case, notable) in [
            (ExtremeKind::Retro, wo),
            (ExtremeKind::Opposed, -wo),
            (ExtremeKind::Mirror, mirrored),
        ] {
            all.extend(near(notable).map(|wi| (case, (wo, wi))));
        }
        for difference in AZIMUTHS_DEG {
            let level = level(difference);
            all.push((ExtremeKind::Horizon, (wo, level)));
            all.push((ExtremeKind::Horizon, (level, wo)));
            all.push((ExtremeKind::Horizon, (level, -wo)));
        }
        for cos in SUBNORMAL {
            for difference in [0.0, 180.0, 33.0] {
                let low = level(difference) + DVec3::Z * cos;
                all.extend(
                    [(wo, low), (low, wo), (wo, -low)].map(|pair| (ExtremeKind::Subnormal, pair)),
                );
            }
        }
    }
    let all_but_level = SUBNORMAL.map(|cos| level(0.0) + DVec3::Z * cos);
    let all_but_up = SUBNORMAL.map(|sin| DVec3::new(sin, 0.5 * sin, 1.0));
    for extremes in [all_but_level, all_but_up] {
        for wo in extremes {
            let others = extremes.map(|wi| [wi, DVec3::new(-wi.x, -wi.y, wi.z)]);
            let pairs = others
                .into_iter()
                .flatten()
                .map(|wi| (ExtremeKind::Subnormal, (wo, wi)));
            all.extend(pairs);
        }
    }
    all
}

/// Pairs about what is notable in `specimen` alone: inside its lobes, and about its critical angle.
pub(super) fn about(specimen: &Specimen) -> Vec<(ExtremeKind, Pair)> {
    let mut all: Vec<(ExtremeKind, Pair)> = sampled(specimen)
        .map(|pair| (ExtremeKind::Sampled, pair))
        .collect();
    let index = specimen.relative_index;
    let critical = if index > 1.0 { index.recip() } else { index };
    if critical == 1.0 {
        return all;
    }
    // Total reflection is on the denser side.
    let side = if index > 1.0 { -1.0 } else { 1.0 };
    let cos = ((1.0 - critical) * (1.0 + critical)).sqrt();
    let (cos_phi, sin_phi) = cos_sin_deg(PHI_DEG);
    let edge = DVec3::new(critical * cos_phi, critical * sin_phi, side * cos);
    for wo in near(edge) {
        let mirrored = DVec3::new(-wo.x, -wo.y, wo.z);
        let grazing = FROM_HORIZON_DEG.map(|degrees| {
            let w = at(90.0 - degrees, 180.0);
            DVec3::new(w.x, w.y, -side * w.z)
        });
        for wi in std::iter::once(mirrored).chain(grazing) {
            all.extend([(wo, wi), (wi, wo)].map(|pair| (ExtremeKind::Critical, pair)));
        }
    }
    all
}

/// Directions of view of samples.
pub(super) fn views() -> Vec<DVec3> {
    let degrees = [0.0, 1e-4, 30.0, 60.0, 85.0, 89.9, 90.0 - 1e-4, 90.0 - 1e-7];
    let above = degrees.map(|theta| at(theta, 0.0));
    above.into_iter().flat_map(|w| [w, -w]).collect()
}

/// Pairs that samples make, by a map of each lobe and of all.
fn sampled(specimen: &Specimen) -> impl Iterator<Item = Pair> {
    let mut random = Random::new(17);
    let bxdf = &*specimen.double;
    let lobes = bxdf.lobes().len();
    let draw = move |wo: DVec3, index: usize| {
        let [u, v] = random.pair();
        let wi = match index % (lobes + 1) {
            0 => {
                bxdf.sample_f(wo.into(), random.unit(), [u, v])
                    .filter(|sample| !sample.is_delta)?
                    .wi
            }
            lobe => bxdf.sample_lobe(lobe - 1, wo.into(), [u, v])?,
        };
        Some((wo, wi.into()))
    };
    let places = views()
        .into_iter()
        .flat_map(|wo| (0..DRAWN).map(move |index| (wo, index)));
    let mut draw = draw;
    places
        .filter_map(move |(wo, index)| draw(wo, index))
        .collect::<Vec<_>>()
        .into_iter()
}

/// `w` and directions at each of [`NUDGES`] from it, four of each.
pub(super) fn near(w: DVec3) -> impl Iterator<Item = DVec3> {
    let across = w.any_orthonormal_vector();
    let other = w.cross(across);
    let nudged = NUDGES.into_iter().flat_map(move |by| {
        [across, -across, other, -other].map(|to| (w + to * by).try_normalize().unwrap_or(w))
    });
    std::iter::once(w).chain(nudged)
}

/// The direction at this polar angle, and this azimuth from wo's, in degrees.
fn at(theta_deg: f64, difference_deg: f64) -> DVec3 {
    direction_from_degrees(theta_deg, PHI_DEG + difference_deg)
}

/// The direction in the horizon plane at this azimuth from wo's, in degrees.
fn level(difference_deg: f64) -> DVec3 {
    let (cos_phi, sin_phi) = cos_sin_deg(PHI_DEG + difference_deg);
    DVec3::new(cos_phi, sin_phi, 0.0)
}

fn case_of(theta_o: f64, theta_i: f64) -> ExtremeKind {
    let last_normal = NORMAL_DEG.into_iter().fold(0.0, f64::max);
    let first_grazing = 90.0 - FROM_HORIZON_DEG.into_iter().fold(0.0, f64::max);
    if theta_o.max(theta_i) <= last_normal {
        ExtremeKind::Normal
    } else if theta_o.min(theta_i) >= first_grazing {
        ExtremeKind::Grazing
    } else {
        ExtremeKind::Ladder
    }
}

/// A pair by chance: over the sphere, about the horizon by decades, or about a notable direction by decades.
pub(super) fn random_pair(random: &mut Random) -> Pair {
    let wo = random_direction(random);
    let [kind, distance] = random.pair();
    let notable = match (kind * 8.0) as u32 {
        0 => wo,
        1 => -wo,
        2 => DVec3::new(-wo.x, -wo.y, wo.z),
        3 => DVec3::new(-wo.x, -wo.y, -wo.z),
        _ => return (wo, random_direction(random)),
    };
    let reach = 10.0_f64.powf(-9.0 * distance);
    let wi = (notable + random.direction() * reach).try_normalize();
    (wo, wi.unwrap_or(notable))
}

fn random_direction(random: &mut Random) -> DVec3 {
    let w = random.direction();
    let [kind, decades] = random.pair();
    let cos = 10.0_f64.powf(-9.0 * decades);
    let radial = DVec3::new(w.x, w.y, 0.0)
        .try_normalize()
        .unwrap_or(DVec3::X);
    let [across, along] = match (kind * 8.0) as u32 {
        // Towards the horizon, and towards the normal.
        0 | 1 => [((1.0 - cos) * (1.0 + cos)).sqrt(), cos],
        2 => [cos, ((1.0 - cos) * (1.0 + cos)).sqrt()],
        _ => return w,
    };
    radial * across + DVec3::Z * along.copysign(w.z)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_case_of_directions_has_pairs_and_all_are_unit() {
        let all = pairs();
        for case in [
            ExtremeKind::Ladder,
            ExtremeKind::Normal,
            ExtremeKind::Grazing,
            ExtremeKind::Horizon,
            ExtremeKind::Retro,
            ExtremeKind::Opposed,
            ExtremeKind::Mirror,
            ExtremeKind::Subnormal,
        ] {
            assert!(
                all.iter().filter(|(found, _)| *found == case).count() > 20,
                "{case:?}"
            );
        }
        let mut random = Random::new(3);
        let by_chance = (0..1000).map(|_| (ExtremeKind::Random, random_pair(&mut random)));
        for (case, (wo, wi)) in all.into_iter().chain(by_chance) {
            for w in [wo, wi] {
                assert!(
                    (w.length_squared() - 1.0).abs() < 1e-15 * 4.0,
                    "{case:?} {w:?}"
                );
            }
        }
    }
}
