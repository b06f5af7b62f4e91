//! The reflectance of an interface over the angle.

use serde::{Deserialize, Serialize};

use super::caption::{Caption, Directions, Subjects};
use super::kind::{Deltas, TableKind, ViewKind, ViewOptions};
use super::words::words;
use crate::answers::Answers;
use crate::export::table::{Table, Value, shown};
use crate::number::{NumberSpec, Numbers, Refused};
use crate::session::{MaterialEntry, Session};
use bxdf::Material;
use bxdf::material::MAX_COMPONENTS;
use bxdf_lab::analysis::Channel;
use bxdf_lab::analysis::fresnel::{Index, Reflectances, Request, lobe};
use bxdf_lab::spectral::{Constants, OverWavelength};

pub(super) const KIND: ViewKind = ViewKind {
    id: "fresnel",
    title: "Fresnel",
    what_you_see: "What a smooth interface reflects of s and p polarised light over the angle, beside the \
        approximations; Brewster's and the critical angle, and Snell's law",
    says_hidden: true,
    deltas: Deltas::Summed,
    with_cosine: false,
    table: TableKind::Computed,
    is_mesh: false,
};

/// The place of the lobe among those of a material.
static LOBE: NumberSpec =
    NumberSpec::new("fresnel.lobe", [0.0, (MAX_COMPONENTS - 1) as f64]).whole();

/// The index of refraction of the view's own interface: no medium has 0.
pub static OWN_N: NumberSpec =
    NumberSpec::new("fresnel.own_n", [0.01, 1e4]).folded([1.0, 3.0], |n| n);

/// Its absorption index.
pub static OWN_K: NumberSpec =
    NumberSpec::new("fresnel.own_k", [0.0, 1e10]).folded([0.0, 10.0], |k| k);

words! {
    /// From where an interface is looked at.
    SeenFrom {
        /// From the side of the held direction.
        #[default]
        Held = "Held side",
        /// From above.
        Above = "Above",
        /// From below.
        Below = "Below",
    }
}

words! {
    /// Over what the reflectance is shown.
    Over {
        /// Over the angle of incidence.
        #[default]
        Angle = "Angle",
        /// Over the wavelength, at the angle of the held direction.
        Wavelength = "Wavelength",
    }
}

/// Which curves are shown.
#[expect(
    clippy::struct_excessive_bools,
    reason = "each curve is shown or not by itself"
)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Curves {
    /// That of s polarised light.
    pub s: bool,
    /// That of p polarised light.
    pub p: bool,
    /// That of unpolarised light.
    pub mean: bool,
    /// Schlick's approximation of that.
    pub schlick: bool,
    /// The same with the term of Lazanyi and Szirmay-Kalos.
    pub lazanyi: bool,
}

impl Default for Curves {
    fn default() -> Self {
        Self {
            s: true,
            p: true,
            mean: true,
            schlick: true,
            lazanyi: false,
        }
    }
}

/// How an interface is shown.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Options {
    /// The place of its lobe among those of a material that have one.
    pub lobe: usize,
    /// From where.
    pub seen_from: SeenFrom,
    /// Over what.
    pub over: Over,
    /// The index of refraction that is taken where no material has an interface.
    pub own_n: f64,
    /// The absorption index of the same.
    pub own_k: f64,
    /// Which curves.
    pub curves: Curves,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            lobe: 0,
            seen_from: SeenFrom::default(),
            over: Over::default(),
            // Glass.
            own_n: 1.5,
            own_k: 0.0,
            curves: Curves::default(),
        }
    }
}

impl Options {
    /// The interface over the angle.
    #[must_use]
    pub fn request(&self) -> Request {
        Request {
            lobe: self.lobe,
            own: Index {
                n: self.own_n,
                k: self.own_k,
            },
            is_from_below: match self.seen_from {
                SeenFrom::Held => None,
                SeenFrom::Above => Some(false),
                SeenFrom::Below => Some(true),
            },
        }
    }

    /// The interface over the wavelength.
    #[must_use]
    pub fn over_wavelength(&self) -> OverWavelength {
        OverWavelength { lobe: self.lobe }
    }

    /// Whether it is known of `material` over the wavelength.
    #[must_use]
    pub fn has_wavelengths(&self, material: &Material) -> bool {
        lobe(material, self.lobe).and_then(Constants::of).is_some()
    }

