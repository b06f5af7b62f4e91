//! The lit sphere: what a material looks like on a body under a light.

use std::sync::Arc;

use egui::{Align2, ColorImage, Rect, Response, Role, Sense, Ui, WidgetInfo, vec2};
use glam::DVec3;

use super::context::ViewContext;
use super::settings;
use crate::theme;
use crate::widgets::number::Number;
use crate::widgets::pictures::{self, Cell, ColorScale, ScaleKind};
use crate::widgets::{choice, draw, still};
use bxdf_lab::analysis::Channel;
use bxdf_lab::analysis::half_difference::Spherical;
use bxdf_lab::analysis::sphere::{self, Light, Picture, pair_at};
use bxdf_study::format;
use bxdf_study::session::{EntryId, MaterialEntry, Session};
use bxdf_study::views::sphere::{Arrangement, Curve, EXPOSURE, Options};

mod handles;
mod place;

/// Room around a sphere for the handle of a light that stands behind it, as a share of the picture.
const MARGIN: f32 = 0.08;

pub(super) fn show(ui: &mut Ui, cx: &mut ViewContext<'_, Options>) {
    settings::show(ui, cx, |ui, cx| controls(ui, cx.session, cx.options));
    if let Some(note) = bxdf_study::export::nothing_to_show(cx.session) {
        draw::centred_note(ui, note);
        return;
    }
    let room = ui.available_rect_before_wrap();
    let options = *cx.options;
    let is_difference = options.arrangement == Arrangement::Difference;
    let room = if is_difference && cx.session.materials.is_overlay() {
        pictures::color_bar(
            ui,
            room,
            difference_scale(&options),
            "difference of radiance",
            cx.palette,
        )
    } else {
        room
    };
    let is_clipped = if options.arrangement == Arrangement::Wipe {
        show_wipe(ui, cx, room)
    } else {
        show_grid(ui, cx, room)
    };
    let is_delta = |entry: &MaterialEntry| entry.material.is_delta_only();
    let is_point = options.light == Light::Directional && !options.is_shared;
    let note = if is_point && cx.session.materials.shown().any(is_delta) {
        Some("A mirror shows light from one direction at the ringed point alone: choose the sky")
    } else if is_clipped && !is_difference {
        Some("Channels are clipped where it is brightest: lower the exposure to see them")
    } else {
        None
    };
    if let Some(note) = note {
        let place = room.left_bottom() + vec2(4.0, -4.0);
        let (font, color) = (draw::small_font(ui), cx.palette.ink);
        draw::haloed_text(
            ui.painter(),
            place,
            Align2::LEFT_BOTTOM,
            note,
            font,
            color,
            cx.palette,
        );
    }
    ui.advance_cursor_after_rect(room);
}

fn controls(ui: &mut Ui, session: &mut Session, options: &mut Options) {
    let is_overlay = session.materials.is_overlay();
    ui.horizontal_wrapped(|ui| {
        let hint = "What lights the sphere";
        choice::choice(
            ui,
            ("Light", hint),
            &mut options.light,
            &Light::ALL,
            Light::title,
        );
        if options.light.has_direction() {
            let mut is_own = !options.is_shared;
            let hint = "A light of this view's own, also behind the sphere; else the light of the other views";
            choice::switch(ui, ("Own light", hint), &mut is_own);
            if is_own {
                options.keep_light(session);
            } else {
                options.is_shared = true;
            }
        }
        let hint = "Soft: nothing is clipped. Linear: in proportion, clipped at white";
        choice::choice(
            ui,
            ("Brightness", hint),
            &mut options.curve,
            Curve::ALL,
            Curve::title,
        );
        choice::keep_together(ui, choice::slider_width(ui, "Exposure"));
        ui.label("Exposure");
        let hint = "Each stop doubles the radiance; white is radiance 1 at 0 stops";
        let number = Number::new("Exposure", EXPOSURE).steps(0.0, 1);
        let shown = number.slider(ui, "", &mut options.exposure);
        shown.on_hover_text(hint).explain(ui);
        if is_overlay {
            let hint = "How the spheres of several materials are arranged";
            choice::choice(
                ui,
                ("Spheres", hint),
                &mut options.arrangement,
                Arrangement::ALL,
                Arrangement::title,
            );
            if options.arrangement == Arrangement::Difference {
                super::context::reference_choice(ui, &mut session.materials);
            }
        }
    });
}

/// The radiance that becomes white.
fn white(options: &Options) -> f64 {
    (-options.exposure).exp2()
}

/// The colours of differences: half of white either way.
fn difference_scale(options: &Options) -> ColorScale {
    let end = 0.5 * white(options);
    ColorScale {
        range: [-end, end],
        kind: ScaleKind::Diverging,
    }
}

