//! Small pictures of the named materials, computed when they first come into sight.

use std::collections::HashMap;

use egui::{ColorImage, Context, TextureHandle, TextureId, TextureOptions};

use crate::theme;
use bxdf::material::library::Named;
use bxdf_lab::analysis::thumbnail;

/// The most pixels along a side: beyond it a picture takes longer than a frame, and shows nothing more.
const MAX_SIDE: usize = 48;

/// The pictures made so far.
pub struct Thumbnails {
    textures: HashMap<&'static str, TextureHandle>,
    is_at_once: bool,
    made_in_frame: Option<u64>,
}

impl Thumbnails {
    /// No pictures yet. `is_at_once`: whether all that are in sight are made in the same frame, or else one, so that the
    /// window never stalls.
    #[must_use]
    pub fn new(is_at_once: bool) -> Self {
        Self {
            textures: HashMap::new(),
            is_at_once,
            made_in_frame: None,
        }
    }

    /// The picture of `named`. `None` where it has to wait for another frame, which is asked for.
    pub fn get(&mut self, ctx: &Context, named: &'static Named) -> Option<TextureId> {
        if let Some(texture) = self.textures.get(named.id) {
            return Some(texture.id());
        }
        let frame = Some(ctx.cumulative_frame_nr());
        if !self.is_at_once && self.made_in_frame == frame {
            ctx.request_repaint();
            return None;
        }
        self.made_in_frame = frame;
        let pixels = (theme::THUMBNAIL_SIZE * ctx.pixels_per_point()).round() as usize;
        let image = picture(named, pixels.clamp(1, MAX_SIDE));
        let texture = ctx.load_texture(named.id, image, TextureOptions::LINEAR);
        let id = texture.id();
        self.textures.insert(named.id, texture);
        Some(id)
    }
}

fn picture(named: &Named, side: usize) -> ColorImage {
    let material = &named.material;
    let picture = thumbnail::sphere(&*material.build(), material.relative_index(), side);
    let pixels = picture.pixels.into_iter();
    let colors = pixels.map(|[r, g, b, coverage]| theme::color_of_radiance([r, g, b], coverage));
    ColorImage::new([side, side], colors.collect())
}

#[cfg(test)]
mod tests {
    use egui::RawInput;

    use super::*;
    use bxdf::material::library;

    /// Which of the first two pictures are there, in each of two frames.
    fn made(mut thumbnails: Thumbnails) -> [[bool; 2]; 2] {
        let ctx = Context::default();
        let [first, second] = [&library::all()[0], &library::all()[1]];
        std::array::from_fn(|_| {
            let mut made = [false; 2];
            let mut output = ctx.run_ui(RawInput::default(), |ui| {
                made = [first, second].map(|named| thumbnails.get(ui.ctx(), named).is_some());
            });
            // egui insists that somebody takes them.
            output.textures_delta.clear();
            made
        })
    }

    #[test]
    fn pictures_come_one_a_frame_or_all_at_once() {
        assert_eq!(made(Thumbnails::new(false)), [[true, false], [true, true]]);
        assert_eq!(made(Thumbnails::new(true)), [[true, true]; 2]);
    }
}
