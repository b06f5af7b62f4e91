//! What views of several kinds have alike, changed in all of them.

use super::Views;
use crate::views::{Arrangement, Options, Scale, VIEWS};

impl Views {
    /// Gives every view that shows radii this scale, unless it has one other than that of the start.
    pub(in crate::session) fn scale_radii(&mut self, scale: Scale) {
        let put = |own: &mut Scale| {
            if *own == Scale::default() {
                *own = scale;
            }
        };
        self.each_scale(put);
        // Those of kinds that are closed get it when they are opened.
        for kind in &VIEWS {
            if self.first(kind).is_some() {
                continue;
            }
            let mut options = self.closed.get(kind.id).cloned();
            let mut options = options.take().unwrap_or_else(|| Options::of(kind));
            if let Some(own) = options.radial_scale() {
                put(own);
                self.put_away(options);
            }
        }
    }

    /// Changes the scale of every open view that shows radii.
    pub fn each_scale(&mut self, change: impl Fn(&mut Scale)) {
        for options in self.open.values_mut() {
            if let Some(scale) = options.radial_scale() {
                change(scale);
            }
        }
    }

    /// Changes how materials stand in every open view that overlays them.
    pub(in crate::session) fn each_arrangement(&mut self, change: impl Fn(&mut Arrangement)) {
        for options in self.open.values_mut() {
            if let Some(arrangement) = options.arrangement() {
                change(arrangement);
            }
        }
    }

    /// Whether any open view shows radii by decades.
    #[must_use]
    pub fn is_logarithmic(&self) -> bool {
        self.open.values().cloned().any(|mut options| {
            let scale = options.radial_scale();
            scale.is_some_and(|scale| scale.lengths.is_logarithmic())
        })
    }
}
