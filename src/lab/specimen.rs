//! What the instruments are run on: a model at one set of parameters, in every precision.

use std::fmt;

use glam::DVec3;
use serde::Serialize;
use xprec::Df64;

use bxdf::batch::Columns;
use bxdf::math::{Real, frame};
use bxdf::param::{ParamSet, ParamSpec, Value};
use bxdf::{Category, Lobe, Material, ModelSpec, Scatterer, Side};

/// Where a deviation is found: as text, and the directions for whoever wants to go there.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
#[serde(transparent)]
pub struct Witness {
    /// Parameters, and directions as (theta, phi) in degrees.
    pub text: String,
    /// The direction to the viewer, where there is one.
    #[serde(skip)]
    pub wo: Option<DVec3>,
    /// The direction to the light, where there is one.
    #[serde(skip)]
    pub wi: Option<DVec3>,
}

impl From<String> for Witness {
    fn from(text: String) -> Self {
        Self {
            text,
            ..Self::default()
        }
    }
}

impl fmt::Display for Witness {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

/// A model at one set of parameters, built in every precision, with what is declared of it.
pub struct Specimen {
    /// Model and parameters, as text.
    pub name: String,
    /// In `f32`.
    pub single: Box<dyn Scatterer<f32>>,
    /// In `f64`: what most laws are run on.
    pub double: Box<dyn Scatterer<f64>>,
    /// In the reference precision.
    pub reference: Box<dyn Scatterer<Df64>>,
    /// In the reference precision, with the parameters rounded to `f32`.
    pub reference_of_single: Box<dyn Scatterer<Df64>>,
    /// The same model at parameters nearby, to measure how much a parameter's rounding matters.
    pub neighbours: Vec<Neighbour>,
    /// The lobes its models say they have.
    pub lobes: Vec<Lobe>,
    /// The index below the surface over the one above.
    pub relative_index: f64,
    /// Whether it is declared isotropic.
    pub is_isotropic: bool,
}

/// A model at two values of one parameter, close to each other.
pub struct Neighbour {
    /// The model at the larger and at the smaller value.
    pub pair: [Box<dyn Scatterer<Df64>>; 2],
    /// The difference of the two values over the value itself.
    pub relative_step: f64,
    /// The precision whose steps these are, by its unit round-off; any where there is none.
    pub unit_roundoff: Option<f64>,
}

/// A number for each text: its FNV-1a hash.
pub(crate) fn seed_of(text: &str) -> u64 {
    text.bytes().fold(0xcbf2_9ce4_8422_2325, |hash: u64, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    })
}

/// Relative step of a parameter: small beside every power it enters with, large beside the rounding of what models tabulate
/// in f64 (1e-16).
const RELATIVE_STEP: f64 = 1e-9;

/// Step of an index, in roundings of the precision: at the edge of total reflection the slope is infinite on one side.
const ROUNDOFFS_OF_INDEX: f64 = 16.0;

impl Specimen {
    /// `model` at `params`.
    #[must_use]
    pub fn new(model: &ModelSpec, params: &ParamSet) -> Self {
        let values = params.to_string();
        let colon = if values.is_empty() { "" } else { ":" };
        Self {
            name: format!("{}{colon}{values}", model.id),
            single: model.build(params),
            double: model.build(params),
            reference: model.build(params),
            reference_of_single: model.build(&rounded_to_single(params)),
            neighbours: neighbours(params, |moved| {
                (model.validate)(moved).ok()?;
                Some(model.build(moved))
            }),
            lobes: model.lobes.to_vec(),
            relative_index: (model.properties.relative_index)(params),
            is_isotropic: (model.properties.is_isotropic)(params),
        }
    }

    /// The three channels of `f` and the density at `pairs` (wo, wi), in `f64`: the order of a law's quantities.
    #[must_use]
    pub fn values(&self, pairs: &[(DVec3, DVec3)]) -> Vec<[f64; 4]> {
        let wo = Columns::directions(pairs.iter().map(|(wo, _)| *wo));
        let wi = Columns::directions(pairs.iter().map(|(_, wi)| *wi));
        self.double.values_and_densities(&wo, &wi).rows().collect()
    }

    /// `material`: its model where that is all, else all its components together.
    #[must_use]
    pub fn at(material: &Material) -> Self {
        material.only().map_or_else(
            || Self::of_material(material),
            |only| Self::new(only.model(), only.params()),
        )
    }

    /// `material`, all its components together.
    #[must_use]
    pub fn of_material(material: &Material) -> Self {
        let components = material.components();
        let with = |index: usize, params: &ParamSet| {
            let mut moved = components.to_vec();
            moved.get_mut(index)?.set_all(params).ok()?;
            material.with_components(moved).ok()
        };
        let mut rounded = material.clone();
        for (index, component) in components.iter().enumerate() {
            let mut single = rounded.components().to_vec();
            if let Some(slot) = single.get_mut(index)
                && slot.set_all(&rounded_to_single(component.params())).is_ok()
                && let Ok(other) = rounded.with_components(single)
            {
                rounded = other;
            }
        }
        Self {
            name: material.to_string(),
            single: material.build(),
            double: material.build(),
            reference: material.build(),
            reference_of_single: rounded.build(),
            neighbours: components
                .iter()
                .enumerate()
                .flat_map(|(index, component)| {
                    neighbours(component.params(), |moved| {
                        Some(with(index, moved)?.build())
                    })
                })
                .collect(),
            lobes: components
                .iter()
                .flat_map(|component| component.model().lobes)
                .copied()
                .collect(),
            relative_index: material.relative_index(),
            is_isotropic: material.is_isotropic(),
        }
    }

