//! The clipboard of the system, for pictures: egui's own says nothing where it refuses one.

use std::borrow::Cow;

use arboard::{Clipboard, ImageData};
use egui::ColorImage;

use crate::app::PutPicture;
use bxdf::error::Error;

/// Puts pictures into the clipboard of the system. It stays open: on X11 what is in it is fetched from the program itself.
#[must_use]
pub fn native() -> PutPicture {
    let mut open: Option<Clipboard> = None;
    Box::new(move |_, picture| {
        let clipboard = match &mut open {
            Some(clipboard) => clipboard,
            None => open.insert(Clipboard::new().map_err(|error| refused(&error))?),
        };
        let set = clipboard.set_image(data(&picture));
        set.map_err(|error| refused(&error))
    })
}

fn data(picture: &ColorImage) -> ImageData<'static> {
    let [width, height] = picture.size;
    let pixels = picture.pixels.iter();
    let bytes: Vec<u8> = pixels
        .flat_map(egui::Color32::to_srgba_unmultiplied)
        .collect();
    ImageData {
        width,
        height,
        bytes: Cow::from(bytes),
    }
}

fn refused(error: &arboard::Error) -> Error {
    Error::Platform {
        problem: format!("the clipboard does not take the picture: {error}"),
        remedy: "export it as a file".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::Color32;

    #[test]
    fn pixels_are_handed_over_row_by_row() {
        let pixels = vec![Color32::RED, Color32::GOLD];
        let data = data(&ColorImage::new([2, 1], pixels));
        assert_eq!((data.width, data.height), (2, 1));
        assert_eq!(*data.bytes, [255, 0, 0, 255, 255, 215, 0, 255]);
    }
}
