//! What a map runs over.

use super::place::Place;
use bxdf::Material;
use bxdf::param::{Kind, ParamSet, ParamSpec, Role, Scale, Value};

/// What a map runs over along one of its sides.
#[derive(Clone, Debug, PartialEq)]
pub enum Axis {
    /// The polar angle of wo, in degrees: 0..90, on the side where it is.
    ThetaO,
    /// That of wi.
    ThetaI,
    /// 90 degrees less the polar angle of wo, by decades from 90 to 1e-7.
    GrazingO,
    /// 90 degrees less that of wi.
    GrazingI,
    /// The azimuth of wi less that of wo, in degrees.
    Azimuth,
    /// Both widths of a component together.
    Width(usize),
    /// The ratio of the widths of a component, at the same product of both where the range allows it.
    Anisotropy(usize),
    /// The distance of a component's index from 1, by decades.
    IndexLessOne(usize),
    /// A number of a component.
    Parameter(usize, &'static ParamSpec),
}

/// The smallest distance from the horizon, in degrees.
const LEAST_GRAZING_DEG: f64 = 1e-7;

/// The range of the ratio of widths.
const RATIOS: [f64; 2] = [1.0, 1e4];

/// The range of an index less 1.
const FROM_ONE: [f64; 2] = [1e-7, 1.0];

/// What counts as 0 where a range goes by decades.
const LEAST: f64 = 1e-4;

impl Axis {
    /// The axes of angles.
    const ANGLES: [Self; 5] = [
        Self::ThetaO,
        Self::ThetaI,
        Self::GrazingO,
        Self::GrazingI,
        Self::Azimuth,
    ];

    /// Every axis of `material`: angles, then the numbers of its components that have an effect.
    #[must_use]
    pub fn all(material: &Material) -> Vec<Self> {
        let mut all = Self::ANGLES.to_vec();
        for (index, component) in material.components().iter().enumerate() {
            let params = component.params();
            if params.widths().is_some() {
                all.extend([Self::Width(index), Self::Anisotropy(index)]);
            }
            for (spec, _) in params.iter().filter(|(spec, _)| params.is_relevant(spec)) {
                let is_number = matches!(spec.kind, Kind::Number | Kind::Rgb);
                if spec.is_index() {
                    all.push(Self::IndexLessOne(index));
                }
                if is_number && !spec.is_colour() {
                    all.push(Self::Parameter(index, spec));
                }
            }
        }
        all
    }

    /// The word for it, that of the same axis in every material that has it.
    #[must_use]
    pub fn id(&self) -> String {
        let of = |index: usize, name: &str| match index {
            0 => name.to_owned(),
            _ => format!("{name} of {}", index + 1),
        };
        match self {
            Self::ThetaO => "theta_o".to_owned(),
            Self::ThetaI => "theta_i".to_owned(),
            Self::GrazingO => "grazing_o".to_owned(),
            Self::GrazingI => "grazing_i".to_owned(),
            Self::Azimuth => "azimuth".to_owned(),
            Self::Width(index) => of(*index, "alpha"),
            Self::Anisotropy(index) => of(*index, "anisotropy"),
            Self::IndexLessOne(index) => of(*index, "eta less 1"),
            Self::Parameter(index, spec) => of(*index, spec.name),
        }
    }

    /// The name with its unit.
    #[must_use]
    pub fn title(&self) -> String {
        match self {
            Self::ThetaO => "θo (°)".to_owned(),
            Self::ThetaI => "θi (°)".to_owned(),
            Self::GrazingO => "90° − θo (°)".to_owned(),
            Self::GrazingI => "90° − θi (°)".to_owned(),
            Self::Azimuth => "φi − φo (°)".to_owned(),
            Self::Anisotropy(_) => "ratio of widths".to_owned(),
            Self::Parameter(_, spec) if !spec.unit.is_empty() => {
                format!("{} ({})", self.id(), spec.unit)
            }
            _ => self.id(),
        }
    }

    /// Smallest and largest value.
    #[must_use]
    pub fn range(&self) -> [f64; 2] {
        match self {
            Self::ThetaO | Self::ThetaI => [0.0, 90.0],
            Self::GrazingO | Self::GrazingI => [LEAST_GRAZING_DEG, 90.0],
            Self::Azimuth => [0.0, 180.0],
            Self::Width(_) => [LEAST, 1.0],
            Self::Anisotropy(_) => RATIOS,
            Self::IndexLessOne(_) => FROM_ONE,
            Self::Parameter(_, spec) if self.is_logarithmic() => {
                let [min, max] = spec.hard;
                [min.max(LEAST), max]
            }
            Self::Parameter(_, spec) => spec.soft,
        }
    }