/// The picture of a material as a texture, or of its difference from that of the reference.
fn texture(
    ui: &Ui,
    cx: &mut ViewContext<'_, Options>,
    entry: EntryId,
    width: f32,
    is_difference: bool,
) -> Option<pictures::Texture> {
    let (session, answers, options) = (&*cx.session, &mut *cx.answers, &*cx.options);
    let pixels = width * ui.ctx().pixels_per_point();
    let mut of = |entry: &MaterialEntry| {
        let request = options.request(session, entry, pixels);
        answers.ask(session, entry, request)
    };
    let picture = of(session.materials.get(entry)?);
    let id = ui.scope_id().with(("sphere", entry));
    let textures = &mut cx.state.textures;
    if is_difference {
        let reference = of(session.materials.reference());
        let scale = difference_scale(cx.options);
        let sources = vec![Arc::clone(&picture) as _, Arc::clone(&reference) as _];
        let paint = || difference(&picture, &reference, scale);
        return Some(textures.get(ui, id, (sources, Some(scale)), paint));
    }
    let curve = cx.options.curve;
    // The look is the radiance that becomes white, and the curve.
    let look = ColorScale {
        range: [0.0, white(cx.options)],
        kind: match curve {
            Curve::Linear => ScaleKind::Linear,
            Curve::Soft => ScaleKind::Logarithmic,
        },
    };
    let sources = vec![Arc::clone(&picture) as _];
    Some(textures.get(ui, id, (sources, Some(look)), || {
        exposed(&picture, white(cx.options), curve)
    }))
}

/// The picture as the screen shows it: clipped where a channel is brighter than `white`, or by a curve on which that is two
/// thirds of the brightness, and nothing all of it.
fn exposed(picture: &Picture, white: f64, curve: Curve) -> ColorImage {
    const MOST: f64 = 0.995;
    const SLOPE: f64 = 2.0;
    let pixels = picture.pixels.iter().map(|[r, g, b, coverage]| {
        let linear = [*r, *g, *b].map(|x| {
            let x = f64::from(x) / white;
            match curve {
                Curve::Linear => x,
                Curve::Soft => MOST * SLOPE * x / (1.0 + SLOPE * x),
            }
        });
        theme::color_of_linear_covered(linear, *coverage)
    });
    ColorImage::new([picture.width, picture.height], pixels.collect())
}

/// The difference of the luminances of two pictures of one size; nothing while one is still coarse.
fn difference(picture: &Picture, reference: &Picture, scale: ColorScale) -> ColorImage {
    let luminance = |[r, g, b, _]: &[f32; 4]| Channel::Luminance.of([*r, *g, *b].map(f64::from));
    let pixels = picture.zip_with(reference, |a, b| {
        let is_covered = a[3] > 0.5;
        if is_covered {
            luminance(a) - luminance(b)
        } else {
            f64::NAN
        }
    });
    pixels.map_or_else(ColorImage::default, |pixels| scale.paint(&pixels))
}

/// A sphere for each material. Returns whether one is clipped.
fn show_grid(ui: &mut Ui, cx: &mut ViewContext<'_, Options>, room: Rect) -> bool {
    let options = *cx.options;
    let is_difference =
        options.arrangement == Arrangement::Difference && cx.session.materials.is_overlay();
    let reference = cx.session.materials.reference().id();
    let ids = cx.session.materials.shown().map(MaterialEntry::id);
    let ids: Vec<EntryId> = ids
        .filter(|id| !is_difference || *id != reference)
        .collect();
    let (mut is_clipped, mut first) = (false, None);
    let mut covered = Vec::new();
    let cells = pictures::cells(ui, room, ids.len(), 1.0);
    for (cell, entry) in cells.into_iter().zip(&ids) {
        let rect = cell.picture.shrink(MARGIN * cell.picture.width());
        let name = pictures::title(ui, cell, *entry, cx.session, cx.palette);
        if let Some(texture) = texture(ui, cx, *entry, rect.width(), is_difference) {
            texture.paint(ui.painter(), rect);
            is_clipped |= texture.is_clipped;
        }
        interact_strip(ui, cx, (rect, rect), (*entry, &name), &mut covered);
        if cx.options.light.has_direction() {
            handles::mark(ui, cx, rect);
        }
        first = first.or(Some(rect));
    }
    // Above all spheres: a grip may reach into the next one.
    if let Some(rect) = first {
        handles::drag(ui, cx, rect, &covered);
    }
    is_clipped
}

