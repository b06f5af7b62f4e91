//! The decomposition: what a value is made of, its lobes or the factors of a microfacet model.

use std::sync::Arc;

use egui::{Color32, Rect, Ui, UiBuilder};

use super::context::ViewContext;
use super::settings;
use crate::theme::{self, Dash, Palette};
use crate::widgets::chart::{self, Axis, Band, Chart, Series};
use crate::widgets::legend::Swatch;
use crate::widgets::{choice, draw, pictures};
use bxdf::{Category, Lobe};
use bxdf_lab::analysis::decomposition::{Decomposition, Factors};
use bxdf_lab::analysis::{Channel, deltas, polar};
use bxdf_study::cursor::Cursor;
use bxdf_study::format;
use bxdf_study::session::{EntryId, Session};
use bxdf_study::views::decomposition::{Decomposed, Options};
use bxdf_study::views::{DECADES, value_of_f};

/// Width over height of the charts of several materials.
const ASPECT: f32 = 1.5;

/// Smaller charts have room for their curves only, in points.
const ROOM_FOR_WORDS: egui::Vec2 = egui::vec2(230.0, 150.0);

/// In a figure, where no pointer reads them out: charts of a smaller area, in square points.
const AREA_FOR_WORDS: f32 = 24_000.0;

/// The names of the factors at the screen: D is shown over its peak, which differs by orders of magnitude.
const FACTORS: [&str; 3] = ["D over its peak", "G", "F"];

pub(super) fn show(ui: &mut Ui, cx: &mut ViewContext<'_, Options>) {
    settings::show(ui, cx, |ui, cx| controls(ui, cx.options));
    if let Some(note) = bxdf_study::export::nothing_to_show(cx.session) {
        draw::centred_note(ui, note);
        return;
    }
    match cx.options.into {
        Decomposed::Lobes => show_lobes(ui, cx),
        Decomposed::Factors => show_factors(ui, cx),
    }
}

fn controls(ui: &mut Ui, options: &mut Options) {
    ui.horizontal_wrapped(|ui| {
        let hint = "Lobes sum to the value; D, G and F are the factors of microfacet models";
        choice::choice(
            ui,
            ("Into", hint),
            &mut options.into,
            Decomposed::ALL,
            Decomposed::title,
        );
        if options.into == Decomposed::Lobes {
            let hint = "Lobes stacked: the top line is their sum";
            choice::switch(ui, ("Stacked", hint), &mut options.is_stacked);
            let hint = "A logarithmic scale: decades below the highest value";
            choice::switch_if(
                !options.is_stacked,
                ui,
                ("By decades", hint),
                &mut options.is_logarithmic,
            );
        }
    });
}

/// The parts of each material shown.
fn parts(cx: &mut ViewContext<'_, Options>) -> Vec<(EntryId, Arc<Decomposition>)> {
    let (session, answers) = (&*cx.session, &mut *cx.answers);
    let request = cx.options.request(session);
    let shown = session.materials.shown();
    shown
        .map(|entry| (entry.id(), answers.ask(session, entry, request)))
        .collect()
}

/// A chart of its lobes for each material.
fn show_lobes(ui: &mut Ui, cx: &mut ViewContext<'_, Options>) {
    let parts = parts(cx);
    let room = ui.available_rect_before_wrap();
    let aspect = if parts.len() > 1 {
        ASPECT
    } else {
        room.aspect_ratio()
    };
    let is_figure = cx.state.is_figure();
    let cells = if is_figure {
        pictures::cells_of_charts(ui, room, parts.len())
    } else {
        pictures::cells(ui, room, parts.len(), aspect)
    };
    let has_room = |picture: Rect| {
        if is_figure {
            picture.area() >= AREA_FOR_WORDS
        } else {
            picture.size().min(ROOM_FOR_WORDS) == ROOM_FOR_WORDS
        }
    };
    for (cell, (entry, decomposition)) in cells.into_iter().zip(&parts) {
        let name = pictures::title(ui, cell, *entry, cx.session, cx.palette);
        let mut chart = lobes_chart(&name, decomposition, (cx.session, cx.options), cx.palette);
        if !has_room(cell.picture) {
            chart.leave_out_words();
        }
        show_chart(ui, cx, (&chart, cell.picture), *entry);
    }
    ui.advance_cursor_after_rect(room);
}

