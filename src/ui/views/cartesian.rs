//! The Cartesian plot: f over an angle.

use egui::{Align2, Ui};

use super::context::ViewContext;
use super::{kept_scale, settings};
use crate::theme::{self, Dash, Palette};
use crate::widgets::chart::{Axis, Chart, Series, Shown, Stem};
use crate::widgets::legend::Swatch;
use crate::widgets::{choice, draw};
use bxdf::Side;
use bxdf_lab::analysis::cartesian::{self, Abscissa, Curve};
use bxdf_lab::analysis::deltas::Arrows;
use bxdf_lab::analysis::half_difference::half_difference;
use bxdf_lab::analysis::lobe::Arrow;
use bxdf_lab::analysis::{Channel, HeldLobe, RadialScale, polar};
use bxdf_study::cursor::Cursor;
use bxdf_study::format;
use bxdf_study::session::{MaterialEntry, Session};
use bxdf_study::views::cartesian::{FIXED_ANGLE, Options};

pub(super) fn show(ui: &mut Ui, cx: &mut ViewContext<'_, Options>) {
    let plotted = plotted(cx);
    let (wanted, scale) = (plotted.reach(), cx.options.scale);
    let full = kept_scale::full(ui, cx, scale, None, wanted);
    // Over their peaks all reach as high as they can.
    let lockable = (wanted > 0.0 && !scale.is_each_to_peak).then_some(full);
    settings::row(ui, cx, |ui, cx| controls(ui, cx, lockable));
    cx.legend(ui, Swatch::Line);
    if let Some(note) = bxdf_study::export::nothing_to_show(cx.session) {
        draw::centred_note(ui, note);
        return;
    }
    let chart = chart(cx, plotted, full);
    let shown = chart.show(ui, None, cx.palette);
    cx.lacks(shown.lacking());
    if let Some(note) = note(cx) {
        let (place, font) = (shown.frame().left_bottom(), draw::small_font(ui));
        let painter = ui.painter_at(shown.frame());
        let (ink, place) = (cx.palette.ink, place + egui::vec2(6.0, -4.0));
        draw::haloed_text(
            &painter,
            place,
            Align2::LEFT_BOTTOM,
            note,
            font,
            ink,
            cx.palette,
        );
    }
    match cx.options.abscissa {
        Abscissa::Free => point_at_direction(ui, cx, &chart, &shown),
        Abscissa::Half | Abscissa::Difference => point_at_pair(ui, cx, &chart, &shown),
    }
}

/// `full`: the largest value that the axis has room for now, where it can be kept.
fn controls(ui: &mut Ui, cx: &mut ViewContext<'_, Options>, full: Option<f64>) {
    let mut options = *cx.options;
    let hint = "Over which angle f is drawn: the free direction's in the section, or the angles of half vector and difference";
    choice::choice(
        ui,
        ("Over", hint),
        &mut options.abscissa,
        &Abscissa::ALL,
        Abscissa::title,
    );
    match options.abscissa {
        Abscissa::Free => {}
        Abscissa::Half => {
            let hint = "The angle between the light and the half vector, held fixed";
            choice::angle(ui, ("at θd", hint), &mut options.fixed_deg, &FIXED_ANGLE);
        }
        Abscissa::Difference => {
            let hint = "The angle between n and the half vector, held fixed";
            choice::angle(ui, ("at θh", hint), &mut options.fixed_deg, &FIXED_ANGLE);
        }
    }
    settings::scale(ui, cx, &mut options.scale, full);
    let hint = "The value minus that of the reference material";
    choice::switch(ui, ("Difference", hint), &mut options.is_residual);
    if options.is_residual {
        super::context::reference_choice(ui, &mut cx.session.materials);
    }
    *cx.options = options;
    settings::cosine(ui, cx);
    if options.abscissa == Abscissa::Free {
        settings::section(ui, cx);
    }
    settings::curves(ui, cx);
}

