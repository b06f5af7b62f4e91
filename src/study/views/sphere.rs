//! The lit sphere.

use serde::{Deserialize, Serialize};

use super::caption::{Caption, Directions, Subjects};
use super::kind::{Deltas, TableKind, ViewKind, ViewOptions};
use super::words::words;
use crate::answers::Answers;
use crate::export::table::{Table, shown};
use crate::number::{NumberSpec, Numbers};
use crate::session::{MaterialEntry, Session, azimuth};
use bxdf::math::frame;
use bxdf_lab::analysis::sphere::{Light, Request};

pub(super) const KIND: ViewKind = ViewKind {
    id: "sphere",
    title: "Lit sphere",
    what_you_see: "A sphere of the material under a light, in true proportion; a click takes \
        the directions of that point",
    says_hidden: true,
    deltas: Deltas::Marked,
    with_cosine: false,
    table: TableKind::Computed,
    is_mesh: false,
};

/// The angle of the sphere's light from the viewer.
pub static LIGHT_THETA: NumberSpec =
    NumberSpec::new("sphere.theta_deg", [0.0, 180.0]).unit("degrees");
/// The azimuth of the sphere's light.
pub static LIGHT_PHI: NumberSpec = azimuth("sphere.phi_deg");
/// The exposure of the sphere: beyond six stops all is black or white.
pub static EXPOSURE: NumberSpec = NumberSpec::new("sphere.exposure", [-6.0, 6.0]).unit("stops");

/// The sizes of pictures of spheres, in pixels: the smallest that fills its place is computed.
const SIZES: [usize; 3] = [128, 256, 512];

words! {
    /// How the spheres of several materials are arranged.
    Arrangement {
        /// Side by side.
        #[default]
        Grid = "Side by side",
        /// As strips of one sphere.
        Wipe = "Wipe",
        /// The difference of each from the reference.
        Difference = "Difference",
    }
}

words! {
    /// How radiance becomes brightness.
    Curve {
        /// By a curve that reaches white nowhere: nothing is clipped.
        #[default]
        Soft = "Soft",
        /// In proportion, clipped at white.
        Linear = "Linear",
    }
}

/// The curve of files that say none: there was only one before version 3.
fn linear() -> Curve {
    Curve::Linear
}

/// How the lit sphere is shown.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Options {
    /// What lights it.
    pub light: Light,
    /// Whether the light stands where the session's does, and a mirror, which would show one point of it, shows the sky. Files
    /// that do not say so have a light of the view's own.
    #[serde(default)]
    pub is_shared: bool,
    /// How radiance becomes brightness.
    #[serde(default = "linear")]
    pub curve: Curve,
    /// The angle of the view's own light from the viewer's axis, in degrees.
    pub theta_deg: f64,
    /// Its azimuth, in degrees: 0 to the right, 90 above.
    pub phi_deg: f64,
    /// The exposure in stops: each one doubles.
    pub exposure: f64,
    /// How several stand.
    pub arrangement: Arrangement,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            light: Light::default(),
            is_shared: true,
            curve: Curve::default(),
            theta_deg: 45.0,
            phi_deg: 135.0,
            exposure: 0.0,
            arrangement: Arrangement::default(),
        }
    }
}

impl Options {
    /// Where the light stands: the angle from the viewer's axis, and the azimuth, in degrees.
    #[must_use]
    pub fn light_at(&self, session: &Session) -> [f64; 2] {
        if !self.is_shared {
            return [self.theta_deg, self.phi_deg];
        }
        let light = session.light();
        [frame::theta(light), frame::phi(light)].map(f64::to_degrees)
    }

    /// Gives the view a light of its own, where it stands now.
    pub fn keep_light(&mut self, session: &Session) {
        [self.theta_deg, self.phi_deg] = self.light_at(session);
        self.is_shared = false;
    }

    /// The lit sphere of a material, in a place this many pixels wide.
    #[must_use]
    pub fn request(&self, session: &Session, entry: &MaterialEntry, pixels: f32) -> Request {
        let [.., largest] = SIZES;
        let fits = |size: &usize| *size as f32 >= pixels;
        Request {
            light: self.light_of(entry),
            direction: self.light_at(session),
            size: SIZES.into_iter().find(fits).unwrap_or(largest),
        }
    }

    /// What lights the sphere of a material.
    fn light_of(&self, entry: &MaterialEntry) -> Light {
        let is_mirror = entry.material.is_delta_only();
        if self.is_shared && is_mirror && self.light == Light::Directional {
            return Light::Sky;
        }
        self.light
    }
}

impl ViewOptions for Options {
    fn caption(&self, _: &Session) -> Caption {
        let names = match self.arrangement {
            Arrangement::Wipe => Subjects::Colors,
            Arrangement::Grid | Arrangement::Difference => Subjects::Apart,
        };
        let light = self.light.title().to_lowercase();
        Caption::of(light).naming(names).at(Directions::None)
    }

    fn is_of_held(&self) -> bool {
        false
    }

    fn numbers(&mut self) -> Numbers<'_> {
        vec![
            (&LIGHT_THETA, &mut self.theta_deg),
            (&LIGHT_PHI, &mut self.phi_deg),
            (&EXPOSURE, &mut self.exposure),
        ]
    }

    /// The radiance of its pixels.
    fn table(&self, session: &Session, answers: &mut Answers) -> Table {
        let mut table = Table::new(&[
            "material",
            "x",
            "y",
            "radiance_r",
            "radiance_g",
            "radiance_b",
            "coverage",
        ]);
        for (entry, title) in shown(session) {
            let request = self.request(session, entry, f32::INFINITY);
            let picture = answers.ask(session, entry, request);
            for (index, [r, g, b, coverage]) in picture.pixels.iter().enumerate() {
                if *coverage > 0.0 {
                    let place =
                        |index: usize, n: usize| 2.0 * (index as f64 + 0.5) / n as f64 - 1.0;
                    let (x, y) = (index % picture.width, index / picture.width);
                    let place = [place(x, picture.width), -place(y, picture.height)];
                    table.push(
                        &title,
                        place
                            .into_iter()
                            .chain([*r, *g, *b, *coverage].map(f64::from)),
                    );
                }
            }
        }
        table
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spheres_are_as_large_as_their_places() {
        let (options, session) = (Options::default(), Session::default());
        let entry = session.materials.selected();
        for (pixels, size) in [(10.0, 128), (128.0, 128), (129.0, 256), (4000.0, 512)] {
            assert_eq!(options.request(&session, entry, pixels).size, size);
        }
    }

    #[test]
    fn the_light_is_the_session_s_unless_the_view_has_its_own() {
        let mut session = Session::of("specular_reflection".parse().unwrap());
        let request = |options: &Options, session: &Session| {
            options.request(session, session.materials.selected(), 100.0)
        };
        session.set_theta_deg(20.0);
        let shared = request(&Options::default(), &session);
        assert!((shared.direction[0] - 20.0).abs() < 1e-9);
        assert_eq!(shared.light, Light::Sky, "a mirror would show one point");
        let read: Options = toml::from_str("theta_deg = 70.0").unwrap();
        let own = request(&read, &session);
        assert_eq!(
            (own.direction, own.light),
            ([70.0, 135.0], Light::Directional)
        );
        assert_eq!(read.curve, Curve::Linear, "as older files have it");
    }
}
