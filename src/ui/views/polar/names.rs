//! The names of the materials beside their curves, in a figure: nobody can point at a curve there.

use egui::{Align2, Pos2, Rect, Vec2};

use super::canvas::{Canvas, Plotted};
use super::radial::peak;
use crate::theme::Palette;
use crate::widgets::draw;
use crate::widgets::labels::{Labels, Place, Reach};
use bxdf_lab::analysis::polar::Point;
use bxdf_study::session::Session;

/// The most characters of a name; the title has more of it.
const LONGEST: usize = 24;

/// What a point of a curve keeps free about it, in points.
const CLEAR: f32 = 4.0;

/// Only every such point is looked at: curves have more points than that shows.
const EVERY: usize = 2;

impl Canvas<'_> {
    /// Writes the name of each material where its curve is longest, clear of all curves and of what is `taken`.
    pub(super) fn name_materials(
        &self,
        session: &Session,
        plotted: &[Plotted],
        taken: &[Rect],
        palette: &Palette,
    ) {
        let painter = self.painter();
        let font = draw::body_font(self.ui);
        let mut labels = Labels::within(self.transform.frame().shrink(2.0));
        taken.iter().for_each(|rect| labels.keep_off(*rect));
        for one in plotted {
            for at in self.curve(session, one).step_by(EVERY) {
                labels.keep_off(Rect::from_center_size(at, Vec2::splat(CLEAR)));
            }
        }
        let foot = self.position(0.0, 0.0);
        // The selected one is drawn last, and named first.
        for one in plotted.iter().rev() {
            let Some(entry) = session.materials.get(one.entry) else {
                continue;
            };
            let far = |at: &Pos2| at.distance(foot);
            let longest = self.curve(session, one);
            let Some(tip) = longest.max_by(|a, b| far(a).total_cmp(&far(b))) else {
                continue;
            };
            if peak(&one.section, session.shown_curves().channels()) <= 0.0 {
                continue;
            }
            let title = draw::clipped(&session.materials.title(entry), LONGEST);
            let color = palette.material(one.slot);
            let ink = palette.text_in(color);
            let galley = painter.layout_no_wrap(title.clone(), font.clone(), ink);
            let outwards = tip - foot;
            let Some(Place { rect, leader }) =
                labels.place(tip, galley.size(), outwards, Reach::Far)
            else {
                continue;
            };
            if let Some(ends) = leader {
                painter.line_segment(ends, (1.0, color));
            }
            let (at, anchor) = (rect.center(), Align2::CENTER_CENTER);
            draw::haloed_text(&painter, at, anchor, &title, font.clone(), ink, palette);
        }
    }

    /// Where the curves of a material lie.
    fn curve<'a>(
        &'a self,
        session: &'a Session,
        plotted: &'a Plotted,
    ) -> impl Iterator<Item = Pos2> + 'a {
        let points = plotted.section.upper.iter().chain(&plotted.section.lower);
        points.flat_map(move |point: &Point| {
            let channels = session.shown_curves().channels().iter();
            channels.map(move |channel| {
                let radius = plotted.radial.radius(channel.of(point.value));
                self.position(radius, point.angle)
            })
        })
    }
}
