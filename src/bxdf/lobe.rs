//! The lobes of a model: their categories and their sides.

use crate::math::{Real, Vec3};

/// The kind of reflection a lobe belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Category {
    /// Light spread over all directions, whatever the mirror direction.
    Diffuse,
    /// Light gathered about the mirror (or refracted) direction, in a lobe of finite width.
    GlossySpecular,
    /// Light in exactly the mirror (or refracted) direction: a Dirac delta.
    PerfectSpecular,
    /// Light gathered about the direction it came from.
    RetroReflective,
}

impl Category {
    /// All categories, in the order in which they are taught.
    pub const ALL: [Self; 4] = [
        Self::Diffuse,
        Self::GlossySpecular,
        Self::PerfectSpecular,
        Self::RetroReflective,
    ];

    /// The word for it in `models --json`.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Diffuse => "diffuse",
            Self::GlossySpecular => "glossy_specular",
            Self::PerfectSpecular => "perfect_specular",
            Self::RetroReflective => "retro_reflective",
        }
    }

    /// The name at the screen, in sentence case.
    #[must_use]
    pub const fn title(self) -> &'static str {
        match self {
            Self::Diffuse => "Diffuse",
            Self::GlossySpecular => "Glossy specular",
            Self::PerfectSpecular => "Perfect specular",
            Self::RetroReflective => "Retro-reflective",
        }
    }

    /// One sentence a newcomer understands.
    #[must_use]
    pub const fn meaning(self) -> &'static str {
        match self {
            Self::Diffuse => {
                "Light leaves in all directions, wherever it came from: chalk, paper, plaster"
            }
            Self::GlossySpecular => {
                "Light gathers about the mirror direction: brushed metal, satin paint, frosted glass"
            }
            Self::PerfectSpecular => {
                "Light leaves in exactly one direction: a mirror, still water, clear glass"
            }
            Self::RetroReflective => {
                "Light returns to where it came from: road signs, the full moon"
            }
        }
    }
}

/// To which side of the surface a lobe sends the light.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Side {
    /// Back to the side it came from.
    Reflection,
    /// Across the surface.
    Transmission,
}

impl Side {
    /// To which side light goes between `w` and `other`.
    #[must_use]
    pub fn between<R: Real>(w: Vec3<R>, other: Vec3<R>) -> Self {
        if (w.z > R::zero()) == (other.z > R::zero()) {
            Self::Reflection
        } else {
            Self::Transmission
        }
    }

    /// The word for it in `models --json`.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Reflection => "reflection",
            Self::Transmission => "transmission",
        }
    }
}

/// A lobe of a model: its category and its side.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Lobe {
    /// The kind of reflection.
    pub category: Category,
    /// The side of the surface.
    pub side: Side,
    /// What tells it from the other lobes of its model: `coat`, `sheen`; empty for the only one of its kind.
    pub name: &'static str,
}

impl Lobe {
    /// A reflecting lobe of this category.
    #[must_use]
    pub const fn reflection(category: Category) -> Self {
        Self {
            category,
            side: Side::Reflection,
            name: "",
        }
    }

    /// A transmitting lobe of this category.
    #[must_use]
    pub const fn transmission(category: Category) -> Self {
        Self {
            category,
            side: Side::Transmission,
            name: "",
        }
    }

    /// The lobe under this name.
    #[must_use]
    pub const fn named(self, name: &'static str) -> Self {
        Self { name, ..self }
    }
}
