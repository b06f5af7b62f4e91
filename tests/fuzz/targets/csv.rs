//! Rows of directions, as `eval` reads them.

#![no_main]

use std::io::Cursor;

use brdf_explorer::cli::input::Rows;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| {
    let source = Box::new(Cursor::new(data.to_vec()));
    let Ok(mut rows) = Rows::read(source, "fuzz".into()) else {
        return;
    };
    while let Ok(Some(row)) = rows.next_row() {
        for w in [row.wo, row.wi] {
            assert!((w.length_squared() - 1.0).abs() < 1e-5, "{w}");
        }
    }
});
