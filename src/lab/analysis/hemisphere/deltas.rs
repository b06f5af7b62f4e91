//! The Dirac deltas of a map, which are no values of it.

use glam::DVec3;

use super::request::{Comparison, Quantity, Request};
use crate::analysis::lobe::Arrow;
use crate::analysis::{Subject, deltas};
use bxdf::Side;

impl Quantity {
    /// What a delta has in its place, a number without unit: the share of the flux in that of values, the probability with
    /// which it is chosen in that of the density, and what a sample of it weighs.
    #[must_use]
    pub const fn title_of_delta(self) -> &'static str {
        match self {
            Self::F | Self::FCos => "share of the flux",
            Self::Pdf => "probability",
            Self::Weight => "weight",
        }
    }

    /// See [`Self::title_of_delta`].
    fn of_delta(self, arrow: &Arrow) -> [f64; 3] {
        match self {
            Self::F | Self::FCos => arrow.flux,
            Self::Pdf => [arrow.probability; 3],
            Self::Weight => arrow.weight.map(|weight| weight / arrow.probability),
        }
    }
}

/// A Dirac delta in place of a value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DeltaValue {
    /// The direction, a unit vector.
    pub direction: DVec3,
    /// See [`Quantity::title_of_delta`]; compared as the values are.
    pub value: [f64; 3],
    /// To which side it goes.
    pub side: Side,
}

impl Request {
    /// The deltas of `subject` on both sides, as what is shown has them.
    #[must_use]
    pub fn deltas(&self, subject: &Subject<'_>) -> Vec<DeltaValue> {
        let is_alone = self.comparison == Comparison::None;
        let subject = Subject {
            against: subject.against.filter(|_| !is_alone),
            ..*subject
        };
        let value =
            |arrow: Option<Arrow>| arrow.map_or([0.0; 3], |arrow| self.quantity.of_delta(&arrow));
        let found = deltas::pairs(&subject).into_iter();
        found
            .filter_map(|[own, other]| {
                let Arrow {
                    direction, side, ..
                } = own.or(other)?;
                Some(DeltaValue {
                    direction,
                    value: self.comparison.of(value(own), value(other)),
                    side,
                })
            })
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::hemisphere::Projection;
    use crate::analysis::{HeldLobe, Hold};
    use bxdf::Material;
    use bxdf::math::frame::direction_from_degrees;

    #[test]
    fn each_quantity_has_its_number_of_a_delta() {
        let glass: Material = "fresnel_specular:eta=1.5".parse().unwrap();
        let surface = glass.build::<f64>();
        let held = direction_from_degrees(0.0, 0.0);
        let lobe = HeldLobe::new(&*surface, Hold::Light, held);
        let subject = Subject {
            against: Some(lobe),
            ..Subject::of(lobe)
        };
        let of = |quantity, comparison| {
            let request = Request {
                projection: Projection::EqualArea,
                quantity,
                comparison,
                is_upper: true,
                size: 4,
            };
            let found = request.deltas(&subject);
            let [up, down] = &found[..] else {
                panic!("{found:?}");
            };
            assert!(up.direction.z > 0.0 && up.side == Side::Reflection);
            [up.value[1], down.value[1]]
        };
        let near = |[a, b]: [f64; 2], [x, y]: [f64; 2]| {
            assert!((a - x).abs() < 1e-12 && (b - y).abs() < 1e-12, "{a} {b}");
        };
        for quantity in [Quantity::F, Quantity::FCos, Quantity::Pdf] {
            near(of(quantity, Comparison::None), [0.04, 0.96]);
        }
        // Radiance across the surface is as many times less as the square of the index.
        near(of(Quantity::Weight, Comparison::None), [1.0, 1.0 / 2.25]);
        near(of(Quantity::F, Comparison::Difference), [0.0, 0.0]);
        near(of(Quantity::F, Comparison::Ratio), [1.0, 1.0]);
    }
}
