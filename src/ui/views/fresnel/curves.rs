//! The charts of an interface.

use egui::Color32;

use crate::theme::{self, Dash, Palette};
use crate::widgets::chart::{Axis, Chart, Mark, Series};
use bxdf_lab::analysis::Channel;
use bxdf_lab::analysis::fresnel::{Curve, Fresnel, MarkKind, Point, Reflectances};
use bxdf_lab::spectral::{AtWavelength, OverWavelengths};
use bxdf_study::format;
use bxdf_study::session::PaletteIndex;
use bxdf_study::views::fresnel::Curves;

/// Above all that can be reflected there is room for the names of lines.
const TOP: f64 = 1.099;

/// What a chart is drawn with.
pub(super) struct Look<'a> {
    /// Where the colour of the material stands.
    pub slot: PaletteIndex,
    pub palette: &'a Palette,
    /// The colour of the held direction, and its name.
    pub held: Color32,
    pub held_name: &'a str,
    /// Which curves are shown.
    pub shown: Curves,
}

/// A kind of curve.
#[derive(Clone, Copy)]
pub(super) struct Kind {
    pub name: &'static str,
    pub of: fn(&Reflectances) -> f64,
    dash: Dash,
    width: f32,
    /// Whether it is an approximation of another one.
    is_approximate: bool,
}

impl Look<'_> {
    /// The kinds of curves that are shown.
    pub(super) fn kinds(&self) -> Vec<Kind> {
        let Curves {
            s,
            p,
            mean,
            schlick,
            lazanyi,
        } = self.shown;
        let kind = |name, of: fn(&Reflectances) -> f64, dash, width, is_approximate| Kind {
            name,
            of,
            dash,
            width,
            is_approximate,
        };
        let (thick, thin) = (theme::CURVE_WIDTH, theme::FRONT_WIDTH);
        let all = [
            (s, kind("s", |all| all.s, Dash::Dashed, thick, false)),
            (p, kind("p", |all| all.p, Dash::Dotted, thick, false)),
            (
                mean,
                kind("mean", Reflectances::mean, Dash::Solid, thick, false),
            ),
            (
                schlick,
                kind("Schlick", |all| all.schlick, Dash::Solid, thin, true),
            ),
            (
                lazanyi,
                kind("Lazanyi", |all| all.lazanyi, Dash::Dashed, thin, true),
            ),
        ];
        all.into_iter()
            .filter_map(|(is_shown, kind)| is_shown.then_some(kind))
            .collect()
    }

    /// The colour of a kind of curve of a channel.
    pub(super) fn color(&self, kind: Kind, channel: Option<Channel>) -> Color32 {
        match channel {
            None if kind.is_approximate => self.palette.faint_ink,
            channel => self.channel(channel),
        }
    }

    /// The colour of a channel, or of all light.
    pub(super) fn channel(&self, channel: Option<Channel>) -> Color32 {
        let channel = channel.unwrap_or(Channel::Luminance);
        self.palette.channel(channel, self.slot)
    }
}

/// A name with its channel before it.
fn named(channel: Option<Channel>, name: &str) -> String {
    match channel.and_then(Channel::symbol) {
        Some(symbol) => format!("{symbol} {name}"),
        None => name.to_owned(),
    }
}

/// The reflectances over the angle, with the angles that have names.
pub(super) fn over_angle(name: &str, fresnel: &Fresnel, look: &Look<'_>) -> Chart {
    let series = fresnel.curves.iter().flat_map(|curve| {
        look.kinds().into_iter().map(move |kind| {
            let point = |point: &Point| [point.theta_deg, (kind.of)(&point.reflectances)];
            Series {
                name: named(curve.channel, kind.name),
                color: look.color(kind, curve.channel),
                dash: kind.dash,
                width: kind.width,
                lines: vec![curve.points.iter().map(point).collect()],
            }
        })
    });
    let side = if fresnel.is_from_below {
        "below"
    } else {
        "above"
    };
    let x = Axis::degrees(format!("θ from {side} (degrees)"), [0.0, 90.0]);
    let mut chart = Chart::of(name, [x, y_axis()], series.collect());
    chart.marks = fresnel
        .curves
        .iter()
        .flat_map(|curve| marks(curve, look))
        .collect();
    chart.marks.push(Mark {
        name: format!("{} {}", look.held_name, format::degrees(fresnel.theta_deg)),
        at: fresnel.theta_deg,
        color: look.held,
        dash: Dash::Solid,
    });
    chart.has_labels = true;
    chart
}

/// The lines at the angles that have names.
fn marks(curve: &Curve, look: &Look<'_>) -> impl Iterator<Item = Mark> {
    curve.marks.iter().map(move |mark| {
        let name = match mark.kind {
            MarkKind::Brewster => "Brewster",
            MarkKind::Critical => "critical",
            MarkKind::LeastP => "least p",
        };
        let color = match curve.channel {
            None => look.palette.ink,
            channel => look.channel(channel),
        };
        Mark {
            name: format!("{} {:.2}°", named(curve.channel, name), mark.theta_deg),
            at: mark.theta_deg,
            color,
            dash: Dash::Dashed,
        }
    })
}

/// The reflectances over the wavelength at the angle held, and the least of p polarised light at any angle.
pub(super) fn over_wavelength(name: &str, all: &OverWavelengths, look: &Look<'_>) -> Chart {
    let line = |of: &dyn Fn(&AtWavelength) -> Option<f64>| {
        let points = all.points.iter();
        points
            .filter_map(|point| Some([point.nm, of(point)?]))
            .collect()
    };
    let mut series: Vec<Series> = look
        .kinds()
        .into_iter()
        .map(|kind| Series {
            name: kind.name.to_owned(),
            color: look.color(kind, None),
            dash: kind.dash,
            width: kind.width,
            lines: vec![line(&|point| Some((kind.of)(&point.reflectances)))],
        })
        .collect();
    if look.shown.p {
        let angles = || all.points.iter().filter_map(|point| point.least_p);
        let ends = [f64::min as fn(f64, f64) -> f64, f64::max]
            .map(|end| angles().map(|[angle, _]| angle).reduce(end));
        let at = match ends {
            [Some(low), Some(high)] => format!(", at {low:.1} to {high:.1}°"),
            _ => String::new(),
        };
        series.push(Series {
            name: format!("least p{at}"),
            color: look.palette.mirror,
            dash: Dash::Dotted,
            width: theme::CURVE_WIDTH,
            lines: vec![line(&|point| point.least_p.map(|[_, share]| share))],
        });
    }
    let ends = [all.points.first(), all.points.last()];
    let ends = ends.map(|end| end.map_or(0.0, |point| point.nm));
    let x = Axis::linear(
        format!("wavelength (nm), at θ {}", format::degrees(all.theta_deg)),
        ends,
    );
    let mut chart = Chart::of(name, [x, y_axis()], series);
    chart.has_labels = true;
    chart
}

fn y_axis() -> Axis {
    Axis::linear("reflectance", [0.0, TOP])
}
