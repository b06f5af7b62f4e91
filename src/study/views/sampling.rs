//! Where samplers send directions.

use serde::{Deserialize, Serialize};

use super::caption::{Caption, Directions, Subjects};
use super::kind::{Deltas, TableKind, ViewKind, ViewOptions};
use super::section::OwnSection;
use super::words::words;
use crate::answers::Answers;
use crate::export::table::{Table, Value, shown};
use crate::number::{NumberSpec, Numbers, Refused};
use crate::session::Session;
use bxdf_lab::analysis::sampling::{FIRST_SEED, Part, Request, Study, WarpRequest};

pub(super) const KIND: ViewKind = ViewKind {
    id: "sampling",
    title: "Sampling",
    what_you_see: "The directions that the sampler draws for the fixed light or viewer: a good one \
        follows f cos and weighs all samples alike",
    says_hidden: true,
    deltas: Deltas::Marked,
    with_cosine: false,
    table: TableKind::Computed,
    is_mesh: false,
};

/// The number of samples as a power of 2: fewer show nothing, more do not follow a drag.
pub static SAMPLES_LOG2: NumberSpec = NumberSpec::new("sampling.count_log2", [6.0, 16.0]).whole();
/// The seed of the random numbers, of 32 bits.
pub static SEED: NumberSpec = NumberSpec::new("sampling.seed", [0.0, 4_294_967_295.0]).whole();

/// How the sampling bends a grid of random numbers: its cells along either side.
pub const WARP: WarpRequest = WarpRequest { cells: 16 };

words! {
    /// What the sampling view shows.
    Plot {
        /// The samples on the disc.
        #[default]
        Points = "Samples",
        /// The images of a regular grid of random numbers.
        Warp = "Warp of the square",
        /// The density and f cos in the section.
        Curves = "pdf and f cos",
        /// How many samples fell where, against the density.
        Histogram = "Histogram",
        /// What samples weigh.
        Weights = "Weights",
        /// What the estimate of the reflectance varies by.
        Estimators = "Estimators",
    }
}

impl Plot {
    /// Whether it shows directions, which may lie on the dome too.
    #[must_use]
    pub const fn shows_directions(self) -> bool {
        matches!(self, Self::Points | Self::Warp)
    }
}

/// How the sampling is shown.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Options {
    /// What of it.
    pub plot: Plot,
    /// The number of samples, as a power of 2.
    pub count_log2: u8,
    /// The seed of the random numbers, as of the command line.
    pub seed: u32,
    /// Whether samples lie on the dome, seen as the 3D view sees it, rather than on a disc.
    pub is_dome: bool,
    /// A section of its own, where one is shown.
    #[serde(skip_serializing_if = "OwnSection::is_absent")]
    pub own_section_deg: OwnSection,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            plot: Plot::default(),
            count_log2: 12,
            seed: FIRST_SEED,
            is_dome: false,
            own_section_deg: OwnSection::default(),
        }
    }
}

impl Options {
    /// The study of the sampling.
    #[must_use]
    pub fn request(&self, session: &Session) -> Request {
        let [least, most] = SAMPLES_LOG2.range.map(|log2| log2 as u8);
        Request {
            part: match self.plot {
                Plot::Points | Plot::Warp => Part::Points,
                Plot::Histogram => Part::Histogram,
                Plot::Weights => Part::Weights,
                Plot::Curves => Part::Densities,
                Plot::Estimators => Part::Estimators,
            },
            count: 1 << self.count_log2.clamp(least, most),
            seed: u64::from(self.seed),
            phi: self.own_section_deg.of(session).phi(),
        }
    }
}

impl ViewOptions for Options {
    fn caption(&self, _: &Session) -> Caption {
        let names = match self.plot {
            Plot::Curves => Subjects::Colors,
            Plot::Weights => Subjects::Lines,
            Plot::Points | Plot::Warp | Plot::Histogram | Plot::Estimators => Subjects::Apart,
        };
        let count = 1_u32 << self.count_log2;
        let plot = self.plot.title();
        let quantity = match self.plot {
            Plot::Warp | Plot::Curves => plot.to_owned(),
            Plot::Points => format!("{count} samples"),
            _ => format!("{plot}, {count} samples"),
        };
        Caption::of(quantity).naming(names).at(Directions::Held)
    }

    /// The other plots are of all directions.
    fn own_section(&mut self) -> Option<&mut OwnSection> {
        (self.plot == Plot::Curves).then_some(&mut self.own_section_deg)
    }

    fn numbers(&mut self) -> Numbers<'_> {
        self.own_section_deg.number().into_iter().collect()
    }

    fn check_whole(&self) -> Result<(), Refused> {
        SAMPLES_LOG2.checked(f64::from(self.count_log2)).map(|_| ())
    }

    /// What is shown of it, the samples themselves where that is drawn from them.
    fn table(&self, session: &Session, answers: &mut Answers) -> Table {
        let plot = self.plot;
        let mut table = Table::new(columns(plot));
        for (entry, title) in shown(session) {
            if plot == Plot::Warp {
                let warps = answers.ask(session, entry, WARP);
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
                let study = answers.ask(session, entry, self.request(session));
                push(&mut table, &title, &study, plot);
            }
        }
        table
    }
}

fn columns(plot: Plot) -> &'static [&'static str] {
    match plot {
        Plot::Points => &[
            "material", "u0", "u1", "uc", "w_x", "w_y", "w_z", "weight_r", "weight_g", "weight_b",
            "delta",
        ],
        Plot::Warp => &["material", "category", "lobe", "line", "w_x", "w_y", "w_z"],
        Plot::Curves => &[
            "material",
            "angle (degrees)",
            "pdf (1/sr)",
            "f_cos_over_integral_luminance (1/sr)",
        ],
        Plot::Histogram => &[
            "material",
            "theta_low (degrees)",
            "theta_high (degrees)",
            "phi_low (degrees)",
            "phi_high (degrees)",
            "solid_angle (sr)",
            "observed",
            "expected",
        ],
        Plot::Weights => &["material", "weight_low", "weight_high", "samples"],
        Plot::Estimators => &["material", "sampling", "mean", "standard_error", "variance"],
    }
}

/// Adds what `plot` shows of a study.
fn push(table: &mut Table, title: &str, study: &Study, plot: Plot) {
    match plot {
        Plot::Points | Plot::Warp => {
            for point in &study.points {
                let ([u0, u1], w, [r, g, b]) = (point.u, point.direction, point.weight);
                let delta = f64::from(u8::from(point.is_delta));
                table.push(title, [u0, u1, point.uc, w.x, w.y, w.z, r, g, b, delta]);
            }
        }
        Plot::Curves => {
            for one in &study.densities {
                table.push(title, [one.angle_deg, one.pdf, one.f_cos]);
            }
        }
        Plot::Histogram => {
            for cell in &study.histogram.cells {
                let angles = cell.theta.into_iter().chain(cell.phi).map(f64::to_degrees);
                let counts = [cell.solid_angle, cell.observed as f64, cell.expected];
                table.push(title, angles.chain(counts));
            }
        }
        Plot::Weights => {
            for bin in &study.weights.bins {
                let [low, high] = bin.log10.map(|x| 10_f64.powf(x));
                table.push(title, [low, high, bin.count as f64]);
            }
        }
        Plot::Estimators => {
            for one in &study.estimators {
                let words = [title, one.name].map(|word| Value::Text(word.to_owned()));
                let numbers = [one.mean, one.standard_error, one.variance].map(Value::Number);
                table.rows.push(words.into_iter().chain(numbers).collect());
            }
        }
    }
}
