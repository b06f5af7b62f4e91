//! The textures of the pictures on the screen, painted anew only where something has changed.

use std::any::Any;
use std::collections::HashMap;
use std::sync::Arc;

use egui::{
    Color32, ColorImage, Id, Painter, Pos2, Rect, TextureHandle, TextureId, TextureOptions, Ui,
    pos2,
};

use super::{ColorScale, Turns};

/// Something that a picture is made of; it stays the same as long as it is the same value.
pub type Source = Arc<dyn Any + Send + Sync>;

/// The textures of the pictures on the screen.
#[derive(Default)]
pub struct Textures {
    kept: HashMap<Id, Kept>,
    /// Who paints in this frame.
    pub turns: Turns,
}

/// A picture ready to be painted.
#[derive(Clone)]
pub struct Texture {
    handle: TextureHandle,
    image: Arc<ColorImage>,
    /// Whether a channel of a pixel is at its end.
    pub is_clipped: bool,
}

impl Texture {
    /// Paints it into `rect`.
    pub fn paint(&self, painter: &Painter, rect: Rect) {
        let whole = Rect::from_min_max(Pos2::ZERO, pos2(1.0, 1.0));
        painter.image(self.handle.id(), rect, whole, Color32::WHITE);
    }
}

struct Kept {
    sources: Vec<Source>,
    look: Option<ColorScale>,
    texture: Texture,
    is_used: bool,
    /// For how many frames it has shown what was, because it had no turn yet.
    waits: u32,
}

impl Textures {
    /// Forgets what the last frame did not show.
    pub fn begin_frame(&mut self) {
        self.turns.begin_frame();
        self.kept
            .retain(|_, kept| std::mem::take(&mut kept.is_used));
    }

    /// The picture of a texture, if it is one of these.
    #[must_use]
    pub fn image(&self, id: TextureId) -> Option<Arc<ColorImage>> {
        let mut all = self.kept.values().map(|kept| &kept.texture);
        let found = all.find(|texture| texture.handle.id() == id);
        found.map(|texture| Arc::clone(&texture.image))
    }

    /// The texture of these sources in this look, painted anew only where one of them is another one; the one before where it
    /// has to wait for its turn.
    pub fn get(
        &mut self,
        ui: &Ui,
        id: Id,
        (sources, look): (Vec<Source>, Option<ColorScale>),
        paint: impl FnOnce() -> ColorImage,
    ) -> Texture {
        let is_same = |kept: &Kept| {
            let mut pairs = kept.sources.iter().zip(&sources);
            kept.look == look
                && kept.sources.len() == sources.len()
                && pairs.all(|(a, b)| std::ptr::addr_eq(Arc::as_ptr(a), Arc::as_ptr(b)))
        };
        if let Some(kept) = self.kept.get_mut(&id).filter(|kept| is_same(kept)) {
            kept.is_used = true;
            return kept.texture.clone();
        }
        let painted = match self.kept.get_mut(&id) {
            Some(kept) => {
                let Some(painted) = self.turns.take(ui.ctx(), &mut kept.waits, paint) else {
                    kept.is_used = true;
                    return kept.texture.clone();
                };
                painted
            }
            None => self.turns.at_once(paint),
        };
        // Before the first answer there is no pixel; a graphics processor wants one.
        let is_empty = painted.pixels.is_empty();
        let image = Arc::new(if is_empty {
            ColorImage::new([1, 1], vec![Color32::TRANSPARENT])
        } else {
            painted
        });
        let is_full = |color: &Color32| color.r().max(color.g()).max(color.b()) == u8::MAX;
        let texture = Texture {
            is_clipped: image.pixels.iter().any(is_full),
            handle: ui
                .ctx()
                .load_texture("picture", Arc::clone(&image), TextureOptions::LINEAR),
            image,
        };
        let kept = Kept {
            sources,
            look,
            texture: texture.clone(),
            is_used: true,
            waits: 0,
        };
        self.kept.insert(id, kept);
        texture
    }
}
