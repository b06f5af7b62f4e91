//! The camera as a file has it, with what each of its numbers may be.

use glam::Vec3;
use serde::Deserialize;

use crate::number::{NumberSpec, Refused};

/// Eye distances that [`super::OrbitCamera::zoom`] can reach, in world units.
pub(super) const DISTANCE_RANGE: (f32, f32) = (1.2, 20.0);
/// How far [`super::OrbitCamera::pan`] may move the target from the origin, in world units.
pub(super) const MAX_TARGET: f32 = 2.0;

/// The camera of a file, which may have been edited.
#[derive(Deserialize)]
pub(super) struct StoredCamera {
    pub(super) yaw: f32,
    pub(super) pitch: f32,
    pub(super) distance: f32,
    pub(super) target: Vec3,
}

/// The azimuth of the eye in a file, within a turn either way.
static YAW: NumberSpec = NumberSpec::new("camera.yaw", [-7.0, 7.0]).unit("radians");
/// The elevation of the eye in a file; a right angle in single precision is more than one in double precision.
static PITCH: NumberSpec = NumberSpec::new("camera.pitch", [-1.571, 1.571]).unit("radians");
/// The distance of the eye in a file, with room for rounding.
static DISTANCE: NumberSpec = NumberSpec::new(
    "camera.distance",
    [
        0.999 * DISTANCE_RANGE.0 as f64,
        1.001 * DISTANCE_RANGE.1 as f64,
    ],
);
/// Each coordinate of the target in a file, with room for rounding.
static TARGET: NumberSpec = NumberSpec::new(
    "camera.target",
    [-1.001 * MAX_TARGET as f64, 1.001 * MAX_TARGET as f64],
);

impl StoredCamera {
    /// Refuses what no camera has, naming what is allowed.
    pub(super) fn checked(self) -> Result<Self, Refused> {
        let angles = [
            (&YAW, self.yaw),
            (&PITCH, self.pitch),
            (&DISTANCE, self.distance),
        ];
        for (spec, value) in angles {
            spec.checked(f64::from(value))?;
        }
        for coordinate in self.target.to_array() {
            TARGET.checked(f64::from(coordinate))?;
        }
        Ok(self)
    }
}

#[cfg(test)]
mod tests {
    use core::f32::consts::PI;

    use glam::Vec2;

    use super::super::OrbitCamera;

    #[test]
    fn stored_values_have_their_ranges() {
        let stored = |text: &str| serde_json::from_str::<OrbitCamera>(text);
        let turned = r#"{"yaw": 6.0, "pitch": 0.5, "distance": 3.0, "target": [1.0, 0.0, 0.0]}"#;
        let camera = stored(turned).expect("within its ranges");
        assert!(camera.yaw() <= PI && camera.eye().is_finite());
        for (good, bad) in [
            ("6.0", "9.0"),
            ("0.5", "2.0"),
            ("3.0", "0.0"),
            ("[1.0", "[1e30"),
        ] {
            let error = stored(&turned.replace(good, bad)).expect_err(bad);
            assert!(error.to_string().contains("allowed is"), "{error}");
        }
        let mut far = OrbitCamera::default();
        for step in 0..50_u8 {
            far.orbit(Vec2::new(f32::from(step) * 37.0, f32::from(step) * 50.0));
            far.pan(Vec2::new(1e4, f32::from(step)), Vec2::splat(300.0));
            far.zoom(if step % 2 == 0 { 1e9 } else { 1e-9 });
            let text = serde_json::to_string(&far).expect("a camera");
            assert_eq!(stored(&text).expect("what is written"), far);
        }
    }
}
