//! Errors over two axes: angles, or parameters of a material.

mod axis;
mod place;

use glam::DVec3;

pub use axis::Axis;
pub use place::Place;

use super::point::{self, Tested};
use crate::analysis::raster::Raster;
use crate::analysis::{Basis, Detail, IsWanted, Pace, Query, Subject as Asked};
use crate::specimen::Specimen;
use bxdf::math::Real;

/// What a map is asked for.
#[derive(Clone, Debug, PartialEq)]
pub struct Request {
    /// Where the map is cut: what the axes leave as it is.
    pub place: Place,
    /// To the right.
    pub x: Axis,
    /// Upwards.
    pub y: Axis,
    /// Pixels along each side.
    pub size: usize,
}

/// What is found at a pixel. Not numbers where there is no value: the material refuses the parameters, or is black there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cell {
    /// The largest relative error of f and pdf in f32 and in f64.
    pub errors: [f64; 2],
    /// The largest error over what the stability law allows, in f32 and in f64.
    pub ratios: [f64; 2],
    /// The largest condition number.
    pub kappa: f64,
}

impl Cell {
    const NOTHING: Self = Self {
        errors: [f64::NAN; 2],
        ratios: [f64::NAN; 2],
        kappa: f64::NAN,
    };

    /// What is found at a place.
    fn at(specimen: Option<&Specimen>, place: Option<&Place>) -> Self {
        let (Some(specimen), Some(place)) = (specimen, place) else {
            return Self::NOTHING;
        };
        let pair = place.pair();
        let kappas = specimen.condition_numbers(pair, f64::UNIT_ROUNDOFF);
        let [single, double] = [
            found(&point::single(specimen), pair),
            found(&point::double(specimen), pair),
        ];
        if point::is_black(specimen, pair) {
            return Self::NOTHING;
        }
        Self {
            errors: [single[0], double[0]],
            ratios: [single[1], double[1]],
            kappa: kappas.into_iter().fold(0.0, f64::max),
        }
    }
}

/// The errors over the two axes, row by row from the upper left: y runs upwards.
pub type Map = Raster<Cell>;

/// A coarse answer has one pixel along a side where a full one has this many.
const COARSE_PIXELS: usize = 4;

impl Request {
    /// The place at shares of the axes, x to the right and y upwards, 0..1 each; `None` where the material refuses it.
    #[must_use]
    pub fn place_at(&self, [x, y]: [f64; 2]) -> Option<Place> {
        let moved = self.x.moved(&self.place, self.x.value(x))?;
        self.y.moved(&moved, self.y.value(y))
    }
}

/// The largest error in a precision, and its ratio to the bound.
fn found<R: Real>(tested: &Tested<'_, R>, pair: (DVec3, DVec3)) -> [f64; 2] {
    let finding = tested.compare(pair, 0.0);
    if finding.is_faulty() {
        return [f64::INFINITY; 2];
    }
    [finding.relative_error, finding.ratio]
}

impl Query for Request {
    type Answer = Map;

    const BASIS: Basis = Basis::Material;
    const PACE: Pace = Pace::CoarseFirst;

