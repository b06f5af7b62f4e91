//! Small pictures of materials, asked for when they first come into sight.

use std::collections::HashMap;
use std::sync::Arc;

use egui::{
    Color32, ColorImage, Context, Rect, TextureHandle, TextureId, TextureOptions, Ui, pos2,
};

use crate::theme;
use bxdf::Material;
use bxdf_lab::analysis::thumbnail::{Picture, Request};
use bxdf_study::answers::Answers;
use bxdf_study::session::{EntryId, MaterialEntry, Materials};

/// The most pixels along a side: more show nothing more.
const MAX_SIDE: usize = 72;

/// What a picture shows.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
enum Of {
    /// What is listed by this id.
    Listed(&'static str),
    /// A material of the session.
    Entry(EntryId),
}

/// A picture that was made.
struct Made {
    picture: Arc<Picture>,
    texture: TextureHandle,
}

/// The pictures made so far.
#[derive(Default)]
pub struct Thumbnails {
    made: HashMap<Of, Made>,
}

impl Thumbnails {
    /// The picture of what is listed by this id, `size` points wide; `None` while `answers` has none.
    pub fn of_listed(
        &mut self,
        ctx: &Context,
        (id, material): (&'static str, &Material),
        size: f32,
        answers: &mut Answers,
    ) -> Option<TextureId> {
        let of = Of::Listed(id);
        if let Some(made) = self.made.get(&of) {
            return Some(made.texture.id());
        }
        let picture = answers.of_listed(id, material, request(ctx, size))?;
        Some(self.made(ctx, of, picture))
    }

    /// The picture of a material of the session, `size` points wide; while the one of its present parameters is made, the one
    /// of those before.
    pub fn of_entry(
        &mut self,
        ctx: &Context,
        entry: &MaterialEntry,
        size: f32,
        answers: &mut Answers,
    ) -> Option<TextureId> {
        let of = Of::Entry(entry.id());
        if let Some(picture) = answers.of_material(entry, request(ctx, size)) {
            return Some(self.made(ctx, of, picture));
        }
        self.made.get(&of).map(|made| made.texture.id())
    }

    /// Forgets the pictures of materials that are no longer there.
    pub fn keep_those_of(&mut self, materials: &Materials) {
        self.made.retain(|of, _| match of {
            Of::Listed(_) => true,
            Of::Entry(id) => materials.get(*id).is_some(),
        });
    }

    /// The texture of `picture`, made anew where it is another than before.
    fn made(&mut self, ctx: &Context, of: Of, picture: Arc<Picture>) -> TextureId {
        let options = TextureOptions::LINEAR;
        let made = self.made.entry(of).or_insert_with(|| Made {
            texture: ctx.load_texture("thumbnail", image(&picture), options),
            picture: Arc::clone(&picture),
        });
        if !Arc::ptr_eq(&made.picture, &picture) {
            made.texture.set(image(&picture), options);
            made.picture = picture;
        }
        made.texture.id()
    }
}

/// Draws a picture into `rect`.
pub fn paint(ui: &Ui, rect: Rect, texture: TextureId, tint: Color32) {
    let whole = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
    ui.painter().image(texture, rect, whole, tint);
}

fn request(ctx: &Context, size: f32) -> Request {
    let pixels = (size * ctx.pixels_per_point()).round() as usize;
    Request {
        side: pixels.clamp(1, MAX_SIDE),
    }
}

fn image(picture: &Picture) -> ColorImage {
    let pixels = picture.pixels.iter();
    let colors =
        pixels.map(|[r, g, b, coverage]| theme::color_of_radiance([*r, *g, *b], *coverage));
    ColorImage::new([picture.width, picture.height], colors.collect())
}

#[cfg(test)]
mod tests {
    use std::time::{Duration, Instant};

    use egui::RawInput;

    use super::*;
    use bxdf::material::library;
    use bxdf_study::parallel::Pool;
    use bxdf_study::platform;
    use bxdf_study::session::Session;

    /// Which of the first two pictures are there in the next frame.
    fn made(ctx: &Context, thumbnails: &mut Thumbnails, answers: &mut Answers) -> [bool; 2] {
        answers.begin_frame(&Session::default());
        let mut made = [false; 2];
        let mut output = ctx.run_ui(RawInput::default(), |ui| {
            let [first, second] = [&library::all()[0], &library::all()[1]];
            made = [first, second].map(|named| {
                let listed = (named.id, &named.material);
                thumbnails
                    .of_listed(ui.ctx(), listed, 36.0, answers)
                    .is_some()
            });
        });
        // egui insists that somebody takes them.
        output.textures_delta.clear();
        made
    }

    /// The frames in which they come into sight wait for none of them; and where nothing waits they are all there.
    #[test]
    fn pictures_come_from_the_workers_or_all_at_once() {
        let ctx = Context::default();
        let all = [true; 2];
        let mut at_once = (Thumbnails::default(), Answers::at_once());
        assert_eq!(made(&ctx, &mut at_once.0, &mut at_once.1), all);
        let mut thumbnails = Thumbnails::default();
        let mut answers = Answers::new(Some(platform::seconds), Pool::new(), || {});
        assert_eq!(made(&ctx, &mut thumbnails, &mut answers), [false; 2]);
        // Nobody is told to wait for them.
        assert!(answers.shown().is_some());
        let begin = Instant::now();
        while made(&ctx, &mut thumbnails, &mut answers) != all {
            assert!(begin.elapsed() < Duration::from_mins(1));
            std::thread::sleep(Duration::from_millis(1));
        }
    }

    /// Where there are no threads each has a frame for itself.
    #[test]
    fn pictures_come_once_nothing_moves_without_threads() {
        let ctx = Context::default();
        let mut thumbnails = Thumbnails::default();
        let mut answers = Answers::new(Some(platform::seconds), Pool::at_once(), || {});
        let mut count = || {
            let made = made(&ctx, &mut thumbnails, &mut answers);
            made.iter().filter(|is| **is).count()
        };
        assert_eq!([count(), count()], [0, 0]);
        std::thread::sleep(std::time::Duration::from_millis(200));
        let counts = [(); 3].map(|()| count());
        assert!(counts.is_sorted() && counts[0] >= 1, "{counts:?}");
        assert_eq!(counts[2], 2);
    }
}
