//! What pictures are drawn by on a machine: an adapter of their own, a software one where there is one.

use eframe::egui_wgpu::{WgpuSetup, wgpu};
use egui_kittest::HarnessBuilder;
use egui_kittest::wgpu::default_wgpu_setup;
use image::RgbaImage;
use wgpu::Backends;

use crate::app::App;
use bxdf::error::{Error, Result};

/// What helps where there is no graphics adapter.
pub const NO_ADAPTER_REMEDY: &str =
    "install a Vulkan driver; the software one is in the package mesa-vulkan-drivers";

/// `builder`, which can draw.
///
/// # Errors
/// [`Error::Platform`] without a graphics adapter.
pub(super) fn drawing(builder: HarnessBuilder<App>) -> Result<HarnessBuilder<App>> {
    let mut setup = default_wgpu_setup();
    if let WgpuSetup::CreateNew(setup) = &mut setup {
        setup.instance_descriptor.backends = backends_with_adapter()?;
    }
    Ok(builder.wgpu_setup(setup))
}

/// What was rendered: it is there at once.
#[expect(clippy::unused_async, reason = "in a browser it has to be waited for")]
pub(super) async fn read(
    rendered: std::result::Result<RgbaImage, String>,
) -> std::result::Result<RgbaImage, String> {
    rendered
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
