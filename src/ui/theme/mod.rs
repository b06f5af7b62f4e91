//! Every colour and size of the window.

use egui::{FontDefinitions, FontFamily, FontId, TextStyle, Theme, Vec2};

use super::scene3d::Rgba;
use bxdf_lab::analysis::Channel;
use bxdf_study::colors;
use bxdf_study::session::PaletteIndex;
pub use maps::*;
pub use math_fonts::family_of;
pub use palette::Palette;
pub use small::*;

mod maps;
mod math_fonts;
mod palette;
mod small;

/// The theme, as the document names it.
#[must_use]
pub const fn chosen(theme: Theme) -> colors::Theme {
    match theme {
        Theme::Dark => colors::Theme::Dark,
        Theme::Light => colors::Theme::Light,
    }
}

/// The theme, as it is drawn.
#[must_use]
pub const fn as_drawn(theme: colors::Theme) -> Theme {
    match theme {
        colors::Theme::Dark => Theme::Dark,
        colors::Theme::Light => Theme::Light,
    }
}

/// The size of the window at first, in points.
pub const WINDOW_SIZE: Vec2 = Vec2::new(1280.0, 800.0);
/// The smallest size of the window, in points.
pub const MIN_WINDOW_SIZE: Vec2 = Vec2::new(360.0, 360.0);
/// Below this size, in points, the bars leave no room for a view.
pub const USABLE_SIZE: Vec2 = Vec2::new(320.0, 240.0);
/// The width of the panel with materials and parameters, in points.
pub const SIDE_WIDTH: f32 = 264.0;
/// Its width while it is folded to icons, in points.
pub const FOLDED_WIDTH: f32 = 48.0;
/// In a window narrower than this, in points, it is folded unless it is wanted: two views of a usable size would not stand
/// beside it.
pub const FOLD_BELOW: f32 = 1100.0;
/// The width of the panel of lessons, in points.
pub const LESSON_WIDTH: f32 = 360.0;
/// The size of its letters, in points.
pub const LESSON_TEXT: f32 = 14.0;
/// Its width while it is presented, in points.
pub const LARGE_LESSON_WIDTH: f32 = 380.0;
/// The size of its letters then, in points.
pub const LARGE_LESSON_TEXT: f32 = 15.0;
/// It takes no more than this part of the width that there is.
pub const LESSON_SHARE: f32 = 0.45;
/// The height of the bar at the bottom, in points.
pub const BAR_HEIGHT: f32 = 36.0;
/// The widths of a slider in that bar, from the least to the most, in points.
pub const BAR_RAIL: [f32; 2] = [40.0, 96.0];
/// The least width of the value under the pointer in that bar, in points, of one material and of one of several, whose name
/// stands before it.
pub const BAR_VALUE: [f32; 2] = [190.0, 280.0];
/// The height of a row of the list of materials, in points.
pub const ROW_HEIGHT: f32 = 32.0;
/// The diameter of the picture of a material in its row, in points.
pub const ROW_PICTURE: f32 = 26.0;
/// The size of what can be chosen in the grid of pictures, with its name below, in points.
pub const CELL: Vec2 = Vec2::new(106.0, 102.0);
/// Between two of them, in points.
pub const CELL_GAP: f32 = 4.0;
/// The side of the picture in one, in points.
pub const CELL_PICTURE: f32 = 60.0;
/// The most columns of that grid, and its greatest height, in points.
pub const GRID_COLUMNS: usize = 5;
/// See [`GRID_COLUMNS`].
pub const GRID_HEIGHT: f32 = 640.0;
/// The side of the icon of a category, in points.
pub const CATEGORY_ICON: f32 = 15.0;
/// The side of a chevron that folds something, in points.
pub const CHEVRON: f32 = 16.0;
/// The room that a scroll bar takes when the pointer is near, in points.
pub const SCROLL_ROOM: f32 = 12.0;
/// The least width of the views that are presented, in points, and how much larger they are at most.
pub const PRESENTED_WIDTH: f32 = 900.0;
/// See [`PRESENTED_WIDTH`].
pub const PRESENTED_ZOOM: f32 = 2.0;
/// The height of the bar at the top.
pub const TOP_BAR_HEIGHT: f32 = 30.0;
/// From this width on the arrangements have words beside their signs, in points.
pub const WORDS_WIDTH: f32 = 1180.0;
/// The largest width of what opens the search, in points.
pub const SEARCH_FIELD_WIDTH: f32 = 230.0;
/// Room between the edge of a tile and its view.
pub const TILE_MARGIN: f32 = 4.0;
/// The room around a figure, and between its title and its view, in points.
pub const FIGURE_MARGIN: f32 = 10.0;
/// See [`FIGURE_MARGIN`].
pub const FIGURE_GAP: f32 = 6.0;
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
/// The size of the bar of shares, in points.
pub const SHARE_BAR: Vec2 = Vec2::new(104.0, 12.0);
/// The size of a sample of a colour in a legend, in points.
pub const SWATCH: Vec2 = Vec2::new(18.0, 12.0);
/// The largest size of the help, in points.
pub const HELP_SIZE: Vec2 = Vec2::new(560.0, 560.0);
/// The width of the column of keys in the help, in points.
pub const HELP_KEYS_WIDTH: f32 = 200.0;
/// The width of the field for a path, in points.
pub const PATH_WIDTH: f32 = 560.0;
/// The largest size of the preview of a figure, in points.
pub const PREVIEW: Vec2 = Vec2::new(560.0, 400.0);
/// The width of the choices beside it, and the height of what stands above and below, in points.
pub const CHOICES_WIDTH: f32 = 240.0;
/// The height of what is said of a size of figures there, in points.
pub const MEANING_HEIGHT: f32 = 46.0;
/// See [`CHOICES_WIDTH`].
pub const CHROME: f32 = 60.0;
/// The width of the search of the commands and the height of its list, in points.
pub const SEARCH_SIZE: Vec2 = Vec2::new(440.0, 320.0);
/// The height of a row of a legend, in points.
pub const LEGEND_ROW: f32 = 17.0;
/// The size of the grip by which a row is dragged, in points.
pub const GRIP: Vec2 = Vec2::new(10.0, 16.0);
/// The room between badges, and between the edge and the text of one.
pub const BADGE_SPACING: (Vec2, Vec2) = (Vec2::new(2.0, 2.0), Vec2::new(1.0, 0.0));
/// The room between the parts of a row of the list of materials, in points: names need the rest.
pub const ROW_SPACING: f32 = 3.0;
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
/// Width of the line of a Pareto front.
pub const FRONT_WIDTH: f32 = 1.0;
/// In a room wider than this, in points, advice stands beside the plot; and how wide it is there.
pub const ADVICE_BESIDE: f32 = 620.0;
/// See [`ADVICE_BESIDE`].
pub const ADVICE_WIDTH: f32 = 240.0;
/// The share of the height that the plot has where advice stands below.
pub const CHART_SHARE: f32 = 0.72;
/// From this height on a view has a list below its pictures, in points.
pub const LIST_BELOW: f32 = 300.0;
/// The width of a bar of progress, in points.
pub const PROGRESS_WIDTH: f32 = 130.0;
/// Radius of a handle that can be dragged.
pub const HANDLE_RADIUS: f32 = 7.0;
/// How far from its middle, in points, a press takes a handle.
pub const HANDLE_REACH: f32 = 20.0;
/// The size of the button that puts a view back, in points.
pub const RESET_VIEW: Vec2 = Vec2::new(76.0, 20.0);
/// Alpha of a lobe one sees through, 0..255.
pub const SEE_THROUGH_ALPHA: u8 = 90;
/// The same of one that is there for comparison: its outline is what counts.
pub const SHELL_ALPHA: u8 = 26;

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
    /// The line of a material. Neighbours in the palette differ in it, and with eight colours no two of the first
    /// twenty-four materials have both in common.
    #[must_use]
    pub fn of(slot: PaletteIndex) -> Self {
        match slot.0 % 3 {
            0 => Self::Solid,
            1 => Self::Dashed,
            _ => Self::Dotted,
        }
    }

    /// The line of a curve: that of its material, or of the channel where these are told apart.
    #[must_use]
    pub fn of_channel(channel: Channel, slot: PaletteIndex) -> Self {
        match channel {
            Channel::Luminance => Self::of(slot),
            Channel::Red => Self::Solid,
            Channel::Green => Self::Dashed,
            Channel::Blue => Self::Dotted,
        }
    }

    /// The line of the part at `index` of a whole.
    #[must_use]
    pub fn of_part(index: usize) -> Self {
        match index % 3 {
            0 => Self::Solid,
            1 => Self::Dashed,
            _ => Self::Dotted,
        }
    }
}

