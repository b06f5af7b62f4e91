//! The command line: one file per verb. Results go to standard output, messages to standard error.
//!
//! Exit codes: 0 done, 1 a check failed, 2 bad input; 101, as Rust has it, where the program itself is at
//! fault.

mod albedo;
mod args;
mod bench;
mod check;
mod eval;
#[cfg(feature = "gui")]
mod export;
pub mod input;
mod models;
mod output;
#[cfg(any(feature = "gui", test))]
pub mod render;
mod sample;
mod tradeoff;

use std::error::Error as _;
use std::io::{self, Write as _};
use std::panic;
use std::process::ExitCode;

use clap::{Parser, Subcommand};

use crate::error::{Error, Result};

/// The exit code of a check that failed.
const CHECK_FAILED: u8 = 1;

/// The exit code of bad input, and of a machine that lacks what was asked for.
const BAD_INPUT: u8 = 2;

/// The exit code of a panic, Rust's own.
const INTERNAL_ERROR: u8 = 101;

#[derive(Parser)]
#[command(
    name = "brdf-explorer",
    version,
    about = "Explore models of surface reflection; without a verb, in a window"
)]
struct Arguments {
    #[command(subcommand)]
    verb: Option<Verb>,
}

#[derive(Subcommand)]
enum Verb {
    /// List the models and their parameters
    Models(models::Arguments),
    /// Evaluate f and pdf for rows of directions
    Eval(eval::Arguments),
    /// Draw directions of incidence
    Sample(sample::Arguments),
    /// Measure the directional-hemispherical reflectance
    Albedo(albedo::Arguments),
    /// Check the laws a model should keep
    Check(check::Arguments),
    /// Measure what accuracy costs, and name the cheapest that is good enough
    Tradeoff(tradeoff::Arguments),
    /// Measure how fast the models are on this machine
    Bench(bench::Arguments),
    /// Render the window into a picture
    #[cfg(feature = "gui")]
    Render(render::Arguments),
    /// Export a view as picture, drawing, numbers or mesh, or the material
    #[cfg(feature = "gui")]
    Export(render::Arguments),
    /// Export a view; not in this build
    #[cfg(not(feature = "gui"))]
    #[command(hide = true)]
    Export(NoWindow),
    /// Render the window into a picture; not in this build
    #[cfg(not(feature = "gui"))]
    #[command(hide = true)]
    Render(NoWindow),
}

/// Whatever stands after a verb that this build lacks.
#[cfg(not(feature = "gui"))]
#[derive(clap::Args)]
struct NoWindow {
    #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
    _words: Vec<std::ffi::OsString>,
}

/// The whole program: reads the arguments of the process, does what they ask, and says how it went.
///
/// Every failure is one line on standard error. A panic, which is a defect, becomes such a line too.
#[must_use]
pub fn main() -> ExitCode {
    panic::set_hook(Box::new(|info| say(&internal_error(info))));
    panic::catch_unwind(run).unwrap_or_else(|_| ExitCode::from(INTERNAL_ERROR))
}

fn run() -> ExitCode {
    let outcome = match Arguments::try_parse() {
        Ok(arguments) => dispatch(arguments.verb),
        Err(error) => return refuse(&error),
    };
    match outcome {
        Ok(code) => code,
        // Whoever reads the results has read enough.
        Err(Error::Io { source, .. }) if source.kind() == io::ErrorKind::BrokenPipe => {
            ExitCode::SUCCESS
        }
        Err(error) => {
            say(&format!("error: {}", on_one_line(&error.to_string())));
            ExitCode::from(BAD_INPUT)
        }
    }
}

