//! Every colour and size of the window.

use egui::{Color32, FontFamily, FontId, TextStyle, Theme, Vec2};

use super::scene3d::Rgba;
use super::session::Slot;
use crate::analysis::{Channel, Hold};
use crate::bxdf::Category;

/// The size of the window at first, in points.
pub const WINDOW_SIZE: Vec2 = Vec2::new(1280.0, 800.0);
/// The smallest size of the window, in points.
pub const MIN_WINDOW_SIZE: Vec2 = Vec2::new(920.0, 600.0);
/// Below this size, in points, the panels leave no room for the views.
pub const USABLE_SIZE: Vec2 = Vec2::new(400.0, 240.0);
/// The width of the panel with models and parameters.
pub const SIDE_WIDTH: f32 = 292.0;
/// The room that a scroll bar takes when the pointer is near, in points.
pub const SCROLL_ROOM: f32 = 12.0;
/// Room between the edge of a tile and its view.
pub const TILE_MARGIN: f32 = 4.0;
/// Height of the bar with the names of the views in a tile.
pub const TAB_BAR_HEIGHT: f32 = 24.0;
/// The width of a drop-down, in points.
pub const COMBO_WIDTH: f32 = 118.0;
/// The width of a drop-down of short words in a bar, in points.
pub const SHORT_COMBO_WIDTH: f32 = 88.0;
/// The width of the number beside a slider, in points.
pub const NUMBER_WIDTH: f32 = 52.0;
/// The width of the reset button at the end of a row, in points.
pub const RESET_WIDTH: f32 = 18.0;
/// The least width of a slider, in points.
pub const SHORTEST_SLIDER: f32 = 40.0;
/// The side of a material's picture in the list, in points.
pub const THUMBNAIL_SIZE: f32 = 36.0;
/// The size of the bar of shares, in points.
pub const SHARE_BAR: Vec2 = Vec2::new(120.0, 12.0);
/// The size of a sample of a colour in a legend, in points.
pub const SWATCH: Vec2 = Vec2::new(18.0, 12.0);
/// The largest size of the help, in points.
pub const HELP_SIZE: Vec2 = Vec2::new(560.0, 560.0);
/// The room around the help, in points.
pub const HELP_MARGIN: f32 = 80.0;
/// The width of the column of keys in the help, in points.
pub const HELP_KEYS_WIDTH: f32 = 200.0;
/// The width of the search of the commands and the height of its list, in points.
pub const SEARCH_SIZE: Vec2 = Vec2::new(440.0, 320.0);
/// The height of a row of a legend, in points.
pub const LEGEND_ROW: f32 = 17.0;
/// The size of the grip by which a row is dragged, in points.
pub const GRIP: Vec2 = Vec2::new(12.0, 16.0);
/// The room between badges, and between the edge and the text of one.
pub const BADGE_SPACING: (Vec2, Vec2) = (Vec2::new(3.0, 2.0), Vec2::new(2.0, 0.0));
/// The room between name, badge and menu in a row of the list of materials, in points.
pub const ROW_SPACING: f32 = 1.0;
/// The height of a badge, in points.
pub const BADGE_HEIGHT: f32 = 15.0;
/// The strength of the colour of a material that is not shown.
pub const HIDDEN_STRENGTH: f32 = 0.35;
/// The most characters of a name.
pub const LONGEST_NAME: usize = 60;
/// The length of a sample of a line, in points.
pub const LINE_SAMPLE: f32 = 24.0;
/// Lengths of a dash and of the gap after it, in points.
pub const DASH: [f32; 2] = [7.0, 4.5];
/// The distance between the dots of a dotted line and their radius, in points.
pub const DOTS: [f32; 2] = [5.0, 1.4];
/// The distance between the lines of a hatch, in points.
pub const HATCH_STEP: f32 = 5.0;
/// The width of the lines of a hatch, in points.
pub const HATCH_WIDTH: f32 = 1.5;
/// Width of the curve of a lobe.
pub const CURVE_WIDTH: f32 = 2.0;
/// Radius of a handle that can be dragged.
pub const HANDLE_RADIUS: f32 = 7.0;
/// Alpha of a lobe one sees through, 0..255.
pub const SEE_THROUGH_ALPHA: u8 = 120;
/// Alpha of the area under a curve, 0..255.
const FILL_ALPHA: u8 = 30;

