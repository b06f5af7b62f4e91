//! The lobe of a surface at one held direction: a function of the direction that is left free.

use glam::DVec3;

use super::quadrature::Integral;
use crate::bxdf::{Bxdf, Side};

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
    /// `wo` is held: the lobe is f(wo, wi) over `wi`, whence one viewer gets light.
    #[serde(alias = "wo")]
    Viewer,
}

/// How many sample directions mark a lobe out, along each side of the unit square.
const SEEDS_PER_SIDE: u32 = 24;

/// How far above the horizon plane the limit of a value is taken, as a cosine: the plane itself carries nothing, but a
/// drawn lobe ends at its limit there. Too small to change a value on the screen, large enough not to lose digits.
pub const HORIZON_LIFT: f64 = 1e-6;

/// A surface with one direction held, in the fixed frame.
#[derive(Clone, Copy)]
pub struct HeldLobe<'a> {
    bxdf: &'a dyn Bxdf<f64>,
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
    /// To which side it goes.
    pub side: Side,
}

impl<'a> HeldLobe<'a> {
    /// The lobe of `bxdf` with the unit vector `held` held.
    #[must_use]
    pub fn new(bxdf: &'a dyn Bxdf<f64>, hold: Hold, held: DVec3) -> Self {
        Self { bxdf, hold, held }
    }

    /// The held direction.
    #[must_use]
    pub fn held(&self) -> DVec3 {
        self.held
    }

    /// f in 1/sr with the unit vector `free` as the other direction.
    #[must_use]
    pub fn value(&self, free: DVec3) -> [f64; 3] {
        match self.hold {
            Hold::Light => self.bxdf.f(free.into(), self.held.into()),
            Hold::Viewer => self.bxdf.f(self.held.into(), free.into()),
        }
        .to_f64()
    }

    /// [`Self::value`], or its limit from the side `is_upper` where `free` lies in the horizon plane.
    #[must_use]
    pub fn value_or_limit(&self, free: DVec3, is_upper: bool) -> [f64; 3] {
        if free.z.abs() < HORIZON_LIFT {
            let z = if is_upper {
                HORIZON_LIFT
            } else {
                -HORIZON_LIFT
            };
            self.value(DVec3::new(free.x, free.y, z))
        } else {
            self.value(free)
        }
    }

    /// The Dirac deltas, by the flux they carry.
    #[must_use]
    pub fn arrows(&self) -> Vec<Arrow> {
        let deltas = self.bxdf.deltas(self.held.into());
        let arrow = |delta: crate::bxdf::Delta<f64>| Arrow {
            direction: delta.direction.into(),
            flux: delta.flux.to_f64(),
            side: delta.side,
        };
        deltas.into_iter().flatten().map(arrow).collect()
    }

    /// Directions where the lobe is, denser where it is higher: the images of a regular grid under the model's own
    /// sampling. They tell the adaptive curve, mesh and quadrature where a narrow lobe hides.
    #[must_use]
    pub fn seeds(&self) -> Seeds {
        let drawn = f64::from(SEEDS_PER_SIDE * SEEDS_PER_SIDE);
        let mut seeds = Seeds {
            directions: Vec::with_capacity(drawn as usize),
            drawn,
            sum: 0.0,
        };
        self.draw(SEEDS_PER_SIDE, |direction, weight| {
            seeds.directions.push(direction);
            seeds.sum += weight.into_iter().fold(0.0, f64::max);
        });
        seeds.directions.extend(self.outer_lobes());
        seeds
    }

