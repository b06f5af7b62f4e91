//! The four kinds of reflection, side by side.

use super::materials::Materials;
use super::{READY_LAYOUTS, Session};
use crate::views::{Arrangement, ScaleChoice};
use bxdf::material::library;
use bxdf::math::frame;
use glam::DVec3;

/// A named material of each category: diffuse, glossy, perfect specular, retro-reflective.
const OF_EACH_KIND: [&str; 4] = ["chalk", "brass", "mirror", "road_sign"];

impl Session {
    /// Shows a material of each of the four categories of reflection side by side under one light, each lobe to its peak, in
    /// place of the materials there are, in a window with this `room` for views.
    pub fn show_four_kinds(&mut self, room: [f32; 2]) {
        let named = OF_EACH_KIND.iter().filter_map(|id| library::find(id).ok());
        let mut found = named.map(|named| named.material.clone());
        let Some(first) = found.next() else {
            return;
        };
        let mut materials = Materials::of(first);
        for other in found {
            // Four are never too many.
            let _ = materials.add(other);
        }
        let first = materials.iter().next().map(super::MaterialEntry::id);
        if let Some(first) = first {
            materials.select(first);
        }
        self.materials = materials;
        let [look, ..] = &READY_LAYOUTS;
        self.views.show_ready(look, room);
        self.views
            .each_scale(|scale| scale.choose(ScaleChoice::EachToPeak));
        self.views
            .each_arrangement(|arrangement| *arrangement = Arrangement::SideBySide);
        self.put_other(self.beside_mirror());
    }
}

/// How near to the mirror direction the viewer would hide what leaves along it, in degrees.
const HIDING_DEG: f64 = 15.0;

/// From n, where the viewer stands out of the way, in degrees: else at the second of them.
const APART_DEG: [f64; 2] = [25.0, 60.0];

impl Session {
    /// A direction to the other side of n than the held one, away from where a mirror sends it.
    fn beside_mirror(&self) -> DVec3 {
        let theta_deg = self.theta_deg.min(180.0 - self.theta_deg);
        let is_apart = |deg: &f64| (deg - theta_deg).abs() > HIDING_DEG;
        let [steep, flat] = APART_DEG;
        let apart = if is_apart(&steep) { steep } else { flat };
        frame::direction_from_degrees(apart, self.phi_deg + 180.0)
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;
    use bxdf::Category;

    #[test]
    fn each_kind_stands_for_itself() {
        let mut session = Session::default();
        session.show_four_kinds([1280.0, 720.0]);
        assert_eq!(session.materials.shown().count(), 4);
        let mut kinds = BTreeSet::new();
        for entry in session.materials.iter() {
            let surface = entry.material.build::<f64>();
            if entry.material.is_delta_only() {
                kinds.insert(format!("{:?}", Category::PerfectSpecular));
            }
            // The strongest lobe of each stands first.
            let first = surface.lobes().first();
            kinds.extend(first.map(|lobe| format!("{:?}", lobe.category)));
        }
        assert_eq!(kinds.len(), OF_EACH_KIND.len(), "{kinds:?}");
        for theta_deg in [0.0, 20.0, 50.0, 85.0] {
            session.theta_deg = theta_deg;
            session.show_four_kinds([1280.0, 720.0]);
            let held = session.held();
            let mirror = DVec3::new(-held.x, -held.y, held.z);
            let angle = mirror.angle_between(session.other()).to_degrees();
            assert!(angle > HIDING_DEG - 0.1, "{theta_deg}: {angle}");
        }
        let text = session.to_toml().unwrap();
        assert_eq!(Session::from_toml(&text, "s").unwrap(), session);
    }
}
