//! Orbit camera of the 3D views.
//!
//! World axes: `x` is the tangent s, `y` the bitangent t and `z` the surface normal n
//! (right-handed, z up). Angles are in radians, screen positions in egui points.

use core::f32::consts::{FRAC_PI_2, PI, TAU};

use egui::{Pos2, Rect, Vec2};
use glam::camera::rh::{proj::directx, view};
use glam::{Mat4, Vec3};
use serde::{Deserialize, Serialize};

use super::ray::Ray;
use stored::StoredCamera;

mod stored;

/// Angle of view across the narrower side of the viewport, in radians (30 degrees).
///
/// Fixing the narrower side rather than the height keeps a unit dome in view in tall panels too.
const NARROW_FOV: f32 = PI / 6.0;
/// Eye distance of the home views: a unit sphere fills 70 % of the narrower side, which leaves
/// room for axes of length 1.2 and their labels.
const HOME_DISTANCE: f32 = 5.4;
/// Eye distances that [`OrbitCamera::zoom`] can reach, in world units.
const DISTANCE_RANGE: (f32, f32) = (1.2, 20.0);
/// How far [`OrbitCamera::pan`] may move the target from the origin, in world units.
const MAX_TARGET: f32 = 2.0;
/// Half a degree per point: half a turn needs a drag across a typical panel.
const ORBIT_RADIANS_PER_POINT: f32 = PI / 360.0;
/// Near plane as a fraction of the eye distance.
const NEAR_FRACTION: f32 = 0.05;
/// Everything closer than this behind the target is inside the far plane, in world units.
const SCENE_DEPTH: f32 = 8.0;

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
struct Basis {
    right: Vec3,
    up: Vec3,
    toward_eye: Vec3,
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
    pub fn orbit(&mut self, delta_points: Vec2) {
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
    pub fn pan(&mut self, delta_points: Vec2, viewport_points: Vec2) {
        let narrow = viewport_points.min_elem();
        if narrow > 0.0 {
            let units_per_point = 2.0 * self.distance * (0.5 * NARROW_FOV).tan() / narrow;
            let Basis { right, up, .. } = self.basis();
            self.target += units_per_point * (delta_points.y * up - delta_points.x * right);
            *self = self.clone().sanitized();
        }
    }

    /// World space to wgpu clip space (y up, z in 0..1); `aspect` is width / height.
    #[must_use]
    pub fn view_proj(&self, aspect: f32) -> Mat4 {
        let Basis { up, toward_eye, .. } = self.basis();
        // `up` comes from the angles and is always orthogonal to the view direction, so the exact
        // top view is not singular.
        let view = view::look_to_mat4(self.eye(), -toward_eye, up);
        let (tan_x, tan_y) = half_tangents(aspect);
        let near = NEAR_FRACTION * self.distance;
        let far = self.distance + SCENE_DEPTH;
        directx::perspective(2.0 * tan_y.atan(), tan_x / tan_y, near, far) * view
    }

    /// Where a world point appears in `rect` (the view, in points); the result may lie outside it.
    ///
    /// `None` when the point is not in front of the near plane.
    #[must_use]
    pub fn project(&self, point: Vec3, rect: Rect) -> Option<Pos2> {
        let clip = self.view_proj(rect.aspect_ratio()) * point.extend(1.0);
        (clip.w > NEAR_FRACTION * self.distance).then(|| {
            let offset = 0.5 * rect.size() * Vec2::new(clip.x / clip.w, -clip.y / clip.w);
            rect.center() + offset
        })
    }

    /// The ray from the eye through a screen position `pos` of the view `rect`, both in points.
    #[must_use]
    pub fn ray(&self, pos: Pos2, rect: Rect) -> Ray {
        let (tan_x, tan_y) = half_tangents(rect.aspect_ratio());
        let ndc = 2.0 * (pos - rect.center()) / rect.size().max(Vec2::splat(1.0));
        let Basis {
            right,
            up,
            toward_eye,
        } = self.basis();
        let direction = ndc.x * tan_x * right - ndc.y * tan_y * up - toward_eye;
        Ray {
            origin: self.eye(),
            direction: direction.normalize_or(-toward_eye),
        }
    }

    fn basis(&self) -> Basis {
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

/// Tangents of half the horizontal and vertical angle of view; `aspect` is width / height.
fn half_tangents(aspect: f32) -> (f32, f32) {
    let narrow = (0.5 * NARROW_FOV).tan();
    // A collapsed panel has no aspect; any finite view of it will do.
    let aspect = if aspect > 0.0 {
        aspect.clamp(1e-3, 1e3)
    } else {
        1.0
    };
    (narrow * aspect.max(1.0), narrow / aspect.min(1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rect(aspect: f32) -> Rect {
        Rect::from_min_size(Pos2::new(10.0, 20.0), Vec2::new(400.0 * aspect, 400.0))
    }

    fn projected(camera: &OrbitCamera, point: Vec3, rect: Rect) -> Vec2 {
        camera.project(point, rect).expect("in front of the camera") - rect.center()
    }

    #[test]
    fn home_views_have_their_documented_axes() {
        let rect = rect(1.5);
        let side = OrbitCamera::new(HomeView::Side);
        let top = OrbitCamera::new(HomeView::Top);
        for (camera, up_axis) in [(&side, Vec3::Z), (&top, Vec3::Y)] {
            let s = projected(camera, Vec3::X, rect);
            let up = projected(camera, up_axis, rect);
            assert!(s.x > 50.0 && s.y.abs() < 1e-3, "{s:?}");
            assert!(up.y < -50.0 && up.x.abs() < 1e-3, "{up:?}");
        }
    }

    #[test]
    fn unit_sphere_fits_at_every_aspect() {
        for aspect in [0.4, 0.7, 1.0, 1.6, 3.0] {
            let rect = rect(aspect);
            for view in HomeView::ALL {
                let camera = OrbitCamera::new(view);
                for step in 0..400_u16 {
                    let (z, phi) = (f32::from(step) / 200.0 - 1.0, f32::from(step) * 2.4);
                    let r = (1.0 - z * z).max(0.0).sqrt();
                    let p = projected(&camera, Vec3::new(r * phi.cos(), r * phi.sin(), z), rect);
                    let narrow = 0.5 * rect.size().min_elem();
                    assert!(p.abs().max_elem() < 0.9 * narrow, "{view:?} {aspect} {p:?}");
                }
            }
        }
    }

    #[test]
    fn ray_inverts_project_in_every_direction() {
        let rect = rect(0.6);
        let mut camera = OrbitCamera::new(HomeView::ThreeQuarter);
        camera.pan(Vec2::new(15.0, -20.0), rect.size());
        for delta in [
            Vec2::ZERO,
            Vec2::new(90.0, 200.0),
            Vec2::new(-300.0, -500.0),
        ] {
            camera.orbit(delta);
            for pos in [rect.center(), rect.left_top(), Pos2::new(60.0, 333.0)] {
                let ray = camera.ray(pos, rect);
                let back = camera.project(ray.origin + 3.0 * ray.direction, rect);
                assert!(back.expect("in front").distance(pos) < 0.01);
            }
        }
    }

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
