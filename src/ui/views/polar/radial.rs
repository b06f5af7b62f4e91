//! The radial scale of the plot: which value has which radius, and which radii have a ring.

use bxdf_lab::analysis::polar::{Point, Section};
use bxdf_lab::analysis::{Channel, RadialScale};
use bxdf_study::format;

/// What has which radius.
#[derive(Clone, Copy)]
pub(super) struct Radial {
    scale: RadialScale,
    /// The value at the unit circle.
    pub(super) full: f64,
}

impl Radial {
    pub(super) fn new(scale: RadialScale, full: f64) -> Self {
        Self { scale, full }
    }

    pub(super) fn radius(&self, value: f64) -> f64 {
        self.scale.radius(value, self.full)
    }
}

/// The largest value of a section in any of the `channels`.
pub(super) fn peak(section: &Section, channels: &[Channel]) -> f64 {
    let shown = |point: &Point| {
        let values = channels.iter().map(|channel| channel.of(point.value));
        values.fold(0.0, f64::max)
    };
    let points = section.upper.iter().chain(&section.lower);
    points.map(shown).fold(0.0, f64::max)
}

/// The value at the unit circle where the largest one is `peak`, above 0: the next that has a ring.
pub(super) fn full(scale: RadialScale, peak: f64) -> f64 {
    match scale {
        RadialScale::Linear => {
            let step = format::round_step(peak);
            step * (peak / step - 1e-9).ceil()
        }
        RadialScale::Logarithmic { .. } => 10_f64.powf((peak.log10() - 1e-9).ceil()),
    }
}

/// The rings of the plot.
pub(super) struct Rings {
    radial: Radial,
    /// The values that have one.
    pub(super) ticks: Vec<f64>,
    /// What they are numbered in, with its unit.
    pub(super) quantity: String,
}

impl Rings {
    /// At round values of `quantity`.
    pub(super) fn of(radial: Radial, quantity: &str) -> Self {
        let Radial { scale, full } = radial;
        let ticks = match scale {
            RadialScale::Linear => {
                let step = format::round_step(full);
                let count = (full / step + 1e-9).floor();
                (1..=count as i32).map(|i| f64::from(i) * step).collect()
            }
            RadialScale::Logarithmic { decades } => {
                let top = (full.log10() + 1e-9).floor();
                (0..decades as i32)
                    .map(|i| 10_f64.powf(top - f64::from(i)))
                    .collect()
            }
        };
        Self {
            radial,
            ticks,
            quantity: quantity.to_owned(),
        }
    }

    /// At quarters of what is 1 at the unit circle, or at decades below it.
    pub(super) fn of_shares(scale: RadialScale, quantity: &str) -> Self {
        let mut rings = Self::of(Radial::new(scale, 1.0), quantity);
        if scale == RadialScale::Linear {
            rings.ticks = vec![0.25, 0.5, 0.75, 1.0];
        }
        rings
    }

    pub(super) fn radius(&self, value: f64) -> f64 {
        self.radial.radius(value)
    }
}

/// The plot's coordinates of a radius at a signed angle from n.
pub(super) fn at(radius: f64, angle: f64) -> [f64; 2] {
    [radius * angle.sin(), radius * angle.cos()]
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_2;

    use super::*;

    const BY_DECADES: RadialScale = RadialScale::Logarithmic { decades: 4.0 };

    #[test]
    fn rings_reach_the_peak_and_no_further_than_needed() {
        for found in [0.01, 0.2546, 1.0, 3.7e6] {
            let full = full(RadialScale::Linear, found);
            assert!(
                full >= found * (1.0 - 1e-9) && full <= 1.7 * found,
                "{found}: {full}"
            );
            let rings = Rings::of(Radial::new(RadialScale::Linear, full), "f");
            assert!(
                (3..=5).contains(&rings.ticks.len()),
                "{found}: {:?}",
                rings.ticks
            );
            assert!((rings.radius(*rings.ticks.last().unwrap()) - 1.0).abs() < 1e-9);
        }
        let full = full(BY_DECADES, 0.2546);
        assert!((full - 1.0).abs() < 1e-12);
        let rings = Rings::of(Radial::new(BY_DECADES, full), "f");
        assert_eq!(rings.ticks.len(), 4);
    }

    /// While the scale goes over from one to the next.
    #[test]
    fn rings_of_any_full_length_lie_inside() {
        for full in [0.013, 0.9, 1.1, 7.77, 1e4 / 3.0] {
            for scale in [RadialScale::Linear, BY_DECADES] {
                let rings = Rings::of(Radial::new(scale, full), "f");
                let radii: Vec<f64> = rings.ticks.iter().map(|tick| rings.radius(*tick)).collect();
                let outermost = radii.iter().copied().fold(0.0, f64::max);
                assert!(
                    outermost <= 1.0 + 1e-9 && outermost > 0.5,
                    "{full} {radii:?}"
                );
            }
        }
    }

    #[test]
    fn the_peak_is_that_of_the_channels_shown() {
        let point = |value: [f64; 3]| Point { angle: 0.0, value };
        let section = Section {
            upper: vec![point([1.0, 0.0, 0.0]), point([0.2; 3])],
            ..Section::default()
        };
        assert_eq!(peak(&section, &[Channel::Red, Channel::Blue]), 1.0);
        assert_eq!(peak(&section, &[Channel::Blue]), 0.2);
        assert_eq!(
            Rings::of_shares(RadialScale::Linear, "share").ticks.len(),
            4
        );
    }

    #[test]
    fn angles_run_from_n_to_the_right() {
        let [x, y] = at(1.0, FRAC_PI_2);
        assert!((x - 1.0).abs() < 1e-15 && y.abs() < 1e-15);
        assert_eq!(at(1.0, 0.0), [0.0, 1.0]);
    }
}