    fn answer(&self, _: &Asked<'_>, detail: Detail, is_wanted: IsWanted<'_>) -> Option<Map> {
        let size = match detail {
            Detail::Coarse => self.size.div_ceil(COARSE_PIXELS),
            Detail::Full => self.size,
        };
        let share = |index: usize| (index as f64 + 0.5) / size as f64;
        // Materials are built once for a line along which they stay the same.
        let is_upright = self.x.is_of_material() && !self.y.is_of_material();
        let (across, along) = if is_upright {
            (&self.x, &self.y)
        } else {
            (&self.y, &self.x)
        };
        let line = |index: usize| {
            let at = if is_upright {
                share(index)
            } else {
                1.0 - share(index)
            };
            let start = across.moved(&self.place, across.value(at));
            let specimen = start
                .as_ref()
                .map(|start| Specimen::of_material(&start.material));
            let cell = |index: usize| {
                let at = if is_upright {
                    1.0 - share(index)
                } else {
                    share(index)
                };
                let place = along.moved(start.as_ref()?, along.value(at));
                let own = along.is_of_material().then(|| {
                    place
                        .as_ref()
                        .map(|place| Specimen::of_material(&place.material))
                });
                let specimen = own.as_ref().map_or(specimen.as_ref(), Option::as_ref);
                Some(Cell::at(specimen, place.as_ref()))
            };
            (0..size)
                .map(|index| cell(index).unwrap_or(Cell::NOTHING))
                .collect()
        };
        let lines = Raster::rows_while(size, size, is_wanted, line)?;
        if !is_upright {
            return Some(lines);
        }
        let pixels =
            (0..size * size).filter_map(|index| lines.at(index / size, index % size).copied());
        Some(Raster {
            width: size,
            height: size,
            pixels: pixels.collect(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::{HeldLobe, Hold};
    use bxdf::Material;
    use bxdf::math::frame::direction_from_degrees;

    fn map(text: &str, x: &str, y: &str, detail: Detail) -> (Request, Map) {
        let material: Material = text.parse().unwrap();
        let all = Axis::all(&material);
        let axis = |id: &str| all.iter().find(|axis| axis.id() == id).unwrap().clone();
        let (wo, wi) = (
            direction_from_degrees(40.0, 20.0),
            direction_from_degrees(35.0, 200.0),
        );
        let request = Request {
            place: Place::of(&material, wo, wi),
            x: axis(x),
            y: axis(y),
            size: 16,
        };
        let bxdf = material.build();
        let asked = Asked::of(HeldLobe::new(&*bxdf, Hold::Light, DVec3::Z));
        let map = request.answer(&asked, detail, &|| true).unwrap();
        (request, map)
    }

    #[test]
    fn maps_stand_upright_whichever_axis_is_of_the_material() {
        let gold = "rough_conductor";
        let (_, map_a) = map(gold, "alpha", "theta_i", Detail::Full);
        let (_, map_b) = map(gold, "theta_i", "alpha", Detail::Full);
        for x in 0..16 {
            for y in 0..16 {
                let [a, b] = [map_a.at(x, 15 - y).unwrap(), map_b.at(y, 15 - x).unwrap()];
                assert_eq!(a, b, "{x} {y}");
            }
        }
        // A narrow lobe is worse conditioned; nothing exceeds the bound.
        let kappa = |x: usize| map_a.at(x, 8).unwrap().kappa;
        assert!(kappa(4) > 3.0 * kappa(15), "{} {}", kappa(4), kappa(15));
        assert!(
            map_a
                .pixels
                .iter()
                .all(|cell| cell.ratios.iter().all(|ratio| *ratio <= 1.0))
        );
        assert_eq!(map(gold, "alpha", "theta_i", Detail::Coarse).1.width, 4);
    }

    #[test]
    fn places_are_found_again_on_the_axes() {
        let (request, _) = map(
            "rough_dielectric",
            "eta less 1",
            "grazing_o",
            Detail::Coarse,
        );
        for shares in [[0.1, 0.9], [0.7, 0.3]] {
            let place = request.place_at(shares).unwrap();
            let back = [request.x.share(&place), request.y.share(&place)];
            for (share, back) in shares.into_iter().zip(back) {
                assert!((share - back).abs() < 1e-6, "{shares:?} {back}");
            }
        }
        let (wo, _) = request.place.pair();
        assert!((wo - direction_from_degrees(40.0, 20.0)).length() < 1e-12);
    }

    #[test]
    fn every_axis_of_every_model_gives_a_place() {
        for model in bxdf::models::MODELS {
            let material: Material = model.id.parse().unwrap();
            for axis in Axis::all(&material) {
                let place = Place::of(&material, DVec3::Z, DVec3::X);
                let moved = [0.0, 0.5, 1.0].map(|share| axis.moved(&place, axis.value(share)));
                assert!(
                    moved.iter().all(Option::is_some),
                    "{} {}",
                    model.id,
                    axis.id()
                );
                assert!(!axis.title().is_empty());
            }
        }
    }
}
