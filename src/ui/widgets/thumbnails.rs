//! Small pictures of the named materials, asked for when they first come into sight.

use std::collections::HashMap;

use egui::{ColorImage, Context, TextureHandle, TextureId, TextureOptions};

use crate::theme;
use bxdf::material::library::Named;
use bxdf_lab::analysis::thumbnail::{Picture, Request};
use bxdf_study::answers::Answers;

/// The most pixels along a side: more show nothing more.
const MAX_SIDE: usize = 48;

/// The pictures made so far.
#[derive(Default)]
pub struct Thumbnails {
    textures: HashMap<&'static str, TextureHandle>,
}

impl Thumbnails {
    /// The picture of `named`; `None` while `data` has none.
    pub fn get(
        &mut self,
        ctx: &Context,
        named: &'static Named,
        answers: &mut Answers,
    ) -> Option<TextureId> {
        if let Some(texture) = self.textures.get(named.id) {
            return Some(texture.id());
        }
        let pixels = (theme::THUMBNAIL_SIZE * ctx.pixels_per_point()).round() as usize;
        let side = pixels.clamp(1, MAX_SIDE);
        let picture = answers.of_named(named, Request { side })?;
        let texture = ctx.load_texture(named.id, image(&picture), TextureOptions::LINEAR);
        let id = texture.id();
        self.textures.insert(named.id, texture);
        Some(id)
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
            made = [first, second].map(|named| thumbnails.get(ui.ctx(), named, answers).is_some());
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
    fn pictures_come_one_a_frame_without_threads() {
        let ctx = Context::default();
        let mut thumbnails = Thumbnails::default();
        let mut answers = Answers::new(Some(platform::seconds), Pool::at_once(), || {});
        let frames = [(); 3].map(|()| made(&ctx, &mut thumbnails, &mut answers));
        assert_eq!(
            frames.map(|made| made.iter().filter(|is| **is).count()),
            [0, 1, 2]
        );
    }
}
