//! The scale of the radii: one for all materials, or one for each.

use egui::{Rect, Ui};

use super::super::context::ViewContext;
use super::super::{kept_scale, settings};
use super::canvas::Plotted;
use super::radial::{self, Radial};
use bxdf_study::views::polar::Options;

/// The radial scale of each material, 1 at the unit circle; the value there, where it is that of all.
pub(super) fn scale_all(
    ui: &Ui,
    cx: &mut ViewContext<'_, Options>,
    plotted: &mut [Plotted],
) -> Option<f64> {
    let (scale, channels) = (cx.options.scale, cx.session.shown_curves().channels());
    let mut largest = 0.0_f64;
    for one in &mut *plotted {
        let peak = radial::peak(&one.section, channels);
        largest = largest.max(peak);
        if scale.is_each_to_peak {
            // The curve itself touches the circle, not the next ring.
            let full = kept_scale::full(ui, cx, scale, Some(one.entry), peak);
            one.radial = Radial::new(scale.lengths, full);
        }
    }
    if scale.is_each_to_peak {
        return None;
    }
    let wanted = if largest > 0.0 {
        radial::full(scale.lengths, largest)
    } else {
        0.0
    };
    let full = kept_scale::full(ui, cx, scale, None, wanted);
    for one in plotted {
        one.radial = Radial::new(scale.lengths, full);
    }
    (full > 0.0).then_some(full)
}

/// Offers to show each lobe to its peak, where one is too small to be seen.
pub(super) fn offer_peaks(
    ui: &mut Ui,
    cx: &mut ViewContext<'_, Options>,
    plotted: &[Plotted],
    room: Rect,
) {
    let channels = cx.session.shown_curves().channels();
    let radii = plotted.iter().map(|one| {
        let radius = one.radial.radius(radial::peak(&one.section, channels));
        (one.entry, radius)
    });
    let small = settings::smallest(cx, radii);
    let mut scale = cx.options.scale;
    settings::offer_peaks(ui, cx, &mut scale, small, room);
    cx.options.scale = scale;
}
