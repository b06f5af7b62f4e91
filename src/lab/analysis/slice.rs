//! The slice of a surface's values over theta_h and theta_d.
//!
//! # Source
//! The image of Burley 2012 (`burley2012`), over the half and difference angles (`rusinkiewicz1998`): of an isotropic
//! surface it leaves out the difference's azimuth phi_d only, on which most materials hardly depend.

use glam::DVec3;

use super::deltas;
use super::half_difference::{Spherical, half_difference, pair};
use super::lobe::pair_values;
use super::raster::Raster;
use super::{Basis, Detail, IsWanted, Pace, Query, Subject};

/// What a slice shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Request {
    /// The azimuth of the difference about the half vector, in degrees; at 90 both directions are equally high.
    pub phi_d_deg: f64,
    /// The azimuth of the half vector, in degrees: it matters for anisotropic surfaces only.
    pub phi_h_deg: f64,
    /// Whether theta_h is spaced as its square root, which gives the specular peak more room.
    pub is_square_root: bool,
    /// Pixels along each side.
    pub size: usize,
}

/// f over theta_h and theta_d.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Slice {
    /// f in 1/sr, per channel: theta_h to the right, theta_d upwards, 0..90 degrees each. Not a number where a direction
    /// lies below the surface.
    pub raster: Raster<[f64; 3]>,
}

/// A coarse answer has one pixel along a side where a full one has this many.
const COARSE_PIXELS: usize = 3;

impl Query for Request {
    type Answer = Slice;

    const BASIS: Basis = Basis::Surface;
    const PACE: Pace = Pace::CoarseFirst;

    fn answer(
        &self,
        subject: &Subject<'_>,
        detail: Detail,
        is_wanted: IsWanted<'_>,
    ) -> Option<Slice> {
        let size = match detail {
            Detail::Coarse => self.size.div_ceil(COARSE_PIXELS),
            Detail::Full => self.size,
        };
        let place = |index: usize| (index as f64 + 0.5) / size as f64;
        let row = |row: usize| {
            let y = 1.0 - place(row);
            let pairs: Vec<_> = (0..size)
                .map(|column| pair_at(self, [place(column), y]))
                .collect();
            let mut values = pair_values(subject.lobe.surface(), &pairs);
            for (value, (wo, wi)) in values.iter_mut().zip(pairs) {
                if wo.z.min(wi.z) <= 0.0 {
                    *value = [f64::NAN; 3];
                }
            }
            values
        };
        let raster = Raster::rows_while(size, size, is_wanted, row)?;
        Some(Slice { raster })
    }
}

/// The pair (wo, wi) at a place of the slice, x to the right and y upwards, 0..1 each.
#[must_use]
pub fn pair_at(request: &Request, [x, y]: [f64; 2]) -> (DVec3, DVec3) {
    let half = Spherical {
        theta_deg: 90.0 * if request.is_square_root { x * x } else { x },
        phi_deg: request.phi_h_deg,
    };
    let difference = Spherical {
        theta_deg: 90.0 * y,
        phi_deg: request.phi_d_deg,
    };
    pair(half, difference)
}

/// The share of the flux that the surface of `subject` mirrors as a Dirac delta at this theta_d, per channel. It stands at
/// theta_h = 0 and is no value of the slice. `None` where there is none.
#[must_use]
pub fn mirrored_at(request: &Request, subject: &Subject<'_>, theta_d_deg: f64) -> Option<[f64; 3]> {
    let (_, wi) = pair_at(request, [0.0, theta_d_deg / 90.0]);
    deltas::mirrored(&subject.lobe, wi)
}

/// The place of a pair in the slice, its azimuths left aside; `None` where the directions are on different sides of the
/// surface, or opposed.
#[must_use]
pub fn place_of(request: &Request, wo: DVec3, wi: DVec3) -> Option<[f64; 2]> {
    let angles = half_difference(wo, wi)?;
    let x = angles.half.theta_deg / 90.0;
    let x = if request.is_square_root { x.sqrt() } else { x };
    Some([x, angles.difference.theta_deg / 90.0])
}

/// A region of the slice that has a name.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Region {
    /// The name, for the screen.
    pub name: &'static str,
    /// What is seen there.
    pub meaning: &'static str,
    /// theta_h of its middle, in degrees.
    pub theta_h_deg: f64,
    /// theta_d of its middle, in degrees.
    pub theta_d_deg: f64,
}

