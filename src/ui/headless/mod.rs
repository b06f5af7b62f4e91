//! Pictures of the window without a display: the same `App`, driven step by step.

use eframe::egui_wgpu::{WgpuSetup, wgpu};
use egui_kittest::wgpu::default_wgpu_setup;
use egui_kittest::{Harness, HarnessBuilder};
use wgpu::Backends;

use super::app::App;
pub use super::app::{Figure, OnScreen, Picture, Title};
use bxdf::error::{Error, Result};
use bxdf_study::lessons::Lesson;

mod controls;
mod page;

pub use controls::unknown_controls;

/// The most frames a picture takes to settle: layout needs two or three.
const MAX_FRAMES: u64 = 32;

/// What helps where there is no graphics adapter.
pub const NO_ADAPTER_REMEDY: &str =
    "install a Vulkan driver; the software one is in the package mesa-vulkan-drivers";

impl Picture {
    /// Draws the picture, as the bytes of a PNG file.
    ///
    /// # Errors
    /// [`Error::Platform`] without a graphics adapter, or where it fails.
    pub fn png(self) -> Result<Vec<u8>> {
        let page = self.figure.as_ref().and_then(|figure| figure.page);
        let image = self.image()?;
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
    pub fn image(self) -> Result<image::RgbaImage> {
        rendered(&mut self.drawn()?)
    }

    /// Draws the window with the panel of a lesson open at the step at index `step`, which comes in place of the session, as
    /// the bytes of a PNG file.
    ///
    /// # Errors
    /// [`Error::Platform`] without a graphics adapter, or where it fails.
    pub fn png_of_lesson(self, lesson: &Lesson, step: usize) -> Result<Vec<u8>> {
        let mut harness = self.settled(|app| app.for_picture(None))?;
        harness.state_mut().open_lesson(lesson, step);
        harness.run_ok();
        encoded(&rendered(&mut harness)?, None)
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
        let mut setup = default_wgpu_setup();
        if let WgpuSetup::CreateNew(setup) = &mut setup {
            setup.instance_descriptor.backends = backends_with_adapter()?;
        }
        let builder = self.builder().wgpu_setup(setup);
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
pub(crate) fn rendered(harness: &mut Harness<'_, App>) -> Result<image::RgbaImage> {
    harness.render().map_err(|problem| Error::Platform {
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

/// The backends that have a graphics adapter: the modern ones if any has, so that the older ones are not even started.
///
/// # Errors
/// [`Error::Platform`] where there is none, naming the remedy.
pub fn backends_with_adapter() -> Result<Backends> {
    let instance = |backends| {
        wgpu::Instance::new(wgpu::InstanceDescriptor {
            backends,
            ..wgpu::InstanceDescriptor::new_without_display_handle()
        })
    };
    let has_adapter =
        |backends| !pollster::block_on(instance(backends).enumerate_adapters(backends)).is_empty();
    [Backends::PRIMARY, Backends::SECONDARY]
        .into_iter()
        .find(|backends| has_adapter(*backends))
        .ok_or_else(|| Error::Platform {
            problem: "no graphics adapter is found".to_owned(),
            remedy: NO_ADAPTER_REMEDY.to_owned(),
        })
}
