//! What each view shows and how, as far as it is the view's own affair.

use serde::{Deserialize, Serialize};

use bxdf_lab::analysis::cartesian::Abscissa;
use bxdf_lab::analysis::hemisphere::{Comparison, Projection, Quantity};
use bxdf_lab::analysis::sampling::FIRST_SEED;
use bxdf_lab::analysis::sphere::Light;

/// The options of all views.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct ViewOptions {
    /// Of the Cartesian plot.
    pub cartesian: CartesianOptions,
    /// Of the hemisphere.
    pub hemisphere: HemisphereOptions,
    /// Of the reflectance.
    pub reflectance: ReflectanceOptions,
    /// Of the slice.
    pub slice: SliceOptions,
    /// Of the lit sphere.
    pub sphere: SphereOptions,
    /// Of the sampling.
    pub sampling: SamplingOptions,
    /// Of the decomposition.
    pub decomposition: DecompositionOptions,
    /// Of the trade-off.
    pub tradeoff: TradeoffOptions,
    /// Of the stability.
    pub stability: StabilityOptions,
}

/// Declares an enum of words a view can be set to, with their titles.
macro_rules! words {
    ($(#[$meta:meta])* $name:ident { $($(#[$variant_meta:meta])* $variant:ident = $title:literal,)+ }) => {
        $(#[$meta])*
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
        #[serde(rename_all = "snake_case")]
        pub enum $name {
            $($(#[$variant_meta])* $variant,)+
        }

        impl $name {
            /// All of them, in the order of the menu.
            pub const ALL: &'static [Self] = &[$(Self::$variant,)+];

            /// The name at the screen.
            #[must_use]
            pub const fn title(self) -> &'static str {
                match self {
                    $(Self::$variant => $title,)+
                }
            }
        }
    };
}

/// How the Cartesian plot shows f.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct CartesianOptions {
    /// Over which angle.
    pub abscissa: Abscissa,
    /// The angle that is held, where there is one: theta_d or theta_h, in degrees.
    pub fixed_deg: f64,
    /// Whether values go by decades.
    pub is_logarithmic: bool,
    /// Whether each curve is divided by its peak.
    pub is_normalised: bool,
    /// Whether the difference from the reference is shown.
    pub is_residual: bool,
}

impl Default for CartesianOptions {
    fn default() -> Self {
        Self {
            abscissa: Abscissa::default(),
            fixed_deg: 30.0,
            is_logarithmic: false,
            is_normalised: false,
            is_residual: false,
        }
    }
}

/// What the disc of directions shows.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct HemisphereOptions {
    /// How directions lie on the disc.
    pub projection: Projection,
    /// Which number is shown.
    pub quantity: Quantity,
    /// With the reference, or by itself.
    pub comparison: Comparison,
    /// Whether colours go by decades.
    pub is_logarithmic: bool,
    /// Whether lines of equal value are drawn.
    pub has_contours: bool,
    /// Whether the lower half is shown, in place of the upper one.
    pub is_lower: bool,
}

impl Default for HemisphereOptions {
    fn default() -> Self {
        Self {
            projection: Projection::default(),
            quantity: Quantity::default(),
            comparison: Comparison::default(),
            is_logarithmic: true,
            has_contours: true,
            is_lower: false,
        }
    }
}

words! {
    /// What the reflectance is split into.
    Split {
        /// Not at all.
        #[default]
        Total = "Total",
        /// Reflection and transmission.
        Side = "Side",
        /// Diffuse, glossy, perfect specular, retro-reflective.
        Category = "Category",
        /// Each lobe by itself.
        Lobe = "Lobe",
    }
}

/// How the reflectance is shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct ReflectanceOptions {
    /// Into which parts.
    pub split: Split,
    /// Whether what is missing from 1 is shown instead.
    pub is_furnace: bool,
}

/// How the slice is shown.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct SliceOptions {
    /// The azimuth of the difference vector, in degrees; 90 holds the half vector in the plane of both directions.
    pub phi_d_deg: f64,
    /// Whether theta_h is spaced by its square root.
    pub is_square_root: bool,
    /// Whether colours go by decades.
    pub is_logarithmic: bool,
    /// Whether the regions are named.
    pub has_regions: bool,
}

impl Default for SliceOptions {
    fn default() -> Self {
        Self {
            phi_d_deg: 90.0,
            is_square_root: false,
            is_logarithmic: true,
            has_regions: true,
        }
    }
}

words! {
    /// How the spheres of several materials stand.
    Arrangement {
        /// Side by side.
        #[default]
        Grid = "Side by side",
        /// As strips of one sphere.
        Wipe = "Wipe",
        /// The difference of each from the reference.
        Difference = "Difference",
    }
}