/// The colour-blind-safe colours of Okabe & Ito 2008 ("Color Universal Design").
mod okabe_ito {
    pub const ORANGE: [u8; 3] = [230, 159, 0];
    pub const YELLOW: [u8; 3] = [240, 228, 66];
    pub const SKY_BLUE: [u8; 3] = [86, 180, 233];
    pub const GREEN: [u8; 3] = [0, 158, 115];
    pub const BLUE: [u8; 3] = [0, 114, 178];
    pub const VERMILION: [u8; 3] = [213, 94, 0];
    pub const PURPLE: [u8; 3] = [204, 121, 167];
}

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
    /// The translucent dome.
    pub dome: Rgba,
    /// The surface itself, seen as a disc.
    pub ground: Rgba,
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

const fn rgb([r, g, b]: [u8; 3]) -> Color32 {
    #[expect(
        clippy::disallowed_methods,
        reason = "this is the file where colours live"
    )]
    Color32::from_rgb(r, g, b)
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
            materials: [
                rgb(okabe_ito::SKY_BLUE),
                rgb([240, 120, 40]),
                rgb([20, 185, 140]),
                rgb([226, 150, 192]),
                rgb(okabe_ito::YELLOW),
                rgb([60, 140, 220]),
                grey(187),
            ],
            light: rgb(okabe_ito::ORANGE),
            viewer: rgb([120, 210, 150]),
            mirror: rgb([170, 150, 235]),
            geometry: rgb([240, 228, 66]),
            dome: [200, 210, 230, 14],
            ground: [150, 160, 180, 40],
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
            materials: [
                rgb(okabe_ito::BLUE),
                rgb(okabe_ito::VERMILION),
                rgb([0, 136, 100]),
                rgb([180, 85, 140]),
                rgb([140, 118, 0]),
                rgb([40, 140, 200]),
                grey(112),
            ],
            light: rgb([196, 120, 0]),
            viewer: rgb([0, 128, 80]),
            mirror: rgb([105, 75, 185]),
            geometry: rgb([150, 110, 0]),
            dome: [90, 110, 150, 20],
            ground: [110, 120, 140, 44],
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
    pub fn material(&self, slot: Slot) -> Color32 {
        let [first, ..] = self.materials;
        let mut colors = self.materials.iter().copied().cycle();
        colors.nth(usize::from(slot.0)).unwrap_or(first)
    }

    /// The colour of a channel's curve; the luminance has that of its material.
    #[must_use]
    pub fn channel(&self, channel: Channel, slot: Slot) -> Color32 {
        match channel {
            Channel::Luminance => self.material(slot),
            Channel::Red => self.red,
            Channel::Green => self.green,
            Channel::Blue => self.blue,
        }
    }
}

/// How a line is drawn: colour never carries meaning alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Dash {
    /// Unbroken.
    Solid,
    /// Of dashes.
    Dashed,
    /// Of dots.
    Dotted,
}

impl Dash {
    /// The line of a material. Neighbours in the palette differ in it, and with seven colours no two of the first
    /// twenty-one materials have both in common.
    #[must_use]
    pub fn of(slot: Slot) -> Self {
        match slot.0 % 3 {
            0 => Self::Solid,
            1 => Self::Dashed,
            _ => Self::Dotted,
        }
    }
}

/// `color` as the area under a curve.
#[must_use]
pub fn fill_of(color: Color32) -> Color32 {
    let [r, g, b, _] = color.to_array();
    #[expect(
        clippy::disallowed_methods,
        reason = "this is the file where colours live"
    )]
    Color32::from_rgba_unmultiplied(r, g, b, FILL_ALPHA)
}

