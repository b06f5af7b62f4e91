//! What a typed text says: a number as people write it, in either notation, with its unit or without.

use bxdf_study::format;

/// Units that are written in several ways.
const SPELLINGS: [(&str, &[&str]); 2] = [
    ("degrees", &["°", "º", "degrees", "degree", "deg"]),
    ("stops", &["stops", "stop"]),
];

/// The number that `text` stands for, in `unit`; `None` where it stands for none. Beyond the range of f64 it is infinite.
///
/// A decimal point or a decimal comma, but no two of them: `1.234,5` could be either. Blanks around sign and unit, and
/// between groups of three digits before the decimal mark. An exponent, typed or as the window sets it. Words such as `inf` are no numbers.
#[must_use]
pub fn number(text: &str, unit: &str) -> Option<f64> {
    let text = without_unit(text.trim(), unit);
    let (is_negative, digits) = sign(text);
    let (before, power) = digits.split_once('×').unwrap_or(("1", digits));
    let raised = power.trim_start().strip_prefix("10").map(format::lowered);
    let is_raised = |exponent: &String| !exponent.is_empty();
    let set = raised
        .filter(is_raised)
        .map(|exponent| (before.trim_end(), exponent));
    let typed = digits.split_once(['e', 'E']);
    let typed = typed.map(|(mantissa, exponent)| (mantissa, exponent.to_owned()));
    let (mantissa, exponent) = match set.or(typed) {
        Some((mantissa, exponent)) => (mantissa, Some(exponent)),
        None => (digits, None),
    };
    let (whole, fraction) = match mantissa.split_once(['.', ',']) {
        Some((whole, fraction)) => (whole, fraction),
        None => (mantissa, ""),
    };
    let whole = ungrouped(whole)?;
    let is_empty = whole.is_empty() && fraction.is_empty();
    if is_empty || !is_digits(fraction) {
        return None;
    }
    let exponent = match exponent.as_deref().map(sign) {
        None => String::new(),
        Some((_, digits)) if digits.is_empty() || !is_digits(digits) => return None,
        Some((true, digits)) => format!("e-{digits}"),
        Some((false, digits)) => format!("e{digits}"),
    };
    let sign = if is_negative { "-" } else { "" };
    format!("{sign}{whole}.{fraction}{exponent}").parse().ok()
}

/// `text` without the unit at its end, if one stands there.
fn without_unit<'a>(text: &'a str, unit: &'a str) -> &'a str {
    let known = SPELLINGS.iter().find(|(name, _)| *name == unit);
    let own = [unit];
    let spellings = known.map_or(own.as_slice(), |(_, spellings)| *spellings);
    let cut = |spelling: &&str| {
        let at = text.len().checked_sub(spelling.len())?;
        let (number, end) = text.split_at_checked(at)?;
        let is_unit = !spelling.is_empty() && end.eq_ignore_ascii_case(spelling);
        is_unit.then(|| number.trim_end())
    };
    spellings.iter().find_map(cut).unwrap_or(text)
}

/// Whether a minus stands before `text`, and what follows the sign.
fn sign(text: &str) -> (bool, &str) {
    // The second one is the minus of typeset text.
    let minus = text.strip_prefix(['-', '\u{2212}']);
    let rest = minus.or(text.strip_prefix('+')).unwrap_or(text);
    (minus.is_some(), rest.trim_start())
}

fn is_digits(text: &str) -> bool {
    text.bytes().all(|byte| byte.is_ascii_digit())
}

/// The digits of `text` without the blanks between groups of three; `None` where something else stands there.
fn ungrouped(text: &str) -> Option<String> {
    let groups: Vec<&str> = text.split(char::is_whitespace).collect();
    let is_grouped = |(index, group): (usize, &&str)| match index {
        0 => groups.len() == 1 || (1..=3).contains(&group.len()),
        _ => group.len() == 3,
    };
    let is_number = groups.iter().all(|group| is_digits(group));
    (is_number && groups.iter().enumerate().all(is_grouped)).then(|| groups.concat())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_read_as_people_write_them() {
        for (text, expected) in [
            ("0.345", 0.345),
            (".345", 0.345),
            ("0,345", 0.345),
            (",5", 0.5),
            ("5.", 5.0),
            ("  12 ", 12.0),
            ("1e-3", 1e-3),
            ("1E+3", 1e3),
            ("2,5e\u{2212}3", 2.5e-3),
            ("1.2 × 10⁻³", 1.2e-3),
            ("-3\u{a0}×\u{a0}10¹²", -3e12),
            ("10⁻⁴", 1e-4),
            ("-7", -7.0),
            ("\u{2212}7", -7.0),
            ("- 7", -7.0),
            ("+7", 7.0),
            ("12 345,5", 12345.5),
            ("1\u{202f}000\u{202f}000", 1e6),
            ("0.123456789012345678", 0.123_456_789_012_345_68),
            ("1e400", f64::INFINITY),
            ("-1e400", f64::NEG_INFINITY),
            ("007", 7.0),
        ] {
            assert_eq!(number(text, ""), Some(expected), "{text}");
        }
    }

    #[test]
    fn what_is_no_number_is_none() {
        for text in [
            "",
            " ",
            "abc",
            "NaN",
            "nan",
            "inf",
            "-inf",
            "infinity",
            "1,5,0",
            "1.234,5",
            "1,234.5",
            "1.2.3",
            ".",
            ",",
            "-",
            "+-1",
            "--1",
            "e5",
            "1e",
            "1e-",
            "1e2.5",
            "1e5e5",
            "1 × 10",
            "1 × 5",
            "× 10⁵",
            "1 × 10⁻",
            "0x10",
            "1_000",
            "3 4",
            "1 00",
            "1000 000",
            "1  000",
            "0. 5",
            "50%",
            "1/2",
            "12 apples",
            "30°",
            "30 deg",
            "\u{661}",
            "1\u{0}",
        ] {
            assert_eq!(number(text, ""), None, "{text}");
        }
    }

    #[test]
    fn units_may_stand_behind() {
        for text in [
            "30",
            "30°",
            "30 °",
            "30 deg",
            "30DEG",
            "30 degrees",
            "30º",
            " 30\u{a0}° ",
        ] {
            assert_eq!(number(text, "degrees"), Some(30.0), "{text}");
        }
        assert_eq!(number("-1,5 stops", "stops"), Some(-1.5));
        assert_eq!(number("633 nm", "nm"), Some(633.0));
        for (text, unit) in [
            ("30 rad", "degrees"),
            ("°", "degrees"),
            ("30°°", "degrees"),
            ("30 deg", "stops"),
            ("m", "nm"),
            ("é", "deg"),
        ] {
            assert_eq!(number(text, unit), None, "{text}");
        }
    }
}
