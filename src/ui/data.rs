//! What the views show, computed from the session and kept while the inputs stay the same.

use std::sync::Arc;

use super::memo::Memo;
use super::session::Session;
use crate::analysis::lobe::Arrow;
use crate::analysis::reflectance::{LobeShare, lobe_shares};
use crate::analysis::{HeldLobe, Hold, RadialScale, lobe3d, polar};
use crate::bxdf::math::frame;
use crate::bxdf::rotated::Rotated;
use crate::bxdf::{Bxdf, Material};

/// Absolute error of the shares of light: below half a unit of the last digit shown.
const SHARE_TOLERANCE: f64 = 2e-4;

/// Evaluations the shares may take: a few milliseconds, whatever the material.
const SHARE_EVALUATIONS: usize = 60_000;

/// A clock: seconds since some start. Pictures and tests have none, so that they are the same bytes twice.
pub type Clock = fn() -> f64;

type SurfaceKey = (Material, f64);
type HeldKey = (u64, Hold, f64, f64);

/// The surface of the session, its data for each view, and how long the last update took.
#[derive(Default)]
pub struct Data {
    surface: Memo<SurfaceKey, Box<dyn Bxdf<f64>>>,
    section: Memo<(HeldKey, f64, bool, RadialScale), polar::Section>,
    mesh: Memo<(HeldKey, bool, RadialScale), lobe3d::Mesh>,
    arrows: Memo<HeldKey, Vec<Arrow>>,
    shares: Memo<HeldKey, Vec<LobeShare>>,
    clock: Option<Clock>,
    computations: u64,
    /// Seconds the last update took; `None` before the first, and without a clock.
    pub last_update: Option<f64>,
    updating: f64,
}

impl Data {
    /// No data yet; `clock` measures the updates.
    #[must_use]
    pub fn new(clock: Option<Clock>) -> Self {
        Self {
            clock,
            ..Self::default()
        }
    }

    /// The surface: the session's material, turned about n.
    pub fn surface(&mut self, session: &Session) -> Arc<Box<dyn Bxdf<f64>>> {
        let key = (session.material.clone(), session.rotation_deg);
        self.surface.get(key, || {
            let turn = frame::cos_sin_deg(session.rotation_deg);
            Box::new(Rotated::new(session.material.build(), turn))
        })
    }

    fn held_key(&self, session: &Session) -> HeldKey {
        (
            self.surface.version(),
            session.hold,
            session.theta_deg,
            session.phi_deg,
        )
    }

    /// The section that the polar plot shows.
    pub fn section(&mut self, session: &Session) -> Arc<polar::Section> {
        self.timed(|data| {
            let surface = data.surface(session);
            let request = section_request(session);
            let key = (
                data.held_key(session),
                request.phi,
                request.with_cosine,
                request.scale,
            );
            data.section.get(key, || {
                polar::section(
                    &HeldLobe::new(&**surface, session.hold, session.held()),
                    &request,
                )
            })
        })
    }

    /// The mesh that the 3D view shows.
    pub fn mesh(&mut self, session: &Session) -> Arc<lobe3d::Mesh> {
        self.timed(|data| {
            let surface = data.surface(session);
            let request = lobe3d::Request {
                scale: session.scale,
                with_cosine: session.with_cosine,
            };
            let key = (data.held_key(session), request.with_cosine, request.scale);
            data.mesh.get(key, || {
                lobe3d::mesh(
                    &HeldLobe::new(&**surface, session.hold, session.held()),
                    &request,
                )
            })
        })
    }

    /// A number that changes with the mesh and the deltas.
    #[must_use]
    pub fn lobe_version(&self) -> u64 {
        self.mesh.version() + self.arrows.version()
    }

    /// The Dirac deltas of the held direction.
    pub fn arrows(&mut self, session: &Session) -> Arc<Vec<Arrow>> {
        let surface = self.surface(session);
        let key = self.held_key(session);
        self.arrows.get(key, || {
            HeldLobe::new(&**surface, session.hold, session.held()).arrows()
        })
    }

    /// What each lobe does with light arriving along the held direction.
    pub fn shares(&mut self, session: &Session) -> Arc<Vec<LobeShare>> {
        self.timed(|data| {
            let surface = data.surface(session);
            let key = data.held_key(session);
            data.shares.get(key, || {
                lobe_shares(
                    &**surface,
                    session.held(),
                    SHARE_TOLERANCE,
                    SHARE_EVALUATIONS,
                )
            })
        })
    }

    /// Begins a frame: the computations from here on are one update.
    pub fn begin_frame(&mut self) {
        self.updating = 0.0;
    }

    fn timed<T>(&mut self, work: impl FnOnce(&mut Self) -> T) -> T {
        let Some(clock) = self.clock else {
            return work(self);
        };
        let start = clock();
        let result = work(self);
        let computations = self.section.version() + self.mesh.version() + self.shares.version();
        if computations != self.computations {
            self.computations = computations;
            self.updating += clock() - start;
            self.last_update = Some(self.updating);
        }
        result
    }
}

/// The section of a session's polar plot.
#[must_use]
pub fn section_request(session: &Session) -> polar::Request {
    polar::Request {
        phi: session.section_azimuth_deg().to_radians(),
        with_cosine: session.with_cosine,
        scale: session.scale,
    }
}
