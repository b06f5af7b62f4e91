//! The extremes of a model's parameters.

use super::ExtremeKind;
use crate::analysis::statistics::Random;
use crate::contract::sweep::{Sets, bases, ends, with_colours, with_widths};
use crate::specimen::rounded_to_single;
use bxdf::ModelSpec;
use bxdf::internals::beyond_range;
use bxdf::param::{Kind, ParamSet, ParamSpec, Role, Scale, Value};

/// Distances of an index from 1.
const FROM_ONE: [f64; 7] = [1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7];

/// Absorption indices.
const ABSORPTIONS: [f64; 7] = [0.0, 1e-8, 1e-3, 1.0, 1e3, 1e6, 1e10];

/// Widths far below every range.
const CORE_WIDTHS: [[f64; 2]; 3] = [[1e-8, 1e-8], [1e-8, 1e-4], [1e-8, 1.0]];

/// What counts as 0 among decades.
const LEAST: f64 = 1e-8;

/// The same where there is one width.
const CORE_WIDTH: f32 = 1e-8;

/// The ratio of the widths of an extreme blade.
const RATIO: f64 = 1e4;

/// Sets of parameters, each with its extreme. None is refused by the model, but for those of [`ExtremeKind::Core`].
pub(super) fn parameter_sets(model: &ModelSpec) -> Vec<(ExtremeKind, ParamSet)> {
    let mut found = Found {
        sets: Sets::of(model),
        named: Vec::new(),
    };
    let defaults = model.defaults();
    found.add(ExtremeKind::Usual, Some(defaults.clone()));
    found.add(ExtremeKind::Colours, with_colours(&defaults, 0.0));
    for base in bases(model) {
        found.add(ExtremeKind::Colours, Some(base.clone()));
        found.add(ExtremeKind::Colours, with_colours(&base, 0.0));
        widths(&base, &mut found);
        for spec in base.iter().map(|(spec, _)| spec) {
            if base.is_relevant(spec) {
                number(&base, spec, &mut found);
            }
        }
        for end in [0, 1] {
            found.add(ExtremeKind::RangeEnds, all_at_end(&base, end));
        }
    }
    let core = core_widths(model)
        .into_iter()
        .map(|set| (ExtremeKind::Core, set));
    found.named.into_iter().chain(core).collect()
}

struct Found<'a> {
    sets: Sets<'a>,
    named: Vec<(ExtremeKind, ParamSet)>,
}

impl Found<'_> {
    fn add(&mut self, case: ExtremeKind, set: Option<ParamSet>) {
        // Numbers of f32, so that every precision is given the same.
        let set = set.map(|set| rounded_to_single(&set));
        if let Some(set) = self.sets.add(set) {
            self.named.push((case, set.clone()));
        }
    }
}

/// The widths along s and t.
fn widths(base: &ParamSet, found: &mut Found<'_>) {
    let Some((spec, _)) = base.of_role(Role::WidthS) else {
        return;
    };
    let [min, max] = spec.hard;
    for narrow in [min, 1e-4, 1e-3, 1e-2] {
        found.add(ExtremeKind::Narrow, with_widths(base, narrow, narrow));
    }
    found.add(ExtremeKind::RangeEnds, with_widths(base, max, max));
    let slim = min.max(max / RATIO);
    for [x, y] in [[slim, max], [max, slim], [0.05, 0.5]] {
        found.add(ExtremeKind::Anisotropic, with_widths(base, x, y));
    }
}

/// One number or index at its extremes.
fn number(base: &ParamSet, spec: &ParamSpec, found: &mut Found<'_>) {
    let value = |x: f64| match spec.kind {
        Kind::Rgb => Value::Rgb([x; 3]),
        _ => Value::Number(x),
    };
    let mut add = |case, x| found.add(case, base.with(&[(spec.name, value(x))]));
    if spec.is_colour() || matches!(spec.role, Role::WidthS | Role::WidthT) {
        // Widths along s and t go together, and colours too.
    } else if spec.kind == Kind::Rgb && !is_plain_but_for_fresnel(base) {
        // Of a metal's index only the reflectance of its facets knows.
    } else if spec.is_index() {
        add(ExtremeKind::IndexNearOne, 1.0);
        for distance in FROM_ONE {
            add(ExtremeKind::IndexNearOne, 1.0 + distance);
            add(ExtremeKind::IndexNearOne, 1.0 - distance);
        }
        for end in [spec.hard, [1e-2, 1e3]].into_iter().flatten() {
            add(ExtremeKind::LargeIndex, end);
        }
    } else if spec.role == Role::Absorption {
        for k in ABSORPTIONS {
            add(ExtremeKind::Absorbing, k);
        }
    } else if spec.role.is_width() {
        let [min, max] = spec.hard;
        for narrow in [min, 1e-4, 1e-3, 1e-2] {
            add(ExtremeKind::Narrow, narrow);
        }
        add(ExtremeKind::RangeEnds, max);
    } else {
        for end in ends(spec) {
            found.add(ExtremeKind::RangeEnds, base.with(&[(spec.name, end)]));
        }
    }
}

