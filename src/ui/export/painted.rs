//! What was painted for a picture, to be drawn in any format when the application behind it is gone.

use std::collections::HashMap;
use std::sync::Arc;

use egui::epaint::ClippedShape;
use egui::{ColorImage, Pos2, Rect, Shape, TextureId, Vec2};
use egui_kittest::Harness;
use image::RgbaImage;

use super::shapes::{self, Canvas, Pictures};
use crate::app::{App, Picture};
use crate::headless;
use bxdf::error::Result;

/// What was painted.
pub struct Painted {
    /// Its width and height in points.
    pub(super) size: Vec2,
    /// The shapes, in the order in which they cover one another.
    pub(super) shapes: Vec<ClippedShape>,
    textures: HashMap<TextureId, Arc<ColorImage>>,
    /// What the graphics processor alone draws, with its pixels per point.
    scenes: Option<(ColorImage, f32)>,
}

impl Painted {
    /// Shapes without pictures, on a page of this size.
    pub(super) fn of_shapes(size: Vec2, shapes: Vec<ClippedShape>) -> Self {
        Self {
            size,
            shapes,
            textures: HashMap::new(),
            scenes: None,
        }
    }

    /// What is painted for a picture.
    ///
    /// # Errors
    /// Where it shows a scene, and there is no graphics adapter, or it fails.
    pub(super) async fn of(picture: Picture) -> Result<Self> {
        let scale = picture.scale;
        let mut harness = picture.clone().shapes();
        let has_scene = |clipped: &ClippedShape| matches!(clipped.shape, Shape::Callback(_));
        let mut scenes = None;
        if harness.output().shapes.iter().any(has_scene) {
            harness = picture.drawn()?;
            harness.state_mut().draw_axes_as_lines();
            scenes = Some((scenes_of(&mut harness).await?, scale));
        }
        let shapes = harness.output().shapes.clone();
        let mut textures = HashMap::new();
        for clipped in &shapes {
            shapes::textures(&clipped.shape, &mut |id| {
                textures.extend(harness.state().image(id).map(|image| (id, image)));
            });
        }
        Ok(Self {
            size: harness.ctx.content_rect().size(),
            shapes,
            textures,
            scenes,
        })
    }

    /// Hands over what knows the pictures in it.
    pub(super) fn with_pictures<T>(&self, then: impl FnOnce(Pictures<'_>) -> T) -> T {
        then(Pictures {
            of_texture: &|id| self.textures.get(&id).cloned(),
            of_scene: &|rect| {
                let (scenes, scale) = self.scenes.as_ref()?;
                Some(scenes.region(&rect, Some(*scale)))
            },
        })
    }

    /// Draws all of it.
    ///
    /// # Errors
    /// Where a picture cannot be encoded.
    pub(super) fn draw(&self, canvas: &mut impl Canvas) -> Result<()> {
        let page = Rect::from_min_size(Pos2::ZERO, self.size);
        self.with_pictures(|pictures| shapes::draw(canvas, &self.shapes, page, pictures))
    }
}

/// The page with nothing on it but what the graphics processor draws.
async fn scenes_of(harness: &mut Harness<'_, App>) -> Result<ColorImage> {
    harness.state_mut().paint_scenes_alone(true);
    harness.run_ok();
    let scenes = headless::rendered(harness).await?;
    harness.state_mut().paint_scenes_alone(false);
    harness.run_ok();
    Ok(as_colors(&scenes))
}

/// A picture in egui's colours.
pub(super) fn as_colors(image: &RgbaImage) -> ColorImage {
    let size = [image.width(), image.height()].map(|side| side as usize);
    ColorImage::from_rgba_unmultiplied(size, image)
}
