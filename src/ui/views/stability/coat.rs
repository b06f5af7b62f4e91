//! The diffuse part under a coat: which Fresnel term it is multiplied by, and what each breaks.

use std::sync::Arc;

use egui::{Color32, Label, RichText, ScrollArea, Ui};

use super::super::context::ViewContext;
use crate::theme::{self, Dash};
use crate::widgets::chart::{Axis, Chart, Series};
use crate::widgets::formula::{self, Look};
use crate::widgets::still;
use bxdf_lab::coat_forms::{COAT_FORMS, CoatForm, Verdict};
use bxdf_study::format;
use bxdf_study::memo::Memo;
use bxdf_study::views::stability::Options;

/// The index of the coat: glass and most lacquers.
const ETA: f64 = 1.5;

/// What is shown.
pub(super) const WHAT: &str =
    "A smooth coat of index 1.5 over a white ground, whose 1/π is multiplied by one of these";

/// Angles along each curve.
const COUNT: usize = 90;

/// The part of the room that the chart has, and the least height of it in points.
const CHART: (f32, f32) = (0.5, 110.0);

/// The size of the letters of a formula, in points.
const LETTERS: f32 = 15.0;

/// What is known of a form.
struct Known {
    form: &'static CoatForm,
    curve: Vec<[f64; 2]>,
    verdict: Verdict,
}

fn known() -> Vec<Known> {
    let of = |form: &'static CoatForm| Known {
        form,
        curve: form.curve(ETA, COUNT).map(|(x, y)| [x, y]).collect(),
        verdict: form.verdict(ETA),
    };
    COAT_FORMS.iter().map(of).collect()
}

/// How the curves of the forms look: as the laws they keep, and told apart by their dashes.
const DASHES: [Dash; 3] = [Dash::Solid, Dash::Dashed, Dash::Dotted];

pub(super) fn show(ui: &mut Ui, cx: &mut ViewContext<'_, Options>) {
    let kept: &mut Memo<(), Vec<Known>> = cx.state.own(cx.view);
    let all: Arc<Vec<Known>> = kept.get((), known);
    let (share, least) = CHART;
    let height = (share * ui.available_height()).max(least);
    chart(ui, cx, &all, height);
    ui.add_space(6.0);
    let area = ScrollArea::vertical().auto_shrink([false, false]);
    still::scroll(ui, area, |ui| {
        for known in all.iter() {
            words(ui, cx, known);
        }
    });
}

fn color(cx: &ViewContext<'_, Options>, verdict: &Verdict) -> Color32 {
    if verdict.is_reciprocal() && verdict.keeps_energy() {
        cx.palette.kept
    } else {
        cx.palette.warning
    }
}

fn chart(ui: &mut Ui, cx: &ViewContext<'_, Options>, all: &[Known], height: f32) {
    let series = all.iter().zip(DASHES).map(|(known, dash)| Series {
        name: known.form.title.to_owned(),
        color: color(cx, &known.verdict),
        dash,
        width: theme::CURVE_WIDTH,
        lines: vec![known.curve.clone()],
    });
    let highest = all
        .iter()
        .map(|known| known.verdict.most)
        .fold(1.0, f64::max);
    let mut chart = Chart::of(
        "Diffuse part under a coat",
        [
            Axis::degrees("θ of the light (degrees)", [0.0, 90.0]),
            Axis::of_values("share of the light that leaves", [0.0, highest], None),
        ],
        series.collect(),
    );
    chart.has_names = true;
    chart.show(ui, Some(height), cx.palette);
}

fn words(ui: &mut Ui, cx: &ViewContext<'_, Options>, known: &Known) {
    let Known { form, verdict, .. } = known;
    let look = Look {
        size: LETTERS,
        palette: cx.palette,
        lobe: cx.palette.ink,
    };
    formula::show(ui, form.formula, true, look);
    let [there, back] =
        [form.factor(ETA, 60.0, 0.0), form.factor(ETA, 0.0, 60.0)].map(format::value);
    let reciprocity = if verdict.is_reciprocal() {
        format!("Reciprocal: {there} from 60° to 0°, and back")
    } else {
        format!("Not reciprocal: {there} from 60° to 0°, {back} back")
    };
    let most = format::value(verdict.most);
    let energy = if verdict.keeps_energy() {
        format!("keeps energy: at most {most} of the light leaves")
    } else {
        let at = format::degrees(verdict.at_deg);
        format!("breaks energy: {most} times the light leaves at {at}")
    };
    let color = cx.palette.text_in(color(cx, verdict));
    let line = RichText::new(format!("{reciprocity}; {energy}")).color(color);
    ui.add(Label::new(line).wrap());
    ui.add(Label::new(RichText::new(form.why).small()).wrap());
    ui.add_space(6.0);
}
