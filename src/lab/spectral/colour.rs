//! The colour of a spectrum under daylight: observer and illuminant of the CIE, to linear R, G, B of ITU-R BT.709.

use std::sync::LazyLock;

use palette::convert::FromColorUnclamped as _;
use palette::white_point::D65;
use palette::{LinSrgb, Xyz};

use super::table::Table;

/// The wavelengths that are seen, in nm: those of the tables.
pub const RANGE_NM: [f64; 2] = [380.0, 780.0];

/// How many wavelengths stand for all: tables of optical constants have no finer features.
pub const FINEST: usize = 80;

/// Steps of a nanometre in which weights are summed: the tables, read between their rows, are straight there.
const STEPS_PER_NM: usize = 2;

// Tests read both: what is no table would give no number.
static OBSERVER: LazyLock<Option<Table>> = LazyLock::new(|| {
    let text = include_str!("../../../assets/cie/observer_1931_2deg.csv");
    Table::parse("observer", text).ok()
});

static ILLUMINANT: LazyLock<Option<Table>> = LazyLock::new(|| {
    let text = include_str!("../../../assets/cie/illuminant_d65.csv");
    Table::parse("illuminant", text).ok()
});

/// What a value at each of `count` wavelengths adds to R, G and B: the wavelengths in nm, each in the middle of an equal
/// part of [`RANGE_NM`], with the weight of its part per channel. The weights of a channel sum to 1: what reflects all
/// light of every wavelength is white.
///
/// # Source
/// Colour-matching functions of the CIE 1931 observer (2 degrees) and illuminant D65 (`assets/cie`, with sources), read
/// linearly between rows.
#[must_use]
pub fn rgb_weights(count: usize) -> Vec<(f64, [f64; 3])> {
    let [start, end] = RANGE_NM;
    let width = (end - start) / count as f64;
    let parts = (0..count).map(|index| {
        let low = start + width * index as f64;
        (low + 0.5 * width, rgb(tristimulus([low, low + width])))
    });
    let mut parts: Vec<(f64, [f64; 3])> = parts.collect();
    let white = parts.iter().fold([0.0; 3], |sum, (_, rgb)| add(sum, *rgb));
    for (_, rgb) in &mut parts {
        rgb.iter_mut()
            .zip(white)
            .for_each(|(weight, white)| *weight /= white);
    }
    parts
}

/// The chromaticity x, y of the illuminant.
#[must_use]
pub fn white_chromaticity() -> [f64; 2] {
    let [x, y, z] = tristimulus(RANGE_NM);
    [x, y].map(|part| part / (x + y + z))
}

/// X, Y, Z of the illuminant's light between two wavelengths in nm, in a unit of its own.
fn tristimulus([low, high]: [f64; 2]) -> [f64; 3] {
    let (Some(observer), Some(illuminant)) = (&*OBSERVER, &*ILLUMINANT) else {
        return [f64::NAN; 3];
    };
    let steps = ((high - low).ceil() as usize).max(1) * STEPS_PER_NM;
    let step = (high - low) / steps as f64;
    (0..steps).fold([0.0; 3], |sum, index| {
        let nm = low + step * (index as f64 + 0.5);
        let [power] = illuminant.at(nm);
        add(sum, observer.at(nm).map(|bar: f64| bar * power * step))
    })
}

fn rgb([x, y, z]: [f64; 3]) -> [f64; 3] {
    let color = LinSrgb::from_color_unclamped(Xyz::<D65, f64>::new(x, y, z));
    [color.red, color.green, color.blue]
}

fn add([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> [f64; 3] {
    [a + x, b + y, c + z]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tables_are_those_of_the_cie() {
        let observer = OBSERVER.as_ref().unwrap();
        let rows = (0..=80).map(|index| observer.at(380.0 + 5.0 * f64::from(index)));
        // The sum of y over the rows of 5 nm, and the chromaticity of D65 for this observer (CIE 15).
        let sum: f64 = rows.map(|[_, y, _]: [f64; 3]| y).sum();
        assert!((sum - 21.3714).abs() < 1e-4, "{sum}");
        let [x, y] = white_chromaticity();
        assert!(
            (x - 0.312_72).abs() < 1e-4 && (y - 0.329_03).abs() < 1e-4,
            "{x} {y}"
        );
    }

    #[test]
    fn white_is_white_for_any_number_and_a_spectrum_line_has_its_colour() {
        for count in [1, 8, 31, 80] {
            let sum = rgb_weights(count)
                .iter()
                .fold([0.0; 3], |sum, (_, weight)| add(sum, *weight));
            assert!(sum.iter().all(|x| (x - 1.0).abs() < 1e-12), "{sum:?}");
        }
        let at = |nm: f64| {
            let weights = rgb_weights(80);
            let near = weights.iter().find(|(middle, _)| (middle - nm).abs() < 2.6);
            near.unwrap().1
        };
        let [r, g, b] = at(620.0);
        assert!(r > 0.0 && r > g && r > b);
        let [r, g, b] = at(450.0);
        assert!(b > 0.0 && b > g && b > r);
        let [r, g, b] = at(530.0);
        assert!(g > 0.0 && g > r && g > b);
    }
}
