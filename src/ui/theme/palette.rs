//! The colours of the two themes.

use egui::{Color32, Theme};

use super::Rgba;
use bxdf::Category;
use bxdf_lab::analysis::{Channel, Hold};
use bxdf_study::colors::{self, material_colors, okabe_ito};
use bxdf_study::session::PaletteIndex;

/// The colours of one theme.
#[derive(Clone, Copy, Debug)]
pub struct Palette {
    /// Behind the views.
    pub background: Color32,
    /// Text and the normal.
    pub ink: Color32,
    /// Labels of secondary rank.
    pub faint_ink: Color32,
    /// Rings, rays and the degree grid.
    pub grid: Color32,
    /// The horizon and the axes.
    pub axis: Color32,
    /// The materials, in the order in which their places are taken.
    materials: [Color32; 7],
    /// The held direction where the light is held.
    pub light: Color32,
    /// The held direction where the viewer is held.
    pub viewer: Color32,
    /// The mirror direction.
    pub mirror: Color32,
    /// Theta, phi and the projection.
    pub geometry: Color32,
    /// Lines of equal value over the colour map of values.
    pub contour: Color32,
    /// The same over that of differences, whose middle is white.
    pub contour_on_white: Color32,
    /// The middle of what is behind a 3D view, whose edges are [`Self::background`].
    pub backdrop: Color32,
    /// The translucent dome.
    pub dome: Rgba,
    /// Its lines of equal polar angle.
    pub dome_line: Rgba,
    /// The surface itself, seen as a disc that lets light through.
    pub ground: Rgba,
    /// The surface itself, as a solid disc.
    pub table: Rgba,
    /// The brush lines on it.
    pub brush: Rgba,
    /// The plane of a section in 3D, in its middle and at the dome.
    pub fan: [Rgba; 2],
    /// The curve that it cuts out of a lobe, and the halo about it.
    pub cut: [Rgba; 2],
    /// Lines of equal value on a lobe.
    pub isoline: Rgba,
    /// Absorbed light in the bar of shares.
    pub absorbed: Color32,
    /// The categories in the bar of shares, in the order in which they are listed.
    categories: [Color32; 4],
    /// What is as it should be.
    pub kept: Color32,
    /// What is wrong.
    pub warning: Color32,
    red: Color32,
    green: Color32,
    blue: Color32,
}

pub(super) const fn rgb([r, g, b]: [u8; 3]) -> Color32 {
    #[expect(
        clippy::disallowed_methods,
        reason = "this is the file where colours live"
    )]
    Color32::from_rgb(r, g, b)
}

/// A colour that lets through what is below it.
pub(super) fn translucent([r, g, b]: [u8; 3], alpha: u8) -> Color32 {
    #[expect(
        clippy::disallowed_methods,
        reason = "this is the file where colours live"
    )]
    Color32::from_rgba_unmultiplied(r, g, b, alpha)
}

const fn grey(level: u8) -> Color32 {
    rgb([level; 3])
}

impl Palette {
    /// The colours for a theme.
    #[must_use]
    pub fn of(theme: Theme) -> Self {
        match theme {
            Theme::Dark => Self::dark(),
            Theme::Light => Self::light(),
        }
    }

