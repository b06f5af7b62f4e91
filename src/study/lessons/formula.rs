//! Formulas in TeX: what may stand in them. A drawing is made of them where they are shown.

/// The most bytes of a formula.
const MAX_LENGTH: usize = 2000;

/// Symbols that have the colour of the thing they name, as `\light{\omega_i}`: the command, and what it stands for.
pub const COLOURED: [&str; 6] = ["light", "viewer", "normal", "half", "lobe", "mirror"];

/// What a symbol with a colour stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Symbol {
    /// A thing, by its command in [`COLOURED`].
    Thing(&'static str),
    /// A parameter, as `\param{alpha_x}{\alpha_s}`, by its place in [`parameters`].
    Parameter(usize),
}

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
pub fn expanded(tex: &str, colour: impl Fn(Symbol) -> String) -> String {
    replaced(tex, |symbol| format!("\\textcolor{{{}}}{{", colour(symbol)))
}

/// The command of a symbol that stands for a parameter.
const PARAMETER: &str = "\\param{";

/// The names of the parameters that symbols stand for, one for each symbol.
#[must_use]
pub fn parameters(tex: &str) -> Vec<&str> {
    let behind = tex.split(PARAMETER).skip(1);
    let names = behind.filter_map(|rest| rest.split_once("}{"));
    names.map(|(name, _)| name).collect()
}

/// The formula with what `open` gives in place of the command of each coloured symbol, up to the brace of the symbol itself.
fn replaced(tex: &str, open: impl Fn(Symbol) -> String) -> String {
    let mut text = tex.to_owned();
    for name in COLOURED {
        text = text.replace(&format!("\\{name}{{"), &open(Symbol::Thing(name)));
    }
    let mut pieces = text.split(PARAMETER);
    let mut whole = pieces.next().unwrap_or_default().to_owned();
    let mut place = 0;
    for piece in pieces {
        if let Some((_, rest)) = piece.split_once("}{") {
            whole.push_str(&open(Symbol::Parameter(place)));
            whole.push_str(rest);
            place += 1;
        } else {
            // It is left for the parser, which says what is wrong with it.
            whole.push_str(PARAMETER);
            whole.push_str(piece);
        }
    }
    whole
}

/// How a formula is read aloud: its signs in words, near enough to be followed.
#[must_use]
pub fn spoken(tex: &str) -> String {
    let mut words = String::new();
    let mut rest = replaced(tex, |_| "{".to_owned());
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
            (r"\param{alpha_x}{\alpha_s}^2", "alpha s squared"),
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
        for tex in [
            "",
            " ",
            r"\frac{1",
            r"\unknown",
            r"\param{x}",
            &"x".repeat(3000),
        ] {
            assert!(check(tex).is_err(), "{tex}");
        }
        assert_eq!(check(r"\lobe{f} = \frac{\rho}{\pi}"), Ok(()));
        let tex = r"\param{alpha_x}{\alpha_s}\,\param{k}{k}";
        assert_eq!(check(tex), Ok(()));
        assert_eq!(parameters(tex), ["alpha_x", "k"]);
    }

    #[test]
    fn every_formula_of_the_cards_can_be_laid_out() {
        use bxdf::models::MODELS;
        use bxdf_lab::formula_card;
        use glam::DVec3;
        let (wo, wi) = (DVec3::new(0.6, 0.0, 0.8), DVec3::new(-0.48, 0.36, 0.8));
        for model in MODELS {
            let card = formula_card::find(model.id).unwrap();
            let words = model.parameters.iter().flat_map(|spec| {
                let choices = spec.choices.iter();
                choices.map(|word| {
                    model
                        .defaults()
                        .with(&[(spec.name, bxdf::Value::Choice(word))])
                })
            });
            for params in words.flatten().chain([model.defaults()]) {
                let terms = [wi, -wi].map(|wi| card.terms(&params, wo, wi));
                let terms = terms.iter().flatten();
                let said = terms.flat_map(|term| [term.symbol, term.formula]);
                for tex in said
                    .chain(card.formulas(&params))
                    .filter(|tex| !tex.is_empty())
                {
                    assert_eq!(check(tex), Ok(()), "{}", model.id);
                    for name in parameters(tex) {
                        assert!(params.get(name).is_some(), "{}: {name}", model.id);
                    }
                }
            }
        }
    }
}
