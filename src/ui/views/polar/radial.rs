//! The radial scale of the plot: which value has which radius, and which radii have a ring.

use bxdf_lab::analysis::RadialScale;
use bxdf_lab::analysis::polar::{Point, Section};
use bxdf_study::format;
use bxdf_study::session::Session;

/// The radial scale with the value at the unit circle.
pub(super) struct Radial {
    scale: RadialScale,
    full: f64,
    /// The values that have a ring.
    pub(super) ticks: Vec<f64>,
    /// What the rings are numbered in, with its unit.
    pub(super) quantity: &'static str,
}

impl Radial {
    /// The scale that holds all `sections`.
    pub(super) fn of<'a>(
        session: &Session,
        sections: impl IntoIterator<Item = &'a Section>,
        has_deltas: bool,
    ) -> Self {
        let channels = session.shown_curves().channels();
        let shown = |point: &Point| {
            channels
                .iter()
                .map(|c| c.of(point.value))
                .fold(0.0, f64::max)
        };
        let peak = sections
            .into_iter()
            .flat_map(|section| section.upper.iter().chain(&section.lower))
            .map(shown)
            .fold(0.0, f64::max);
        if peak <= 0.0 {
            // Deltas alone: the rings count shares of the light. Nothing at all: any scale will do.
            let ticks = vec![0.25, 0.5, 0.75, 1.0];
            let quantity = if has_deltas {
                "share of the flux"
            } else {
                "f in 1/sr"
            };
            return Self {
                scale: RadialScale::Linear,
                full: 1.0,
                ticks,
                quantity,
            };
        }
        let (full, ticks) = match session.scale {
            RadialScale::Linear => {
                let step = format::round_step(peak);
                let count = (peak / step - 1e-9).ceil();
                (
                    step * count,
                    (1..=count as i32).map(|i| f64::from(i) * step).collect(),
                )
            }
            RadialScale::Logarithmic { decades } => {
                let top = (peak.log10() - 1e-9).ceil();
                (
                    10_f64.powf(top),
                    (0..decades as i32)
                        .map(|i| 10_f64.powf(top - f64::from(i)))
                        .collect(),
                )
            }
        };
        let quantity = if session.with_cosine {
            "f cos θ in 1/sr"
        } else {
            "f in 1/sr"
        };
        Self {
            scale: session.scale,
            full,
            ticks,
            quantity,
        }
    }

    pub(super) fn radius(&self, value: f64) -> f64 {
        self.scale.radius(value, self.full)
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

    #[test]
    fn rings_reach_the_peak_and_no_further_than_needed() {
        let point = |f: f64| Point {
            angle: 0.0,
            value: [f; 3],
        };
        let section = |f: f64| Section {
            upper: vec![point(f)],
            peak: f,
            ..Section::default()
        };
        let mut session = Session::default();
        for peak in [0.01, 0.2546, 1.0, 3.7e6] {
            let radial = Radial::of(&session, [&section(0.01), &section(peak)], false);
            assert!(
                radial.full >= peak * (1.0 - 1e-9) && radial.full <= 1.7 * peak,
                "{peak}: {}",
                radial.full
            );
            assert!(
                (3..=5).contains(&radial.ticks.len()),
                "{peak}: {:?}",
                radial.ticks
            );
            assert!((radial.radius(*radial.ticks.last().unwrap()) - 1.0).abs() < 1e-9);
        }
        session.scale = RadialScale::Logarithmic { decades: 4.0 };
        let radial = Radial::of(&session, [&section(0.2546)], true);
        assert_eq!(radial.ticks.len(), 4);
        assert!((radial.full - 1.0).abs() < 1e-12);
        assert_eq!(
            Radial::of(&session, &[], true).quantity,
            "share of the flux"
        );
    }

    #[test]
    fn angles_run_from_n_to_the_right() {
        let [x, y] = at(1.0, FRAC_PI_2);
        assert!((x - 1.0).abs() < 1e-15 && y.abs() < 1e-15);
        assert_eq!(at(1.0, 0.0), [0.0, 1.0]);
    }
}