    /// The integrals of f |cos(theta)| over the hemispheres about +n and -n as means of `per_side`^2 stratified samples;
    /// the error is one standard error of as many independent samples.
    #[must_use]
    pub fn sampled_integrals(&self, per_side: u32) -> [Integral; 2] {
        let (mut sums, mut squares) = ([[0.0; 3]; 2], [[0.0; 3]; 2]);
        self.draw(per_side, |direction, weight| {
            let side = usize::from(direction.z < 0.0);
            if let (Some(sum), Some(square)) = (sums.get_mut(side), squares.get_mut(side)) {
                sum.iter_mut().zip(weight).for_each(|(sum, w)| *sum += w);
                square
                    .iter_mut()
                    .zip(weight)
                    .for_each(|(square, w)| *square += w * w);
            }
        });
        let drawn = f64::from(per_side) * f64::from(per_side);
        let [upper, lower] = [0, 1].map(|side: usize| {
            let value = sums
                .get(side)
                .copied()
                .unwrap_or_default()
                .map(|sum| sum / drawn);
            let mean_square = squares
                .get(side)
                .copied()
                .unwrap_or_default()
                .map(|square| square / drawn);
            let variance = value
                .iter()
                .zip(mean_square)
                .map(|(mean, square)| square - mean * mean)
                .fold(0.0, f64::max);
            Integral {
                value,
                error: (variance / drawn).sqrt(),
                has_converged: false,
            }
        });
        [upper, lower]
    }

    /// Visits the directions of a regular grid of `per_side`^2 cells under the model's sampling, each with
    /// f |cos(theta)| over its density. Lost samples and deltas are not visited.
    fn draw(&self, per_side: u32, mut visit: impl FnMut(DVec3, [f64; 3])) {
        let centre = |index: u32| (f64::from(index) + 0.5) / f64::from(per_side);
        for (i, j) in (0..per_side).flat_map(|i| (0..per_side).map(move |j| (i, j))) {
            let u = [centre(i), centre(j)];
            let sample = self
                .bxdf
                .sample_f(self.held.into(), radical_inverse(i * per_side + j), u);
            let Some(sample) = sample.filter(|sample| !sample.is_delta && sample.pdf > 0.0) else {
                continue;
            };
            let direction = DVec3::from(sample.wi);
            let scale = direction.z.abs() / sample.pdf;
            visit(direction, self.value(direction).map(|f| f * scale));
        }
    }

    /// Directions of the lobes that are seldom sampled, as many for each as of a model with one lobe.
    ///
    /// A model chooses among its lobes by one number; its ends choose the first and the last of them, however faint.
    /// Empty where they choose the same.
    fn outer_lobes(&self) -> Vec<DVec3> {
        let ends = [0.0, 1.0 - 0.5 * f64::EPSILON];
        let n = SEEDS_PER_SIDE;
        let centre = |index: u32| (f64::from(index) + 0.5) / f64::from(n);
        let sample = |uc: f64, i: u32, j: u32| {
            let sample = self
                .bxdf
                .sample_f(self.held.into(), uc, [centre(i), centre(j)])?;
            (!sample.is_delta && sample.pdf > 0.0).then(|| DVec3::from(sample.wi))
        };
        let [first, last] = ends.map(|uc| sample(uc, n / 3, n / 2));
        if first == last {
            return Vec::new();
        }
        let cells = || (0..n).flat_map(|i| (0..n).map(move |j| (i, j)));
        ends.into_iter()
            .flat_map(|uc| cells().filter_map(move |(i, j)| sample(uc, i, j)))
            .collect()
    }
}

/// What [`HeldLobe::seeds`] returns.
#[derive(Clone, Debug)]
pub struct Seeds {
    /// The directions, lost samples and deltas left out.
    pub directions: Vec<DVec3>,
    drawn: f64,
    sum: f64,
}

impl Seeds {
    /// An estimate, good to a few percent, of the integral of f |cos(theta)| over the sphere, largest channel.
    #[must_use]
    pub fn integral(&self) -> f64 {
        self.sum / self.drawn
    }
}

/// The van der Corput sequence in base 2: the bits of `index` mirrored behind the binary point.
fn radical_inverse(index: u32) -> f64 {
    f64::from(index.reverse_bits()) / 2_f64.powi(32)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bxdf::Material;
    use crate::bxdf::math::frame::direction_from_degrees;

    #[test]
    fn seeds_estimate_the_integral() {
        let material: Material = "lambertian_reflection:reflectance=0.6".parse().unwrap();
        let model = material.build();
        let lobe = HeldLobe::new(&*model, Hold::Light, direction_from_degrees(40.0, 10.0));
        assert!((lobe.seeds().integral() - 0.6).abs() < 1e-12);
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
