//! Texts of materials: `id:name=value,...`, and files.

#![no_main]

use brdf_explorer::bxdf::Material;
use brdf_explorer::bxdf::material::file;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| {
    let Ok(text) = std::str::from_utf8(data) else {
        return;
    };
    if let Ok(material) = text.parse::<Material>() {
        // What was read is written as a text that is read as the same.
        let written = material.to_string();
        assert_eq!(written.parse::<Material>().ok(), Some(material), "{written}");
    }
    if let Ok(material) = file::parse(text, "fuzz") {
        let written = file::print(&material);
        assert_eq!(file::parse(&written, "fuzz").ok(), Some(material), "{written}");
    }
});
