//! Numbers as the screen shows them.

/// A value in three significant digits, as short as it goes and as it is set: `0.318`, `12`, `1.2 × 10⁵`, `10⁻⁴`, `0`. It
/// breaks over no two lines.
#[must_use]
pub fn value(x: f64) -> String {
    match rounded(x) {
        (digits, 0) => digits,
        (one, exponent) if one == "1" => power_of_ten(exponent),
        (mantissa, exponent) => format!("{mantissa}\u{a0}×\u{a0}{}", power_of_ten(exponent)),
    }
}

/// The same as it is typed, for fields, where room is short: `1.2e5`.
#[must_use]
pub fn typed(x: f64) -> String {
    match rounded(x) {
        (digits, 0) => digits,
        (mantissa, exponent) => format!("{mantissa}e{exponent}"),
    }
}

/// The signs of an exponent, as they are typed and raised.
const RAISED: [(char, char); 11] = [
    ('-', '⁻'),
    ('0', '⁰'),
    ('1', '¹'),
    ('2', '²'),
    ('3', '³'),
    ('4', '⁴'),
    ('5', '⁵'),
    ('6', '⁶'),
    ('7', '⁷'),
    ('8', '⁸'),
    ('9', '⁹'),
];

/// A power of ten: `10⁻³`.
fn power_of_ten(exponent: i32) -> String {
    let raised = |typed: char| {
        let mut pairs = RAISED.into_iter();
        pairs.find(|pair| pair.0 == typed).map(|pair| pair.1)
    };
    let digits = exponent.to_string();
    let exponent: String = digits.chars().filter_map(raised).collect();
    format!("10{exponent}")
}

/// The exponent behind a 10, `⁻³`, as it is typed; empty where something else stands there.
#[must_use]
pub fn lowered(raised: &str) -> String {
    let typed = |raised: char| {
        let mut pairs = RAISED.into_iter();
        pairs.find(|pair| pair.1 == raised).map(|pair| pair.0)
    };
    raised
        .chars()
        .map(typed)
        .collect::<Option<String>>()
        .unwrap_or_default()
}

/// The magnitudes that plain digits say at a glance: others have too many zeros to count.
const PLAIN: std::ops::Range<f64> = 1e-3..1e5;

/// The three digits that count, and the power of ten behind them; 0 where plain digits say it.
fn rounded(x: f64) -> (String, i32) {
    let trimmed = |text: &str| {
        if text.contains('.') {
            text.trim_end_matches('0').trim_end_matches('.').to_owned()
        } else {
            text.to_owned()
        }
    };
    // Of the rounded value: 0.9999 is 1.
    let text = format!("{x:.2e}");
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    if x == 0.0 || !x.is_finite() {
        (trimmed(mantissa), 0)
    } else if PLAIN.contains(&x.abs()) {
        let decimals = usize::try_from(2 - exponent).unwrap_or(0);
        (trimmed(&format!("{x:.decimals$}")), 0)
    } else {
        (trimmed(mantissa), exponent)
    }
}

/// A share in two significant digits: in percent where that is short, `22 %`, else as a number, `2.2e-7`.
#[must_use]
pub fn share(x: f64) -> String {
    if x == 0.0 || !x.is_finite() {
        return percent(x);
    }
    let rounded = two_digits(x);
    if rounded.abs() < LEAST_IN_PERCENT {
        value(rounded)
    } else {
        percent(100.0 * rounded)
    }
}

/// A number of percent, on one line with its sign.
fn percent(x: f64) -> String {
    format!("{}\u{a0}%", value(x))
}

/// The nearest number of two significant digits.
#[must_use]
pub fn two_digits(x: f64) -> f64 {
    if x == 0.0 || !x.is_finite() {
        return x;
    }
    let unit = 10.0_f64.powf(x.abs().log10().floor() - 1.0);
    (x / unit).round() * unit
}

/// Below a hundredth of a percent the zeros before the digits have to be counted.
const LEAST_IN_PERCENT: f64 = 0.999e-4;

/// An angle in degrees with at most one decimal and the sign for degrees: `50°`, `12.5°`.
#[must_use]
pub fn degrees(angle_deg: f64) -> String {
    let rounded = (angle_deg * 10.0).round() / 10.0;
    // Adding 0 turns the -0 of rounding into 0.
    format!("{}°", rounded + 0.0)
}

/// The smallest round step (1, 2, 2.5 or 5 times a power of ten) of which five reach `range`, above 0.
#[must_use]
pub fn round_step(range: f64) -> f64 {
    const STEPS_WANTED: f64 = 5.0;
    let least = range / STEPS_WANTED;
    let power = 10_f64.powf(least.log10().floor());
    // The tolerance keeps 0.5 a step of itself in spite of rounding in the logarithm.
    let fits = |step: &f64| *step >= least * (1.0 - 1e-9);
    [1.0, 2.0, 2.5, 5.0]
        .map(|digit| digit * power)
        .into_iter()
        .find(fits)
        .unwrap_or(10.0 * power)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_short() {
        let cases = [
            (0.0, "0"),
            (0.254_65, "0.255"),
            (12.0, "12"),
            (1234.6, "1235"),
            (0.999_9, "1"),
            (0.001, "0.001"),
            (12_345.0, "12345"),
            (123_456.0, "1.23 × 10⁵"),
            (0.000_12, "1.2 × 10⁻⁴"),
            (-3e-12, "-3 × 10⁻¹²"),
            (1e-4, "10⁻⁴"),
        ];
        for (x, text) in cases {
            assert_eq!(value(x).replace('\u{a0}', " "), text);
        }
        assert_eq!(typed(123_456.0), "1.23e5");
        assert_eq!(typed(0.000_12), "1.2e-4");
        assert_eq!(typed(0.25), "0.25");
        assert_eq!(lowered("⁻¹²"), "-12");
        assert_eq!(lowered("⁻1"), "");
        assert_eq!(value(-0.5), "-0.5");
        assert_eq!(degrees(-0.01), "0°");
        assert_eq!(degrees(12.54), "12.5°");
    }

    #[test]
    fn shares_are_short() {
        let cases = [
            (0.223, "22 %"),
            (0.01, "1 %"),
            (0.0444, "4.4 %"),
            (1e-4, "0.01 %"),
            (0.0, "0 %"),
            (7.71, "770 %"),
            (2.16e-7, "2.2 × 10⁻⁷"),
        ];
        for (x, text) in cases {
            assert_eq!(share(x).replace('\u{a0}', " "), text);
        }
    }

    #[test]
    fn five_steps_reach_the_range() {
        for (range, step) in [
            (1.0, 0.2),
            (0.32, 0.1),
            (5.0, 1.0),
            (12.6, 5.0),
            (2.5, 0.5),
            (1.2e5, 2.5e4),
        ] {
            assert!(
                (round_step(range) / step - 1.0).abs() < 1e-12,
                "{range}: {}",
                round_step(range)
            );
        }
    }
}
