//! The angle between microfacet normal and n.

use super::normals::Normals;
use super::quantity::{Argument, Quantity, number};

pub(super) const QUANTITY: Quantity = Quantity {
    id: "theta_m",
    symbol: "θ_m",
    unit: "degrees",
    meaning: "The angle from n below which the share u of the microfacet normals lies, as D cos has it: what the inverse CDF \
        makes of the random number u",
    arguments: &[Argument::number("u", [0.0, 1.0])],
    value: |scene, given| {
        let u = number(given, 0).unwrap_or_default();
        Ok(Normals::of(scene)?.quantile(u).to_degrees())
    },
};

pub(super) const MODE: Quantity = Quantity {
    id: "theta_m_mode",
    symbol: "mode of θ_m",
    unit: "degrees",
    meaning: "The most frequent angle from n of the microfacet normals: where their density per angle, not per solid angle, peaks",
    arguments: &[],
    value: |scene, _| Ok(Normals::of(scene)?.mode.to_degrees()),
};

pub(super) const MEAN: Quantity = Quantity {
    id: "theta_m_mean",
    symbol: "mean of θ_m",
    unit: "degrees",
    meaning: "The mean angle from n of the microfacet normals, as D cos has it",
    arguments: &[],
    value: |scene, _| Ok(Normals::of(scene)?.mean(&|theta| theta).to_degrees()),
};

pub(super) const DENSITY: Quantity = Quantity {
    id: "theta_m_density",
    symbol: "p(θ_m)",
    unit: "1/degree",
    meaning: "The density of the angle between microfacet normal and n at the angle theta: which share of the normals, as D cos has it, \
        lies within a degree there",
    arguments: &[Argument::number("theta", [0.0, 90.0])],
    value: |scene, given| {
        let theta = number(given, 0).unwrap_or_default().to_radians();
        // Per degree is by so much less than per radian.
        Ok(Normals::of(scene)?.density(theta).to_radians())
    },
};
