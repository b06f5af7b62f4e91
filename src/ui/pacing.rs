//! The events of a frame, paced so that each is judged where it happened.
//!
//! egui asks once a frame what lies under the pointer, and asks at the place where the pointer was last: of a press and a far
//! move within one frame, the press would meet what lies at the end of the move. Keys are handed out once a frame, too: what is
//! typed right behind a click would go to what had the focus before. So a frame gets its events only up to where one of
//! them depends on what the ones before do; the rest, in order, waits for the next frame.

use std::collections::VecDeque;

use egui::{Event, Pos2};

/// A move no longer than this, in points, is no drag: egui takes a press and a release so near to each other for a click.
const CLICK_DISTANCE: f32 = 6.0;

/// The events that wait for a later frame.
#[derive(Debug, Default)]
pub struct Pacing {
    waiting: VecDeque<Event>,
    /// How many events were handed out last, while it is not known that a frame took them.
    handed_out: usize,
    /// Where the button went down that is held, if one is.
    pressed_at: Option<Pos2>,
}

/// What a frame has been handed so far.
#[derive(Default)]
struct Handed {
    is_button: bool,
    /// A move with the button held, too far to be part of a click.
    is_far_move: bool,
    /// A key that types nothing: it may move the focus, or open a field.
    is_other_key: bool,
}

impl Pacing {
    /// Leaves in `events` what the next frame is to see, and keeps what must wait.
    pub fn pace(&mut self, events: &mut Vec<Event>) {
        // What no frame has taken since comes first again.
        let new = events.split_off(self.handed_out.min(events.len()));
        self.waiting.extend(new);
        if events.is_empty() {
            let mut handed = Handed::default();
            while let Some(event) = self.next(&mut handed) {
                events.push(event);
            }
        }
        self.handed_out = events.len();
    }

    /// To be called by the frame that takes what was handed out.
    pub fn take(&mut self) {
        self.handed_out = 0;
    }

    /// Whether something waits for the next frame.
    #[must_use]
    pub fn is_waiting(&self) -> bool {
        !self.waiting.is_empty()
    }

    /// The next event, if it may come in the same frame as those before it.
    fn next(&mut self, handed: &mut Handed) -> Option<Event> {
        let is_text = matches!(self.waiting.get(1), Some(Event::Text(_)));
        // What is typed goes to what has the focus, which these may move.
        let must_wait = handed.is_button || handed.is_other_key;
        match self.waiting.front()? {
            Event::PointerMoved(_) | Event::PointerGone if handed.is_button => return None,
            Event::PointerMoved(place) => {
                let is_far = |from: Pos2| from.distance(*place) > CLICK_DISTANCE;
                handed.is_far_move |= self.pressed_at.is_some_and(is_far);
            }
            // What is dragged must see the end of the move before it is let go.
            Event::PointerButton { pressed: false, .. } if handed.is_far_move => return None,
            Event::PointerButton { pos, pressed, .. } => {
                handed.is_button = true;
                self.pressed_at = pressed.then_some(*pos);
            }
            Event::Key { pressed: true, .. } if is_text && must_wait => return None,
            Event::Key { pressed: true, .. } if is_text => {}
            Event::Key { pressed: true, .. } => {
                if handed.is_button {
                    return None;
                }
                handed.is_other_key = true;
            }
            Event::Text(_) | Event::Paste(_) | Event::Ime(_) if must_wait => return None,
            _ => {}
        }
        self.waiting.pop_front()
    }
}

#[cfg(test)]
mod tests {
    use egui::{Key, Modifiers, PointerButton, pos2};

    use super::*;

    fn moved(x: f32) -> Event {
        Event::PointerMoved(pos2(x, 0.0))
    }

    fn button(x: f32, pressed: bool) -> Event {
        Event::PointerButton {
            pos: pos2(x, 0.0),
            button: PointerButton::Primary,
            pressed,
            modifiers: Modifiers::NONE,
        }
    }

    fn key(key: Key, modifiers: Modifiers) -> Event {
        Event::Key {
            key,
            physical_key: None,
            pressed: true,
            repeat: false,
            modifiers,
        }
    }

    fn typed(letter: Key) -> [Event; 2] {
        let text = letter.name().to_lowercase();
        [key(letter, Modifiers::NONE), Event::Text(text)]
    }

