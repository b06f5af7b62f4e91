//! The session: all that is saved, shared and shown; everything else on the screen follows from it.

use std::collections::BTreeSet;

use glam::DVec3;
use serde::{Deserialize, Serialize};

use super::number::NumberSpec;
use bxdf::math::frame;
use bxdf::{Material, Side, models};
use bxdf_lab::analysis::{Channel, Hold};

pub mod camera;
mod data;
mod directions;
mod entry;
mod file;
mod four_kinds;
mod instances;
mod layout;
mod materials;
mod numbers;
mod queries;
mod ready;
mod section;
mod size;
mod stored;
mod stored_views;
mod text;
mod ties;
mod written;

pub use camera::{HomeView, OrbitCamera};
pub use directions::Direction;
pub use entry::{EntryId, MaterialEntry, PaletteIndex};
pub use file::{Read, VERSION};
pub use instances::{MAX_VIEWS, Views};
pub use layout::{LEAST_PLACE, Layout, Part, Place, ViewId};
pub use materials::{MAX_MATERIALS, Materials};
pub(crate) use numbers::azimuth;
pub use numbers::{PHI, ROTATION, SECTION_PHI, THETA};
pub use queries::SHARES;
pub use ready::{READY_LAYOUTS, ReadyLayout};
pub use section::Section;
pub use text::{Opened, pasted, read};

/// Which curves the polar plot draws.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Curves {
    /// One curve of the luminance.
    #[default]
    Luminance,
    /// Three curves: R, G and B.
    Rgb,
}

impl Curves {
    /// The channels drawn.
    #[must_use]
    pub fn channels(self) -> &'static [Channel] {
        match self {
            Self::Luminance => &[Channel::Luminance],
            Self::Rgb => &[Channel::Red, Channel::Green, Channel::Blue],
        }
    }
}

/// How the 3D view draws a lobe.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum LobeSurface {
    /// One alone as a body, several as skins.
    #[default]
    Automatic,
    /// As a body that hides what is behind it.
    Solid,
    /// As the edges of its mesh.
    Wire,
    /// As a skin one sees through.
    Translucent,
}

/// What is on the screen.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Session {
    /// The materials; a file may also give one by itself, as `material`.
    #[serde(alias = "material")]
    pub materials: Materials,
    /// The names of parameters that are locked across materials: a change of one changes all that have it.
    #[serde(skip_serializing_if = "BTreeSet::is_empty")]
    pub locked: BTreeSet<String>,
    /// The names of parameters that are pinned: while the views are presented, the bar below them has sliders for those that the
    /// selected material has.
    #[serde(skip_serializing_if = "BTreeSet::is_empty")]
    pub pinned: BTreeSet<String>,
    /// Which direction is held.
    pub hold: Hold,
    /// Polar angle of the held direction from n, in degrees, 0..180. From below opaque materials look as from above:
    /// gestures end at 90 for them.
    pub theta_deg: f64,
    /// Azimuth of the held direction from s, in degrees, -180..180.
    pub phi_deg: f64,
    /// The other direction, where it was put; else it follows the held one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub other: Option<Direction>,
    /// By how much the surface is turned about n, in degrees, -180..180.
    pub rotation_deg: f64,
    /// Azimuth of the section that views share, in degrees; the plane of incidence if absent.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub section_phi_deg: Option<f64>,
    /// The curves of the polar plot, where it shows one material: several have their luminance drawn.
    pub curves: Curves,
    /// Whether values carry |cos(theta)| of the free direction.
    pub with_cosine: bool,
    /// How the 3D view draws the lobes.
    pub lobe_surface: LobeSurface,
    /// Whether the 3D view draws theta, phi and the projection of the held direction.
    pub show_geometry: bool,
    /// The camera of the 3D view.
    pub camera: OrbitCamera,
    /// The views: where they stand, and the options of each. In a file they have the keys
    /// `layout` and `views`.
    #[serde(skip)]
    pub views: Views,
}

impl Default for Session {
    /// A start worth looking at: rough gold, lit from the left at 50 degrees.
    fn default() -> Self {
        Self {
            materials: Materials::of(Material::of(models::START)),
            locked: BTreeSet::new(),
            pinned: BTreeSet::new(),
            hold: Hold::Light,
            theta_deg: 50.0,
            phi_deg: 180.0,
            other: None,
            rotation_deg: 0.0,
            section_phi_deg: None,
            curves: Curves::Luminance,
            with_cosine: false,
            lobe_surface: LobeSurface::Automatic,
            show_geometry: false,
            camera: OrbitCamera::default(),
            views: Views::default(),
        }
    }
}

