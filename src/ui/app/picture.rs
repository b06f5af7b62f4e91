//! A picture of the application, before it is drawn, and who draws it.

use egui::{ColorImage, Theme};

use bxdf::error::Result;
use bxdf_study::export::Format;
use bxdf_study::session::{Session, ViewId};

/// A picture to be made.
pub struct Picture {
    /// What to show.
    pub session: Session,
    /// The view to show alone; the whole window if absent.
    pub only: Option<ViewId>,
    /// Width and height in points.
    pub size: [u32; 2],
    /// Pixels per point.
    pub scale: f32,
    /// Dark or light.
    pub theme: Theme,
}

/// Puts a picture into the clipboard.
pub type PutPicture = Box<dyn FnMut(&egui::Context, ColorImage) -> Result<()>>;

/// What makes files of pictures: the application that a picture shows is made by it, and not known here.
#[derive(Clone, Copy)]
pub struct Maker {
    /// Makes the file of what a picture shows.
    pub file: fn(Picture, Format) -> Result<Vec<u8>>,
    /// Draws a picture.
    pub image: fn(Picture) -> Result<ColorImage>,
}
