//! The kinds of files, and what they are called.

/// A kind of file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// A picture of the view.
    Png,
    /// A drawing of the view.
    Svg,
    /// The numbers behind the view.
    Csv,
    /// The lobes as a mesh, for modelling programs.
    Obj,
    /// The lobes as a mesh, for the web.
    Gltf,
    /// The selected material.
    Toml,
}

/// What there is to say of a kind of file.
pub struct FormatSpec {
    /// The kind.
    pub format: Format,
    /// What its names end in.
    pub extension: &'static str,
    /// The name at the screen.
    pub title: &'static str,
    /// What it holds.
    pub meaning: &'static str,
}

/// Every kind of file, in the order of the menu.
pub static FORMATS: [FormatSpec; 6] = [
    FormatSpec {
        format: Format::Png,
        extension: "png",
        title: "Picture (PNG)",
        meaning: "This view as a picture, in the size chosen for figures",
    },
    FormatSpec {
        format: Format::Svg,
        extension: "svg",
        title: "Drawing (SVG)",
        meaning: "This view as a drawing for print: lines stay lines, text stays text; a surface in it is a picture",
    },
    FormatSpec {
        format: Format::Csv,
        extension: "csv",
        title: "Numbers (CSV)",
        meaning: "The numbers behind this view, with all their digits and the units in the header",
    },
    FormatSpec {
        format: Format::Obj,
        extension: "obj",
        title: "Lobe mesh (OBJ)",
        meaning: "The lobes of the 3D view as a mesh for modelling programs",
    },
    FormatSpec {
        format: Format::Gltf,
        extension: "gltf",
        title: "Lobe mesh (glTF)",
        meaning: "The lobes of the 3D view as a mesh with their colours",
    },
    FormatSpec {
        format: Format::Toml,
        extension: "toml",
        title: "Material (TOML)",
        meaning: "The selected material as a file that can be opened here",
    },
];

impl Format {
    /// Whether it shows the view as it is seen, so that it is a figure.
    #[must_use]
    pub const fn is_picture(self) -> bool {
        matches!(self, Self::Png | Self::Svg)
    }
}

/// The kind of file that ends in `extension`, whatever its case.
#[must_use]
pub fn format_of(extension: &str) -> Option<Format> {
    let mut all = FORMATS.iter();
    let found = all.find(|spec| spec.extension.eq_ignore_ascii_case(extension));
    found.map(|spec| spec.format)
}
