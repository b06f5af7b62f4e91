//! Where samplers send directions.

use super::kind::ViewKind;
use crate::data::Data;
use crate::export::table::{Table, Value, shown};
use crate::session::SamplingPlot;
use crate::session::Session;
use bxdf_lab::analysis::sampling::Study;

pub(super) const KIND: ViewKind = ViewKind {
    id: "sampling",
    title: "Sampling",
    is_of_held: |_| true,
    what_you_see: "Where the sampler sends directions for the held one: good samplers follow \
        f cos and weigh all samples alike",
    table: Some(table),
    is_mesh: false,
};

/// Of the sampling: what is shown of it, the samples themselves where that is drawn from them.
fn table(session: &Session, data: &mut Data) -> Table {
    let plot = session.views.sampling.plot;
    let mut table = Table::new(columns(plot));
    for (entry, title) in shown(session) {
        if plot == SamplingPlot::Warp {
            let warps = data.ask(session, entry, session.warp_request());
            for warp in warps.iter() {
                for (index, line) in warp.lines.iter().enumerate() {
                    for w in line {
                        let place = [index as f64, w.x, w.y, w.z].map(Value::Number);
                        let words = [&title, warp.lobe.category.id(), warp.lobe.name];
                        let words = words.map(|word| Value::Text(word.to_owned()));
                        table.rows.push(words.into_iter().chain(place).collect());
                    }
                }
            }
        } else {
            let study = data.ask(session, entry, session.sampling_request());
            push(&mut table, &title, &study, plot);
        }
    }
    table
}

fn columns(plot: SamplingPlot) -> &'static [&'static str] {
    match plot {
        SamplingPlot::Points => &[
            "material", "u0", "u1", "uc", "w_x", "w_y", "w_z", "weight_r", "weight_g", "weight_b",
            "delta",
        ],
        SamplingPlot::Warp => &["material", "category", "lobe", "line", "w_x", "w_y", "w_z"],
        SamplingPlot::Curves => &[
            "material",
            "angle (degrees)",
            "pdf (1/sr)",
            "f_cos_over_integral_luminance (1/sr)",
        ],
        SamplingPlot::Histogram => &[
            "material",
            "theta_low (degrees)",
            "theta_high (degrees)",
            "phi_low (degrees)",
            "phi_high (degrees)",
            "solid_angle (sr)",
            "observed",
            "expected",
        ],
        SamplingPlot::Weights => &["material", "weight_low", "weight_high", "samples"],
        SamplingPlot::Estimators => &["material", "sampling", "mean", "standard_error", "variance"],
    }
}

/// Adds what `plot` shows of a study.
fn push(table: &mut Table, title: &str, study: &Study, plot: SamplingPlot) {
    match plot {
        SamplingPlot::Points | SamplingPlot::Warp => {
            for point in &study.points {
                let ([u0, u1], w, [r, g, b]) = (point.u, point.direction, point.weight);
                let delta = f64::from(u8::from(point.is_delta));
                table.push(title, [u0, u1, point.uc, w.x, w.y, w.z, r, g, b, delta]);
            }
        }
        SamplingPlot::Curves => {
            for one in &study.densities {
                table.push(title, [one.angle_deg, one.pdf, one.f_cos]);
            }
        }
        SamplingPlot::Histogram => {
            for cell in &study.histogram.cells {
                let angles = cell.theta.into_iter().chain(cell.phi).map(f64::to_degrees);
                let counts = [cell.solid_angle, cell.observed as f64, cell.expected];
                table.push(title, angles.chain(counts));
            }
        }
        SamplingPlot::Weights => {
            for bin in &study.weights.bins {
                let [low, high] = bin.log10.map(|x| 10_f64.powf(x));
                table.push(title, [low, high, bin.count as f64]);
            }
        }
        SamplingPlot::Estimators => {
            for one in &study.estimators {
                let words = [title, one.name].map(|word| Value::Text(word.to_owned()));
                let numbers = [one.mean, one.standard_error, one.variance].map(Value::Number);
                table.rows.push(words.into_iter().chain(numbers).collect());
            }
        }
    }
}
