//! Families of lobes that want cells of their own.
//!
//! A chart in half-vector slopes follows the needle about the mirrored direction or the one that points back, not both: in
//! the chart of the one, the other is a wedge at the far rim of the hemisphere, seen from the horizon as thin as alpha
//! times the cosine. A surface with lobes of both kinds is therefore cut twice, and every direction is shared between
//! the two sets of cells by the balance heuristic (Veach 1997, section 9.2.2, `veach1997`). Shares sum to 1 whatever the
//! densities of the lobes are worth, so a model that says a wrong one is integrated as well.

use glam::DVec3;

use crate::analysis::statistics::Random;
use crate::specimen::Specimen;
use bxdf::{Category, Lobe, Side};

/// Lobes that one set of cells follows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Family {
    /// All lobes of the surface.
    All,
    /// The lobes that point back, where others are about the mirrored direction.
    Back,
    /// The lobes beside [`Self::Back`].
    Others,
}

impl Family {
    /// The families of `specimen`: one, or the two between which directions are shared.
    pub(super) fn of(specimen: &Specimen) -> &'static [Self] {
        let has = |category| {
            let mut lobes = specimen.double.lobes().iter();
            lobes.any(|lobe| lobe.side == Side::Reflection && lobe.category == category)
        };
        if has(Category::RetroReflective) && has(Category::GlossySpecular) {
            &[Self::Back, Self::Others]
        } else {
            &[Self::All]
        }
    }

    /// Whether the chart of the hemisphere of `wo` follows the lobes that point back.
    pub(super) fn is_back(self, specimen: &Specimen) -> bool {
        match self {
            Self::All => specimen.has_category(Category::RetroReflective),
            Self::Back => true,
            Self::Others => false,
        }
    }

    /// One of the families of `specimen`, drawn with the shares they have of `wi`.
    pub(super) fn drawn(specimen: &Specimen, wo: DVec3, wi: DVec3, random: &mut Random) -> Self {
        match Self::of(specimen) {
            [first, other] if random.unit() >= first.share(specimen, wo, wi) => *other,
            [first, ..] => *first,
            [] => Self::All,
        }
    }

    /// The share of the direction `wi` that belongs to this family.
    pub(super) fn share(self, specimen: &Specimen, wo: DVec3, wi: DVec3) -> f64 {
        if self == Self::All {
            return 1.0;
        }
        let is_back = |lobe: &Lobe| lobe.category == Category::RetroReflective;
        let [mut back, mut others] = [0.0; 2];
        for (index, lobe) in specimen.double.lobes().iter().enumerate() {
            let density = specimen.double.lobe_pdf(index, wo.into(), wi.into());
            *(if is_back(lobe) {
                &mut back
            } else {
                &mut others
            }) += density;
        }
        let sum = back + others;
        // Where no lobe has a density, or one that is no number, the direction is the others'.
        let is_shared = sum > 0.0 && sum.is_finite();
        match self {
            Self::Back if is_shared => back / sum,
            Self::Others if is_shared => others / sum,
            Self::Back => 0.0,
            _ => 1.0,
        }
    }
}
