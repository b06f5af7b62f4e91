//! Whether the window moves anything by itself.

use super::Store;

impl Store {
    /// Whether a person wants the window to move and fade nothing by itself.
    #[must_use]
    pub fn has_reduced_motion(&self) -> bool {
        self.preferences.has_reduced_motion
    }

    /// Keeps whether it moves nothing by itself.
    pub fn keep_reduced_motion(&mut self, is_reduced: bool) {
        if self.preferences.has_reduced_motion != is_reduced {
            self.preferences.has_reduced_motion = is_reduced;
            self.keep_preferences();
        }
    }
}
