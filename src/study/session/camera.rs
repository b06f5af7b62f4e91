//! Where the 3D views are looked at from: an eye that orbits a target.
//!
//! World axes: `x` is the tangent s, `y` the bitangent t and `z` the surface normal n
//! (right-handed, z up). Angles are in radians, motions of the pointer in points of the screen.

use core::f32::consts::{FRAC_PI_2, PI, TAU};

use glam::{Vec2, Vec3};
use serde::{Deserialize, Serialize};

use stored::{DISTANCE_RANGE, MAX_TARGET, StoredCamera};

mod stored;

/// Angle of view across the narrower side of the viewport, in radians (30 degrees).
///
/// Fixing the narrower side rather than the height keeps a unit dome in view in tall panels too.
pub const NARROW_FOV: f32 = PI / 6.0;
/// Eye distance of the home views: a unit sphere fills 70 % of the narrower side, which leaves
/// room for axes of length 1.2 and their labels.
const HOME_DISTANCE: f32 = 5.4;
/// Half a degree per point: half a turn needs a drag across a typical panel.
const ORBIT_RADIANS_PER_POINT: f32 = PI / 360.0;

/// A named view direction to return to.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum HomeView {
    /// Along +t: s points right and n points up.
    Side,
    /// Straight down the normal: s points right and t points up.
    Top,
    /// From above and to the side, so that all three axes are visible.
    #[default]
    ThreeQuarter,
}

impl HomeView {
    /// All views, in the order in which to offer them.
    pub const ALL: [Self; 3] = [Self::Side, Self::Top, Self::ThreeQuarter];

    /// English name for a button or menu.
    #[must_use]
    pub const fn label(self) -> &'static str {
        match self {
            Self::Side => "Side",
            Self::Top => "Top",
            Self::ThreeQuarter => "Three-quarter",
        }
    }

    /// Yaw and pitch of the view, in radians.
    const fn angles(self) -> (f32, f32) {
        match self {
            Self::Side => (-FRAC_PI_2, 0.0),
            Self::Top => (-FRAC_PI_2, FRAC_PI_2),
            Self::ThreeQuarter => (-FRAC_PI_2 + PI / 6.0, PI / 7.5),
        }
    }
}

/// Perspective camera that orbits a target point, always with n up on screen.
///
/// Two equal cameras draw the same picture, so a view can be cached by its camera.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "StoredCamera")]
pub struct OrbitCamera {
    yaw: f32,
    pitch: f32,
    distance: f32,
    target: Vec3,
}

impl Default for OrbitCamera {
    fn default() -> Self {
        Self::new(HomeView::default())
    }
}

/// Orthonormal camera axes in world space: to the right, up, and from the target to the eye.
pub struct Basis {
    /// To the right of the screen.
    pub right: Vec3,
    /// Up the screen.
    pub up: Vec3,
    /// Out of the screen.
    pub toward_eye: Vec3,
}

impl OrbitCamera {
    /// A camera at the given home view.
    #[must_use]
    pub fn new(view: HomeView) -> Self {
        let (yaw, pitch) = view.angles();
        Self {
            yaw,
            pitch,
            distance: HOME_DISTANCE,
            target: Vec3::ZERO,
        }
    }

    /// Returns to a home view: direction, distance and target.
    pub fn home(&mut self, view: HomeView) {
        *self = Self::new(view);
    }

    /// Whether it stands at one of the home views, but for rounding.
    #[must_use]
    pub fn is_home(&self) -> bool {
        /// Of angles in radians and of places in world units: no eye sees less.
        const ROUNDING: f32 = 1e-4;
        HomeView::ALL.into_iter().map(Self::new).any(|home| {
            let angles = [self.yaw - home.yaw, self.pitch - home.pitch];
            let is_near = |x: f32| x.abs() < ROUNDING;
            angles.into_iter().all(is_near)
                && is_near(self.distance - home.distance)
                && is_near(self.target.distance(home.target))
        })
    }

    /// The camera on the way from this one to `other`, 0 to 1: the shorter way round, at a distance that changes evenly in
    /// proportion.
    #[must_use]
    pub fn on_way_to(&self, other: &Self, part: f32) -> Self {
        let turn = PI - (PI - (other.yaw - self.yaw)).rem_euclid(TAU);
        let stretch = (other.distance / self.distance).powf(part);
        let between = |a: f32, b: f32| a + (b - a) * part;
        Self {
            yaw: self.yaw + turn * part,
            pitch: between(self.pitch, other.pitch),
            distance: self.distance * stretch,
            target: self.target.lerp(other.target, part),
        }
        .sanitized()
    }

    /// Azimuth of the eye about n from +s towards +t, in radians, in (-pi, pi].
    #[must_use]
    pub const fn yaw(&self) -> f32 {
        self.yaw
    }

    /// Elevation of the eye above the s-t plane, in radians, in [-pi/2, pi/2].
    #[must_use]
    pub const fn pitch(&self) -> f32 {
        self.pitch
    }

    /// Distance from the eye to the target, in world units.
    #[must_use]
    pub const fn distance(&self) -> f32 {
        self.distance
    }

    /// Point at the centre of the view, in world units.
    #[must_use]
    pub const fn target(&self) -> Vec3 {
        self.target
    }

    /// Moves the centre of the view to `target`, in world units, at most 2 from the origin.
    ///
    /// For example up the normal, for a scene that has only its upper half.
    pub fn set_target(&mut self, target: Vec3) {
        self.target = target;
        *self = self.clone().sanitized();
    }

