//! The cheapest choice that is good enough.

use serde::Serialize;

use super::report::{FamilyReport, Point, Report};
use bxdf::Material;

/// Tolerances for which advice is given where none is asked for: relative errors, root mean square.
pub const DEFAULT_TOLERANCES: [f64; 4] = [1e-1, 1e-2, 1e-3, 1e-4];

/// The id under which advice for the material as a whole stands among that for families.
pub const WHOLE: &str = "material";

/// A choice for a tolerance.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Advice {
    /// The largest error that is good enough: relative, root mean square.
    pub tolerance: f64,
    /// The id of the family, or [`WHOLE`].
    pub family: &'static str,
    /// Whether the choice meets the tolerance; where none does it is the closest.
    pub met: bool,
    /// The choice.
    pub choice: String,
    /// Its number of samples, nodes or vertices.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub n: Option<u64>,
    /// What it costs, in nanoseconds.
    pub cost_ns: f64,
    /// Its error.
    pub error_rms: f64,
    /// What is lost with it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lost: Option<String>,
    /// The material that it is, where it is one.
    #[serde(skip_serializing_if = "super::report::is_no_text")]
    pub material: Option<Material>,
}

/// What is cheapest within `tolerance`, for each family of `report` that has points and for the material as a whole.
#[must_use]
pub fn advise(report: &Report, tolerance: f64) -> Vec<Advice> {
    let of_families = report
        .families
        .iter()
        .filter_map(|family| best(family.id, &family.points, tolerance));
    let whole = best(WHOLE, &whole(&report.families), tolerance);
    of_families.chain(whole).collect()
}

/// The choices for the material as it is used: the number formats of the exact material, and its stand-ins with the error
/// that they have in the precision in which their cost was measured.
pub(super) fn whole(families: &[FamilyReport]) -> Vec<Point> {
    let of_material = || families.iter().filter(|family| family.is_of_material);
    // Number formats: what they say of the material itself need not be said again.
    let is_format = |point: &Point| point.error_rms_f32.is_none() && point.lost.is_none();
    let has_formats = of_material().any(|family| family.points.iter().any(is_format));
    let as_used = |point: &Point| {
        let is_itself = point.error_rms_f32.is_some() && point.lost.is_none();
        (!(is_itself && has_formats)).then(|| Point {
            error_rms: point.error_rms_f32.unwrap_or(point.error_rms),
            choice: match point.error_rms_f32 {
                Some(_) => format!("{}, in f32", point.choice),
                None => point.choice.clone(),
            },
            ..point.clone()
        })
    };
    let points = of_material().flat_map(|family| &family.points);
    points.filter_map(as_used).collect()
}

/// The cheapest of `points` within `tolerance`.
pub(super) fn cheapest<'a>(
    points: impl IntoIterator<Item = &'a Point>,
    tolerance: f64,
) -> Option<&'a Point> {
    let within = points
        .into_iter()
        .filter(|point| point.error_rms <= tolerance);
    within.min_by(|a, b| a.cost_ns.total_cmp(&b.cost_ns))
}

/// The point of the smallest error.
pub(super) fn nearest(points: &[Point]) -> Option<&Point> {
    let points = points.iter();
    points.min_by(|a, b| a.error_rms.total_cmp(&b.error_rms))
}

/// The cheapest of `points` within `tolerance`, or the nearest.
fn best(family: &'static str, points: &[Point], tolerance: f64) -> Option<Advice> {
    let cheapest = cheapest(points, tolerance);
    let point = cheapest.or_else(|| nearest(points))?;
    Some(Advice {
        tolerance,
        family,
        met: cheapest.is_some(),
        choice: point.choice.clone(),
        n: point.n,
        cost_ns: point.cost_ns,
        error_rms: point.error_rms,
        lost: point.lost.clone(),
        material: point.material.clone(),
    })
}
