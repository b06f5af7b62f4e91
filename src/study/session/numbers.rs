//! Every number of a session, with what it may be: the one place for its control and for the reader of its file.

use super::{Session, folded_deg, wrapped_deg};
use crate::number::NumberSpec;
use bxdf_lab::analysis::RadialScale;

/// An angle of a full turn, stored within half a turn either way.
const fn azimuth(name: &'static str) -> NumberSpec {
    NumberSpec::new(name, [-360.0, 360.0])
        .unit("degrees")
        .folded([-180.0, 180.0], wrapped_deg)
}

/// The polar angle of the held direction; [`Session::theta_spec`] has its end for the materials shown.
pub static THETA: NumberSpec = NumberSpec::new("theta_deg", [0.0, 180.0]).unit("degrees");
/// The azimuth of the held direction.
pub static PHI: NumberSpec = azimuth("phi_deg");
/// The turn of the surface.
pub static ROTATION: NumberSpec = azimuth("rotation_deg");
/// The azimuth of the section, a plane: the same after half a turn.
pub static SECTION_PHI: NumberSpec = NumberSpec::new("section_phi_deg", [-360.0, 360.0])
    .unit("degrees")
    .folded([-90.0, 90.0], folded_deg);
/// The decades of a logarithmic radius: beyond 16 a double has no digits left to show.
static DECADES: NumberSpec = NumberSpec::new("scale.logarithmic.decades", [1.0, 16.0]);
/// The angle that the Cartesian plot holds.
pub static FIXED_ANGLE: NumberSpec =
    NumberSpec::new("views.cartesian.fixed_deg", [0.0, 90.0]).unit("degrees");
/// The azimuth of the difference vector in the slice: beyond half a turn the directions change places.
pub static DIFFERENCE_AZIMUTH: NumberSpec =
    NumberSpec::new("views.slice.phi_d_deg", [0.0, 180.0]).unit("degrees");
/// The angle of the sphere's light from the viewer.
pub static LIGHT_THETA: NumberSpec =
    NumberSpec::new("views.sphere.theta_deg", [0.0, 180.0]).unit("degrees");
/// The azimuth of the sphere's light.
pub static LIGHT_PHI: NumberSpec = azimuth("views.sphere.phi_deg");
/// The exposure of the sphere: beyond six stops all is black or white.
pub static EXPOSURE: NumberSpec =
    NumberSpec::new("views.sphere.exposure", [-6.0, 6.0]).unit("stops");
/// The number of samples as a power of 2: fewer show nothing, more do not follow a drag.
pub static SAMPLES_LOG2: NumberSpec =
    NumberSpec::new("views.sampling.count_log2", [6.0, 16.0]).whole();
/// The seed of the random numbers, of 32 bits.
pub static SEED: NumberSpec =
    NumberSpec::new("views.sampling.seed", [0.0, 4_294_967_295.0]).whole();
/// The tolerated error of the trade-off: below a few roundings of f64 no choice can be, above 1 all are.
pub static TOLERANCE: NumberSpec = NumberSpec::new("views.tradeoff.tolerance", [1e-12, 1.0]);
/// The share of a part of a row or a column: beyond this one neighbour is thinner than a line of any screen.
pub(super) static SHARE: NumberSpec = NumberSpec::new("share", [1e-4, 1e4]);

impl Session {
    /// Every number that gestures and files set, with what it may be. Materials, camera and layout check their own.
    fn numbers(&mut self) -> Vec<(&'static NumberSpec, &mut f64)> {
        let views = &mut self.views;
        let mut all = vec![
            (&THETA, &mut self.theta_deg),
            (&PHI, &mut self.phi_deg),
            (&ROTATION, &mut self.rotation_deg),
            (&FIXED_ANGLE, &mut views.cartesian.fixed_deg),
            (&DIFFERENCE_AZIMUTH, &mut views.slice.phi_d_deg),
            (&LIGHT_THETA, &mut views.sphere.theta_deg),
            (&LIGHT_PHI, &mut views.sphere.phi_deg),
            (&EXPOSURE, &mut views.sphere.exposure),
            (&TOLERANCE, &mut views.tradeoff.tolerance),
        ];
        all.extend(self.section_phi_deg.as_mut().map(|phi| (&SECTION_PHI, phi)));
        if let RadialScale::Logarithmic { decades } = &mut self.scale {
            all.push((&DECADES, decades));
        }
        all
    }

