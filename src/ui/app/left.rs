//! What was pointed at until a moment ago.

use bxdf_study::cursor::Cursor;

/// How long its mark is seen after the pointer has left, in seconds.
const FADE: f64 = 0.4;

/// What was pointed at last, and fades.
#[derive(Clone, Copy, Debug)]
pub struct Left {
    cursor: Cursor,
    /// When the pointer left it, in seconds.
    at: f64,
}

impl Left {
    /// What is left at `now`, in seconds, where `pointed` is pointed at and `before` was in the frame before.
    #[must_use]
    pub fn next(
        left: Option<Self>,
        (pointed, before): (Option<Cursor>, Option<Cursor>),
        now: f64,
    ) -> Option<Self> {
        match (pointed, before) {
            (Some(_), _) => None,
            (None, Some(cursor)) => Some(Self { cursor, at: now }),
            (None, None) => left.filter(|left| left.strength(now) > 0.0),
        }
    }

    /// What is marked at `now`, and how strongly, 0 to 1.
    #[must_use]
    pub fn mark(&self, now: f64) -> (Cursor, f32) {
        (self.cursor, self.strength(now))
    }

    fn strength(&self, now: f64) -> f32 {
        (1.0 - (now - self.at) / FADE).clamp(0.0, 1.0) as f32
    }
}