    /// The index of refraction on the side of `w`.
    pub(crate) fn index_at(&self, w: DVec3) -> f64 {
        if w.z < 0.0 { self.relative_index } else { 1.0 }
    }

    /// Flux over radiance of what goes from `wi` to `wo`: e^2, e being the index on wi's side over that on wo's.
    pub(crate) fn flux_factor(&self, wo: DVec3, wi: DVec3) -> f64 {
        let e = self.index_at(wi) / self.index_at(wo);
        e * e
    }

    /// Whether one of the lobes goes to `side`.
    pub(crate) fn has_side(&self, side: Side) -> bool {
        self.lobes.iter().any(|lobe| lobe.side == side)
    }

    /// Whether one of the lobes is of `category`.
    pub(crate) fn has_category(&self, category: Category) -> bool {
        self.lobes.iter().any(|lobe| lobe.category == category)
    }

    /// Whether a glossy lobe crosses the surface.
    pub(crate) fn has_transmitted_lobe(&self) -> bool {
        self.lobes.iter().any(|lobe| {
            lobe.side == Side::Transmission && lobe.category == Category::GlossySpecular
        })
    }

    /// A seed that depends on model and parameters only.
    pub(crate) fn seed(&self) -> u64 {
        seed_of(&self.name)
    }

    /// The witness of a comparison at these directions, of which `wo` and `wi` are the viewer's and the light's.
    pub(crate) fn witness(&self, directions: &[(&str, DVec3)]) -> Witness {
        let places = directions.iter().map(|(name, w)| {
            let (theta, phi) = (frame::theta(*w).to_degrees(), frame::phi(*w).to_degrees());
            format!(" {name} ({theta:.7}, {phi:.7})")
        });
        let named = |wanted: &str| {
            let mut all = directions.iter();
            all.find_map(|(name, w)| (*name == wanted).then_some(*w))
        };
        Witness {
            text: std::iter::once(self.name.clone()).chain(places).collect(),
            wo: named("wo"),
            wi: named("wi"),
        }
    }
}

/// `params` with every number rounded to the nearest `f32` inside its range.
pub(crate) fn rounded_to_single(params: &ParamSet) -> ParamSet {
    let mut rounded = params.clone();
    for (spec, value) in params.iter() {
        let round = |x: f64| f64::from(x as f32);
        let value = match value {
            Value::Number(x) => Value::Number(round(x)),
            Value::Rgb(rgb) => Value::Rgb(rgb.map(round)),
            other => other,
        };
        // An end of the range may round to just outside it; the parameter then keeps its exact value, which the model
        // in f32 does not have either: a part in 1e8, within the parameter's own share of the condition number.
        let _ = rounded.set(spec.name, value);
    }
    rounded
}

/// The neighbours of `params` along each numeric parameter that has an effect; `build` gives what stands at other
/// parameters, if they are allowed.
fn neighbours(
    params: &ParamSet,
    build: impl Fn(&ParamSet) -> Option<Box<dyn Scatterer<Df64>>>,
) -> Vec<Neighbour> {
    params
        .iter()
        .filter(|(spec, _)| params.is_relevant(spec))
        .flat_map(|(spec, value)| {
            let roundoffs: &[Option<f64>] = if spec.is_index() {
                &[Some(f32::UNIT_ROUNDOFF), Some(f64::UNIT_ROUNDOFF)]
            } else {
                &[None]
            };
            let build = &build;
            let of = move |u: &Option<f64>| neighbour(params, build, (spec, value), *u);
            roundoffs.iter().filter_map(of)
        })
        .collect()
}

fn neighbour(
    params: &ParamSet,
    build: &impl Fn(&ParamSet) -> Option<Box<dyn Scatterer<Df64>>>,
    (spec, value): (&ParamSpec, Value),
    unit_roundoff: Option<f64>,
) -> Option<Neighbour> {
    let step = unit_roundoff.map_or(RELATIVE_STEP, |u| ROUNDOFFS_OF_INDEX * u);
    let scaled = |factor: f64| {
        let value = match value {
            Value::Number(x) => Value::Number(x * factor),
            Value::Rgb(rgb) => Value::Rgb(rgb.map(|x| x * factor)),
            Value::Choice(_) | Value::Bool(_) | Value::Data(_) => return None,
        };
        let mut moved = params.clone();
        moved.set(spec.name, value).ok()?;
        build(&moved)
    };
    let (pair, relative_step) = match (scaled(1.0 + step), scaled(1.0 - step)) {
        (Some(up), Some(down)) => ([up, down], 2.0 * step),
        (Some(up), None) => ([up, build(params)?], step),
        (None, Some(down)) => ([build(params)?, down], step),
        (None, None) => return None,
    };
    Some(Neighbour {
        pair,
        relative_step,
        unit_roundoff,
    })
}
