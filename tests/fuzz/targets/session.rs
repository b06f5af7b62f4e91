//! Sessions and whatever else is opened, pasted or dropped.

#![no_main]

use brdf_explorer::study::session::{Opened, read};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| {
    let Ok(text) = std::str::from_utf8(data) else {
        return;
    };
    if let Ok(Opened::Session(first)) = read(text, "fuzz.toml") {
        let written = first.session.to_toml().expect("a session that was read can be written");
        let again = read(&written, "fuzz.toml").expect("and read again");
        assert_eq!(again, Opened::from(first.session), "{written}");
    }
});
