//! Arguments to command line or window; no logic.

use std::process::ExitCode;

fn main() -> ExitCode {
    brdf_explorer::cli::main()
}
