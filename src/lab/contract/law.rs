//! What is said of a law: its names, what became of it, and where.

use serde::Serialize;

use crate::specimen::Witness;
use bxdf::math::frame;
use bxdf::{Declaration, Law, ModelSpec};

/// A law of the contract.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum LawId {
    /// The integral of `pdf` over the sphere is the rate of samples that are no deltas.
    PdfIntegral,
    /// The samples are distributed as `pdf` and the deltas' probabilities say.
    Sampling,
    /// `f` and `pdf` are 0 where no lobe goes, and there is a density wherever there is a value or a sample.
    Support,
    /// A sample carries the very `f` and `pdf` of its direction, and the direction is a unit vector.
    Weight,
    /// The mean sample weight is the integral of f |cos|, deltas included.
    MeanWeight,
    /// The inner lobes sum to f, and the maps of the square that follow them integrate to the same.
    Lobes,
    /// `n_i^2` f(wo, wi) = `n_o^2` f(wi, wo), and each delta has its way back.
    Reciprocity,
    /// A delta's flux, weight, side and probability agree with one another.
    Deltas,
    /// No more flux leaves than arrives.
    Energy,
    /// Every result is finite and not negative, in every precision and at every extreme.
    Finite,
    /// The lobe turns with the surface exactly where it is declared to.
    Isotropy,
    /// Models agree where one becomes another.
    Limits,
    /// f32 and f64 agree with the reference precision as far as rounding allows.
    Precision,
}

impl LawId {
    /// All laws, in the order of the reports.
    pub const ALL: [Self; 13] = [
        Self::PdfIntegral,
        Self::Sampling,
        Self::Support,
        Self::Weight,
        Self::MeanWeight,
        Self::Lobes,
        Self::Reciprocity,
        Self::Deltas,
        Self::Energy,
        Self::Finite,
        Self::Isotropy,
        Self::Limits,
        Self::Precision,
    ];

    /// The word for it in reports.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::PdfIntegral => "pdf_integral",
            Self::Sampling => "sampling",
            Self::Support => "support",
            Self::Weight => "weight",
            Self::MeanWeight => "mean_weight",
            Self::Lobes => "lobes",
            Self::Reciprocity => "reciprocity",
            Self::Deltas => "deltas",
            Self::Energy => "energy",
            Self::Finite => "finite",
            Self::Isotropy => "isotropy",
            Self::Limits => "limits",
            Self::Precision => "precision",
        }
    }

    /// What [`LawReport::worst`] counts for this law.
    #[must_use]
    pub const fn measure(self) -> &'static str {
        match self {
            Self::PdfIntegral => "absolute difference of the integral and the rate",
            Self::Sampling => "minus the decimal logarithm of the smallest p-value",
            Self::Support => "value or density where none belongs, in 1/sr",
            Self::Weight => "relative difference of a sample's numbers from the model's",
            Self::MeanWeight => "absolute difference of the mean weight and the integral",
            Self::Lobes => {
                "relative difference of the sum and f, or absolute difference of the integrals"
            }
            Self::Reciprocity => "relative difference of the two ways",
            Self::Deltas => "absolute disagreement of a delta's numbers",
            Self::Energy => "share of the flux created",
            Self::Finite => "1 where a result is not finite, negative or no unit vector",
            Self::Isotropy => "relative difference of the lobe and the turned lobe",
            Self::Limits => "relative difference of the two models",
            Self::Precision => "relative error against the reference precision",
        }
    }

    /// The name at the screen, in sentence case.
    #[must_use]
    pub const fn title(self) -> &'static str {
        match self {
            Self::PdfIntegral => "Integral of the density",
            Self::Sampling => "Sampling",
            Self::Support => "Support",
            Self::Weight => "Weight of samples",
            Self::MeanWeight => "Mean weight",
            Self::Lobes => "Lobes",
            Self::Reciprocity => "Reciprocity",
            Self::Deltas => "Deltas",
            Self::Energy => "Energy",
            Self::Finite => "Non-negativity",
            Self::Isotropy => "Isotropy",
            Self::Limits => "Limits",
            Self::Precision => "Precision",
        }
    }

    /// Where `model` says that it breaks the law.
    pub fn declarations(self, model: &ModelSpec) -> impl Iterator<Item = &'static Declaration> {
        let all = model.properties.declarations.iter();
        all.filter(move |declaration| Some(declaration.law) == self.declared_as())
    }

    /// Whether it is one that models may break as published: how much is then what counts.
    pub(super) const fn is_physical(self) -> bool {
        self.declared_as().is_some()
    }

    const fn declared_as(self) -> Option<Law> {
        match self {
            Self::Energy => Some(Law::Energy),
            Self::Reciprocity => Some(Law::Reciprocity),
            _ => None,
        }
    }
}

/// What became of a law.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Status {
    /// It holds.
    Ok,
    /// It breaks as the model declares.
    Declared,
    /// It breaks, and the model does not declare it, or declares a far smaller break.
    Violated,
    /// The model declares a break that its witness does not show.
    Misdeclared,
}

impl Status {
    /// Whether the check passes.
    #[must_use]
    pub const fn is_pass(self) -> bool {
        matches!(self, Self::Ok | Self::Declared)
    }

    /// The word for it in reports.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Ok => "ok",
            Self::Declared => "declared",
            Self::Violated => "violated",
            Self::Misdeclared => "misdeclared",
        }
    }
}

/// The outcome of one law for one model.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LawReport {
    /// The law.
    pub law: LawId,
    /// What became of it.
    pub status: Status,
    /// The deviation at the witness, in [`LawId::measure`]: where it exceeds `error` by the largest factor; of a broken
    /// law of physics the largest of those that exceed it. Infinite where the deviation is no number.
    pub worst: f64,
    /// What numerical error and chance account for there; the law holds while no deviation exceeds its error.
    pub error: f64,
    /// Number of comparisons made.
    pub n: usize,
    /// Where the worst deviation is found.
    pub witness: Witness,
    /// Why it breaks: what comes after "because". Empty where it holds, and where no reason is known.
    #[serde(skip)]
    pub reason: String,
}

impl LawReport {
    /// What happens where the law breaks most, in a sentence without a full stop; `None` where it holds, and for laws of
    /// which no sentence is known.
    #[must_use]
    pub fn sentence(&self) -> Option<String> {
        if self.status == Status::Ok {
            return None;
        }
        let share = percent(self.worst);
        let what = match self.law {
            LawId::Energy => {
                let theta_deg = frame::theta(self.witness.wi?).to_degrees();
                // Angles are given in tenths of a degree at most.
                let theta_deg = (10.0 * theta_deg).round() / 10.0;
                format!("With light at {theta_deg} degrees {share} more leaves than arrives")
            }
            LawId::Reciprocity => {
                format!("The two ways between light and viewer differ by {share}")
            }
            _ => return None,
        };
        if self.reason.is_empty() {
            return Some(what);
        }
        Some(format!("{what}, because {}", self.reason))
    }
}

/// A share in per cent, with two digits at least.
fn percent(share: f64) -> String {
    let per_cent = 100.0 * share;
    let decimals = match per_cent {
        10.0.. => 0,
        1.0.. => 1,
        _ => 2,
    };
    format!("{per_cent:.decimals$} %")
}
