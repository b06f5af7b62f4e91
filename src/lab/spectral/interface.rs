//! The reflectance of an interface over the wavelength, where the constants of its substance are known.

use super::{Constants, RANGE_NM};
use crate::analysis::fresnel::{Face, Index, MarkKind, Reflectances, lobe};
use crate::analysis::{Basis, Detail, IsWanted, Pace, Query, Subject};
use bxdf::math::frame;

/// Whose interface is looked at, at the angle of the held direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OverWavelength {
    /// The place of its lobe among those of the material that have one; see [`lobe`].
    pub lobe: usize,
}

/// An interface over the wavelength; empty where no constants are known.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct OverWavelengths {
    /// The angle of the held direction from the axis of its side, in degrees.
    pub theta_deg: f64,
    /// By the wavelength, in rising order.
    pub points: Vec<AtWavelength>,
}

/// An interface at a wavelength.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AtWavelength {
    /// The wavelength in nm.
    pub nm: f64,
    /// The index there.
    pub index: Index,
    /// The reflectances there.
    pub reflectances: Reflectances,
    /// The angle at which the least p polarised light is reflected, in degrees, and how much that is; `None` where that is
    /// not less than straight on.
    pub least_p: Option<[f64; 2]>,
}

/// Between two wavelengths, in nm: tables have no finer features.
const STEP_NM: f64 = 2.0;

impl Query for OverWavelength {
    type Answer = OverWavelengths;

    const BASIS: Basis = Basis::Held;
    const PACE: Pace = Pace::Short;

    fn answer(&self, subject: &Subject<'_>, _: Detail, _: IsWanted<'_>) -> Option<OverWavelengths> {
        let theta_deg = frame::theta(subject.lobe.held()).to_degrees();
        let theta_deg = theta_deg.min(180.0 - theta_deg);
        let component = subject
            .material
            .and_then(|material| lobe(material, self.lobe));
        let points = component
            .and_then(Constants::of)
            .map(|constants| over(constants, theta_deg));
        Some(OverWavelengths {
            theta_deg,
            points: points.unwrap_or_default(),
        })
    }
}

/// The interface of `constants` at each wavelength that is seen and that they know.
fn over(constants: &Constants, theta_deg: f64) -> Vec<AtWavelength> {
    let ([first, last], [start, end]) = (constants.range_nm(), RANGE_NM);
    let (start, end) = (first.max(start), last.min(end));
    let steps = ((end - start) / STEP_NM).floor().max(0.0) as u32;
    let at = |step: u32| {
        let nm = start + STEP_NM * f64::from(step);
        let [n, k] = constants.at(nm);
        let index = Index { n, k };
        let face = Face::new(index);
        let marks = face.marks();
        let least = marks.iter().find(|mark| mark.kind != MarkKind::Critical);
        AtWavelength {
            nm,
            index,
            reflectances: face.at(theta_deg),
            least_p: least.map(|mark| [mark.theta_deg, face.at(mark.theta_deg).p]),
        }
    };
    (0..=steps).map(at).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spectral::find;

    #[test]
    fn gold_turns_from_a_poor_mirror_to_a_good_one() {
        let points = over(find("gold").unwrap(), 0.0);
        let mean = |nm: f64| {
            let point = points.iter().find(|point| point.nm >= nm).unwrap();
            point.reflectances.mean()
        };
        assert!(mean(450.0) < 0.45 && mean(650.0) > 0.9);
        for point in &points {
            let Index { n, k } = point.index;
            let expected = ((n - 1.0).powi(2) + k * k) / ((n + 1.0).powi(2) + k * k);
            assert!((point.reflectances.mean() - expected).abs() < 1e-14);
            let [angle, least] = point.least_p.unwrap();
            assert!((55.0..85.0).contains(&angle) && least < expected);
        }
    }
}
