//! Angles, in degrees.

use super::quantity::{Argument, Given, Quantity, Value, word};
use super::reflectance::faces;
use super::scene::Scene;
use crate::analysis::fresnel::{Face, MarkKind};
use bxdf::math::frame;

pub(super) const QUANTITY: Quantity = Quantity {
    id: "angle",
    symbol: "angle",
    unit: "degrees",
    meaning: "The angle from n of the light, the viewer or the half vector, the azimuth of light or viewer from s, the angle between light and half vector \
        (difference), the angle of refracted light from its side of the normal, Brewster's or the critical angle",
    arguments: &[Argument::word(
        "of",
        &[
            "light",
            "viewer",
            "light_azimuth",
            "viewer_azimuth",
            "half",
            "difference",
            "transmitted",
            "brewster",
            "critical",
        ],
    )],
    value,
};

fn value(scene: &Scene, given: &[Given]) -> Value {
    let theta = |w| frame::theta(w).to_degrees();
    let half = || {
        let half = scene.half();
        half.ok_or("light and viewer are opposite: there is no half vector".to_owned())
    };
    match word(given, 0).as_str() {
        "light" => Ok(theta(scene.light())),
        "viewer" => Ok(theta(scene.viewer())),
        "light_azimuth" => Ok(frame::phi(scene.light()).to_degrees()),
        "viewer_azimuth" => Ok(frame::phi(scene.viewer()).to_degrees()),
        "half" => Ok(theta(half()?)),
        "difference" => Ok(frame::angle_between(scene.light(), half()?).to_degrees()),
        "brewster" => mark(scene, MarkKind::Brewster, "Brewster's angle"),
        "critical" => mark(scene, MarkKind::Critical, "critical angle on this side"),
        _ => {
            let (faces, theta_deg) = faces(scene)?;
            let refracted = faces.first().and_then(|face| face.refracted_deg(theta_deg));
            refracted.ok_or_else(|| "no real angle: no light crosses the interface".to_owned())
        }
    }
}

fn mark(scene: &Scene, kind: MarkKind, name: &str) -> Value {
    let (faces, _) = faces(scene)?;
    let mut marks = faces.iter().flat_map(Face::marks);
    let found = marks.find(|mark| mark.kind == kind);
    let found = found.map(|mark| mark.theta_deg);
    found.ok_or_else(|| format!("the interface has no {name}"))
}
