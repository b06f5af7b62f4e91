//! Whether a number is on the move: it changes while something is being dragged, its own field or another control.

/// What is known of a value between frames.
#[derive(Clone, Default)]
pub(super) struct Moving {
    last: Option<u64>,
    is_on_way: bool,
}

impl Moving {
    /// Takes note of the value in this frame, and of whether something is being dragged.
    pub(super) fn note(&mut self, value: f64, is_dragging: bool) {
        let last = self.last.replace(value.to_bits());
        let has_changed = last.is_some_and(|last| last != value.to_bits());
        self.is_on_way = is_dragging && (self.is_on_way || has_changed);
    }

    /// Whether the value has changed since the drag began that goes on.
    pub(super) fn is_on_way(&self) -> bool {
        self.is_on_way
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_drag_changes_moves_until_it_ends() {
        let mut moving = Moving::default();
        for (value, is_dragging, is_on_way) in [
            (1.0, false, false),
            (2.0, false, false),
            (2.0, true, false),
            (2.5, true, true),
            (2.5, true, true),
            (2.5, false, false),
            (2.5, true, false),
        ] {
            moving.note(value, is_dragging);
            assert_eq!(moving.is_on_way(), is_on_way, "{value} {is_dragging}");
        }
    }
}
