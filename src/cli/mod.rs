//! The command line: one file per verb. Results go to standard output, messages to standard error.
//!
//! Exit codes: 0 done, 1 a check failed, 2 bad input; 101, as Rust has it, where the program itself is at
//! fault.

mod albedo;
mod args;
mod bench;
mod check;
mod eval;
mod export;
pub mod input;
mod lessons;
mod models;
mod output;
mod render;
#[cfg(all(feature = "gui", unix, not(target_vendor = "apple")))]
mod restart;
mod sample;
mod say;
#[cfg(unix)]
mod signals;
mod tradeoff;

use std::any::TypeId;
use std::error::Error as _;
use std::ffi::OsString;
use std::io;
use std::panic;
use std::path::PathBuf;
use std::process::ExitCode;

use clap::error::ErrorKind;
use clap::{CommandFactory as _, FromArgMatches as _, Parser, Subcommand};

use bxdf::error::{Error, Result, line, shown};
use bxdf_study::parallel;

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
    /// List the lessons, and check that they hold what they say
    Lessons(lessons::Arguments),
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
    #[cfg_attr(not(feature = "gui"), command(hide = true))]
    Render(render::OfWindow),
    /// Export a view as picture, drawing, numbers or mesh, or the material
    Export(render::Arguments),
}

/// The whole program: reads the arguments of the process, does what they ask, and says how it went.
///
/// Every failure is one line on standard error. A panic, which is a defect, becomes such a line too.
#[must_use]
pub fn main() -> ExitCode {
    panic::set_hook(Box::new(|info| say::say(&internal_error(info))));
    panic::catch_unwind(run).unwrap_or_else(|_| ExitCode::from(INTERNAL_ERROR))
}

fn run() -> ExitCode {
    #[cfg(all(feature = "gui", unix, not(target_vendor = "apple")))]
    restart::in_quiet_environment();
    let words: Vec<OsString> = std::env::args_os().collect();
    let outcome = match parse(&words) {
        Ok(arguments) => dispatch(arguments.verb),
        Err(error) => return refuse(&error, &words),
    };
    match outcome {
        Ok(code) => code,
        // Whoever reads the results has read enough.
        Err(Error::Io { source, .. }) if source.kind() == io::ErrorKind::BrokenPipe => {
            ExitCode::SUCCESS
        }
        Err(error) => {
            say::say(&format!("error: {error}"));
            ExitCode::from(BAD_INPUT)
        }
    }
}

fn dispatch(verb: Option<Verb>) -> Result<ExitCode> {
    let threads = match &verb {
        Some(Verb::Bench(arguments)) => arguments.threads(),
        _ => None,
    };
    parallel::take_part(threads)?;
    match verb {
        None => window()?,
        Some(Verb::Models(arguments)) => models::run(&arguments)?,
        Some(Verb::Lessons(arguments)) => {
            if !lessons::run(&arguments)? {
                return Ok(ExitCode::from(CHECK_FAILED));
            }
        }
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
        Some(Verb::Render(arguments)) => render::run(&arguments)?,
        Some(Verb::Export(arguments)) => export::run(&arguments.request()?)?,
    }
    Ok(ExitCode::SUCCESS)
}

#[cfg(all(feature = "gui", not(target_arch = "wasm32")))]
fn window() -> Result<()> {
    bxdf_ui::run()
}

#[cfg(not(all(feature = "gui", not(target_arch = "wasm32"))))]
fn window() -> Result<()> {
    Err(say::no_window())
}

/// The arguments that `words`, the first of which is the program's name, stand for.
fn parse(words: &[OsString]) -> std::result::Result<Arguments, clap::Error> {
    let mut command = Arguments::command().mut_subcommands(with_hyphens);
    command
        .try_get_matches_from_mut(words)
        .and_then(|matches| Arguments::from_arg_matches(&matches))
        .map_err(|error| error.format(&mut command))
}

/// The command, the values of whose options may begin with a hyphen, as negative numbers do: whoever reads the value says what
/// is wrong with it. A path may be a negative number only: `--out --json` lacks one.
fn with_hyphens(command: clap::Command) -> clap::Command {
    command.mut_args(|argument| {
        if argument.is_positional() || !argument.get_action().takes_values() {
            return argument;
        }
        let is_path = argument.get_value_parser().type_id() == TypeId::of::<PathBuf>();
        argument
            .allow_hyphen_values(!is_path)
            .allow_negative_numbers(is_path)
    })
}

/// The line about a word that is no UTF-8 where only text is taken. Which of them it is clap does not say: the one that it
/// refuses when all others are text.
fn no_text(words: &[OsString]) -> String {
    let as_text = |word: &OsString| OsString::from(word.to_string_lossy().into_owned());
    let is_refused = |index: usize| {
        let others = words.iter().enumerate();
        let words: Vec<OsString> = others
            .map(|(other, word)| {
                if other == index {
                    word.clone()
                } else {
                    as_text(word)
                }
            })
            .collect();
        parse(&words).is_err_and(|error| error.kind() == ErrorKind::InvalidUtf8)
    };
    let mut found = (1..words.len()).filter(|index| is_refused(*index));
    let word = found.next().and_then(|index| words.get(index));
    let name = word.map_or_else(String::new, |word| word.to_string_lossy().into_owned());
    format!("error: argument '{}': expected text in UTF-8", shown(&name))
}

/// Shows help and version on standard output, and what clap refuses of `words` as one line on standard error.
fn refuse(error: &clap::Error, words: &[OsString]) -> ExitCode {
    if !error.use_stderr() {
        // Only a closed standard output can fail here, and then nobody reads.
        let _ = error.print();
        return ExitCode::SUCCESS;
    }
    say::say(
        &match error.source().and_then(|e| e.downcast_ref::<Error>()) {
            Some(ours) => format!("error: {ours}"),
            None if error.kind() == ErrorKind::InvalidUtf8 => no_text(words),
            None => line(&before_usage(&error.to_string())),
        },
    );
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
        info.payload_as_str().unwrap_or("no message")
    )
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
            let words: Vec<OsString> = words.map(Into::into).collect();
            let error = parse(&words).err().unwrap();
            assert_eq!(before_usage(&error.to_string()), expected);
        }
    }

    #[test]
    fn no_negative_number_is_taken_for_a_flag() {
        let command = Arguments::command();
        let mut count = 0;
        for verb in command.get_subcommands() {
            for option in verb
                .get_opts()
                .filter(|option| option.get_action().takes_values())
            {
                let name = option.get_long().map_or_else(
                    || format!("-{}", option.get_short().unwrap()),
                    |long| format!("--{long}"),
                );
                for number in ["-1", "-0.5", "-1e-3", "-.5", "-inf", "-5,3"] {
                    let is_path = option.get_value_parser().type_id() == TypeId::of::<PathBuf>();
                    if is_path && number.parse::<i32>().is_err() {
                        continue;
                    }
                    let words = ["brdf-explorer", verb.get_name(), &name, number];
                    let words = words.map(OsString::from);
                    if let Err(error) = parse(&words) {
                        let line = before_usage(&error.to_string());
                        assert!(
                            error.kind() != ErrorKind::UnknownArgument,
                            "{words:?}: {line}"
                        );
                        assert!(!line.contains("tip: "), "{words:?}: {line}");
                    }
                    count += 1;
                }
            }
        }
        assert!(count > 50, "{count}");
    }
}
