//! The names of the materials beside their curves, in a figure: nobody can point at a curve there.

use std::f64::consts::FRAC_PI_2;

use egui::{Align2, Pos2, Rect, Vec2};

use super::super::context::ViewContext;
use super::canvas::{Canvas, Plotted};
use super::radial::peak;
use crate::widgets::labels::{Labels, Place, Reach};
use crate::widgets::{draw, handle};
use bxdf_lab::analysis::polar::{Point, signed_angle};
use bxdf_study::session::Session;
use bxdf_study::views::polar::Options;

/// The most characters of a name; the title has more of it.
const LONGEST: usize = 24;

/// What a point of a curve keeps free about it, in points.
const CLEAR: Vec2 = Vec2::splat(4.0);

/// The points of a straight line that are looked at.
const STEPS: u8 = 40;

/// Only every such point is looked at: curves have more points than that shows.
const EVERY: usize = 2;

impl Canvas<'_> {
    /// In a figure of several materials: writes the name of each material where its curve is longest, clear of all curves and directions and of what is `taken`.
    pub(super) fn name_materials(
        &self,
        cx: &ViewContext<'_, Options>,
        plotted: &[Plotted],
        taken: Vec<Rect>,
    ) {
        if !cx.state.is_figure() || plotted.len() < 2 {
            return;
        }
        let (session, palette) = (&*cx.session, cx.palette);
        let painter = self.painter();
        let font = draw::body_font(self.ui);
        let mut labels = Labels::within(self.transform.frame().shrink(2.0));
        for rect in taken {
            labels.keep_off(rect);
        }
        let mut keep_off = |at: Pos2| labels.keep_off(Rect::from_center_size(at, CLEAR));
        for one in plotted {
            self.curve(session, one)
                .step_by(EVERY)
                .for_each(&mut keep_off);
        }
        let azimuth = cx.options.own_section_deg.of(session).phi();
        let directions = cx.directions();
        let angles = directions
            .iter()
            .map(|one| signed_angle(one.direction, azimuth));
        for angle in angles.chain([0.0, FRAC_PI_2, -FRAC_PI_2]) {
            let radii = (0..=STEPS).map(|step| f64::from(step) / f64::from(STEPS));
            radii.for_each(|radius| keep_off(self.position(radius, angle)));
        }
        for one in &directions {
            let tip = self.position(1.0, signed_angle(one.direction, azimuth));
            labels.keep_off(handle::room(tip));
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
