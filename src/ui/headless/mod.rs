//! Pictures of the window without a display: the same `App`, driven step by step.

use egui_kittest::{Harness, HarnessBuilder};

use super::app::App;
pub use super::app::{Figure, OnScreen, Picture, Title};
use bxdf::error::{Error, Result};
#[cfg(not(target_arch = "wasm32"))]
use bxdf_study::lessons::Lesson;

#[cfg(not(target_arch = "wasm32"))]
mod adapter;
#[cfg(target_arch = "wasm32")]
#[path = "adapter_of_page.rs"]
mod adapter;
mod controls;
mod page;

#[cfg(target_arch = "wasm32")]
pub use adapter::draw_with;
#[cfg(not(target_arch = "wasm32"))]
pub use adapter::{NO_ADAPTER_REMEDY, backends_with_adapter};
pub use controls::unknown_controls;

/// The most frames a picture takes to settle: layout needs two or three.
const MAX_FRAMES: u64 = 32;

impl Picture {
    /// Draws the picture, as the bytes of a PNG file.
    ///
    /// # Errors
    /// [`Error::Platform`] without a graphics adapter, or where it fails.
    pub(crate) async fn png(self) -> Result<Vec<u8>> {
        let page = self.figure.as_ref().and_then(|figure| figure.page);
        let image = self.drawn_image().await?;
        let width = page.and_then(|page| page.print_width_mm);
        encoded(
            &image,
            width.map(|mm| f64::from(image.width()) / (1e-3 * mm)),
        )
    }

    /// Draws the picture.
    ///
    /// # Errors
    /// [`Error::Platform`] without a graphics adapter, or where it fails.
    #[cfg(not(target_arch = "wasm32"))]
    pub fn image(self) -> Result<image::RgbaImage> {
        pollster::block_on(self.drawn_image())
    }

    /// [`Self::image`], which in a browser has to be waited for.
    pub(crate) async fn drawn_image(self) -> Result<image::RgbaImage> {
        rendered(&mut self.drawn()?).await
    }

    /// Draws the window with the panel of a lesson open at the step at index `step`, which comes in place of the session, as
    /// the bytes of a PNG file.
    ///
    /// # Errors
    /// [`Error::Platform`] without a graphics adapter, or where it fails.
    #[cfg(not(target_arch = "wasm32"))]
    pub fn png_of_lesson(self, lesson: &Lesson, step: usize) -> Result<Vec<u8>> {
        let mut harness = self.settled(|app| app.for_picture(None))?;
        harness.state_mut().open_lesson(lesson, step);
        harness.run_ok();
        encoded(&pollster::block_on(rendered(&mut harness))?, None)
    }

    /// The running application behind the picture, settled, which can draw it: as pictures are, without what is there for a
    /// hand alone.
    ///
    /// # Errors
    /// [`Error::Platform`] without a graphics adapter.
    pub fn drawn(self) -> Result<Harness<'static, App>> {
        let figure = self.figure.clone();
        let mut harness = self.settled(|app| app.for_picture(figure.as_ref()))?;
        page::fit(&mut harness, figure.as_ref());
        Ok(harness)
    }

    /// The running application behind the picture, settled, on a machine that need not be able to draw: what it paints is
    /// there as shapes.
    #[must_use]
    pub fn shapes(self) -> Harness<'static, App> {
        let figure = self.figure.clone();
        let mut harness = self.undrawn(|app| app.for_picture(figure.as_ref()));
        page::fit(&mut harness, figure.as_ref());
        harness
    }

    /// The running application, settled, as a hand finds it at the screen, on a machine that need not be able to draw.
    #[must_use]
    pub fn controls(self) -> Harness<'static, App> {
        self.undrawn(|app| app)
    }

    fn undrawn(self, prepare: impl FnOnce(App) -> App) -> Harness<'static, App> {
        let builder = self.builder();
        let mut harness =
            builder.build_eframe(|cc| prepare(App::new(cc, self.session, self.only, None)));
        harness.run_ok();
        harness
    }

    fn builder(&self) -> HarnessBuilder<App> {
        let [width, height] = self.size.map(|points| points as f32);
        Harness::builder()
            .with_size(egui::vec2(width, height))
            .with_pixels_per_point(self.scale)
            .with_theme(self.theme)
            .with_max_steps(MAX_FRAMES)
            .with_render_cursor(false)
            // What no font has is a box, as in the window: people name their materials in every script.
            .allow_missing_glyphs()
    }

    /// The running application behind the picture, settled; tests drive it on.
    ///
    /// # Errors
    /// [`Error::Platform`] without a graphics adapter.
    pub fn harness(self) -> Result<Harness<'static, App>> {
        self.settled(|app| app)
    }

    fn settled(self, prepare: impl FnOnce(App) -> App) -> Result<Harness<'static, App>> {
        let builder = adapter::drawing(self.builder())?;
        let mut harness =
            builder.build_eframe(|cc| prepare(App::new(cc, self.session, self.only, None)));
        harness.run_ok();
        Ok(harness)
    }
}

/// Draws what an application shows.
///
/// # Errors
/// [`Error::Platform`] where the adapter fails.
pub(crate) async fn rendered(harness: &mut Harness<'_, App>) -> Result<image::RgbaImage> {
    let rendered = harness.render();
    let read = adapter::read(rendered).await;
    read.map_err(|problem| Error::Platform {
        problem: format!("the picture cannot be drawn: {problem}"),
        remedy: "a smaller size may do".to_owned(),
    })
}

/// A picture as the bytes of a PNG file; `density`: its pixels per metre in print, where it has a size there.
///
/// # Errors
/// [`Error::Platform`] where it cannot be encoded.
pub fn encoded(image: &image::RgbaImage, density: Option<f64>) -> Result<Vec<u8>> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, image.width(), image.height());
    encoder.set_color(png::ColorType::Rgba);
    encoder.set_compression(png::Compression::Fast);
    encoder.set_pixel_dims(density.map(|density| {
        let per_metre = density.round() as u32;
        png::PixelDimensions {
            xppu: per_metre,
            yppu: per_metre,
            unit: png::Unit::Meter,
        }
    }));
    let written = encoder.write_header().and_then(|mut writer| {
        writer.write_image_data(image)?;
        writer.finish()
    });
    written.map_err(|error| Error::Platform {
        problem: format!("the picture cannot be encoded: {error}"),
        remedy: "a smaller size may do".to_owned(),
    })?;
    Ok(bytes)
}