    /// Whether `material` is shown over the wavelength.
    #[must_use]
    pub fn is_over_wavelength(&self, material: &Material) -> bool {
        self.over == Over::Wavelength && self.has_wavelengths(material)
    }
}

/// Whether none of the materials shown has an interface, so that the view's own is shown.
#[must_use]
pub fn is_own(session: &Session) -> bool {
    let has_one = |entry: &MaterialEntry| lobe(&entry.material, 0).is_some();
    !session.materials.shown().any(has_one)
}

/// The materials of which an interface is shown: those that have one. Where none has, the first stands for the view's own.
#[must_use]
pub fn subjects(session: &Session) -> Vec<(&MaterialEntry, String)> {
    if is_own(session) {
        return shown(session).take(1).collect();
    }
    let has_one = |(entry, _): &(&MaterialEntry, String)| lobe(&entry.material, 0).is_some();
    shown(session).filter(has_one).collect()
}

/// The names of the columns of reflectances.
const REFLECTANCES: [&str; 5] = ["s", "p", "mean", "schlick", "lazanyi"];

/// The cells of these columns.
fn cells(all: &Reflectances) -> [f64; REFLECTANCES.len()] {
    [all.s, all.p, all.mean(), all.schlick, all.lazanyi]
}

impl ViewOptions for Options {
    fn caption(&self, _: &Session) -> Caption {
        Caption::of("reflectance of a smooth interface")
            .naming(Subjects::Apart)
            .at(Directions::Held)
    }

    fn is_of_held(&self) -> bool {
        false
    }

    fn check_whole(&self) -> Result<(), Refused> {
        LOBE.checked(self.lobe as f64).map(|_| ())
    }

    fn numbers(&mut self) -> Numbers<'_> {
        vec![(&OWN_N, &mut self.own_n), (&OWN_K, &mut self.own_k)]
    }

    /// All curves, those that are not shown too; over the wavelength where any material is shown so.
    fn table(&self, session: &Session, answers: &mut Answers) -> Table {
        let subjects = subjects(session);
        let is_over =
            |(entry, _): &(&MaterialEntry, String)| self.is_over_wavelength(&entry.material);
        let (spectral, angular): (Vec<_>, Vec<_>) = subjects.into_iter().partition(is_over);
        if spectral.is_empty() {
            self.over_angle(session, answers, &angular)
        } else {
            self.over_wavelengths(session, answers, &spectral)
        }
    }
}

impl Options {
    fn over_angle(
        &self,
        session: &Session,
        answers: &mut Answers,
        subjects: &[(&MaterialEntry, String)],
    ) -> Table {
        let first = [
            "material",
            "channel",
            "from",
            "theta_i (degrees)",
            "theta_t (degrees)",
        ];
        let mut table = Table::new(&[&first[..], &REFLECTANCES].concat());
        for (entry, title) in subjects {
            let fresnel = answers.ask(session, entry, self.request());
            let from = if fresnel.is_from_below {
                "below"
            } else {
                "above"
            };
            for curve in &fresnel.curves {
                let channel = curve.channel.and_then(Channel::symbol);
                let words = [title, channel.unwrap_or_default(), from];
                for point in &curve.points {
                    let words = words.map(|word| Value::Text(word.to_owned()));
                    // An empty cell: there is no real angle.
                    let refracted = point.refracted_deg.unwrap_or(f64::NAN);
                    let angles = [point.theta_deg, refracted];
                    let numbers = angles.into_iter().chain(cells(&point.reflectances));
                    let row = words.into_iter().chain(numbers.map(Value::Number));
                    table.rows.push(row.collect());
                }
            }
        }
        table
    }

    fn over_wavelengths(
        &self,
        session: &Session,
        answers: &mut Answers,
        subjects: &[(&MaterialEntry, String)],
    ) -> Table {
        let first = ["material", "wavelength (nm)", "n", "k", "theta_i (degrees)"];
        let last = ["theta_i of the least p (degrees)", "least p"];
        let mut table = Table::new(&[&first[..], &REFLECTANCES, &last].concat());
        for (entry, title) in subjects {
            let all = answers.ask(session, entry, self.over_wavelength());
            for point in &all.points {
                let at = [point.nm, point.index.n, point.index.k, all.theta_deg];
                let least = point.least_p.unwrap_or([f64::NAN; 2]);
                let numbers = at.into_iter().chain(cells(&point.reflectances));
                table.push(title, numbers.chain(least));
            }
        }
        table
    }
}