/// One chart of the factors of all materials.
fn show_factors(ui: &mut Ui, cx: &mut ViewContext<'_, Options>) {
    cx.legend(ui, Swatch::Patch);
    let parts = parts(cx);
    let mut series = Vec::new();
    for (entry, decomposition) in &parts {
        let named = cx.session.materials.get(*entry);
        if let (Some(entry), Some(factors)) = (named, &decomposition.factors) {
            let name = if parts.len() > 1 {
                cx.session.materials.title(entry) + " "
            } else {
                String::new()
            };
            let color = cx.palette.material(entry.slot());
            series.extend(factor_lines(&name, decomposition, factors, color));
        }
    }
    if series.is_empty() {
        draw::centred_note(
            ui,
            "No microfacet model among them: only those have D, G and F",
        );
        return;
    }
    let y = Axis::of_values("share", [0.0, 1.0], None);
    let x = x_axis(cx.session, parts.iter().map(|(_, parts)| &**parts));
    let mut chart = Chart::of("Factors", [x, y], series);
    chart.marks = super::context::section_marks(
        cx.session,
        cx.options.own_section_deg.of(cx.session),
        cx.palette,
    );
    chart.has_names = true;
    let room = ui.available_rect_before_wrap();
    let selected = cx.session.materials.selected().id();
    show_chart(ui, cx, (&chart, room), selected);
    ui.advance_cursor_after_rect(room);
}

/// Draws a chart over the free direction's angle into `room`; the pointer points at a direction of material `entry`.
fn show_chart(
    ui: &mut Ui,
    cx: &mut ViewContext<'_, Options>,
    (chart, room): (&Chart, Rect),
    entry: EntryId,
) {
    let shown = ui
        .scope_builder(UiBuilder::new().max_rect(room).id_salt(entry), |ui| {
            chart.show(ui, Some(room.height()), cx.palette)
        })
        .inner;
    cx.lacks(shown.lacking());
    let azimuth = cx.options.own_section_deg.of(cx.session).phi();
    if let Some([x, _]) = chart.pointed(&shown).filter(|[x, _]| x.abs() <= 180.0) {
        chart.read_out(
            ui,
            &shown,
            x,
            &format!("θ {}", format::degrees(x)),
            cx.palette,
        );
        *cx.pointed = Some(Cursor {
            material: entry,
            direction: polar::direction(x.to_radians(), azimuth),
        });
    } else if let Some((cursor, strength)) = &cx.mark {
        let x = polar::signed_angle(cursor.direction, azimuth).to_degrees();
        chart.mark(ui, &shown, x, (cx.palette, *strength));
    }
}

/// The lobes of a material, stacked or as curves.
fn lobes_chart(
    name: &str,
    decomposition: &Decomposition,
    (session, options): (&Session, &Options),
    palette: &Palette,
) -> Chart {
    let angles = &decomposition.angles_deg;
    let mut below = vec![0.0; angles.len()];
    let (mut series, mut bands) = (Vec::new(), Vec::new());
    for (index, part) in decomposition.lobes.iter().enumerate() {
        let values: Vec<f64> = part
            .values
            .iter()
            .map(|rgb| Channel::Luminance.of(*rgb))
            .collect();
        let color = palette.category(part.lobe.category);
        let top: Vec<f64> = if options.is_stacked {
            values
                .iter()
                .zip(&below)
                .map(|(value, below)| value + below)
                .collect()
        } else {
            values
        };
        if options.is_stacked {
            let points = angles.iter().zip(&below).zip(&top);
            bands.push(Band {
                name: lobe_name(&part.lobe),
                color,
                points: points.map(|((x, low), high)| [*x, *low, *high]).collect(),
            });
        }
        series.push(Series {
            name: lobe_name(&part.lobe),
            color,
            dash: Dash::of_part(index),
            width: theme::CURVE_WIDTH,
            lines: pieces(angles, &top),
        });
        if options.is_stacked {
            below = top;
        }
    }
    let highest = series
        .iter()
        .flat_map(|one| one.lines.iter().flatten())
        .map(|[_, y]| *y);
    let highest = highest.fold(0.0, f64::max);
    let stems: Vec<_> = decomposition
        .stems
        .iter()
        .map(delta_stem(palette))
        .collect();
    let decades = (options.is_logarithmic && !options.is_stacked).then_some(DECADES);
    let quantity = value_of_f(session);
    let y = if highest == 0.0 && !stems.is_empty() {
        super::context::share_axis(stems.iter().map(|stem| stem.share))
    } else {
        Axis::of_values(quantity, [0.0, highest], decades)
    };
    let x = x_axis(session, std::iter::once(decomposition));
    let mut chart = Chart::of(name, [x, y], series);
    chart.bands = bands;
    chart.stems = stems;
    chart.marks =
        super::context::section_marks(session, options.own_section_deg.of(session), palette);
    chart.has_names = true;
    chart
}