/// The size of the one number that a view is about, in points.
pub const LARGE_TEXT: f32 = 20.0;

/// The size of text of secondary rank, in points.
pub const SMALL_TEXT: f32 = 13.0;

/// Makes the text of a view, which is that of its plots, larger by this factor.
pub fn enlarge_labels(style: &mut egui::Style, factor: f32) {
    for text in [TextStyle::Small, TextStyle::Body] {
        if let Some(font) = style.text_styles.get_mut(&text) {
            font.size *= factor;
        }
    }
}

/// Lets the text of controls in a view be as large as elsewhere.
pub fn plain_text(ui: &mut egui::Ui) {
    ui.style_mut().text_styles = ui.ctx().global_style().text_styles.clone();
}

/// The fonts of all families.
#[must_use]
pub fn fonts() -> FontDefinitions {
    // The raised minus of 10⁻³ is in no font for text.
    let mut fonts = FontDefinitions::default();
    let families = &mut fonts.families;
    if let Some(wide) = families.get(&FontFamily::Monospace).cloned() {
        let text = families.entry(FontFamily::Proportional).or_default();
        let lacks = |font: &String| !text.contains(font);
        let more: Vec<String> = wide.into_iter().filter(lacks).collect();
        text.extend(more);
    }
    math_fonts::add(&mut fonts);
    fonts
}