/// Why there are fewer deltas than one might expect.
fn note(cx: &mut ViewContext<'_, Options>) -> Option<&'static str> {
    let (session, answers) = (&*cx.session, &mut *cx.answers);
    if cx.options.abscissa == Abscissa::Free {
        return None;
    }
    let crosses = |arrow: &Arrow| arrow.side == Side::Transmission;
    let mut shown = session.materials.shown();
    let has_one = shown.any(|entry| answers.ask(session, entry, Arrows).iter().any(crosses));
    has_one.then_some("Deltas that cross the surface have no half vector: they are not shown here")
}

/// What every material has to show.
struct Plotted {
    series: Vec<Series>,
    stems: Vec<Stem>,
    /// The least value, or 0, and the largest one, or 0.
    ends: [f64; 2],
}

impl Plotted {
    /// How far its values go from 0.
    fn reach(&self) -> f64 {
        let [least, largest] = self.ends;
        largest.max(-least)
    }
}

/// The curves and deltas of every material shown.
fn plotted(cx: &mut ViewContext<'_, Options>) -> Plotted {
    let (session, answers, palette) = (&*cx.session, &mut *cx.answers, cx.palette);
    let options = *cx.options;
    let request = options.request(session);
    let reference = options.is_residual.then(|| session.materials.reference());
    let (mut series, mut stems) = (Vec::new(), Vec::new());
    let outside = match options.abscissa {
        Abscissa::Difference => ", at θh 0°",
        Abscissa::Free | Abscissa::Half => super::context::OUTSIDE_SECTION,
    };
    for entry in session.materials.shown() {
        let curve = answers.compare(session, entry, reference, request);
        let (title, color) = (
            session.materials.title(entry),
            palette.material(entry.slot()),
        );
        let own = curve.stems.iter();
        stems.extend(own.map(|stem| super::context::chart_stem(stem, &title, color, outside)));
        for channel in session.shown_curves().channels() {
            series.push(line((session, &options), entry, &curve, *channel, palette));
        }
    }
    let values = || {
        series
            .iter()
            .flat_map(|one| one.lines.iter().flatten())
            .map(|[_, y]| *y)
    };
    let ends = [values().fold(0.0, f64::min), values().fold(0.0, f64::max)];
    Plotted {
        series,
        stems,
        ends,
    }
}

/// The chart of them, with an axis that has room for values that go as far as `full` from 0.
fn chart(cx: &ViewContext<'_, Options>, plotted: Plotted, full: f64) -> Chart {
    let (session, palette, options) = (&*cx.session, cx.palette, *cx.options);
    let reach = plotted.reach();
    let Plotted {
        series,
        stems,
        ends,
    } = plotted;
    let zoom = if reach > 0.0 { full / reach } else { 1.0 };
    let [mut least, largest] = ends.map(|end| end * zoom);
    let y = if least == largest && !stems.is_empty() {
        super::context::share_axis(stems.iter().map(|stem| stem.share))
    } else {
        // Room for stems that go down.
        let lowest = stems.iter().map(|stem| stem.share).fold(0.0, f64::min);
        least = least.min(lowest * largest.max(-least));
        let decades = match options.request(session).scale {
            RadialScale::Linear => None,
            RadialScale::Logarithmic { decades } => Some(decades),
        };
        let axis = Axis::of_values(options.quantity(session), [least, largest], decades);
        // What leaves a scale that stays is cut off.
        Axis {
            is_cut: true,
            ..axis
        }
    };
    let mut chart = Chart::of("Cartesian plot", [x_axis(session, &options), y], series);
    chart.stems = stems;
    chart.has_labels = cx.state.is_figure() && session.materials.is_overlay();
    if options.abscissa == Abscissa::Free {
        chart.marks =
            super::context::section_marks(session, options.own_section_deg.of(session), palette);
    }
    chart
}

/// One curve of a material.
fn line(
    (session, options): (&Session, &Options),
    entry: &MaterialEntry,
    curve: &Curve,
    channel: Channel,
    palette: &Palette,
) -> Series {
    let shown = |point: &cartesian::Point| [point.x_deg, channel.of(point.value)];
    let mut lines: Vec<Vec<[f64; 2]>> = curve
        .lines
        .iter()
        .map(|line| line.iter().map(shown).collect())
        .collect();
    if options.scale.is_each_to_peak {
        let values = lines.iter().flatten().map(|[_, y]| y.abs());
        let peak = values.fold(0.0, f64::max);
        if peak > 0.0 {
            lines.iter_mut().flatten().for_each(|[_, y]| *y /= peak);
        }
    }
    let title = session.materials.title(entry);
    Series {
        name: match channel.symbol() {
            Some(symbol) => format!("{title} {symbol}"),
            None => title,
        },
        color: palette.channel(channel, entry.slot()),
        dash: Dash::of_channel(channel, entry.slot()),
        width: theme::CURVE_WIDTH,
        lines,
    }
}

/// The axis to the right.
fn x_axis(session: &Session, options: &Options) -> Axis {
    let fixed = format::degrees(options.fixed_deg);
    match options.abscissa {
        Abscissa::Free => {
            let end = if session.shows_lower_half() {
                180.0
            } else {
                90.0
            };
            let free = session.free_name();
            let azimuth = format::degrees(options.own_section_deg.of(session).azimuth_deg);
            let name = format!("θ of the {free} in the section at azimuth {azimuth} (degrees)");
            Axis::degrees(name, [-end, end]).or_short(format!("θ of the {free} (degrees)"))
        }
        Abscissa::Half => {
            let name = format!("θh, the half vector's angle from n, at θd {fixed} (degrees)");
            Axis::degrees(name, [0.0, 90.0]).or_short("θh (degrees)")
        }
        Abscissa::Difference => {
            let name =
                format!("θd, the light's angle from the half vector, at θh {fixed} (degrees)");
            Axis::degrees(name, [0.0, 90.0]).or_short("θd (degrees)")
        }
    }
}

/// The pointer over angles of the free direction points at it; elsewhere the direction pointed at is marked.
fn point_at_direction(ui: &Ui, cx: &mut ViewContext<'_, Options>, chart: &Chart, shown: &Shown) {
    let azimuth = cx.options.own_section_deg.of(cx.session).phi();
    let pointed = chart.pointed(shown).filter(|[x, _]| x.abs() <= 180.0);
    let Some([x, _]) = pointed else {
        if let Some((cursor, strength)) = &cx.mark {
            let x = polar::signed_angle(cursor.direction, azimuth).to_degrees();
            chart.mark(ui, shown, x, (cx.palette, *strength));
        }
        return;
    };
    let heading = format!("θ {}", format::degrees(x));
    chart.read_out(ui, shown, x, &heading, cx.palette);
    *cx.pointed = Some(Cursor {
        material: cx.session.materials.selected().id(),
        direction: polar::direction(x.to_radians(), azimuth),
    });
}

/// Over half and difference angles a click holds the pair of directions that has them.
fn point_at_pair(ui: &Ui, cx: &mut ViewContext<'_, Options>, chart: &Chart, shown: &Shown) {
    let request = cx.options.request(cx.session);
    let (wo, wi) = cx.pair();
    let place = half_difference(wo, wi);
    let Some([x, _]) = chart
        .pointed(shown)
        .filter(|[x, _]| (0.0..=90.0).contains(x))
    else {
        if let Some(pair) = place {
            let x = match request.abscissa {
                Abscissa::Difference => pair.difference.theta_deg,
                _ => pair.half.theta_deg,
            };
            chart.mark(ui, shown, x, (cx.palette, 1.0));
        }
        return;
    };
    let heading = format!("{} {}", request.abscissa.title(), format::degrees(x));
    chart.read_out(ui, shown, x, &heading, cx.palette);
    if shown.response.clicked() {
        let session = &*cx.session;
        let surface = cx.answers.surface(session, session.materials.selected());
        let lobe = HeldLobe::new(&*surface.bxdf, session.hold, session.held());
        let (wo, wi) = request.pair_at(&lobe, x);
        cx.hold_pair(wo, wi);
    }
}
