//! What has fallen so far: all of it, but while it is played.

use egui::Ui;

use super::super::context::ViewContext;
use bxdf_study::views::integral::Options;

/// The longest time that a patch takes to fall, in seconds.
const FALL: f64 = 0.7;

/// A patch falls for no larger a part of the whole than this.
const SHARE_OF_FALL: f64 = 0.25;

/// When playing began, by the clock of the frames.
#[derive(Default)]
struct Playing {
    begun: Option<f64>,
}

/// A moment of the play.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Moment {
    /// Since it began, in seconds; `None` where all has fallen.
    elapsed: Option<f64>,
    /// How long all of it takes, in seconds.
    seconds: f64,
}

impl Moment {
    /// All has fallen.
    #[cfg(test)]
    pub(super) const END: Self = Self {
        elapsed: None,
        seconds: 1.0,
    };

    /// Whether it is played.
    pub(super) fn is_playing(self) -> bool {
        self.elapsed.is_some()
    }

    /// How far the part at `index` of `total` has fallen: 0 before it falls, 1 on the disc.
    pub(super) fn fallen(self, index: usize, total: usize) -> f64 {
        let Some(elapsed) = self.elapsed else {
            return 1.0;
        };
        let fall = FALL.min(SHARE_OF_FALL * self.seconds);
        let begins = (self.seconds - fall) * index as f64 / total.max(1) as f64;
        ((elapsed - begins) / fall).clamp(0.0, 1.0)
    }

    /// How many of `total` parts lie on the disc.
    pub(super) fn counted(self, total: usize) -> usize {
        let is_down = |index: &usize| self.fallen(*index, total) >= 1.0;
        (0..total).take_while(is_down).count()
    }
}

/// The moment that this frame shows. Where there is a next one, it asks for it; pictures show the end.
pub(super) fn moment(ui: &Ui, cx: &mut ViewContext<'_, Options>) -> Moment {
    let seconds = cx.options.seconds;
    let is_picture = cx.state.is_picture;
    let now = ui.input(|input| input.time);
    let playing = cx.state.own::<Playing>(cx.view);
    let elapsed = playing.begun.map(|begun| now - begun);
    let elapsed = elapsed.filter(|elapsed| *elapsed < seconds && !is_picture);
    if elapsed.is_some() {
        ui.ctx().request_repaint();
    } else {
        playing.begun = None;
    }
    Moment { elapsed, seconds }
}

/// The button that begins and ends it.
pub(super) fn button(ui: &mut Ui, cx: &mut ViewContext<'_, Options>) {
    let now = ui.input(|input| input.time);
    let playing = cx.state.own::<Playing>(cx.view);
    let (name, hint) = if playing.begun.is_some() {
        ("Stop", "Show the finished sum")
    } else {
        ("Play", "Let the patches fall one by one")
    };
    if ui.button(name).on_hover_text(hint).clicked() {
        playing.begun = if playing.begun.is_some() {
            None
        } else {
            Some(now)
        };
        ui.ctx().request_repaint();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_fall_in_turn_and_all_have_fallen_in_the_end() {
        let at = |elapsed| Moment {
            elapsed: Some(elapsed),
            seconds: 8.0,
        };
        assert_eq!((at(0.0).counted(16), at(0.0).fallen(0, 16)), (0, 0.0));
        assert_eq!(at(8.0).counted(16), 16);
        let counts: Vec<usize> = (0..=80)
            .map(|t| at(f64::from(t) / 10.0).counted(16))
            .collect();
        assert!(counts.is_sorted() && counts[40] == 8, "{counts:?}");
        assert_eq!(Moment::END.counted(4096), 4096);
    }
}
