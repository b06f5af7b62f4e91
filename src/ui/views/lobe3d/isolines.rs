//! Lines of equal value on a lobe, at the values that have rings in the polar plot.

use glam::Vec3;

use super::level;
use super::surface::DrawnLobe;
use bxdf_lab::analysis::RadialScale;
use bxdf_study::format;

/// Of a lobe that reaches less far, lines would be a blot, in world units.
const SHORTEST: f64 = 0.04;

/// Values this near to the largest one, as a share of it, have no line: it would be a dot at the tip.
const NEAR_TIP: f64 = 0.98;

/// A line of equal value.
pub(super) struct Isoline {
    /// The value, in 1/sr.
    pub(super) value: f64,
    /// Whether it is one of those between the ones that are numbered.
    pub(super) is_minor: bool,
    /// Its pieces: one for each bump of the lobe that it goes around.
    pub(super) pieces: Vec<Vec<Vec3>>,
}

/// The lines of `lobe`, whose radius is 1 where the value is `full`.
pub(super) fn of(lobe: &DrawnLobe, scale: RadialScale, full: f64) -> Vec<Isoline> {
    let Some((top, _)) = lobe.highest().filter(|(radius, _)| *radius > SHORTEST) else {
        return Vec::new();
    };
    let line = |(value, is_minor)| Isoline {
        value,
        is_minor,
        pieces: level::lines(
            &lobe.triangles,
            &lobe.radii,
            scale.radius(value, full),
            |edge, part| lobe.on_edge(edge, part),
        ),
    };
    let levels = levels(scale, scale.value(top, full)).into_iter();
    let seen = levels.filter(|(value, _)| scale.radius(*value, full) > SHORTEST);
    seen.map(line).collect()
}

/// Round values below `top`, and whether each is one between the others: on a linear scale about five that are not, else the
/// powers of ten.
fn levels(scale: RadialScale, top: f64) -> Vec<(f64, bool)> {
    let is_below = |(value, _): &(f64, bool)| *value < NEAR_TIP * top;
    match scale {
        RadialScale::Linear => {
            let step = format::round_step(top);
            let halves = (1..).map(|n: i32| (0.5 * f64::from(n) * step, n % 2 == 1));
            halves.take_while(is_below).collect()
        }
        RadialScale::Logarithmic { decades } => {
            let highest = top.log10().ceil() as i32;
            let power = |n: i32| 10_f64.powi(highest - n);
            let powers = (0..=decades.ceil() as i32).map(power);
            let levels = powers.flat_map(|power| [(power, false), (0.3 * power, true)]);
            levels.filter(is_below).collect()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_are_round_and_below_the_top() {
        let numbered = |scale, top| -> Vec<f64> {
            let levels = levels(scale, top).into_iter();
            levels
                .filter(|(_, is_minor)| !is_minor)
                .map(|(value, _)| value)
                .collect()
        };
        assert_eq!(numbered(RadialScale::Linear, 4.89), [1.0, 2.0, 3.0, 4.0]);
        assert_eq!(numbered(RadialScale::Linear, 0.2546), [0.1, 0.2]);
        assert_eq!(
            levels(RadialScale::Linear, 0.2546).len(),
            4,
            "with those between"
        );
        let decades = RadialScale::Logarithmic { decades: 4.0 };
        assert_eq!(numbered(decades, 4.89), [1.0, 0.1, 0.01, 0.001]);
        // A line about the very tip would be a dot.
        assert_eq!(numbered(decades, 1.001), [0.1, 0.01, 0.001]);
    }
}
