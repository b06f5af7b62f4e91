//! Whether a material gives back more light than arrives, looked at in passing.

use std::fmt;

use crate::analysis::reflectance::{Reflectance, lobe_shares};
use crate::bxdf::math::frame::direction_from_degrees;
use crate::bxdf::{Material, Side};

/// The polar angles looked at, in degrees.
const THETAS_DEG: [f64; 5] = [0.0, 30.0, 60.0, 80.0, 89.0];

/// The share beyond 1 that is reported: rounded parameters of a material that gives back all light stay below.
const EXCESS: f64 = 1e-3;

/// The absolute error asked of the shares, well below [`EXCESS`].
const TOLERANCE: f64 = 1e-4;

/// Evaluations each lobe may take at each angle: some hundredths of a second in all.
const MAX_EVALUATIONS: usize = 60_000;

/// Where a material creates energy, and how much leaves.
#[derive(Debug, PartialEq)]
pub(super) struct Created {
    theta_deg: f64,
    share: f64,
}

impl fmt::Display for Created {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { theta_deg, share } = self;
        write!(
            f,
            "{share:.4} times the light arriving at theta {theta_deg} degrees leaves"
        )
    }
}

/// The worst of a few angles at which more light leaves `material` than arrives. `None` where there is none, and for a
/// material of one lobe: its model declares what it does.
pub(super) fn created(material: &Material) -> Option<Created> {
    if material.components().len() < 2 {
        return None;
    }
    let bxdf = material.build::<f64>();
    let below = THETAS_DEG.map(|theta_deg| 180.0 - theta_deg);
    let is_crossed = material.has_side(Side::Transmission);
    THETAS_DEG
        .into_iter()
        .chain(below.into_iter().filter(|_| is_crossed))
        .filter_map(|theta_deg| {
            let wi = direction_from_degrees(theta_deg, 0.0);
            let shares = lobe_shares(&*bxdf, wi, TOLERANCE, MAX_EVALUATIONS);
            let found = Reflectance::of(&shares);
            let share = found.largest();
            (share > 1.0 + EXCESS + found.error).then_some(Created { theta_deg, share })
        })
        .min_by_key(|created| std::cmp::Reverse(ten_thousandths(created.share)))
}

/// `share` as it is printed: of equal ones the first angle is named.
fn ten_thousandths(share: f64) -> u64 {
    (1e4 * share).round() as u64
}
