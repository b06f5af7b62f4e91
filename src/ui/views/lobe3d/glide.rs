//! The camera on its way to a home view: a jump would lose which side is which.

use bxdf_study::session::OrbitCamera;

/// How long it takes, in seconds: long enough to be followed, too short to wait for.
const DURATION: f64 = 0.2;

/// Where the camera of a view is on its way.
#[derive(Default)]
pub(super) struct Glide {
    /// The camera last shown, and where it was to be.
    last: Option<(OrbitCamera, OrbitCamera)>,
    /// Where it began, and when, in seconds.
    start: Option<(OrbitCamera, f64)>,
}

impl Glide {
    /// What is shown at `now`, in seconds, where the session has `wanted`; and whether it is still on its way. It glides to home
    /// views only: elsewhere it follows the hand.
    pub(super) fn shown(&mut self, wanted: &OrbitCamera, now: f64) -> (OrbitCamera, bool) {
        if let Some((shown, last_wanted)) = &self.last
            && last_wanted != wanted
            && wanted.is_home()
        {
            self.start = Some((shown.clone(), now));
        }
        let part = |began: f64| ((now - began) / DURATION) as f32;
        let on_way = self
            .start
            .as_ref()
            .filter(|(_, began)| (0.0..1.0).contains(&part(*began)));
        let (shown, is_on_way) = match on_way {
            Some((from, began)) => (from.on_way_to(wanted, eased(part(*began))), true),
            None => (wanted.clone(), false),
        };
        if !is_on_way {
            self.start = None;
        }
        self.last = Some((shown.clone(), wanted.clone()));
        (shown, is_on_way)
    }
}

/// Slow at either end.
fn eased(t: f32) -> f32 {
    t * t * (3.0 - 2.0 * t)
}

#[cfg(test)]
mod tests {
    use super::*;
    use bxdf_study::session::HomeView;

    #[test]
    fn it_glides_home_and_follows_the_hand() {
        let mut glide = Glide::default();
        let [start, top] = [HomeView::ThreeQuarter, HomeView::Top].map(OrbitCamera::new);
        assert_eq!(
            glide.shown(&start, 1.0),
            (start.clone(), false),
            "nothing to see before it"
        );
        let mut turned = start.clone();
        turned.orbit([30.0, 0.0]);
        assert_eq!(glide.shown(&turned, 2.0), (turned.clone(), false));
        // From where it is, to where it is to be, without a jump at either end.
        assert_eq!(glide.shown(&top, 3.0), (turned.clone(), true));
        let (half, is_on_way) = glide.shown(&top, 3.1);
        assert!(is_on_way && (half.pitch() - 0.5 * (turned.pitch() + top.pitch())).abs() < 1e-3);
        assert_eq!(glide.shown(&top, 3.3), (top.clone(), false));
        assert_eq!(glide.shown(&top, 3.4), (top, false), "and rests");
    }
}
