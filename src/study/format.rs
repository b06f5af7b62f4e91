//! Numbers as the screen shows them.

/// A value in three significant digits, as short as it goes: `0.318`, `12`, `1.2e5`, `0`.
#[must_use]
pub fn value(x: f64) -> String {
    if x == 0.0 {
        return "0".to_owned();
    }
    let magnitude = x.abs().log10().floor();
    if (-3.0..4.0).contains(&magnitude) {
        let decimals = (2.0 - magnitude).max(0.0) as usize;
        let text = format!("{x:.decimals$}");
        if text.contains('.') {
            text.trim_end_matches('0').trim_end_matches('.').to_owned()
        } else {
            text
        }
    } else {
        let text = format!("{x:.2e}");
        let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
        format!(
            "{}e{exponent}",
            mantissa.trim_end_matches('0').trim_end_matches('.')
        )
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
            (123_456.0, "1.23e5"),
        ];
        for (x, text) in cases {
            assert_eq!(value(x), text);
        }
        assert_eq!(value(0.000_12), "1.2e-4");
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
            (2.16e-7, "2.2e-7"),
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
