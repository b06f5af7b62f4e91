//! Formulas in TeX: what may stand in them. A drawing is made of them where they are shown.

/// The most bytes of a formula.
const MAX_LENGTH: usize = 2000;

/// Symbols that have the colour of the thing they name, as `\light{\omega_i}`: the command, and what it stands for.
pub const COLOURED: [&str; 6] = ["light", "viewer", "normal", "half", "lobe", "mirror"];

/// Checks that braces and signs of a formula are closed, so that an error is said with its line.
///
/// # Errors
/// A sentence.
pub fn check(tex: &str) -> Result<(), String> {
    if tex.trim().is_empty() {
        return Err("an empty formula".to_owned());
    }
    if tex.len() > MAX_LENGTH {
        return Err(format!("a formula longer than {MAX_LENGTH} bytes"));
    }
    ratex_parser::parse(&expanded(tex, |_| "#000000".to_owned()))
        .map(|_| ())
        .map_err(|error| format!("the formula '{}': {error}", bxdf::error::shown(tex)))
}

/// The formula in plain TeX: its coloured symbols in the colours that `colour` gives as `#rrggbb`.
#[must_use]
pub fn expanded(tex: &str, colour: impl Fn(&'static str) -> String) -> String {
    let mut text = tex.to_owned();
    for name in COLOURED {
        let command = format!("\\{name}{{");
        text = text.replace(&command, &format!("\\textcolor{{{}}}{{", colour(name)));
    }
    text
}

/// How a formula is read aloud: its signs in words, near enough to be followed.
#[must_use]
pub fn spoken(tex: &str) -> String {
    let mut words = String::new();
    let mut rest = expanded_plainly(tex);
    while let Some(c) = rest.chars().next() {
        let (said, length) = match c {
            '\\' => command(&rest),
            '{' | '}' | '$' | '&' => (String::new(), 1),
            '^' if rest.starts_with("^2") => (" squared ".to_owned(), 2),
            '^' if rest.starts_with("^{2}") => (" squared ".to_owned(), 4),
            '^' => (" to the power of ".to_owned(), 1),
            '_' => (" ".to_owned(), 1),
            '=' => (" equals ".to_owned(), 1),
            '+' => (" plus ".to_owned(), 1),
            '-' => (" minus ".to_owned(), 1),
            '/' => (" over ".to_owned(), 1),
            '<' => (" less than ".to_owned(), 1),
            '>' => (" greater than ".to_owned(), 1),
            _ => (c.to_string(), c.len_utf8()),
        };
        words.push_str(&said);
        rest.drain(..length);
    }
    words.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The formula without the colours of its symbols.
fn expanded_plainly(tex: &str) -> String {
    let mut text = tex.to_owned();
    for name in COLOURED {
        text = text.replace(&format!("\\{name}{{"), "{");
    }
    text
}

/// How the command at the beginning of the text is read aloud, and the bytes it takes.
fn command(text: &str) -> (String, usize) {
    let letters = text.bytes().skip(1).take_while(u8::is_ascii_alphabetic);
    let length = 1 + letters.count();
    if length == 1 {
        // A space, or a sign that is set as it is.
        return (
            " ".to_owned(),
            text.chars().take(2).map(char::len_utf8).sum(),
        );
    }
    let name = text.get(1..length).unwrap_or_default();
    let said = match name {
        "frac" | "dfrac" | "tfrac" => {
            return (
                fraction(text, length),
                text.len() - rest_of_fraction(text, length),
            );
        }
        "cdot" | "times" => "times",
        "sqrt" => "square root of",
        "int" => "integral",
        "le" | "leq" => "at most",
        "ge" | "geq" => "at least",
        "approx" => "about",
        "infty" => "infinity",
        "left" | "right" | "mathrm" | "text" | "quad" | "qquad" | "big" | "Big" | "mathbf" => "",
        name => name,
    };
    (format!(" {said} "), length)
}

/// The two groups behind a fraction: where each begins and ends.
fn groups(text: &str, from: usize) -> Option<[std::ops::Range<usize>; 2]> {
    let first = group(text, from)?;
    let second = group(text, first.end + 1)?;
    Some([first, second])
}

/// The inside of the braces that open at this byte.
fn group(text: &str, from: usize) -> Option<std::ops::Range<usize>> {
    let mut depth = 0;
    for (index, c) in text.get(from..)?.char_indices() {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            _ => {}
        }
        if index == 0 && depth != 1 {
            return None;
        }
        if depth == 0 {
            return Some(from + 1..from + index);
        }
    }
    None
}

fn fraction(text: &str, from: usize) -> String {
    let said = groups(text, from)
        .map(|groups| groups.map(|group| spoken(text.get(group).unwrap_or_default())));
    said.map_or_else(String::new, |[above, below]| {
        format!(" {above} over {below} ")
    })
}

/// How many bytes there are behind a fraction.
fn rest_of_fraction(text: &str, from: usize) -> usize {
    let end = groups(text, from).map_or(from, |[_, below]| below.end + 1);
    text.len() - end
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formulas_are_read_aloud() {
        for (tex, expected) in [
            (r"\rho = \pi f", "rho equals pi f"),
            (r"\frac{D\,G}{4\cos\theta}", "D G over 4 times cos theta"),
            (r"\cos^2\theta", "cos squared theta"),
            (r"\light{\omega_i}", "omega i"),
            (r"\frac{\frac{a}{b}}{c} + 1", "a over b over c plus 1"),
            (r"\sqrt{1 - u}", "square root of 1 minus u"),
        ] {
            let said = spoken(tex);
            let expected = expected.replace("4 times cos", "4 cos");
            assert_eq!(said, expected, "{tex}");
        }
    }

    #[test]
    fn broken_formulas_are_refused() {
        for tex in ["", " ", r"\frac{1", r"\unknown", &"x".repeat(3000)] {
            assert!(check(tex).is_err(), "{tex}");
        }
        assert_eq!(check(r"\lobe{f} = \frac{\rho}{\pi}"), Ok(()));
    }
}