/// The regions, as `burley2012` names them.
pub static REGIONS: [Region; 5] = [
    Region {
        name: "Specular peak",
        meaning: "Along theta_h = 0 the half vector is the normal: mirrored light. How fast it falls off to the right is \
                  the width of the lobe",
        theta_h_deg: 3.0,
        theta_d_deg: 40.0,
    },
    Region {
        name: "Fresnel peak",
        meaning: "At theta_d near 90 degrees the directions are all but opposed: facets reflect nearly everything there",
        theta_h_deg: 3.0,
        theta_d_deg: 85.0,
    },
    Region {
        name: "Retro-reflection",
        meaning: "Along theta_d = 0 both directions are one: light goes back where it came from",
        theta_h_deg: 40.0,
        theta_d_deg: 2.0,
    },
    Region {
        name: "Grazing retro-reflection",
        meaning: "At theta_h near 90 degrees and small theta_d light grazes and goes back: rough surfaces and cloth are \
                  brighter there",
        theta_h_deg: 84.0,
        theta_d_deg: 8.0,
    },
    Region {
        name: "Diffuse",
        meaning: "Away from the edges stands the light scattered everywhere: level where it is Lambertian",
        theta_h_deg: 45.0,
        theta_d_deg: 40.0,
    },
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::{HeldLobe, Hold};
    use bxdf::Material;

    const REQUEST: Request = Request {
        phi_d_deg: 90.0,
        phi_h_deg: 30.0,
        is_square_root: false,
        size: 32,
    };

    fn slice(text: &str, request: Request, detail: Detail) -> Raster<[f64; 3]> {
        let surface = text.parse::<Material>().unwrap().build();
        let subject = Subject::of(HeldLobe::new(&*surface, Hold::Light, DVec3::Z));
        request.answer(&subject, detail, &|| true).unwrap().raster
    }

    #[test]
    fn places_come_back() {
        for is_square_root in [false, true] {
            let request = Request {
                is_square_root,
                ..REQUEST
            };
            for [x, y] in [[0.01, 0.5], [0.5, 0.01], [0.7, 0.95], [1e-4, 1e-6]] {
                let (wo, wi) = pair_at(&request, [x, y]);
                let [found_x, found_y] = place_of(&request, wo, wi).unwrap();
                assert!((found_x - x).abs() < 1e-7 && (found_y - y).abs() < 1e-14);
                // Which of the two is the light makes no difference.
                assert!((place_of(&request, wi, wo).unwrap()[0] - found_x).abs() < 1e-7);
            }
        }
        let (wo, wi) = pair_at(&REQUEST, [0.0, 0.5]);
        assert_eq!(place_of(&REQUEST, wo, -wi), None);
    }

    #[test]
    fn a_diffuse_surface_is_level_and_what_lies_below_it_is_no_number() {
        let diffuse = "lambertian_reflection:reflectance=0.5";
        let level = 0.5 / std::f64::consts::PI;
        let is_level = |value: &[f64; 3]| (value[1] - level).abs() < 1e-15;
        let across = slice(diffuse, REQUEST, Detail::Full);
        assert_eq!(
            (across.width, across.height, across.pixels.len()),
            (32, 32, 1024)
        );
        assert!(across.pixels.iter().all(is_level));
        // In the plane of n a direction is theta_h + theta_d from n: half of the square lies below.
        let in_plane = Request {
            phi_d_deg: 0.0,
            ..REQUEST
        };
        let along = slice(diffuse, in_plane, Detail::Full);
        for row in 0..32 {
            for column in 0..32 {
                let value = along.pixels[32 * row + column];
                // The centres of the diagonal stand at the horizon itself.
                if column < row {
                    assert!(is_level(&value), "{column} {row}: {value:?}");
                } else if column > row {
                    assert!(value[0].is_nan(), "{column} {row}: {value:?}");
                }
            }
        }
        assert_eq!(slice(diffuse, REQUEST, Detail::Coarse).width, 11);
    }

    #[test]
    fn lobes_stand_where_the_regions_say() {
        let brightest = |text: &str| {
            let raster = slice(text, REQUEST, Detail::Full);
            let values = raster.pixels.iter().map(|value| value[1]).enumerate();
            let (index, _) = values.max_by(|a, b| a.1.total_cmp(&b.1)).unwrap();
            [index % 32, 31 - index / 32]
        };
        assert_eq!(brightest("rough_conductor:alpha=0.05,fresnel=one")[0], 0);
        assert_eq!(brightest("retro_reflector:alpha=0.05")[1], 0);
        for region in &REGIONS {
            let place = [region.theta_h_deg / 90.0, region.theta_d_deg / 90.0];
            let (wo, wi) = pair_at(&REQUEST, place);
            assert!(wo.z > 0.0 && wi.z > 0.0, "{}", region.name);
        }
    }

    #[test]
    fn a_square_root_gives_the_peak_more_room() {
        let wide = Request {
            is_square_root: true,
            ..REQUEST
        };
        let (wo, wi) = pair_at(&wide, [0.1, 0.3]);
        let half = half_difference(wo, wi).unwrap().half;
        assert!((half.theta_deg - 0.9).abs() < 1e-12 && (half.phi_deg - 30.0).abs() < 1e-9);
    }
}
