//! The status line: the value under the pointer, the shares of light, the time of the last update.

use egui::{Color32, Rect, Role, Sense, Ui, WidgetInfo, vec2};

use super::draw;
use crate::analysis::Channel;
use crate::analysis::reflectance::Reflectance;
use crate::ui::session::Session;
use crate::ui::theme::Palette;
use crate::ui::views::Cursor;

/// Width of the bar of shares, in points.
const BAR_WIDTH: f32 = 120.0;

/// The line; `last_update` in seconds.
pub fn show(
    ui: &mut Ui,
    session: &Session,
    cursor: Option<&Cursor>,
    shares: &Reflectance,
    last_update: Option<f64>,
    palette: &Palette,
) {
    ui.horizontal(|ui| {
        let time = last_update.map_or_else(|| "-".to_owned(), |seconds| format!("{:.1} ms", 1000.0 * seconds));
        let shares = rounded_shares(shares);
        bar(ui, shares, palette);
        let [reflected, transmitted, absorbed] = shares;
        let text = format!("reflected {reflected:.3} | transmitted {transmitted:.3} | absorbed {absorbed:.3}");
        let hint = "What becomes of light arriving along the held direction, as shares of its flux (luminance)";
        ui.label(text).on_hover_text(hint);
        ui.separator();
        let note = cursor.map_or_else(|| "Point at a view to read its value".to_owned(), |cursor| draw::cursor_text(cursor, session));
        ui.label(note);
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            ui.label(format!("Update {time}")).on_hover_text("Time the last change took to compute");
        });
    });
}

/// The luminance of the shares in thousandths; they sum to 1 exactly, the rest being what is absorbed.
fn rounded_shares(shares: &Reflectance) -> [f64; 3] {
    let thousandths = |rgb: [f64; 3]| (Channel::Luminance.of(rgb) * 1000.0).round() / 1000.0;
    let (reflected, transmitted) = (
        thousandths(shares.reflection),
        thousandths(shares.transmission),
    );
    let absorbed = ((1.0 - reflected - transmitted) * 1000.0).round() / 1000.0;
    // Adding 0 turns the -0 of rounding into 0.
    [reflected, transmitted, absorbed + 0.0]
}

fn bar(ui: &mut Ui, [reflected, transmitted, absorbed]: [f64; 3], palette: &Palette) {
    let (rect, response) = ui.allocate_exact_size(vec2(BAR_WIDTH, 12.0), Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(Role::ProgressIndicator, true, "Shares of light"));
    let painter = ui.painter_at(rect);
    let mut left = rect.left();
    let mut part = |share: f64, color: Color32| {
        let width = rect.width() * share.clamp(0.0, 1.0) as f32;
        painter.rect_filled(
            Rect::from_min_size(egui::pos2(left, rect.top()), vec2(width, rect.height())),
            0.0,
            color,
        );
        left += width;
    };
    part(reflected, palette.lobe);
    part(transmitted, palette.transmitted);
    part(absorbed, palette.absorbed);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_sum_to_one() {
        let shares = Reflectance {
            reflection: [0.333_33; 3],
            transmission: [0.333_33; 3],
            error: 0.0,
        };
        assert_eq!(rounded_shares(&shares), [0.333, 0.333, 0.334]);
        let all = Reflectance {
            reflection: [1.0 - 1e-9; 3],
            transmission: [0.0; 3],
            error: 0.0,
        };
        assert_eq!(rounded_shares(&all), [1.0, 0.0, 0.0]);
    }
}