impl Session {
    /// The start, with this material.
    #[must_use]
    pub fn of(material: Material) -> Self {
        Self {
            materials: Materials::of(material),
            ..Self::default()
        }
    }

    /// The selected material.
    #[must_use]
    pub fn material(&self) -> &Material {
        &self.materials.selected().material
    }

    /// Holds a direction at this polar angle, in degrees, or at the nearest one that is of use.
    pub fn set_theta_deg(&mut self, theta_deg: f64) {
        self.theta_spec().put(&mut self.theta_deg, theta_deg);
    }

    /// The polar angle of the held direction as gestures set it: to the horizon where nothing shown lets light through.
    #[must_use]
    pub fn theta_spec(&self) -> NumberSpec {
        let horizon = 90.0;
        if self.materials.shown().any(is_crossed) {
            THETA
        } else {
            THETA.within([0.0, horizon])
        }
    }

    /// Whether the held direction lies below the surface of materials that are all opaque, so that nothing is to be seen
    /// above it.
    #[must_use]
    pub fn is_held_below(&self) -> bool {
        let mut shown = self.materials.shown().peekable();
        shown.peek().is_some() && !self.theta_spec().admits(self.theta_deg)
    }

    /// Holds the direction as far above the surface as it is below, on the same side of n.
    pub fn raise_held(&mut self) {
        self.set_theta_deg(180.0 - self.theta_deg);
    }

    /// Holds exactly the direction `w` of a surface that is not turned, on the surface as it is turned.
    pub fn hold_on_surface(&mut self, w: DVec3) {
        let w = self.on_surface(w);
        THETA.put(&mut self.theta_deg, frame::theta(w).to_degrees());
        PHI.put(&mut self.phi_deg, frame::phi(w).to_degrees());
    }

    /// Where the direction `w` of a surface that is not turned lies on the surface as it is turned.
    #[must_use]
    pub fn on_surface(&self, w: DVec3) -> DVec3 {
        frame::turned_about_normal(w, self.rotation_deg.to_radians())
    }

    /// Whether the views show what is below the surface: where light can cross it, or comes from below.
    #[must_use]
    pub fn shows_lower_half(&self) -> bool {
        self.theta_deg > 90.0 || self.materials.shown().any(is_crossed)
    }

    /// The curves that the polar plot draws.
    #[must_use]
    pub fn shown_curves(&self) -> Curves {
        if self.materials.is_overlay() {
            Curves::Luminance
        } else {
            self.curves
        }
    }

    /// The name of the held direction.
    #[must_use]
    pub fn held_name(&self) -> &'static str {
        match self.hold {
            Hold::Light => "light",
            Hold::Viewer => "viewer",
        }
    }

    /// The name of the direction that is left free.
    #[must_use]
    pub fn free_name(&self) -> &'static str {
        match self.hold {
            Hold::Light => "viewer",
            Hold::Viewer => "light",
        }
    }
}

/// Whether light passes through the material.
fn is_crossed(entry: &MaterialEntry) -> bool {
    entry.material.has_side(Side::Transmission)
}

/// The azimuth of the same plane, in degrees, from -90 (excluded) to 90.
#[must_use]
pub fn folded_deg(azimuth_deg: f64) -> f64 {
    within_period(azimuth_deg, 90.0)
}

/// The same azimuth, in degrees, from -180 (excluded) to 180.
#[must_use]
pub fn wrapped_deg(angle_deg: f64) -> f64 {
    within_period(angle_deg, 180.0)
}

/// `x` less a multiple of twice `half`, from minus `half` (excluded) to `half`. What is there already stays to the last
/// digit.
fn within_period(x: f64, half: f64) -> f64 {
    if -half < x && x <= half {
        return x;
    }
    let folded = (x + half).rem_euclid(2.0 * half) - half;
    if folded == -half { half } else { folded }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn azimuths_wrap() {
        for (angle, wrapped) in [
            (230.0, -130.0),
            (-180.0, 180.0),
            (180.0, 180.0),
            (0.0, 0.0),
            (-360.0, 0.0),
            (0.345, 0.345),
            (-1e-9, -1e-9),
        ] {
            assert_eq!(wrapped_deg(angle), wrapped);
        }
        assert_eq!([0.345, 120.0, -90.0].map(folded_deg), [0.345, -60.0, 90.0]);
        assert_eq!(
            Session::from_toml("phi_deg = 230.0", "s").unwrap().phi_deg,
            -130.0
        );
        assert_eq!(
            Session::from_toml("hold = \"wo\"", "s").unwrap().hold,
            Hold::Viewer
        );
    }
}