    /// What the frames get that follow, until nothing waits, if all of `events` come at once.
    fn frames(events: &[Event]) -> Vec<Vec<Event>> {
        let mut pacing = Pacing::default();
        let (mut frames, mut next) = (Vec::new(), events.to_vec());
        loop {
            pacing.pace(&mut next);
            pacing.take();
            frames.push(std::mem::take(&mut next));
            if !pacing.is_waiting() {
                let in_order: Vec<Event> = frames.iter().flatten().cloned().collect();
                assert_eq!(in_order, events, "nothing is lost, and the order stays");
                return frames;
            }
        }
    }

    fn lengths(events: &[Event]) -> Vec<usize> {
        frames(events).iter().map(Vec::len).collect()
    }

    #[test]
    fn a_press_is_judged_where_it_happened_and_a_release_after_the_move() {
        for far in [8.0, 20.0, 60.0] {
            let (press, drag) = (button(0.0, true), moved(far));
            let release = button(far, false);
            let all = [moved(0.0), press, drag.clone(), release];
            assert_eq!(lengths(&all), [2, 1, 1]);
            // Moves on the way may come together: the last one counts.
            let [hover, press, drag, release] = all;
            let halfway = moved(0.5 * far);
            assert_eq!(lengths(&[hover, press, halfway, drag, release]), [2, 2, 1]);
        }
    }

    #[test]
    fn a_click_is_followed_by_no_move_in_its_frame() {
        let click = [button(0.0, true), button(0.0, false)];
        let [press, release] = click.clone();
        assert_eq!(lengths(&[press, release, moved(60.0)]), [2, 1]);
        // Where the pointer comes from is nothing to a click: its release does not wait, for frames may be slow, and what
        // takes long is no click.
        let [press, release] = click.clone();
        assert_eq!(lengths(&[moved(-300.0), moved(0.0), press, release]), [4]);
        // A double click stays in one frame: it is told by the time between its clicks.
        assert_eq!(lengths(&[click.clone(), click].concat()), [4]);
        // A hand that trembles costs it no more frames than it must.
        let trembling = [button(0.0, true), moved(2.0), button(2.0, false)];
        assert_eq!(lengths(&trembling), [1, 2]);
    }

    #[test]
    fn a_long_drag_keeps_its_last_move() {
        let mut pacing = Pacing::default();
        for mut frame in [vec![button(0.0, true)], vec![moved(50.0)]] {
            pacing.pace(&mut frame);
            pacing.take();
            assert_eq!(frame.len(), 1);
        }
        let mut last = vec![moved(90.0), button(90.0, false)];
        pacing.pace(&mut last);
        assert_eq!(last, [moved(90.0)]);
        assert!(pacing.is_waiting());
    }

    #[test]
    fn what_is_typed_waits_for_the_focus_to_be_settled() {
        let (a, b) = (typed(Key::A), typed(Key::B));
        let both = [a.clone(), b].concat();
        assert_eq!(lengths(&both), [4], "typing on is one frame");
        let after = |first: Event| lengths(&[vec![first], both.clone()].concat());
        assert_eq!(after(button(0.0, false)), [1, 4]);
        assert_eq!(after(key(Key::M, Modifiers::COMMAND)), [1, 4]);
        assert_eq!(after(key(Key::Tab, Modifiers::NONE)), [1, 4]);
        // A key that types nothing waits for a click, but not for others of its kind: held, it repeats.
        let arrow = key(Key::ArrowDown, Modifiers::NONE);
        assert_eq!(lengths(&[button(0.0, false), arrow.clone()]), [1, 1]);
        assert_eq!(lengths(&[arrow.clone(), arrow.clone(), arrow]), [3]);
    }

    #[test]
    fn new_events_come_after_those_that_wait() {
        let mut pacing = Pacing::default();
        let mut frame = vec![button(0.0, true), moved(20.0), button(20.0, false)];
        pacing.pace(&mut frame);
        // No frame took it, as where the window is covered: it is handed out again, before what is new.
        frame.push(moved(99.0));
        pacing.pace(&mut frame);
        assert_eq!(frame, [button(0.0, true)]);
        pacing.take();
        let mut next = Vec::new();
        pacing.pace(&mut next);
        assert_eq!(next, [moved(20.0)]);
        pacing.take();
        next = vec![moved(120.0)];
        pacing.pace(&mut next);
        assert_eq!(next, [button(20.0, false)]);
        pacing.take();
        next.clear();
        pacing.pace(&mut next);
        assert_eq!(next, [moved(99.0), moved(120.0)]);
        assert!(!pacing.is_waiting());
    }
}