/// A lobe that is a delta.
fn delta_stem(palette: &Palette) -> impl Fn(&deltas::Stem) -> chart::Stem {
    let color = palette.category(Category::PerfectSpecular);
    move |stem| {
        let lobe = Lobe {
            category: Category::PerfectSpecular,
            side: stem.side,
            name: "",
        };
        let of = lobe_name(&lobe);
        let stem = super::context::chart_stem(stem, &of, color, super::context::OUTSIDE_SECTION);
        chart::Stem {
            name: format!("{of}: {}", stem.name),
            ..stem
        }
    }
}

/// The axis of the free direction's angle.
fn x_axis<'a>(session: &Session, mut parts: impl Iterator<Item = &'a Decomposition>) -> Axis {
    let reaches_below = |parts: &Decomposition| {
        let is_below = |stem: &deltas::Stem| stem.x_deg.abs() > 90.0;
        let ends = parts.angles_deg.first();
        ends.is_some_and(|x| *x < -90.0) || parts.stems.iter().any(is_below)
    };
    let end = if parts.any(reaches_below) {
        180.0
    } else {
        90.0
    };
    Axis::degrees(
        format!("θ of the {} (degrees)", session.free_name()),
        [-end, end],
    )
}

/// What a lobe is called.
fn lobe_name(lobe: &Lobe) -> String {
    let kind = lobe.category.title();
    let side = match lobe.side {
        bxdf::Side::Reflection => "",
        bxdf::Side::Transmission => ", transmitted",
    };
    if lobe.name.is_empty() {
        format!("{kind}{side}")
    } else {
        format!("{kind}{side}: {}", lobe.name)
    }
}

/// The curve through these values, a piece for each side of the surface: at the horizon it may jump.
fn pieces(angles: &[f64], values: &[f64]) -> Vec<Vec<[f64; 2]>> {
    let mut pieces: Vec<Vec<[f64; 2]>> = vec![Vec::new()];
    let mut last = None;
    for (x, y) in angles.iter().zip(values) {
        if last == Some(*x) {
            pieces.push(Vec::new());
        }
        last = Some(*x);
        if let Some(piece) = pieces.last_mut() {
            piece.push([*x, *y]);
        }
    }
    pieces
}

/// D over its peak, G and F of a material, broken where there is no half vector.
fn factor_lines(
    name: &str,
    decomposition: &Decomposition,
    factors: &Factors,
    color: Color32,
) -> [Series; 3] {
    let peak = factors.d.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
    let of = |index: usize, values: Vec<f64>| {
        let mut lines: Vec<Vec<[f64; 2]>> = vec![Vec::new()];
        let points = decomposition
            .angles_deg
            .iter()
            .zip(values)
            .zip(&factors.is_defined);
        for ((x, y), is_defined) in points {
            match lines.last_mut() {
                Some(line) if *is_defined => line.push([*x, y]),
                Some(line) if !line.is_empty() => lines.push(Vec::new()),
                _ => {}
            }
        }
        Series {
            name: format!("{name}{}", FACTORS.get(index).unwrap_or(&"")),
            color,
            dash: Dash::of_part(index),
            width: theme::CURVE_WIDTH,
            lines,
        }
    };
    let fresnel = factors
        .fresnel
        .iter()
        .map(|rgb| Channel::Luminance.of(*rgb));
    [
        of(0, factors.d.iter().map(|d| d / peak).collect()),
        of(1, factors.g.clone()),
        of(2, fresnel.collect()),
    ]
}
