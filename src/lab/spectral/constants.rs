//! Optical constants of substances by wavelength: the tables of `assets/ior`.

use std::sync::LazyLock;

use include_dir::{Dir, include_dir};

use super::channels;
use super::table::Table;
use bxdf::Component;
use bxdf::param::{Role, Value};

/// The files. Their folder is the one list of them.
static FILES: Dir<'_> = include_dir!("$CARGO_MANIFEST_DIR/../../assets/ior");

static ALL: LazyLock<Vec<Constants>> = LazyLock::new(|| {
    let mut all: Vec<Constants> = FILES.files().filter_map(Constants::read).collect();
    all.sort_by_key(|constants| constants.id);
    all
});

/// Dominant wavelengths of the BT.709 primaries in nm: where the k of a channel is read that no reflectance fixes.
const CHANNELS_NM: [f64; 3] = [611.4, 549.1, 464.2];

/// The least k of a metal: that of silicon, the most absorbing of the others, is a tenth of it, and that of the blue of
/// brass, the least absorbing metal, nearly twice.
const LEAST_OF_METALS: f64 = 1.0;

/// The index of refraction and the extinction coefficient of a substance.
#[derive(Clone, Debug)]
pub struct Constants {
    /// The name of its file without `.csv`.
    pub id: &'static str,
    table: Table,
    /// n and k of red, green and blue.
    channels: [[f64; 2]; 3],
}

impl Constants {
    /// `None` where it is no table; a test reads every file.
    fn read(file: &include_dir::File<'static>) -> Option<Self> {
        let id = file.path().file_stem()?.to_str()?;
        if file.path().extension()? != "csv" {
            return None;
        }
        let table = Table::parse(id, file.contents_utf8()?).ok()?;
        let channels = channels::indices(|nm| table.at(nm), CHANNELS_NM);
        Some(Self {
            id,
            table,
            channels,
        })
    }

    /// n and k of n + ik at `nm`, interpolated linearly; the nearer end's outside the table.
    #[must_use]
    pub fn at(&self, nm: f64) -> [f64; 2] {
        self.table.at(nm)
    }

    /// The first and the last wavelength in nm.
    #[must_use]
    pub fn range_nm(&self) -> [f64; 2] {
        self.table.range_nm()
    }

    /// n and k of red, green and blue with which a metal reflects, at [`MATCHED_DEG`](super::MATCHED_DEG), the colour that
    /// its spectrum has.
    #[must_use]
    pub fn channels(&self) -> [[f64; 2]; 3] {
        self.channels
    }

    /// n and k of red, green and blue as files of materials give them: [`Self::channels`] in four significant digits.
    #[must_use]
    pub fn given(&self) -> [[f64; 3]; 2] {
        [0, 1].map(|part| {
            self.channels
                .map(|pair| pair.get(part).map_or(0.0, |exact| rounded(*exact)))
        })
    }

    /// Whether it is a metal: in every channel a wave dies away within less than one of its lengths.
    #[must_use]
    pub fn is_metal(&self) -> bool {
        self.channels.iter().all(|[_, k]| *k > LEAST_OF_METALS)
    }

    /// Those whose [`Self::channels`] are the index and the absorption of `component`; `None` where it has no such parameters, or no table
    /// has these values.
    #[must_use]
    pub fn of(component: &Component) -> Option<&'static Self> {
        let params = component.params();
        let value = |role| {
            let found = params.of_role(role);
            found
                .filter(|(spec, _)| params.is_relevant(spec))
                .map(|(_, value)| value)
        };
        let (Some(Value::Rgb(eta)), Some(Value::Rgb(k))) =
            (value(Role::Index), value(Role::Absorption))
        else {
            return None;
        };
        ALL.iter().find(|constants| constants.gives(eta, k))
    }

    /// Whether [`Self::channels`] are `eta` and `k`, in four significant digits.
    #[must_use]
    pub fn gives(&self, eta: [f64; 3], k: [f64; 3]) -> bool {
        let given = eta.into_iter().zip(k);
        let mut pairs = self.channels.into_iter().zip(given);
        pairs.all(|([n, extinction], (eta, k))| agrees(eta, n) && agrees(k, extinction))
    }
}