    fn dark() -> Self {
        Self {
            background: rgb([22, 24, 28]),
            ink: grey(225),
            faint_ink: grey(160),
            grid: rgb([58, 62, 70]),
            axis: grey(140),
            materials: material_colors(colors::Theme::Dark).map(rgb),
            light: rgb(okabe_ito::ORANGE),
            viewer: rgb([120, 210, 150]),
            mirror: rgb([170, 150, 235]),
            geometry: rgb([240, 228, 66]),
            contour: translucent([255, 255, 255], 130),
            contour_on_white: translucent([0, 0, 0], 130),
            backdrop: rgb([38, 42, 50]),
            dome: [200, 210, 230, 5],
            dome_line: [190, 196, 206, 84],
            ground: [150, 160, 180, 40],
            table: [66, 71, 80, 255],
            brush: [210, 216, 226, 26],
            fan: [[220, 226, 236, 6], [220, 226, 236, 24]],
            cut: [[255, 255, 255, 255], [14, 16, 20, 150]],
            isoline: [0, 0, 0, 90],
            absorbed: grey(70),
            categories: [
                rgb(okabe_ito::SKY_BLUE),
                rgb(okabe_ito::GREEN),
                rgb(okabe_ito::VERMILION),
                rgb(okabe_ito::PURPLE),
            ],
            kept: rgb([60, 190, 140]),
            warning: rgb([255, 140, 70]),
            red: rgb([240, 110, 90]),
            green: rgb([60, 190, 140]),
            blue: rgb([90, 160, 240]),
        }
    }

    fn light() -> Self {
        Self {
            background: grey(252),
            ink: grey(30),
            faint_ink: grey(95),
            grid: grey(214),
            axis: grey(120),
            materials: material_colors(colors::Theme::Light).map(rgb),
            light: rgb([196, 120, 0]),
            viewer: rgb([0, 128, 80]),
            mirror: rgb([105, 75, 185]),
            geometry: rgb([150, 110, 0]),
            contour: translucent([255, 255, 255], 150),
            contour_on_white: translucent([0, 0, 0], 130),
            backdrop: rgb([241, 243, 247]),
            dome: [90, 110, 150, 7],
            dome_line: [70, 80, 100, 96],
            ground: [110, 120, 140, 44],
            table: [222, 224, 228, 255],
            brush: [60, 70, 90, 26],
            fan: [[60, 80, 120, 6], [60, 80, 120, 26]],
            cut: [[255, 255, 255, 255], [20, 24, 32, 170]],
            isoline: [0, 0, 0, 90],
            absorbed: grey(190),
            categories: [
                rgb(okabe_ito::BLUE),
                rgb(okabe_ito::GREEN),
                rgb(okabe_ito::VERMILION),
                rgb(okabe_ito::PURPLE),
            ],
            kept: rgb([0, 120, 85]),
            warning: rgb([176, 60, 0]),
            red: rgb([190, 50, 40]),
            green: rgb([0, 120, 85]),
            blue: rgb([20, 90, 190]),
        }
    }

    /// The surface itself, as egui takes it.
    #[must_use]
    pub fn ground_color(&self) -> Color32 {
        let [r, g, b, alpha] = self.ground;
        translucent([r, g, b], alpha)
    }

    /// The colour of the held direction.
    #[must_use]
    pub fn held(&self, hold: Hold) -> Color32 {
        match hold {
            Hold::Light => self.light,
            Hold::Viewer => self.viewer,
        }
    }

    /// The colour of a category's share.
    #[must_use]
    pub fn category(&self, category: Category) -> Color32 {
        let [diffuse, glossy, perfect, retro] = self.categories;
        match category {
            Category::Diffuse => diffuse,
            Category::GlossySpecular => glossy,
            Category::PerfectSpecular => perfect,
            Category::RetroReflective => retro,
        }
    }

    /// The colour of a material.
    #[must_use]
    pub fn material(&self, slot: PaletteIndex) -> Color32 {
        self.kind(usize::from(slot.0))
    }

    /// The colour of things of a kind that are no materials, where there are several kinds.
    #[must_use]
    pub fn kind(&self, index: usize) -> Color32 {
        let [first, ..] = self.materials;
        self.materials
            .iter()
            .copied()
            .cycle()
            .nth(index)
            .unwrap_or(first)
    }

    /// The colour of a channel's curve; the luminance has that of its material.
    #[must_use]
    pub fn channel(&self, channel: Channel, slot: PaletteIndex) -> Color32 {
        match channel {
            Channel::Luminance => self.material(slot),
            Channel::Red => self.red,
            Channel::Green => self.green,
            Channel::Blue => self.blue,
        }
    }
}
