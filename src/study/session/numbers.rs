//! Every number of a session, with what it may be: the one place for its control and for the reader of its file.

use super::{Session, folded_deg, wrapped_deg};
use crate::number::{NumberSpec, Numbers, Refused, are_allowed, checked, keep};

/// An angle of a full turn, stored within half a turn either way.
pub(crate) const fn azimuth(name: &'static str) -> NumberSpec {
    NumberSpec::new(name, [-360.0, 360.0])
        .unit("degrees")
        .folded([-180.0, 180.0], wrapped_deg)
}

/// The polar angle of the held direction; [`Session::theta_spec`] has its end for the materials shown.
pub static THETA: NumberSpec = NumberSpec::new("theta_deg", [0.0, 180.0]).unit("degrees");
/// The azimuth of the held direction.
pub static PHI: NumberSpec = azimuth("phi_deg");
/// The polar angle of the other direction, as files have it.
static OTHER_THETA: NumberSpec = NumberSpec::new("other.theta_deg", [0.0, 180.0]).unit("degrees");
/// The azimuth of the other direction, as files have it.
static OTHER_PHI: NumberSpec = azimuth("other.phi_deg");
/// The turn of the surface.
pub static ROTATION: NumberSpec = azimuth("rotation_deg");
/// The azimuth of the section, a plane: the same after half a turn.
pub static SECTION_PHI: NumberSpec = NumberSpec::new("section_phi_deg", [-360.0, 360.0])
    .unit("degrees")
    .folded([-90.0, 90.0], folded_deg);
/// The share of a part of a row or a column: beyond this one neighbour is thinner than a line of any screen.
pub(super) static SHARE: NumberSpec = NumberSpec::new("share", [1e-4, 1e4]);

impl Session {
    /// Every number that gestures and files set, with what it may be. Materials, camera and views check their own.
    fn numbers(&mut self) -> Numbers<'_> {
        let mut all = vec![
            (&THETA, &mut self.theta_deg),
            (&PHI, &mut self.phi_deg),
            (&ROTATION, &mut self.rotation_deg),
        ];
        if let Some(other) = &mut self.other {
            all.push((&OTHER_THETA, &mut other.theta_deg));
            all.push((&OTHER_PHI, &mut other.phi_deg));
        }
        all.extend(self.section_phi_deg.as_mut().map(|phi| (&SECTION_PHI, phi)));
        all
    }

    /// Checks every number of a file, and folds angles into their turn.
    ///
    /// # Errors
    /// The number that is refused.
    pub(crate) fn check_numbers(&mut self) -> Result<(), Refused> {
        checked(self.numbers())?;
        self.views.check_numbers()
    }

    /// Takes each number that is not allowed from `before`: whatever a gesture came to, no session holds what its own file
    /// could not be read with. (With what is no number a session is not even equal to itself.)
    pub fn keep_allowed(&mut self, before: &Self) {
        self.views.keep_allowed(&before.views);
        if !are_allowed(&self.numbers()) {
            keep(self.numbers(), &before.clone().numbers());
        }
    }
}

#[cfg(test)]
mod tests {
    use toml::Value;

    use super::*;
    use crate::session::{Direction, Place};
    use crate::views::{Options, OwnSection, VIEWS, cartesian, sphere};

    /// A session in whose file every number stands: every kind of view is open, with a section of its own where it has one.
    fn full() -> Session {
        let mut session = Session {
            section_phi_deg: Some(30.0),
            other: Some(Direction {
                theta_deg: 20.0,
                phi_deg: 30.0,
            }),
            ..Session::default()
        };
        let options = VIEWS.iter().map(|kind| {
            let mut options = Options::of(kind);
            if let Some(section) = options.own_section() {
                *section = OwnSection(Some(20.0));
            }
            if let Some(scale) = options.radial_scale() {
                scale.set_logarithmic(true);
                scale.lock(Some(2.0));
            }
            options
        });
        session.views = Place::column(options.map(Place::View).collect()).into();
        let closed = cartesian::Options {
            fixed_deg: 10.0,
            ..cartesian::Options::default()
        };
        session.views.put_away(closed.into());
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
        for expected in [
            "views.cartesian.fixed_deg",
            "layout.column.2.place.view.fixed_deg",
            "layout.column.0.place.view.own_section_deg",
            "camera.yaw",
            "other.theta_deg",
            "section_phi_deg",
            "layout.column.0.place.view.scale.locked_at",
            "layout.column.1.place.view.scale.lengths.logarithmic.decades",
        ] {
            assert!(names.iter().any(|name| name == expected), "{names:?}");
        }
        let whole = toml::to_string(&file).unwrap();
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
                assert!(!line.contains('\n'), "{line}");
                let mut lines = whole.lines().zip(text.lines());
                let number = 1 + lines.position(|(old, new)| old != new).unwrap();
                // Of the camera and of the shares of a layout the line is that of the whole; so is that of a view with a number
                // that its field cannot hold.
                let is_part = |key: &String| key == "camera" || key == "share";
                let is_exact = line.contains("allowed is") && !path.iter().any(is_part);
                let expected = format!("s.toml: line {number}: ");
                assert!(
                    line.starts_with("s.toml: line ") && (!is_exact || line.starts_with(&expected)),
                    "{expected}{line}"
                );
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
        session.views.each(|sphere: &mut sphere::Options| {
            sphere.exposure = f64::NAN;
        });
        session.keep_allowed(&before);
        assert_eq!(session, before);
        session.theta_deg = f64::INFINITY;
        session.views.each(|sphere: &mut sphere::Options| {
            sphere.exposure = 2.0;
            sphere.phi_deg = f64::INFINITY;
        });
        session.keep_allowed(&before);
        let sphere: sphere::Options = session.views.options();
        assert_eq!((session.theta_deg, sphere.exposure), (50.0, 2.0));
        assert_eq!(sphere.phi_deg, 135.0);
    }
}