/// `color` on a surface that is turned from the light so far that this share of it arrives, 0..1.
#[must_use]
pub fn shaded(color: Rgba, light: f32) -> Rgba {
    const LEAST: f32 = 0.45;
    let [r, g, b, alpha] = color;
    let shade = |channel: u8| (f32::from(channel) * (LEAST + (1.0 - LEAST) * light)) as u8;
    [shade(r), shade(g), shade(b), alpha]
}

/// `color` as the 3D view takes it, with this alpha.
#[must_use]
pub fn rgba(color: Color32, alpha: u8) -> Rgba {
    let [r, g, b, _] = color.to_array();
    [r, g, b, alpha]
}

/// The perceptual colour map of values: viridis. `t`: 0..1, clamped.
#[must_use]
pub fn viridis(t: f64) -> Rgba {
    let color = colorous::VIRIDIS.eval_continuous(t.clamp(0.0, 1.0));
    [color.r, color.g, color.b, 255]
}

/// [`viridis`] as egui takes it.
#[must_use]
pub fn viridis_color(t: f64) -> Color32 {
    let [r, g, b, _] = viridis(t);
    rgb([r, g, b])
}

/// Linear channels 0..1 as the colour the screen shows.
#[must_use]
pub fn color_of_linear([r, g, b]: [f64; 3]) -> Color32 {
    egui::Rgba::from_rgb(r as f32, g as f32, b as f32).into()
}

/// The radiance of a small picture as the screen shows it, where it covers this share of a pixel (0..1). Highlights are
/// compressed in luminance, so that their colour stays.
#[must_use]
pub fn color_of_radiance(rgb: [f64; 3], coverage: f64) -> Color32 {
    // Reinhard's operator with the radiance that becomes white.
    const EXPOSURE: f64 = 1.1;
    const WHITE: f64 = 3.0;
    let luminance = EXPOSURE * Channel::Luminance.of(rgb);
    let gain = EXPOSURE * (1.0 + luminance / (WHITE * WHITE)) / (1.0 + luminance);
    let [r, g, b] = rgb.map(|channel| (gain * channel).min(1.0) as f32);
    egui::Rgba::from_rgba_unmultiplied(r, g, b, coverage as f32).into()
}

/// Sets text sizes and spacing for both themes.
pub fn apply(ctx: &egui::Context) {
    ctx.all_styles_mut(|style| {
        let font = |size: f32| FontId::new(size, FontFamily::Proportional);
        style.text_styles.insert(TextStyle::Heading, font(17.0));
        style.text_styles.insert(TextStyle::Body, font(13.5));
        style.text_styles.insert(TextStyle::Button, font(13.5));
        style.text_styles.insert(TextStyle::Small, font(11.5));
        style.spacing.item_spacing = Vec2::new(7.0, 5.0);
        style.spacing.slider_width = 118.0;
        style.spacing.interact_size.y = 20.0;
    });
    for theme in [Theme::Dark, Theme::Light] {
        let palette = Palette::of(theme);
        ctx.style_mut_of(theme, |style| {
            style.visuals.override_text_color = Some(palette.ink);
            style.visuals.weak_text_color = Some(palette.faint_ink);
            style.visuals.extreme_bg_color = palette.background;
            style.visuals.error_fg_color = palette.warning;
            style.visuals.slider_trailing_fill = true;
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn twenty_one_materials_are_told_apart() {
        for palette in [Theme::Dark, Theme::Light].map(Palette::of) {
            let look = |slot: u8| (palette.material(Slot(slot)), Dash::of(Slot(slot)));
            for a in 0..21 {
                assert!((0..a).all(|b| look(a) != look(b)), "{a}");
                assert_ne!(Dash::of(Slot(a)), Dash::of(Slot(a + 1)));
            }
        }
    }
}