    /// Eye position, in world units.
    #[must_use]
    pub fn eye(&self) -> Vec3 {
        self.target + self.distance * self.basis().toward_eye
    }

    /// Turns the scene with the pointer; `delta_points` is the pointer motion in points.
    pub fn orbit(&mut self, delta_points: impl Into<[f32; 2]>) {
        let delta_points = Vec2::from(delta_points.into());
        self.yaw -= delta_points.x * ORBIT_RADIANS_PER_POINT;
        self.pitch += delta_points.y * ORBIT_RADIANS_PER_POINT;
        *self = self.clone().sanitized();
    }

    /// Magnifies by `factor` (above 1 moves closer), within fixed limits.
    pub fn zoom(&mut self, factor: f32) {
        if factor > 0.0 {
            self.distance /= factor;
            *self = self.clone().sanitized();
        }
    }

    /// Moves the scene with the pointer, so that the target plane stays under it.
    ///
    /// `delta_points` is the pointer motion and `viewport_points` the size of the view, both in
    /// points.
    pub fn pan(&mut self, delta_points: impl Into<[f32; 2]>, viewport_points: impl Into<[f32; 2]>) {
        let delta_points = Vec2::from(delta_points.into());
        let viewport_points = Vec2::from(viewport_points.into());
        let narrow = viewport_points.min_element();
        if narrow > 0.0 {
            let units_per_point = 2.0 * self.distance * (0.5 * NARROW_FOV).tan() / narrow;
            let Basis { right, up, .. } = self.basis();
            self.target += units_per_point * (delta_points.y * up - delta_points.x * right);
            *self = self.clone().sanitized();
        }
    }

    /// Its axes in world space.
    #[must_use]
    pub fn basis(&self) -> Basis {
        let (sin_yaw, cos_yaw) = self.yaw.sin_cos();
        let (sin_pitch, cos_pitch) = self.pitch.sin_cos();
        Basis {
            right: Vec3::new(-sin_yaw, cos_yaw, 0.0),
            up: Vec3::new(-sin_pitch * cos_yaw, -sin_pitch * sin_yaw, cos_pitch),
            toward_eye: Vec3::new(cos_pitch * cos_yaw, cos_pitch * sin_yaw, sin_pitch),
        }
    }

    /// The nearest valid camera; a home view if a value is not finite.
    fn sanitized(self) -> Self {
        let Self {
            yaw,
            pitch,
            distance,
            target,
        } = self;
        if !(yaw.is_finite() && pitch.is_finite() && distance.is_finite() && target.is_finite()) {
            return Self::default();
        }
        Self {
            yaw: PI - (PI - yaw).rem_euclid(TAU),
            pitch: pitch.clamp(-FRAC_PI_2, FRAC_PI_2),
            distance: distance.clamp(DISTANCE_RANGE.0, DISTANCE_RANGE.1),
            target: target.clamp_length_max(MAX_TARGET),
        }
    }
}

impl TryFrom<StoredCamera> for OrbitCamera {
    type Error = String;

    fn try_from(stored: StoredCamera) -> Result<Self, String> {
        let StoredCamera {
            yaw,
            pitch,
            distance,
            target,
        } = stored.checked().map_err(|refused| refused.to_string())?;
        let camera = Self {
            yaw,
            pitch,
            distance,
            target,
        };
        Ok(camera.sanitized())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_camera_is_home_until_it_is_moved() {
        for view in HomeView::ALL {
            let home = OrbitCamera::new(view);
            let mut moved = [home.clone(), home.clone(), home.clone()];
            let [orbited, zoomed, panned] = &mut moved;
            orbited.orbit(Vec2::new(3.0, 0.0));
            zoomed.zoom(1.05);
            panned.pan(Vec2::new(3.0, 0.0), Vec2::splat(300.0));
            assert!(home.is_home());
            assert!(moved.iter().all(|camera| !camera.is_home()), "{view:?}");
        }
    }

    #[test]
    fn the_way_to_another_camera_is_the_shorter_one() {
        let [mut from, mut to] = [OrbitCamera::default(), OrbitCamera::default()];
        from.orbit(Vec2::new(-400.0, 0.0));
        to.orbit(Vec2::new(120.0, 60.0));
        to.zoom(4.0);
        let way = [0.0, 0.5, 1.0].map(|part| from.on_way_to(&to, part));
        assert!((way[0].yaw - from.yaw).abs() < 1e-5 && way[0].distance == from.distance);
        assert!((way[2].yaw - to.yaw).abs() < 1e-5 && (way[2].pitch - to.pitch).abs() < 1e-5);
        // 520 points are 260 degrees one way and 100 the other; half of that, and half of the zoom in proportion.
        let turned = (way[1].yaw - from.yaw).rem_euclid(TAU);
        assert!((turned - 50_f32.to_radians()).abs() < 1e-5, "{turned}");
        assert!((way[1].distance - HOME_DISTANCE / 2.0).abs() < 1e-5);
    }

    #[test]
    fn zoom_and_pan_keep_their_limits() {
        let mut camera = OrbitCamera::default();
        for (factor, distance) in [(1e9, DISTANCE_RANGE.0), (1e-9, DISTANCE_RANGE.1)] {
            camera.zoom(factor);
            assert!((camera.distance() - distance).abs() < 1e-6);
        }
        camera.pan(Vec2::new(1e6, 0.0), Vec2::splat(300.0));
        assert!(camera.target().length() < MAX_TARGET + 1e-3);
    }
}