/// How the lit sphere is shown.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct SphereOptions {
    /// What lights it.
    pub light: Light,
    /// The angle of the light from the viewer's axis, in degrees.
    pub theta_deg: f64,
    /// Its azimuth, in degrees: 0 to the right, 90 above.
    pub phi_deg: f64,
    /// The exposure in stops: each one doubles.
    pub exposure: f64,
    /// How several stand.
    pub arrangement: Arrangement,
}

impl Default for SphereOptions {
    fn default() -> Self {
        Self {
            light: Light::default(),
            theta_deg: 45.0,
            phi_deg: 135.0,
            exposure: 0.0,
            arrangement: Arrangement::default(),
        }
    }
}

words! {
    /// What the sampling view shows.
    SamplingPlot {
        /// The samples on the disc.
        #[default]
        Points = "Samples",
        /// The images of a regular grid of random numbers.
        Warp = "Warp of the square",
        /// The density and f cos in the section.
        Curves = "pdf and f cos",
        /// How many samples fell where, against the density.
        Histogram = "Histogram",
        /// What samples weigh.
        Weights = "Weights",
        /// What the estimate of the reflectance varies by.
        Estimators = "Estimators",
    }
}

/// How the sampling is shown.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct SamplingOptions {
    /// What of it.
    pub plot: SamplingPlot,
    /// The number of samples, as a power of 2.
    pub count_log2: u8,
    /// The seed of the random numbers, as of the command line.
    pub seed: u32,
    /// Whether samples lie on the dome, seen as the 3D view sees it, rather than on a disc.
    pub is_dome: bool,
}

impl SamplingPlot {
    /// Whether it shows directions, which may lie on the dome too.
    #[must_use]
    pub const fn shows_directions(self) -> bool {
        matches!(self, Self::Points | Self::Warp)
    }
}

impl Default for SamplingOptions {
    fn default() -> Self {
        Self {
            plot: SamplingPlot::default(),
            count_log2: 12,
            seed: FIRST_SEED,
            is_dome: false,
        }
    }
}

words! {
    /// Into what a value is taken apart.
    Decomposed {
        /// Its lobes, which sum to it.
        #[default]
        Lobes = "Lobes",
        /// The factors of a microfacet model.
        Factors = "D, G, F",
    }
}

/// How the decomposition is shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct DecompositionOptions {
    /// Into what.
    pub into: Decomposed,
    /// Whether lobes are stacked.
    pub is_stacked: bool,
    /// Whether values go by decades.
    pub is_logarithmic: bool,
}

/// How the trade-off of cost and error is measured and shown.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct TradeoffOptions {
    /// The largest error that is good enough: relative, root mean square.
    pub tolerance: f64,
    /// The ids of the families that are not wanted.
    pub left_out: Vec<String>,
    /// Whether a material is measured as soon as it is shown; else when asked for.
    pub is_immediate: bool,
}

impl Default for TradeoffOptions {
    fn default() -> Self {
        Self {
            tolerance: 0.01,
            left_out: Vec::new(),
            is_immediate: false,
        }
    }
}

words! {
    /// What the stability view shows.
    StabilityPlot {
        /// Errors of the selected material over two axes.
        #[default]
        Map = "Errors over two axes",
        /// The errors of textbooks' formulas and of the core's.
        Formulas = "Formulas on trial",
    }
}

words! {
    /// What errors are counted in.
    ErrorUnit {
        /// Roundings of the precision: the same for both, so that they can be compared.
        #[default]
        Roundings = "In roundings",
        /// Shares of the value.
        Relative = "Relative",
        /// Shares of what the stability law allows.
        Bound = "Of its bound",
    }
}

/// How the stability is shown.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct StabilityOptions {
    /// What of it.
    pub plot: StabilityPlot,
    /// The id of the axis to the right; the first that a material has instead, where it has no such axis.
    pub x: String,
    /// The id of the axis upwards; likewise.
    pub y: String,
    /// What errors are counted in.
    pub unit: ErrorUnit,
    /// Whether lines of equal condition number are drawn.
    pub has_contours: bool,
    /// The id of the formula on trial.
    pub trial: String,
}

impl Default for StabilityOptions {
    fn default() -> Self {
        Self {
            plot: StabilityPlot::default(),
            x: "theta_i".to_owned(),
            y: "alpha".to_owned(),
            unit: ErrorUnit::default(),
            has_contours: true,
            trial: "ggx".to_owned(),
        }
    }
}
