//! Picking on a sphere.

use glam::Vec3;

/// A half-line in world space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// Start point, in world units.
    pub origin: Vec3,
    /// Unit direction.
    pub direction: Vec3,
}

impl Ray {
    /// Where the ray enters and leaves the sphere of `radius` about the origin, nearest first.
    ///
    /// An entry is `None` if the ray misses the sphere or that point lies behind its start.
    #[must_use]
    pub fn sphere_hits(&self, radius: f32) -> [Option<Vec3>; 2] {
        let closest = -self.origin.dot(self.direction);
        // The closest approach as a point, because |o|^2 - (o.d)^2 cancels near the silhouette.
        let approach = self.origin + closest * self.direction;
        let half_chord_squared = radius * radius - approach.length_squared();
        if half_chord_squared < 0.0 {
            return [None; 2];
        }
        let half_chord = half_chord_squared.sqrt();
        [closest - half_chord, closest + half_chord]
            .map(|t| (t >= 0.0).then(|| self.origin + t * self.direction))
    }

    /// Whether the ray passes through the box with these corners, the least first.
    #[must_use]
    pub fn meets_box(&self, [least, most]: [Vec3; 2]) -> bool {
        // Along an axis where the ray does not move, both are infinite, or NaN on a face, which `min` and `max` pass over.
        let (a, b) = (
            (least - self.origin) / self.direction,
            (most - self.origin) / self.direction,
        );
        let (enters, leaves) = (a.min(b).max_element(), a.max(b).min_element());
        !(enters > leaves || leaves < 0.0)
    }

    /// The point of the sphere of `radius` about the origin for a handle that follows the pointer.
    ///
    /// This is the front hit; the back hit from inside the sphere; and on a miss the point of the
    /// visible outline nearest to the ray, so that a handle slides along the outline.
    #[must_use]
    pub fn drag_on_sphere(&self, radius: f32) -> Vec3 {
        let [front, back] = self.sphere_hits(radius);
        front.or(back).unwrap_or_else(|| self.outline_point(radius))
    }

    /// The outline is the circle of tangent points q with q.(q - eye) = 0.
    fn outline_point(&self, radius: f32) -> Vec3 {
        let axis = self.origin.normalize_or(-self.direction);
        let cosine = (radius / self.origin.length().max(radius)).min(1.0);
        let sideways = self
            .direction
            .reject_from_normalized(axis)
            .normalize_or(axis.any_orthonormal_vector());
        radius * (cosine * axis + (1.0 - cosine * cosine).sqrt() * sideways)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const EYE: Vec3 = Vec3::new(0.0, -3.0, 4.0);

    #[test]
    fn a_box_is_met_where_the_ray_passes_through_it() {
        let bounds = [Vec3::new(-1.0, 0.0, 0.0), Vec3::new(1.0, 2.0, 0.5)];
        let ray = |x, y, z, direction| Ray {
            origin: Vec3::new(x, y, z),
            direction,
        };
        let down = Vec3::NEG_Z;
        assert!(ray(0.5, 1.0, 3.0, down).meets_box(bounds));
        assert!(!ray(1.5, 1.0, 3.0, down).meets_box(bounds));
        assert!(!ray(0.5, 1.0, -1.0, down).meets_box(bounds), "behind");
        assert!(ray(0.5, 1.0, 0.2, down).meets_box(bounds), "from inside");
        assert!(ray(1.0, 1.0, 3.0, down).meets_box(bounds), "along a face");
        let slant = Vec3::new(1.0, 0.0, -1.0);
        assert!(ray(-3.0, 1.0, 3.0, slant).meets_box(bounds));
        assert!(!ray(-5.0, 1.0, 3.0, slant).meets_box(bounds));
    }

    fn ray_to(point: Vec3) -> Ray {
        Ray {
            origin: EYE,
            direction: (point - EYE).normalize_or_zero(),
        }
    }

    #[test]
    fn hits_are_ordered_and_on_the_sphere() {
        let [front, back] = ray_to(Vec3::new(0.2, 0.1, 0.0)).sphere_hits(1.0);
        let (front, back) = (front.expect("front"), back.expect("back"));
        assert!((front.length() - 1.0).abs() < 1e-5 && (back.length() - 1.0).abs() < 1e-5);
        assert!(front.distance(EYE) < back.distance(EYE));
        assert_eq!(ray_to(2.0 * EYE).sphere_hits(1.0), [None, None]);
    }

    #[test]
    fn from_inside_only_the_far_wall_is_hit() {
        let ray = Ray {
            origin: Vec3::ZERO,
            direction: Vec3::X,
        };
        assert_eq!(ray.sphere_hits(1.0), [None, Some(Vec3::X)]);
        assert_eq!(ray.drag_on_sphere(1.0), Vec3::X);
    }

    #[test]
    fn drag_is_continuous_across_the_outline() {
        let mut previous: Option<Vec3> = None;
        for step in 0..4000_u16 {
            let sideways = f32::from(step) * 0.001;
            let handle = ray_to(Vec3::new(sideways, 0.1, 0.0)).drag_on_sphere(1.0);
            assert!((handle.length() - 1.0).abs() < 1e-4);
            assert!(previous.is_none_or(|p| p.distance(handle) < 0.05));
            previous = Some(handle);
        }
    }

    #[test]
    fn a_miss_gives_a_tangent_point() {
        let tangent = ray_to(Vec3::new(5.0, 1.0, 0.0)).drag_on_sphere(1.0);
        assert!(tangent.dot(tangent - EYE).abs() < 1e-5);
    }
}