    /// Checks every number of a file, and folds angles into their turn.
    ///
    /// # Errors
    /// One sentence that names the number, its value and what is allowed.
    pub(super) fn check_numbers(&mut self) -> Result<(), String> {
        SAMPLES_LOG2.checked(f64::from(self.views.sampling.count_log2))?;
        for (spec, value) in self.numbers() {
            *value = spec.checked(*value)?;
        }
        Ok(())
    }

    /// Takes each number that is not allowed from `before`: whatever a gesture came to, no session holds what its own file
    /// could not be read with. (With what is no number a session is not even equal to itself.)
    pub fn keep_allowed(&mut self, before: &Self) {
        let is_allowed = |(spec, value): &(&NumberSpec, &mut f64)| spec.admits(**value);
        if self.numbers().iter().all(is_allowed) {
            return;
        }
        let mut before = before.clone();
        let old = before.numbers();
        for (spec, value) in self.numbers() {
            let known = old.iter().find(|(other, _)| other.name == spec.name);
            if !spec.admits(*value) {
                let [low, _] = spec.range;
                *value = known.map_or(low, |(_, old)| **old);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use toml::Value;

    use super::*;
    use crate::session::{Layout, READY_LAYOUTS};

    /// A session in whose file every number stands.
    fn full() -> Session {
        let mut session = Session {
            section_phi_deg: Some(30.0),
            scale: RadialScale::Logarithmic { decades: 4.0 },
            ..Session::default()
        };
        session.layout = (READY_LAYOUTS[1].layout)();
        assert!(matches!(session.layout, Layout::Column(_)));
        session
    }

    /// The places of all numbers in `value`, as keys and indices.
    fn places(value: &Value, path: &[String], found: &mut Vec<Vec<String>>) {
        let below = |key: String| [path, &[key]].concat();
        match value {
            Value::Float(_) | Value::Integer(_) => found.push(path.to_vec()),
            Value::Table(table) => {
                for (key, value) in table {
                    places(value, &below(key.clone()), found);
                }
            }
            Value::Array(values) => {
                for (index, value) in values.iter().enumerate() {
                    places(value, &below(index.to_string()), found);
                }
            }
            _ => {}
        }
    }

    fn at<'a>(value: &'a mut Value, path: &[String]) -> &'a mut Value {
        path.iter().fold(value, |value, key| match value {
            Value::Array(values) => &mut values[key.parse::<usize>().unwrap()],
            other => &mut other[key.as_str()],
        })
    }

    /// Holds for whatever number is added to the session too: they are found in its file.
    #[test]
    fn every_number_of_a_file_has_its_range() {
        let file: Value = toml::from_str(&full().to_toml().unwrap()).unwrap();
        let mut found = Vec::new();
        places(&file, &[], &mut found);
        found.retain(|path| path != &["version"]);
        let names: Vec<String> = found.iter().map(|path| path.join(".")).collect();
        assert!(names.len() > 20, "{names:?}");
        for expected in ["views.cartesian.fixed_deg", "camera.yaw", "section_phi_deg"] {
            assert!(names.iter().any(|name| name == expected), "{names:?}");
        }
        for path in &found {
            let is_whole = matches!(at(&mut file.clone(), path), Value::Integer(_));
            let values = if is_whole {
                vec![Value::Integer(-1), Value::Integer(i64::MAX)]
            } else {
                let bad = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e308, -1e308];
                bad.map(Value::Float).to_vec()
            };
            for value in values {
                let mut broken = file.clone();
                *at(&mut broken, path) = value.clone();
                let text = toml::to_string(&broken).unwrap();
                let place = format!("{} = {value}", path.join("."));
                let Err(error) = Session::from_toml(&text, "s.toml") else {
                    panic!("{place} is read");
                };
                let line = error.to_string();
                assert!(!line.contains('\n') && line.starts_with("s.toml"), "{line}");
                let key = path.iter().rev().find(|key| key.parse::<u32>().is_err());
                let is_named = line.contains(key.unwrap()) && line.contains("allowed is");
                let is_named_by_its_line = line.contains("invalid value: integer");
                assert!(is_named || is_named_by_its_line, "{place}: {line}");
            }
        }
    }

    #[test]
    fn what_is_no_number_never_stays() {
        let before = full();
        let mut session = before.clone();
        for (_, value) in session.numbers() {
            *value = f64::NAN;
        }
        session.keep_allowed(&before);
        assert_eq!(session, before);
        let mut session = before.clone();
        session.theta_deg = f64::INFINITY;
        session.views.sphere.exposure = 2.0;
        session.keep_allowed(&before);
        assert_eq!(
            (session.theta_deg, session.views.sphere.exposure),
            (50.0, 2.0)
        );
    }
}
