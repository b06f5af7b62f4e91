//! The value at the full length of a view: it stays while something is dragged, so that a lobe is seen to grow and to shrink,
//! and goes over to what is wanted once afterwards.

use std::collections::HashMap;

use egui::Ui;

use super::context::ViewContext;
use bxdf_study::session::EntryId;
use bxdf_study::views::Scale;

/// By how much a lobe may exceed the full length while something is dragged: what is longer would leave the view.
const OVERSHOOT: f64 = 1.5;

/// The seconds in which the scale goes over.
const EASING: f64 = 0.2;

/// Whose full length it is: that of one material, or that of all.
type Of = Option<EntryId>;

/// A full length on the screen.
#[derive(Clone, Copy)]
struct Kept {
    /// What it is to come to.
    wanted: f64,
    /// From where it goes there.
    from: f64,
    /// Since when, in seconds of the window's clock.
    since: f64,
}

impl Kept {
    /// What is shown.
    fn at(&self, now: f64) -> f64 {
        between(self.from, self.wanted, (now - self.since) / EASING)
    }
}

/// The full lengths of a view.
#[derive(Default)]
struct Scales {
    kept: HashMap<(Of, bool), Kept>,
}

/// The value at the full length, where `wanted` fits what is shown.
pub(super) fn full<O>(
    ui: &Ui,
    cx: &mut ViewContext<'_, O>,
    scale: Scale,
    of: Of,
    wanted: f64,
) -> f64 {
    if let Some(locked) = scale.locked_at.filter(|_| !scale.is_each_to_peak) {
        return locked;
    }
    if cx.state.is_picture || wanted <= 0.0 {
        return wanted;
    }
    let (is_dragging, now) = (
        ui.ctx().dragged_id().is_some(),
        ui.input(|input| input.time),
    );
    let at_rest = |shown: f64| Kept {
        wanted: shown,
        from: shown,
        since: now - EASING,
    };
    let scales: &mut Scales = cx.state.own(cx.view);
    let key = (of, scale.lengths.is_logarithmic());
    let kept = scales.kept.entry(key).or_insert_with(|| at_rest(wanted));
    if is_dragging {
        *kept = at_rest(held(kept.at(now), wanted));
    } else if kept.wanted != wanted {
        *kept = Kept {
            wanted,
            from: kept.at(now),
            since: now,
        };
    }
    if now < kept.since + EASING {
        ui.ctx().request_repaint();
    }
    kept.at(now)
}

/// The full length while something is dragged.
fn held(shown: f64, wanted: f64) -> f64 {
    shown.max(wanted / OVERSHOOT)
}

/// A value of this share of the way, by ratios: lengths change evenly.
fn between(from: f64, to: f64, share: f64) -> f64 {
    if share >= 1.0 || from == to {
        return to;
    }
    from * (to / from).powf(share)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_scale_grows_only_for_what_would_leave_the_view() {
        assert_eq!(held(2.0, 1.0), 2.0, "a lobe is seen to shrink");
        assert_eq!(held(2.0, 2.9), 2.0, "and to grow");
        assert_eq!(held(2.0, 6.0), 4.0);
    }

    #[test]
    fn it_goes_over_by_ratios() {
        assert_eq!(between(1.0, 100.0, 0.0), 1.0);
        assert!((between(1.0, 100.0, 0.5) - 10.0).abs() < 1e-12);
        assert_eq!(between(3.0, 0.1, 1.0), 0.1);
    }
}