/// Whether every word but that of the Fresnel term is the default.
fn is_plain_but_for_fresnel(base: &ParamSet) -> bool {
    let mut choices = base.iter().filter(|(spec, _)| spec.kind == Kind::Choice);
    choices.all(|(spec, value)| spec.role == Role::Fresnel || value == spec.default)
}

/// Every number at the same end of its range, but for indices, which have extremes of their own.
fn all_at_end(base: &ParamSet, end: usize) -> Option<ParamSet> {
    let mut set = base.clone();
    for (spec, _) in base.iter() {
        let value = spec.hard.get(end).copied()?;
        match spec.kind {
            Kind::Number if !spec.is_index() => set.set(spec.name, Value::Number(value)).ok()?,
            _ => {}
        }
    }
    Some(set)
}

/// Widths inside the core, below their range, for each word that chooses a distribution.
fn core_widths(model: &ModelSpec) -> Vec<ParamSet> {
    let defaults = model.defaults();
    let words = model
        .parameters
        .iter()
        .filter(|spec| spec.role == Role::Distribution)
        .flat_map(|spec| {
            spec.choices
                .iter()
                .map(|word| (spec.name, Value::Choice(word)))
        });
    let mut starts: Vec<ParamSet> = words.filter_map(|word| defaults.with(&[word])).collect();
    if starts.is_empty() {
        starts.push(defaults.clone());
    }
    let with_core_widths = |start: &ParamSet| {
        CORE_WIDTHS.map(|widths| {
            // Numbers of f32, so that every precision has the same.
            let [x, y] = widths.map(|width| f64::from(width as f32));
            let [s, t] = start.widths()?;
            beyond_range(&beyond_range(start, s, x)?, t, y)
        })
    };
    let mut sets: Vec<ParamSet> = starts.iter().flat_map(with_core_widths).flatten().collect();
    let others = model.parameters.iter();
    let others = others.filter(|spec| spec.role == Role::Width);
    sets.extend(
        others.filter_map(|spec| beyond_range(&defaults, spec.name, f64::from(CORE_WIDTH))),
    );
    sets
}

/// Parameters by chance within their ranges, an end of the range now and then; evenly over the decades where the slider
/// goes by decades. `None` where the model refuses them.
pub(super) fn random_set(model: &ModelSpec, random: &mut Random) -> Option<ParamSet> {
    let mut set = model.defaults();
    for spec in model.parameters {
        let value = random_value(spec, random);
        set.set(spec.name, value).ok()?;
    }
    (model.validate)(&set).ok()?;
    Some(rounded_to_single(&set))
}

fn random_value(spec: &ParamSpec, random: &mut Random) -> Value {
    let mut number = || random_number(spec, random);
    match spec.kind {
        Kind::Number => Value::Number(number()),
        Kind::Rgb => Value::Rgb([number(), number(), number()]),
        Kind::Choice => {
            let index = (random.unit() * spec.choices.len() as f64) as usize;
            spec.choices
                .get(index)
                .map_or(spec.default, |word| Value::Choice(word))
        }
        Kind::Bool => Value::Bool(random.unit() < 0.5),
        Kind::Data => spec.default,
    }
}

fn random_number(spec: &ParamSpec, random: &mut Random) -> f64 {
    let [min, max] = spec.hard;
    let [kind, place] = random.pair();
    let x = if kind < 0.05 {
        if place < 0.5 { min } else { max }
    } else if spec.is_index() && kind < 0.3 {
        // About 1, on both sides, evenly over the decades of the distance.
        let distance = 10.0_f64.powf(-8.0 * random.unit());
        if place < 0.5 {
            1.0 - distance
        } else {
            1.0 + distance
        }
    } else if spec.scale == Scale::Logarithmic || max > 100.0 {
        let (low, high) = (min.max(LEAST).ln(), max.ln());
        (low + (high - low) * place).exp()
    } else {
        min + (max - min) * place
    };
    x.clamp(min, max)
}