/// The constants of every metal, by id.
pub fn metals() -> impl Iterator<Item = &'static Constants> {
    ALL.iter().filter(|constants| constants.is_metal())
}

/// The constants of the substance with this id: a file of `assets/ior` without its ending.
#[must_use]
pub fn find(id: &str) -> Option<&'static Constants> {
    ALL.iter().find(|constants| constants.id == id)
}

/// What a smooth surface of `constants` reflects at the polar angle `theta_deg`, in degrees, as linear sRGB: 1 is white;
/// where the colour lies outside sRGB a channel is above 1 or below 0.
#[must_use]
pub fn colour(constants: &Constants, theta_deg: f64) -> [f64; 3] {
    channels::colour_by(|nm| constants.at(nm), theta_deg)
}

/// The unit of the last of four significant digits of `x`, which is not 0.
fn last_digit(x: f64) -> f64 {
    10_f64.powf(x.abs().log10().floor() - 3.0)
}

/// `exact` in four significant digits.
fn rounded(exact: f64) -> f64 {
    if exact == 0.0 {
        return 0.0;
    }
    // Through a text, so that it is the number that these digits are read as.
    let decimals = (-last_digit(exact).log10().round()).max(0.0) as usize;
    format!("{exact:.decimals$}").parse().unwrap_or(exact)
}

/// Whether `given` is `exact` in four significant digits.
#[must_use]
pub fn agrees(given: f64, exact: f64) -> bool {
    if exact == 0.0 {
        return given == 0.0;
    }
    let unit = last_digit(exact);
    // Half a unit of the last digit; the rest is for rounding in this comparison.
    (given - exact).abs() <= 0.5001 * unit
}

#[cfg(test)]
mod tests {
    use super::*;
    use bxdf::material::library;

    #[test]
    fn every_table_is_read() {
        let is_table =
            |file: &&include_dir::File<'_>| file.path().extension().is_some_and(|end| end == "csv");
        let count = FILES.files().filter(is_table).count();
        assert!(count >= 20 && ALL.len() == count, "{count} {}", ALL.len());
    }

    #[test]
    fn metals_are_known_by_their_indices() {
        let of = |id: &str| {
            let material = &library::find(id).unwrap().material;
            let component = material.components().first().unwrap();
            Constants::of(component).map(|constants| constants.id)
        };
        assert_eq!(
            [of("gold"), of("copper"), of("chalk")],
            [Some("gold"), Some("copper"), None]
        );
        let gold = find("gold").unwrap();
        let material = &library::find("gold").unwrap().material;
        let params = material.components().first().unwrap().params();
        assert_eq!(gold.given(), ["eta", "k"].map(|name| params.rgb(name)));
        assert!(metals().all(|metal| { metal.gives(metal.given()[0], metal.given()[1]) }));
        let [is_metal, is_none] = ["titanium", "silicon"].map(|id| find(id).unwrap().is_metal());
        assert!(is_metal && !is_none && metals().count() > 10);
        assert!(agrees(0.2224, 0.222_449) && !agrees(0.2224, 0.222_46));
        assert!(agrees(0.0, 0.0) && !agrees(0.1, 0.0));
    }

    #[test]
    fn metals_have_the_colours_that_others_computed() {
        // Tables through CIE 1931 and D65 to linear sRGB, to three decimals and by another rule of summation: of 5 nm.
        for (id, expected) in [
            ("gold", [1.035, 0.730, 0.364]),
            ("copper", [0.929, 0.624, 0.522]),
            ("brass", [0.908, 0.779, 0.423]),
        ] {
            let found = colour(find(id).unwrap(), 0.0);
            for (found, expected) in found.into_iter().zip(expected) {
                assert!((found - expected).abs() < 4e-3, "{id}: {found} {expected}");
            }
        }
    }
}