fn dispatch(verb: Option<Verb>) -> Result<ExitCode> {
    match verb {
        None => window()?,
        Some(Verb::Models(arguments)) => models::run(&arguments)?,
        Some(Verb::Eval(arguments)) => eval::run(&arguments)?,
        Some(Verb::Sample(arguments)) => sample::run(&arguments)?,
        Some(Verb::Albedo(arguments)) => albedo::run(&arguments)?,
        Some(Verb::Tradeoff(arguments)) => tradeoff::run(&arguments)?,
        Some(Verb::Bench(arguments)) => bench::run(&arguments)?,
        Some(Verb::Check(arguments)) => {
            if !check::run(&arguments)? {
                return Ok(ExitCode::from(CHECK_FAILED));
            }
        }
        #[cfg(feature = "gui")]
        Some(Verb::Render(arguments)) => render::run(&arguments.request()?)?,
        #[cfg(feature = "gui")]
        Some(Verb::Export(arguments)) => export::run(&arguments.request()?)?,
        #[cfg(not(feature = "gui"))]
        Some(Verb::Render(_) | Verb::Export(_)) => window()?,
    }
    Ok(ExitCode::SUCCESS)
}

#[cfg(all(feature = "gui", not(target_arch = "wasm32")))]
fn window() -> Result<()> {
    crate::ui::run()
}

#[cfg(not(all(feature = "gui", not(target_arch = "wasm32"))))]
fn window() -> Result<()> {
    Err(Error::Platform {
        problem: "this build has no window and draws no pictures".to_owned(),
        remedy: "build it with the gui feature, or name another verb (see --help)".to_owned(),
    })
}

/// Shows help and version on standard output, and what clap refuses as one line on standard error.
fn refuse(error: &clap::Error) -> ExitCode {
    if !error.use_stderr() {
        // Only a closed standard output can fail here, and then nobody reads.
        let _ = error.print();
        return ExitCode::SUCCESS;
    }
    let line = match error.source().and_then(|e| e.downcast_ref::<Error>()) {
        Some(ours) => format!("error: {}", on_one_line(&ours.to_string())),
        None => before_usage(&error.to_string()),
    };
    say(&line);
    ExitCode::from(BAD_INPUT)
}

/// What clap says before it explains the usage, as one line.
fn before_usage(message: &str) -> String {
    let mut line = String::new();
    for part in message
        .lines()
        .map(str::trim)
        .take_while(|part| !part.starts_with("Usage:") && !part.starts_with("For more information"))
        .filter(|part| !part.is_empty())
    {
        if !line.is_empty() {
            line.push_str(if line.ends_with(':') { " " } else { "; " });
        }
        line.push_str(part);
    }
    line
}

fn internal_error(info: &panic::PanicHookInfo<'_>) -> String {
    let place = info.location().map(ToString::to_string);
    format!(
        "error: internal error at {}: {}",
        place.as_deref().unwrap_or("an unknown place"),
        on_one_line(info.payload_as_str().unwrap_or("no message"))
    )
}

/// `text` with its line breaks, which stem from the user's own input or a library, replaced by spaces.
fn on_one_line(text: &str) -> String {
    text.split(['\n', '\r'])
        .map(str::trim)
        .filter(|part| !part.is_empty())
        .collect::<Vec<_>>()
        .join(" ")
}

/// Writes `line` to standard error. Where that is closed, there is nobody to tell.
fn say(line: &str) {
    let _ = writeln!(io::stderr(), "{line}");
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_arguments_are_consistent() {
        <Arguments as clap::CommandFactory>::command().debug_assert();
    }

    #[test]
    fn what_clap_refuses_is_one_line() {
        for (words, expected) in [
            (
                vec!["modles"],
                "error: unrecognized subcommand 'modles'; tip: a similar subcommand exists: 'models'",
            ),
            (
                vec!["eval"],
                "error: the following required arguments were not provided: <MATERIAL>",
            ),
            (
                vec!["models", "--jsn"],
                "error: unexpected argument '--jsn' found; tip: a similar argument exists: '--json'",
            ),
        ] {
            let words = std::iter::once("brdf-explorer").chain(words);
            let error = Arguments::try_parse_from(words).err().unwrap();
            assert_eq!(before_usage(&error.to_string()), expected);
        }
    }

    #[test]
    fn messages_lose_their_line_breaks() {
        assert_eq!(on_one_line("a\r\n b\n"), "a b");
    }
}
