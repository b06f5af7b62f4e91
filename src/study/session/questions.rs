//! What the views ask about each material, as the session has it.

use glam::DVec3;

use super::{DECADES, SAMPLES_LOG2, SamplingPlot, Session};
use bxdf_lab::analysis::reflectance::{CurveRequest, SharesRequest};
use bxdf_lab::analysis::{
    Hold, RadialScale, cartesian, decomposition, hemisphere, lobe3d, polar, sampling, slice, sphere,
};
use bxdf_lab::stability::map::{self, Axis};

/// The shares of light at the screen: an error below half a unit of the last digit shown, and evaluations for a few
/// milliseconds, whatever the material.
pub const SHARES: SharesRequest = SharesRequest {
    tolerance: 2e-4,
    max_evaluations: 60_000,
};

/// The reflectance over the angle: a value for each degree, with a tenth of the error that a curve of its width shows.
const REFLECTANCE: CurveRequest = CurveRequest {
    phi_deg: 0.0,
    angles: 91,
    tolerance: 1e-4,
    max_evaluations: 400_000,
};

/// Pixels along either side of a map of values.
const MAP_SIZE: usize = 256;

/// The sizes of pictures of spheres, in pixels: the smallest that fills its place is computed.
const SPHERE_SIZES: [usize; 3] = [128, 256, 512];

/// Cells of a grid of random numbers, along either side.
const WARP_CELLS: usize = 16;

impl Session {
    /// The azimuth of the section, in radians.
    fn section_phi(&self) -> f64 {
        self.section_azimuth_deg().to_radians()
    }

    /// The section of the polar plot.
    #[must_use]
    pub fn section_request(&self) -> polar::Request {
        polar::Request {
            phi: self.section_phi(),
            with_cosine: self.with_cosine,
            scale: self.scale,
        }
    }

    /// The mesh of the 3D view.
    #[must_use]
    pub fn mesh_request(&self) -> lobe3d::Request {
        lobe3d::Request {
            scale: self.scale,
            with_cosine: self.with_cosine,
        }
    }

    /// The curve of the Cartesian plot; its residual is that against the reference.
    #[must_use]
    pub fn cartesian_request(&self) -> cartesian::Request {
        let options = self.views.cartesian;
        cartesian::Request {
            abscissa: options.abscissa,
            fixed_deg: options.fixed_deg,
            phi: self.section_phi(),
            with_cosine: self.with_cosine,
            scale: if options.is_logarithmic && !options.is_residual {
                RadialScale::Logarithmic { decades: DECADES }
            } else {
                RadialScale::Linear
            },
            is_residual: options.is_residual,
        }
    }

    /// The map of the hemisphere; its comparison is that with the reference.
    #[must_use]
    pub fn hemisphere_request(&self) -> hemisphere::Request {
        let options = self.views.hemisphere;
        hemisphere::Request {
            projection: options.projection,
            quantity: options.quantity,
            comparison: options.comparison,
            is_upper: !options.is_lower,
            size: MAP_SIZE,
        }
    }

    /// The reflectance over the angle of incidence, at the azimuth of the held direction.
    #[must_use]
    pub fn reflectance_request(&self) -> CurveRequest {
        CurveRequest {
            phi_deg: self.phi_deg,
            ..REFLECTANCE
        }
    }

    /// The slice, at the azimuth of the section.
    #[must_use]
    pub fn slice_request(&self) -> slice::Request {
        let options = self.views.slice;
        slice::Request {
            phi_d_deg: options.phi_d_deg,
            phi_h_deg: self.section_azimuth_deg(),
            is_square_root: options.is_square_root,
            size: MAP_SIZE,
        }
    }

    /// The lit sphere, in a place this many pixels wide.
    #[must_use]
    pub fn sphere_request(&self, pixels: f32) -> sphere::Request {
        let options = self.views.sphere;
        let [.., largest] = SPHERE_SIZES;
        let fits = |size: &usize| *size as f32 >= pixels;
        sphere::Request {
            light: options.light,
            direction: [options.theta_deg, options.phi_deg],
            size: SPHERE_SIZES.into_iter().find(fits).unwrap_or(largest),
        }
    }

    /// The study of the sampling.
    #[must_use]
    pub fn sampling_request(&self) -> sampling::Request {
        let options = self.views.sampling;
        let [least, most] = SAMPLES_LOG2.range.map(|log2| log2 as u8);
        sampling::Request {
            part: match options.plot {
                SamplingPlot::Points | SamplingPlot::Warp => sampling::Part::Points,
                SamplingPlot::Histogram => sampling::Part::Histogram,
                SamplingPlot::Weights => sampling::Part::Weights,
                SamplingPlot::Curves => sampling::Part::Densities,
                SamplingPlot::Estimators => sampling::Part::Estimators,
            },
            count: 1 << options.count_log2.clamp(least, most),
            seed: u64::from(options.seed),
            phi: self.section_phi(),
        }
    }

    /// How the sampling bends a grid of random numbers.
    #[must_use]
    pub fn warp_request(&self) -> sampling::WarpRequest {
        sampling::WarpRequest { cells: WARP_CELLS }
    }

    /// The decomposition in the section.
    #[must_use]
    pub fn decomposition_request(&self) -> decomposition::Request {
        decomposition::Request {
            phi: self.section_phi(),
            with_cosine: self.with_cosine,
        }
    }
}

/// Pixels along either side of a map of errors.
const ERROR_MAP_SIZE: usize = 96;

impl Session {
    /// The axes of the map of errors that the selected material has: those chosen, where it has them.
    #[must_use]
    pub fn stability_axes(&self) -> (Axis, Axis) {
        let all = Axis::all(self.material());
        let options = &self.views.stability;
        let find = |id: &str| all.iter().find(|axis| axis.id() == id).cloned();
        let x = find(&options.x).unwrap_or(Axis::ThetaI);
        (x, find(&options.y).unwrap_or(Axis::ThetaO))
    }

    /// The place of the selected material and a pair: the direction held, and the other one.
    #[must_use]
    pub fn stability_place(&self, held: DVec3, free: DVec3) -> map::Place {
        let [held, free] = [held, free].map(|w| self.on_surface(w));
        let (wo, wi) = match self.hold {
            Hold::Light => (free, held),
            Hold::Viewer => (held, free),
        };
        map::Place::of(self.material(), wo, wi)
    }

    /// The map of the selected material's errors, cut through the held direction and its mirror direction.
    #[must_use]
    pub fn stability_request(&self) -> map::Request {
        let (x, y) = self.stability_axes();
        let held = self.held();
        let mirror = DVec3::new(-held.x, -held.y, held.z);
        map::Request {
            place: self.stability_place(held, mirror),
            x,
            y,
            size: ERROR_MAP_SIZE,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spheres_are_as_large_as_their_places() {
        let session = Session::default();
        for (pixels, size) in [(10.0, 128), (128.0, 128), (129.0, 256), (4000.0, 512)] {
            assert_eq!(session.sphere_request(pixels).size, size);
        }
    }
}
