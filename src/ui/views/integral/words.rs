//! What is said of a sum: which one it is, how it stands, what it misses.

use bxdf_lab::analysis::Channel;
use bxdf_lab::analysis::integral::{Exact, Integrand, Missed, Request, Sum};
use bxdf_study::format;
use bxdf_study::session::Session;

use super::play::Moment;

/// A number in four decimals, or where these would read as nothing in three digits.
pub(super) fn number(x: f64) -> String {
    if x == 0.0 || x.abs() >= 1e-3 {
        format!("{x:.4}")
    } else {
        format::value(x)
    }
}

/// What the exact value is called, `2π` or `ρ_dh`.
pub(super) fn symbol(request: Request, session: &Session) -> &'static str {
    match (request.integrand, request.is_sphere) {
        (Integrand::One, true) => "4π",
        (Integrand::One, false) | (Integrand::Cosine, true) => "2π",
        (Integrand::Cosine, false) => "π",
        (Integrand::FCos, _) if session.held_name() == "light" => "ρ_dh",
        (Integrand::FCos, _) => "ρ_hd",
        (Integrand::Density, _) => "P",
    }
}

/// Which sum it is, in a sentence.
pub(super) fn meaning(request: Request, session: &Session) -> String {
    let symbol = symbol(request, session);
    let held = format::degrees(session.theta_deg);
    let whole = if request.is_sphere {
        "sphere"
    } else {
        "hemisphere"
    };
    match request.integrand {
        Integrand::One => format!(
            "1 over the {whole} is its solid angle: all patches have the same, so that their sum is {symbol} sr exactly, at \
             every count"
        ),
        Integrand::Cosine => {
            let disc = if request.is_sphere {
                "two discs"
            } else {
                "unit disc"
            };
            format!(
                "cos θ over the {whole} is the area of the {disc}: a patch's shadow is its solid angle times cos θ at its \
                 middle, so that the sum is {symbol} exactly, at every count"
            )
        }
        Integrand::FCos if symbol == "ρ_dh" => format!(
            "f cos θ over all viewers is {symbol}, the share of the light arriving at θ {held} that leaves: each patch adds f \
             times the area of its shadow"
        ),
        Integrand::FCos => format!(
            "f cos θ over all lights is {symbol}, what the viewer at θ {held} sees under an even sky of radiance 1: each patch \
             adds f times the area of its shadow"
        ),
        Integrand::Density => format!(
            "The density over the {whole} is the probability P of a sample for the {} at θ {held}: density times solid angle, \
             patch by patch",
            session.held_name()
        ),
    }
}

/// How much has been counted.
pub(super) fn counted(sum: &Sum, moment: Moment) -> String {
    let total = sum.parts.len() + sum.deltas.len();
    let done = moment.counted(total).min(sum.parts.len());
    let of_side = sum.grid.count();
    let all = if sum.parts.len() > of_side {
        format!("2 × {of_side}")
    } else {
        of_side.to_string()
    };
    if moment.is_playing() {
        format!("{done} of {all} patches")
    } else {
        format!("Sum of {all} patches")
    }
}

/// How far the sum is from the exact value; what is still to come, while it is played.
pub(super) fn error(integrand: Integrand, so_far: f64, exact: f64, moment: Moment) -> String {
    let difference = so_far - exact;
    if moment.is_playing() {
        return format!("{} to come", number((-difference).max(0.0)));
    }
    if !integrand.is_of_surface() {
        return "No error".to_owned();
    }
    // What rounding leaves of thousands of summands is no error of the patches.
    if difference.abs() <= 1e-12 * exact.abs().max(1e-12) {
        return "Error 0".to_owned();
    }
    let sign = if difference > 0.0 { "+" } else { "" };
    let relative = if exact == 0.0 {
        String::new()
    } else {
        format!(" ({sign}{} %)", format::value(100.0 * difference / exact))
    };
    format!("Error {sign}{}{relative}", number(difference))
}

/// What is known of an exact value.
pub(super) fn exact(symbol: &str, exact: &Exact) -> String {
    let Some(value) = exact.value else {
        return format!("Exact {symbol} …");
    };
    let value = number(Channel::Luminance.of(value));
    // An error that the digits shown do not hold is not worth a word.
    if exact.error > 1e-4 {
        format!("Exact {symbol} = {value} ± {}", format::value(exact.error))
    } else {
        format!("Exact {symbol} = {value}")
    }
}

/// Where the samples are that the density does not hold.
pub(super) fn elsewhere(exact: &Exact) -> Option<String> {
    // Less is an error of the quadrature.
    let least = exact.error.max(1e-6);
    let part =
        |share: f64, words: &str| (share > least).then(|| format!("{} {words}", number(share)));
    let parts = [
        part(exact.deltas, "in Dirac deltas"),
        part(exact.lost, "lost below the horizon"),
    ];
    let parts: Vec<String> = parts.into_iter().flatten().collect();
    (!parts.is_empty()).then(|| format!("The rest to 1: {}", parts.join(", ")))
}

/// A lobe that the patches are too coarse for.
pub(super) fn missed(missed: &Missed) -> String {
    let lobe = missed.lobe;
    let name = if lobe.name.is_empty() {
        lobe.category.title()
    } else {
        lobe.name
    };
    let name = name.to_lowercase();
    let needed = missed.needed_log2.map_or_else(
        || "no number of them would do".to_owned(),
        |log2| format!("{} would find it", many(log2)),
    );
    let verb = if missed.found < NOTHING * missed.of {
        "miss"
    } else {
        "are too coarse for"
    };
    let [found, of] = [missed.found, missed.of].map(number);
    format!("The patches {verb} the {name} lobe, finding {found} of its {of}: {needed}")
}

/// Who finds less than this part of a lobe misses it.
const NOTHING: f64 = 0.1;

/// 2 to the power of `log2`, in words where it is large.
fn many(log2: u8) -> String {
    let count = f64::from(log2).exp2();
    match log2 {
        0..20 => format!("{count}"),
        20..30 => format!("about {:.0} million", count / 1e6),
        30..40 => format!("about {:.0} billion", count / 1e9),
        _ => format!("about 10^{:.0}", count.log10()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_and_errors_read_well() {
        assert_eq!(many(14), "16384");
        assert_eq!(many(22), "about 4 million");
        assert_eq!(many(38), "about 275 billion");
        assert_eq!(many(56), "about 10^17");
        let end = Moment::END;
        let of = |so_far, exact| error(Integrand::FCos, so_far, exact, end);
        assert_eq!(of(0.5, 0.5), "Error 0");
        assert_eq!(of(0.505, 0.5), "Error +0.0050 (+1 %)");
        assert_eq!(of(0.4, 0.5), "Error -0.1000 (-20 %)");
        assert_eq!(error(Integrand::One, 3.0, 3.1, end), "No error");
        assert_eq!(number(2e-5), "2\u{a0}×\u{a0}10⁻⁵");
    }
}
