//! The projection of the 3D views: what an orbit camera sees in a rectangle of the screen.
//!
//! Screen positions are in egui points, angles in radians.

use egui::{Pos2, Rect, Vec2};
use glam::camera::rh::{proj::directx, view};
use glam::{Mat4, Vec3};

use super::ray::Ray;
use bxdf_study::session::camera::{Basis, NARROW_FOV, OrbitCamera};

/// Near plane as a fraction of the eye distance.
const NEAR_FRACTION: f32 = 0.05;
/// Everything closer than this behind the target is inside the far plane, in world units.
const SCENE_DEPTH: f32 = 8.0;

/// What a camera sees.
pub trait Projection {
    /// World space to wgpu clip space (y up, z in 0..1); `aspect` is width / height.
    #[must_use]
    fn view_proj(&self, aspect: f32) -> Mat4;

    /// Where a world point appears in `rect` (the view, in points); the result may lie outside it.
    ///
    /// `None` when the point is not in front of the near plane.
    #[must_use]
    fn project(&self, point: Vec3, rect: Rect) -> Option<Pos2>;

    /// The ray from the eye through a screen position `pos` of the view `rect`, both in points.
    #[must_use]
    fn ray(&self, pos: Pos2, rect: Rect) -> Ray;
}

impl Projection for OrbitCamera {
    fn view_proj(&self, aspect: f32) -> Mat4 {
        let Basis { up, toward_eye, .. } = self.basis();
        // `up` comes from the angles and is always orthogonal to the view direction, so the exact
        // top view is not singular.
        let view = view::look_to_mat4(self.eye(), -toward_eye, up);
        let (tan_x, tan_y) = half_tangents(aspect);
        let near = NEAR_FRACTION * self.distance();
        let far = self.distance() + SCENE_DEPTH;
        directx::perspective(2.0 * tan_y.atan(), tan_x / tan_y, near, far) * view
    }

    fn project(&self, point: Vec3, rect: Rect) -> Option<Pos2> {
        let clip = self.view_proj(rect.aspect_ratio()) * point.extend(1.0);
        (clip.w > NEAR_FRACTION * self.distance()).then(|| {
            let offset = 0.5 * rect.size() * Vec2::new(clip.x / clip.w, -clip.y / clip.w);
            rect.center() + offset
        })
    }

    fn ray(&self, pos: Pos2, rect: Rect) -> Ray {
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
    use bxdf_study::session::camera::HomeView;

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
        camera.pan([15.0, -20.0], rect.size());
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
}
