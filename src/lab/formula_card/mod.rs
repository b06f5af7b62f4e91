//! Formula cards: of each model the formula in TeX, and its terms with their numbers at one pair of directions, down to f.
//!
//! A symbol that has the colour of the thing it names is written `\light{..}`, `\viewer{..}`, `\normal{..}`, `\half{..}`,
//! `\mirror{..}` or `\lobe{..}`; one of a parameter `\param{name}{..}`. The numbers are computed by the formulas as they stand, in
//! f64; where one comes from a table its meaning says so.

mod baked;
mod conventions;
mod diffuse;
mod documentation;
mod facets;
mod fibres;
mod glossy;
mod interface;
mod microfacet;
mod place;
mod principled;
mod specular;
mod term;

pub use conventions::{Convention, Value};
pub use documentation::Documentation;
pub use term::{Term, Worth};

use bxdf::Component;
use bxdf::math::frame::cos_sin_deg;
use bxdf::param::ParamSet;
use glam::DVec3;

use place::Place;
use term::Terms;

/// The formula of a model.
pub struct Card {
    /// The id of the model.
    pub id: &'static str,
    file: &'static str,
    formulas: fn(&ParamSet) -> Vec<&'static str>,
    terms: for<'a> fn(&Place<'a>) -> Option<Terms<'a>>,
}

/// The one list of the cards: a model, and its formulas and terms.
macro_rules! cards {
    ($($id:ident: $family:ident $formulas:ident $terms:ident;)*) => {
        /// The card of each model of the catalogue's list.
        pub static CARDS: [Card; [$(stringify!($id)),*].len()] = [$(Card {
            id: stringify!($id),
            file: include_str!(concat!("../../bxdf/models/", stringify!($id), ".rs")),
            formulas: $family::$formulas,
            terms: $family::$terms,
        }),*];
    };
}

cards! {
    lambertian_reflection: diffuse lambert lambert_terms;
    lambertian_transmission: diffuse transmitted transmitted_terms;
    oren_nayar: diffuse oren_nayar oren_nayar_terms;
    eon: diffuse eon eon_terms;
    burley_diffuse: diffuse burley burley_terms;
    rough_conductor: microfacet conductor conductor_terms;
    rough_dielectric: interface dielectric dielectric_terms;
    plastic: interface plastic plastic_terms;
    phong: glossy phong phong_terms;
    blinn_phong: glossy blinn blinn_terms;
    ward: glossy ward ward_terms;
    ashikhmin_shirley: glossy ashikhmin ashikhmin_terms;
    cook_torrance: microfacet cook_torrance cook_torrance_terms;
    principled: principled formulas terms;
    table: baked formulas terms;
    specular_reflection: specular mirror mirror_terms;
    specular_transmission: specular refracted refracted_terms;
    fresnel_specular: specular interface interface_terms;
    thin_dielectric: specular slab slab_terms;
    retro_reflector: glossy retro retro_terms;
    hapke: fibres hapke hapke_terms;
    velvet: fibres velvet velvet_terms;
    charlie_sheen: fibres charlie charlie_terms;
}

/// The card of the model of this id; a model that a program adds has none.
#[must_use]
pub fn find(id: &str) -> Option<&'static Card> {
    CARDS.iter().find(|card| card.id == id)
}

impl Card {
    /// The right sides of its formulas in TeX, one of each side of the surface that has its own.
    #[must_use]
    pub fn formulas(&self, params: &ParamSet) -> Vec<&'static str> {
        (self.formulas)(params)
    }

    /// The terms at the unit vectors `wo` and `wi` in the frame of the surface, the last of which is f, or the weight of a delta;
    /// none where no light goes between the two.
    #[must_use]
    pub fn terms(&self, params: &ParamSet, wo: DVec3, wi: DVec3) -> Vec<Term> {
        let place = Place::new(params, wo, wi);
        let terms = place.and_then(|place| (self.terms)(&place));
        terms.map_or_else(Vec::new, |terms| terms.list)
    }

    /// What the file of the model says of it.
    #[must_use]
    pub fn documentation(&self) -> Documentation {
        Documentation::of(self.file)
    }
}

/// A formula worked out for a component, on a surface turned about n, at one pair of directions.
pub struct Reading {
    /// The card of its model.
    pub card: &'static Card,
    /// See [`Card::formulas`].
    pub formulas: Vec<&'static str>,
    /// See [`Card::terms`].
    pub terms: Vec<Term>,
    /// Whether the last term is the weight of a delta.
    pub is_delta: bool,
    /// The last term by the conventions of others.
    pub conventions: Vec<Convention>,
}

impl Reading {
    /// That of `component` turned by `rotation_deg`, at the unit vectors `wo` and `wi`. `None` for a model without a card.
    #[must_use]
    pub fn of(component: &Component, rotation_deg: f64, wo: DVec3, wi: DVec3) -> Option<Self> {
        let (model, params) = (component.model(), component.params());
        let card = find(model.id)?;
        let (cos, sin) = cos_sin_deg(rotation_deg);
        let local = |w: DVec3| DVec3::new(cos * w.x + sin * w.y, cos * w.y - sin * w.x, w.z);
        let (wo, wi) = (local(wo), local(wi));
        let last = |terms: &[Term]| terms.last().map_or([0.0; 3], |term| term.worth.channels());
        let terms = card.terms(params, wo, wi);
        let is_delta = terms.last().is_some_and(|term| !term.is_f());
        let index = component.relative_index();
        let index_at = |w: DVec3| if w.z < 0.0 { index } else { 1.0 };
        let value = Value {
            rgb: last(&terms),
            swapped: last(&card.terms(params, wi, wo)),
            cos: wi.z.abs(),
            index: index_at(wi) / index_at(wo),
            is_delta,
        };
        Some(Self {
            card,
            formulas: card.formulas(params),
            terms,
            is_delta,
            conventions: value.conventions(),
        })
    }
}

#[cfg(test)]
mod tests;