/// Sets fonts, text sizes and spacing for both themes.
pub fn apply(ctx: &egui::Context) {
    ctx.set_fonts(fonts());
    ctx.all_styles_mut(|style| {
        let font = |size: f32| FontId::new(size, FontFamily::Proportional);
        style.text_styles.insert(TextStyle::Heading, font(15.0));
        style.text_styles.insert(TextStyle::Body, font(13.0));
        style.text_styles.insert(TextStyle::Button, font(13.0));
        style.text_styles.insert(TextStyle::Small, font(SMALL_TEXT));
        style.spacing.item_spacing = Vec2::new(7.0, 5.0);
        style.spacing.slider_width = 118.0;
        style.spacing.interact_size.y = small::POINTED_AT;
    });
    for theme in [Theme::Dark, Theme::Light] {
        let palette = Palette::of(theme);
        ctx.style_mut_of(theme, |style| {
            let visuals = &mut style.visuals;
            visuals.override_text_color = Some(palette.ink);
            visuals.weak_text_color = Some(palette.faint_ink);
            visuals.panel_fill = palette.panel;
            visuals.window_fill = palette.panel;
            visuals.extreme_bg_color = palette.background;
            visuals.error_fg_color = palette.warning;
            visuals.warn_fg_color = palette.warning;
            visuals.selection.bg_fill = palette.accent;
            visuals.selection.stroke.color = palette.accent_line;
            // The rail of a slider would have the accent.
            visuals.slider_trailing_fill = false;
            visuals.text_cursor.stroke.color = palette.accent_line;
        });
    }
}

/// Lets nothing move or fade by itself, or lets it again.
pub fn reduce_motion(ctx: &egui::Context, is_reduced: bool) {
    if has_reduced_motion(ctx) == is_reduced {
        return;
    }
    ctx.data_mut(|data| data.insert_temp(reduced_motion(), is_reduced));
    let usual = egui::Style::default();
    ctx.all_styles_mut(|style| {
        if is_reduced {
            style.animation_time = 0.0;
            style.scroll_animation = egui::style::ScrollAnimation::none();
        } else {
            style.animation_time = usual.animation_time;
            style.scroll_animation = usual.scroll_animation;
        }
    });
}

/// Whether nothing moves or fades by itself.
#[must_use]
pub fn has_reduced_motion(ctx: &egui::Context) -> bool {
    let is_reduced: Option<bool> = ctx.data(|data| data.get_temp(reduced_motion()));
    is_reduced.unwrap_or(false)
}

fn reduced_motion() -> egui::Id {
    egui::Id::unique("reduced motion")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers that change in place do not make what is beside them jump.
    #[test]
    fn all_digits_are_as_wide_as_one_another() {
        let context = egui::Context::default();
        let mut output = context.run_ui(egui::RawInput::default(), |ui| {
            apply(ui.ctx());
        });
        output.textures_delta.clear();
        let mut output = context.run_ui(egui::RawInput::default(), |ui| {
            for family in [FontFamily::Proportional, FontFamily::Monospace] {
                for size in [SMALL_TEXT, 13.0, 15.0] {
                    let font = FontId::new(size, family.clone());
                    let width = |digit: char| ui.fonts_mut(|fonts| fonts.glyph_width(&font, digit));
                    let widths = ('0'..='9').map(width);
                    let zero = width('0');
                    assert!(zero > 0.0 && widths.into_iter().all(|width| width == zero));
                }
            }
        });
        output.textures_delta.clear();
    }

    #[test]
    fn twenty_four_materials_are_told_apart() {
        for palette in [Theme::Dark, Theme::Light].map(Palette::of) {
            let look = |slot: u8| {
                (
                    palette.material(PaletteIndex(slot)),
                    Dash::of(PaletteIndex(slot)),
                )
            };
            for a in 0..24 {
                assert!((0..a).all(|b| look(a) != look(b)), "{a}");
                assert_ne!(Dash::of(PaletteIndex(a)), Dash::of(PaletteIndex(a + 1)));
            }
        }
    }
}
