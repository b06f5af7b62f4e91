//! What becomes of light that meets several facets.

use std::sync::Arc;

use super::multiple_scattering::EnergyTable;
use super::{Distribution, Masking};
use crate::math::Real;
use crate::optics::Spectrum;
use crate::optics::facet_fresnel::FacetFresnel;
use crate::param::{ParamSet, ParamSpec};
use crate::spec::{Declaration, Law};

/// The parameter that chooses it.
pub const COMPENSATION: ParamSpec = ParamSpec::choice(
    "compensation",
    &["none", "kulla_conty", "turquin"],
    "What becomes of light that meets several facets: lost, given back in a wide lobe of its own (Kulla & Conty), \
     or by making the lobe brighter (Turquin)",
);

/// The laws that the compensations break.
pub const DECLARATIONS: &[Declaration] = &[
    Declaration {
        law: Law::Reciprocity,
        parameters: "fresnel=one,alpha=1,compensation=turquin",
        theta_deg: 89.9,
        note: "Turquin's factor depends on wo alone: the two ways differ by up to 69 %",
        when: |params| params.choice("compensation") == "turquin",
    },
    Declaration {
        law: Law::Energy,
        parameters: "fresnel=one,alpha=1,compensation=turquin",
        theta_deg: 89.9,
        note: "rho_dh reaches 2.18: the factor is made for the light leaving along wo, and brightens a lobe that grazing \
               light fills already",
        when: |params| params.choice("compensation") == "turquin",
    },
    Declaration {
        law: Law::Energy,
        parameters: "fresnel=one,alpha_x=1,alpha_y=.0001,compensation=kulla_conty",
        theta_deg: 89.5,
        note: "rho_dh reaches 1.08: the lobe gives back what an isotropic surface of alpha = sqrt(alpha_x alpha_y) loses",
        when: |params| {
            let is_isotropic = params.number("alpha_x") == params.number("alpha_y");
            params.choice("compensation") == "kulla_conty" && !is_isotropic
        },
    },
    Declaration {
        law: Law::Energy,
        parameters: "fresnel=one,alpha=.1,distribution=beckmann_rational,compensation=kulla_conty",
        theta_deg: 82.0,
        note: "rho_dh reaches 1.003: the lobe gives back what the exact masking loses, where the fit masks less",
        when: |params| {
            let is_fitted = params.choice("distribution") == "beckmann_rational";
            params.choice("compensation") == "kulla_conty" && is_fitted
        },
    },
];

/// The part that several reflections have in a lobe.
pub trait SeveralFacets<R: Real>: Send + Sync + 'static {
    /// Whether loops over it can be compiled for wide registers: those over a table cannot.
    const VECTORISES: bool;

    /// Whether they have a lobe of their own.
    fn has_lobe(&self) -> bool;

    /// That lobe at these cosines, in 1/sr.
    fn lobe(&self, mu_o: R, mu_i: R) -> Spectrum<R>;

    /// The factor on the lobe of one reflection.
    fn factor(&self, mu_o: R) -> Spectrum<R>;

    /// The table and the probability with which the lobe of several reflections is sampled: its share of the albedo.
    fn choice(&self, mu_o: R) -> Option<(&EnergyTable, R)>;
}

/// None: light that meets a second facet is lost.
#[derive(Clone, Copy, Debug)]
pub struct Uncompensated;

impl<R: Real> SeveralFacets<R> for Uncompensated {
    const VECTORISES: bool = true;

    fn has_lobe(&self) -> bool {
        false
    }

    #[inline(always)]
    fn lobe(&self, _mu_o: R, _mu_i: R) -> Spectrum<R> {
        Spectrum::black()
    }

    #[inline(always)]
    fn factor(&self, _mu_o: R) -> Spectrum<R> {
        Spectrum::grey(R::one())
    }

    #[inline(always)]
    fn choice(&self, _mu_o: R) -> Option<(&EnergyTable, R)> {
        None
    }
}

/// One of them, chosen when the program runs.
pub enum Compensation<R> {
    /// As [`Uncompensated`].
    None,
    /// F_ms / (pi (1 - Ebar)) times (1 - E(mu_o)) (1 - E(mu_i)).
    KullaConty {
        /// 1 - E.
        table: Arc<EnergyTable>,
        /// F_ms / (pi (1 - Ebar)).
        factor: Spectrum<R>,
        /// Largest channels of F_ms and of Fbar, by which the two lobes are chosen.
        weights: [R; 2],
    },
    /// One reflection times 1 + F0 (1 - E(mu_o)) / E(mu_o).
    Turquin {
        /// 1 - E.
        table: Arc<EnergyTable>,
        /// The reflectance at normal incidence.
        f0: Spectrum<R>,
    },
}

impl<R: Real> Compensation<R> {
    /// The choice in `params`.
    pub fn from_params(
        params: &ParamSet,
        fresnel: &impl FacetFresnel<R>,
        masking: Masking,
    ) -> Self {
        let table = || {
            let alpha = (params.number("alpha_x") * params.number("alpha_y")).sqrt();
            EnergyTable::of(Distribution::<R>::is_beckmann(params), alpha, masking)
        };
        match params.choice("compensation") {
            "kulla_conty" => {
                let table = table();
                let lost = R::of(table.one_minus_mean());
                let mean = fresnel.mean();
                let one = R::one();
                let colour = mean.map(|f| f * f * (one - lost) / (one - f * lost));
                let scale = if lost > R::zero() {
                    R::frac_1_pi() / lost
                } else {
                    R::zero()
                };
                Self::KullaConty {
                    table,
                    factor: colour * scale,
                    weights: [colour.max_channel(), mean.max_channel()],
                }
            }
            "turquin" => Self::Turquin {
                table: table(),
                f0: fresnel.at(R::one()),
            },
            _ => Self::None,
        }
    }
}

impl<R: Real> SeveralFacets<R> for Compensation<R> {
    const VECTORISES: bool = false;

    fn has_lobe(&self) -> bool {
        matches!(self, Self::KullaConty { .. })
    }

    /// The lobe of several reflections.
    #[inline(always)]
    fn lobe(&self, mu_o: R, mu_i: R) -> Spectrum<R> {
        match self {
            Self::KullaConty { table, factor, .. } => {
                *factor * (table.one_minus_e(mu_o) * table.one_minus_e(mu_i))
            }
            Self::None | Self::Turquin { .. } => Spectrum::black(),
        }
    }

    /// The factor on the lobe of one reflection.
    #[inline(always)]
    fn factor(&self, mu_o: R) -> Spectrum<R> {
        match self {
            Self::Turquin { table, f0 } => {
                let lost = table.one_minus_e(mu_o);
                let ratio = lost / (R::one() - lost);
                f0.map(|f0| R::one() + f0 * ratio)
            }
            Self::None | Self::KullaConty { .. } => Spectrum::grey(R::one()),
        }
    }

    /// The table and the probability with which the lobe of several reflections is sampled: its share of the albedo.
    #[inline(always)]
    fn choice(&self, mu_o: R) -> Option<(&EnergyTable, R)> {
        let Self::KullaConty { table, weights, .. } = self else {
            return None;
        };
        let [several, one] = *weights;
        let lost = table.one_minus_e(mu_o);
        let several = several * lost;
        let both = several + one * (R::one() - lost);
        (several > R::zero()).then(|| (&**table, several / both))
    }
}
