//! The answer to a question: the cheapest choice that is good enough, and what it is cheaper than.

use std::borrow::Cow;
use std::collections::BTreeSet;

use super::advice::{cheapest, nearest, whole};
use super::report::{FamilyReport, Point, Question, Report};

/// Up to this error a choice counts as exact: some thousand roundings of f64.
const EXACT: f64 = 1e-12;

/// What is chosen for a tolerance.
#[derive(Clone, Debug, PartialEq)]
pub struct Verdict {
    /// The cheapest choice within the tolerance; where there is none, the nearest.
    pub chosen: Point,
    /// Whether it is within the tolerance.
    pub is_met: bool,
    /// What it is cheaper than: the cheapest exact way to evaluate f; the dearest way to integrate it as well as that.
    pub instead: Option<Point>,
}

/// The answer to `question` within `tolerance`: of the material as it is used, of ways to integrate in the first family that
/// has points. `None` where nothing has.
#[must_use]
pub fn verdict(report: &Report, question: Question, tolerance: f64) -> Option<Verdict> {
    let of_it = |family: &&FamilyReport| family.cost_unit.question() == question;
    let mut families = report.families.iter().filter(of_it);
    let points: Cow<'_, [Point]> = match whole(&report.families) {
        of_material if question == Question::Evaluate && !of_material.is_empty() => {
            of_material.into()
        }
        _ => (&*families.find(|family| !family.points.is_empty())?.points).into(),
    };
    let within = cheapest(points.iter(), tolerance);
    let chosen = within.or_else(|| nearest(&points))?.clone();
    let instead = match question {
        Question::Evaluate => cheapest(points.iter(), EXACT).or_else(|| nearest(&points)),
        Question::Integrate => dearest_way(&points, tolerance),
    };
    let is_cheaper = |other: &&Point| within.is_some() && chosen.cost_ns < other.cost_ns;
    Some(Verdict {
        is_met: within.is_some(),
        instead: instead.filter(is_cheaper).cloned(),
        chosen,
    })
}

/// Of the choices' own cheapest within `tolerance` the one that costs most.
fn dearest_way(points: &[Point], tolerance: f64) -> Option<&Point> {
    let choices: BTreeSet<&str> = points.iter().map(|point| &*point.choice).collect();
    let ways = choices.into_iter().filter_map(|choice| {
        let own = points.iter().filter(|point| point.choice == choice);
        cheapest(own, tolerance)
    });
    ways.max_by(|a, b| a.cost_ns.total_cmp(&b.cost_ns))
}

#[cfg(test)]
mod tests {
    use super::super::report::{CostUnit, Slopes};
    use super::*;
    use bxdf::Material;
    use glam::DVec3;

    fn report(cost_unit: CostUnit, choices: &[(&str, f64, f64)]) -> Report {
        let point = |(choice, cost_ns, error_rms): &(&str, f64, f64)| Point {
            cost_ns: *cost_ns,
            error_rms: *error_rms,
            ..Point::new(*choice)
        };
        Report {
            material: "phong".parse::<Material>().unwrap(),
            held: DVec3::Z,
            families: vec![FamilyReport {
                id: "any",
                title: "Any",
                reference: String::new(),
                not_applicable: None,
                cost_unit,
                is_of_material: cost_unit == CostUnit::Evaluation,
                points: choices.iter().map(point).collect(),
                slopes: Slopes::new(),
            }],
        }
    }

    #[test]
    fn the_cheapest_to_evaluate_is_held_against_the_cheapest_exact_one() {
        let choices = [
            ("rough", 10.0, 1e-2),
            ("f32", 20.0, 1e-7),
            ("f64", 40.0, 1e-16),
            ("slow", 900.0, 0.0),
        ];
        let report = report(CostUnit::Evaluation, &choices);
        let of = |tolerance| verdict(&report, Question::Evaluate, tolerance).unwrap();
        let names = |verdict: Verdict| {
            let instead = verdict.instead.map(|point| point.choice);
            (verdict.chosen.choice, verdict.is_met, instead)
        };
        let f64 = Some("f64".to_owned());
        assert_eq!(names(of(1e-1)), ("rough".to_owned(), true, f64.clone()));
        assert_eq!(names(of(1e-3)), ("f32".to_owned(), true, f64));
        assert_eq!(names(of(1e-12)), ("f64".to_owned(), true, None));
        assert_eq!(verdict(&report, Question::Integrate, 0.1), None);
    }

    #[test]
    fn the_cheapest_to_integrate_is_held_against_the_dearest_way_as_near() {
        let choices = [
            ("uniform", 10.0, 0.5),
            ("uniform", 800.0, 0.009),
            ("uniform", 9000.0, 0.001),
            ("by the lobe", 20.0, 0.008),
            ("hopeless", 1e6, 0.2),
        ];
        let report = report(CostUnit::Estimate, &choices);
        let found = verdict(&report, Question::Integrate, 0.01).unwrap();
        assert_eq!(found.chosen.choice, "by the lobe");
        assert_eq!(found.instead.unwrap().cost_ns, 800.0);
        let none = verdict(&report, Question::Integrate, 1e-4).unwrap();
        assert!(!none.is_met && none.instead.is_none() && none.chosen.cost_ns == 9000.0);
    }
}
