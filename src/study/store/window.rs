//! Where the window stands.

use serde::{Deserialize, Serialize};

use crate::number::NumberSpec;

/// How far from the first corner of the screens a window may stand, in points: no screens reach further.
static PLACE: NumberSpec = NumberSpec::new("position", [-1e5, 1e5]).unit("points");

/// How large it may be.
static SIZE: NumberSpec = NumberSpec::new("size", [1.0, 1e5]).unit("points");

/// Where the window stands, and how large it is, while it neither fills the screen nor is folded away.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct WindowPlace {
    /// Its upper left corner, in points; `None` where the system does not say.
    pub position: Option<[f32; 2]>,
    /// The size of what is in its frame, in points.
    pub size: [f32; 2],
    /// Whether it fills the screen now.
    pub is_maximized: bool,
}

impl WindowPlace {
    /// Whether its numbers are such as windows have.
    pub(super) fn is_allowed(&self) -> bool {
        let admits = |spec: &NumberSpec, values: [f32; 2]| {
            let mut values = values.into_iter();
            values.all(|x| spec.admits(f64::from(x)))
        };
        admits(&SIZE, self.size) && self.position.is_none_or(|place| admits(&PLACE, place))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_broken_place_is_none() {
        let place = WindowPlace {
            position: Some([-1800.0, 40.0]),
            size: [1000.0, 700.0],
            is_maximized: false,
        };
        assert!(place.is_allowed());
        for broken in [
            WindowPlace {
                position: Some([f32::NAN, 0.0]),
                ..place
            },
            WindowPlace {
                size: [1e9, 700.0],
                ..place
            },
            WindowPlace {
                size: [0.0, 700.0],
                ..place
            },
        ] {
            assert!(!broken.is_allowed(), "{broken:?}");
        }
    }
}
