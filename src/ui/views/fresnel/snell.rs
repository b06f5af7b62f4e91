//! Snell's law beside the chart: its triangles, the angles, and what is reflected at the angle held.

use egui::{Grid, Sense, TextStyle, Ui, vec2};

use super::curves::Look;
use super::rays::Drawing;
use super::words::with_subscripts;
use bxdf::math::frame;
use bxdf_lab::analysis::Channel;
use bxdf_lab::analysis::fresnel::{Curve, Fresnel};
use bxdf_study::format;

/// The part of the height that the picture has at most.
const LARGEST_SHARE: f32 = 0.62;

/// Between the columns and between the rows of values, in points.
const SPACING: egui::Vec2 = vec2(14.0, 1.0);

/// The picture, the equation, and what is reflected at the angle held.
pub(super) fn show(ui: &mut Ui, fresnel: &Fresnel, look: &Look<'_>) {
    let room = ui.available_size();
    let below = room.y - words_height(ui, fresnel, look);
    let side = room.x.min(LARGEST_SHARE * room.y).min(below).max(0.0);
    let (rect, _) = ui.allocate_exact_size(vec2(room.x, side), Sense::hover());
    Drawing::new(ui, rect, fresnel, look).show();
    ui.add_space(SPACING.x);
    ui.spacing_mut().item_spacing.y = SPACING.y;
    ui.spacing_mut().interact_size.y = 0.0;
    equations(ui, fresnel, look);
    ui.add_space(SPACING.x);
    values(ui, fresnel, look);
}

/// The height of what is written below the picture, in points.
fn words_height(ui: &Ui, fresnel: &Fresnel, look: &Look<'_>) -> f32 {
    let row = ui.text_style_height(&TextStyle::Small) + SPACING.y;
    let curves = fresnel.curves.len();
    // A line of an equation may take two rows.
    let equations = if fresnel.is_absorbing { 2 } else { 2 * curves };
    let kinds = look.kinds().len();
    let values = kinds + usize::from(kinds > 0) + usize::from(curves > 1);
    row * (equations + values) as f32 + 2.0 * SPACING.x
}

/// The angles of both sides, and n sin θ, which is the same.
fn equations(ui: &mut Ui, fresnel: &Fresnel, look: &Look<'_>) {
    let theta = format::degrees(fresnel.theta_deg);
    let ink = look.palette.ink;
    if fresnel.is_absorbing {
        let text = format!("θ_i {theta}, θ_t no real angle: n + ik is complex");
        ui.label(with_subscripts(ui, &text, ink));
        return;
    }
    for curve in &fresnel.curves {
        let symbol = curve.channel.and_then(Channel::symbol);
        let symbol = symbol.map_or_else(String::new, |symbol| format!("{symbol}  "));
        let color = symbol.is_empty().then_some(ink);
        let color = color.unwrap_or_else(|| look.channel(curve.channel));
        for line in lines(curve, fresnel) {
            ui.label(with_subscripts(ui, &format!("{symbol}{line}"), color));
        }
    }
}

/// Snell's law for a channel.
fn lines(curve: &Curve, fresnel: &Fresnel) -> Vec<String> {
    let theta = format::degrees(fresnel.theta_deg);
    let [n_i, _] = curve.sides(fresnel.is_from_below);
    let product = n_i * frame::cos_sin_deg(fresnel.theta_deg).1;
    let product = format::value(product);
    match curve.held.refracted_deg {
        Some(_) if curve.index.is_matched() => {
            vec!["equal indices: nothing is reflected or bent".to_owned()]
        }
        Some(angle) => vec![
            format!("θ_i {theta}, θ_t {angle:.2}°"),
            format!("n_i sin θ_i = n_t sin θ_t = {product}"),
        ],
        None => vec![
            format!("θ_i {theta}, θ_t no real angle: total reflection"),
            format!("n_i sin θ_i = {product}, more than n_t"),
        ],
    }
}

/// What is reflected at the angle held.
fn values(ui: &mut Ui, fresnel: &Fresnel, look: &Look<'_>) {
    let ink = look.palette.ink;
    let say = |ui: &mut Ui, text: &str, color| ui.label(with_subscripts(ui, text, color));
    let kinds = look.kinds();
    if !kinds.is_empty() {
        let heading = format!("reflectance at {}", format::degrees(fresnel.theta_deg));
        say(ui, &heading, look.palette.faint_ink);
    }
    let grid = Grid::new("reflectances")
        .num_columns(1 + fresnel.curves.len())
        .min_row_height(0.0)
        .spacing(SPACING);
    grid.show(ui, |ui| {
        if fresnel.curves.len() > 1 {
            ui.label("");
            for curve in &fresnel.curves {
                let symbol = curve.channel.and_then(Channel::symbol).unwrap_or_default();
                say(ui, symbol, look.channel(curve.channel));
            }
            ui.end_row();
        }
        for kind in kinds {
            say(ui, kind.name, ink);
            for curve in &fresnel.curves {
                let value = (kind.of)(&curve.held.reflectances);
                say(ui, &format::value(value), ink);
            }
            ui.end_row();
        }
    });
}
