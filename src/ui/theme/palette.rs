//! The colours of the two themes.

use egui::{Color32, Theme};

use super::Rgba;
use bxdf::Category;
use bxdf_lab::analysis::{Channel, Hold};
use bxdf_study::colors::{self, material_colors};
use bxdf_study::session::PaletteIndex;

/// The colours of one theme.
#[derive(Clone, Copy, Debug)]
pub struct Palette {
    /// Behind the views.
    pub background: Color32,
    /// Behind the bars and panels around them.
    pub panel: Color32,
    /// Behind what is selected: the one accent.
    pub accent: Color32,
    /// The outline of what is selected or has the focus.
    pub accent_line: Color32,
    /// Text and the normal.
    pub ink: Color32,
    /// Labels of secondary rank.
    pub faint_ink: Color32,
    /// Rings, rays and the degree grid.
    pub grid: Color32,
    /// The horizon and the axes.
    pub axis: Color32,
    /// The materials, in the order in which their places are taken.
    materials: [Color32; 8],
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
    /// The categories of lobes, in the order in which they are listed: tints of slate, which no material has; icons, names and
    /// dashes tell them apart.
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

/// The contrast of text with what is behind it that WCAG 2.1 asks for (success criterion 1.4.3).
const TEXT_CONTRAST: f32 = 4.5;

/// The contrast of two colours that let nothing through, as WCAG 2.1 defines it: 1 to 21.
fn contrast(one: Color32, other: Color32) -> f32 {
    let luminance = |color: Color32| {
        let linear = egui::Rgba::from(color);
        0.2126 * linear.r() + 0.7152 * linear.g() + 0.0722 * linear.b()
    };
    let [one, other] = [one, other].map(luminance);
    (one.max(other) + 0.05) / (one.min(other) + 0.05)
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

    /// The same for a figure, which is read from afar or in print: secondary text, whose strokes are fine, is stronger.
    #[must_use]
    pub fn of_figure(&self) -> Self {
        Self {
            faint_ink: self.faint_ink.lerp_to_gamma(self.ink, 0.5),
            ..*self
        }
    }

    fn dark() -> Self {
        Self {
            background: rgb([20, 22, 27]),
            panel: rgb([27, 30, 36]),
            accent: rgb([38, 72, 118]),
            accent_line: rgb([160, 200, 255]),
            ink: grey(225),
            faint_ink: grey(160),
            grid: rgb([58, 62, 70]),
            axis: grey(140),
            materials: material_colors(colors::Theme::Dark).map(rgb),
            light: rgb([242, 165, 65]),
            viewer: rgb([111, 207, 151]),
            mirror: rgb([190, 168, 195]),
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
                rgb([104, 122, 148]),
                rgb([138, 156, 180]),
                rgb([172, 188, 210]),
                rgb([208, 220, 236]),
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
            background: rgb([250, 250, 247]),
            panel: rgb([248, 248, 245]),
            accent: rgb([190, 214, 246]),
            accent_line: rgb([28, 84, 150]),
            ink: grey(30),
            faint_ink: grey(95),
            grid: grey(214),
            axis: grey(120),
            materials: material_colors(colors::Theme::Light).map(rgb),
            light: rgb([143, 86, 0]),
            viewer: rgb([14, 122, 69]),
            mirror: rgb([101, 56, 188]),
            geometry: rgb([132, 96, 0]),
            contour: translucent([255, 255, 255], 150),
            contour_on_white: translucent([0, 0, 0], 130),
            backdrop: rgb([243, 244, 244]),
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
                rgb([128, 144, 168]),
                rgb([98, 116, 142]),
                rgb([70, 88, 114]),
                rgb([42, 58, 84]),
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

    /// `color` as text has it on the background: with as much ink in it as it takes to be read.
    #[must_use]
    pub fn text_in(&self, color: Color32) -> Color32 {
        /// Shades between a colour and the ink: neighbours look alike.
        const SHADES: u8 = 16;
        let shade = |step| color.lerp_to_gamma(self.ink, f32::from(step) / f32::from(SHADES));
        let is_read = |color: &Color32| contrast(*color, self.background) >= TEXT_CONTRAST;
        (0..SHADES).map(shade).find(is_read).unwrap_or(self.ink)
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

#[cfg(test)]
mod tests;