/// One sphere, a strip of it for each material. Returns whether one is clipped.
fn show_wipe(ui: &mut Ui, cx: &mut ViewContext<'_, Options>, room: Rect) -> bool {
    let ids: Vec<EntryId> = cx
        .session
        .materials
        .shown()
        .map(MaterialEntry::id)
        .collect();
    let Some(cell) = pictures::cells(ui, room, 1, 1.0).into_iter().next() else {
        return false;
    };
    let rect = cell.picture.shrink(MARGIN * cell.picture.width());
    let width = rect.width() / ids.len().max(1) as f32;
    let (mut is_clipped, mut covered) = (false, Vec::new());
    for (index, entry) in ids.iter().enumerate() {
        let left = rect.left() + width * index as f32;
        let strip = Rect::from_x_y_ranges(left..=left + width, room.y_range());
        if let Some(texture) = texture(ui, cx, *entry, rect.width(), false) {
            texture.paint(
                &ui.painter().with_clip_rect(strip.intersect(ui.clip_rect())),
                rect,
            );
            is_clipped |= texture.is_clipped;
        }
        if index > 0 {
            ui.painter()
                .vline(left, rect.y_range(), (1.0, cx.palette.axis));
        }
        let title = Rect::from_min_size(strip.min, vec2(width, theme::LEGEND_ROW));
        let cell = Cell {
            title,
            picture: Rect::from_x_y_ranges(strip.x_range(), rect.y_range()),
        };
        let name = pictures::title(ui, cell, *entry, cx.session, cx.palette);
        let strip = (cell.picture, rect);
        interact_strip(ui, cx, strip, (*entry, &name), &mut covered);
    }
    if cx.options.light.has_direction() {
        handles::mark(ui, cx, rect);
    }
    handles::drag(ui, cx, rect, &covered);
    is_clipped
}

/// The pointer over the part `strip` of the sphere in `rect`: reads out, and a click holds the directions of that point. Adds
/// what its labels cover to `covered`.
fn interact_strip(
    ui: &Ui,
    cx: &mut ViewContext<'_, Options>,
    (strip, rect): (Rect, Rect),
    (entry, name): (EntryId, &str),
    covered: &mut Vec<Rect>,
) {
    let response = ui.interact(
        strip,
        ui.scope_id().with(("on sphere", entry)),
        still::sense(ui, Sense::click()),
    );
    response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, format!("Sphere of {name}")));
    let Some(found) = cx.session.materials.get(entry) else {
        return;
    };
    let request = cx.options.request(cx.session, found, rect.width());
    if !request.light.has_direction() {
        return;
    }
    let light = request.to_light();
    handles::mark_glint(ui, cx, (strip, rect), light, entry, covered);
    let Some(pointer) = response.hover_pos() else {
        return;
    };
    let [x, y] =
        pictures::share_of(rect, pointer).map(|share| (2.0 * share - 1.0) / sphere::RADIUS);
    let Some((wo, wi)) = pair_at(light, [x, -y]) else {
        return;
    };
    read_out(ui, cx, (&response, name), (wo, wi));
    if response.clicked() {
        cx.session.materials.select(entry);
        // The sphere stays as it was clicked, wherever the light of the pair is.
        cx.options.keep_light(cx.session);
        cx.hold_pair(wo, wi);
    }
}

fn read_out(
    ui: &Ui,
    cx: &ViewContext<'_, Options>,
    (response, name): (&Response, &str),
    (wo, wi): (DVec3, DVec3),
) {
    let angles = |w: DVec3| {
        let w = Spherical::of(w);
        format!(
            "θ {}  φ {}",
            format::degrees(w.theta_deg),
            format::degrees(w.phi_deg)
        )
    };
    let text = format!(
        "{name}\nto the viewer  {}\nto the light  {}",
        angles(wo),
        angles(wi)
    );
    if let Some(pointer) = response.hover_pos() {
        draw::pointer_note(ui, pointer, ui.clip_rect(), &text, cx.palette);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exposure_and_clipping() {
        let picture = Picture {
            width: 2,
            height: 1,
            pixels: vec![[0.5, 0.5, 0.5, 1.0], [0.0; 4]],
        };
        let half = exposed(&picture, 1.0, Curve::Linear);
        assert!(half.pixels[0].r() < 255 && half.pixels[1].a() == 0);
        assert_eq!(exposed(&picture, 0.5, Curve::Linear).pixels[0].r(), 255);
        let bright = Picture {
            pixels: vec![[1e6, 0.5, 1e-3, 1.0], [0.0; 4]],
            ..picture
        };
        let [r, g, b, _] = exposed(&bright, 1.0, Curve::Soft).pixels[0].to_array();
        assert!(r > 250 && r < 255 && g > b && b > 0, "{r} {g} {b}");
    }
}