    /// Whether it runs by decades.
    #[must_use]
    pub fn is_logarithmic(&self) -> bool {
        match self {
            Self::ThetaO | Self::ThetaI | Self::Azimuth => false,
            Self::Parameter(_, spec) => spec.scale == Scale::Logarithmic || spec.hard[1] > 100.0,
            _ => true,
        }
    }

    /// The value at a share of the axis, 0..1.
    #[must_use]
    pub fn value(&self, share: f64) -> f64 {
        let [from, to] = self.range();
        if self.is_logarithmic() {
            from * (to / from).powf(share)
        } else {
            from + share * (to - from)
        }
    }

    /// The share at which `place` stands on it, 0..1; at an end where it lies beyond.
    #[must_use]
    pub fn share(&self, place: &Place) -> f64 {
        let found = |index: usize, find: &dyn Fn(&ParamSet) -> Option<Value>| {
            let component = place.material.components().get(index);
            match component.and_then(|component| find(component.params())) {
                Some(Value::Number(x) | Value::Rgb([x, ..])) => x,
                _ => 0.0,
            }
        };
        let of_role = |index: usize, role| {
            found(index, &|params| {
                params.of_role(role).map(|(_, value)| value)
            })
        };
        let value = match self {
            Self::ThetaO => place.theta_o_deg,
            Self::ThetaI => place.theta_i_deg,
            Self::GrazingO => 90.0 - place.theta_o_deg,
            Self::GrazingI => 90.0 - place.theta_i_deg,
            Self::Azimuth => place.azimuth_deg,
            Self::Width(index) => of_role(*index, Role::WidthS),
            Self::Anisotropy(index) => {
                of_role(*index, Role::WidthS) / of_role(*index, Role::WidthT)
            }
            Self::IndexLessOne(index) => (of_role(*index, Role::Index) - 1.0).abs(),
            Self::Parameter(index, spec) => found(*index, &|params| params.get(spec.name)),
        };
        let [from, to] = self.range();
        let share = if self.is_logarithmic() {
            (value.max(f64::MIN_POSITIVE) / from).ln() / (to / from).ln()
        } else {
            (value - from) / (to - from)
        };
        share.clamp(0.0, 1.0)
    }

    /// Whether it changes the material.
    pub(super) fn is_of_material(&self) -> bool {
        !Self::ANGLES.contains(self)
    }

    /// `place` with this axis at `value`; `None` where the material refuses it.
    pub(super) fn moved(&self, place: &Place, value: f64) -> Option<Place> {
        let mut moved = place.clone();
        let params = |index: usize| Some(place.material.components().get(index)?.params());
        let with = |index: usize, values: &[(&str, f64)]| {
            let mut components = place.material.components().to_vec();
            let component = components.get_mut(index)?;
            let mut params = component.params().clone();
            for (name, x) in values {
                let value = match params.get(name)? {
                    Value::Rgb(_) => Value::Rgb([*x; 3]),
                    _ => Value::Number(*x),
                };
                params.set(name, value).ok()?;
            }
            component.set_all(&params).ok()?;
            place.material.with_components(components).ok()
        };
        match self {
            Self::ThetaO => moved.theta_o_deg = value,
            Self::ThetaI => moved.theta_i_deg = value,
            Self::GrazingO => moved.theta_o_deg = 90.0 - value,
            Self::GrazingI => moved.theta_i_deg = 90.0 - value,
            Self::Azimuth => moved.azimuth_deg = value,
            Self::Width(index) => {
                let [s, t] = params(*index)?.widths()?;
                moved.material = with(*index, &[(s, value), (t, value)])?;
            }
            Self::Anisotropy(index) => {
                let params = params(*index)?;
                let [s, t] = params.widths()?;
                let product = params.number(s) * params.number(t);
                let x = (product * value).sqrt().clamp(value * LEAST, 1.0);
                moved.material = with(*index, &[(s, x), (t, x / value)])?;
            }
            Self::IndexLessOne(index) => {
                let (spec, _) = params(*index)?.of_role(Role::Index)?;
                moved.material = with(*index, &[(spec.name, 1.0 + value)])?;
            }
            Self::Parameter(index, spec) => moved.material = with(*index, &[(spec.name, value)])?,
        }
        Some(moved)
    }
}
