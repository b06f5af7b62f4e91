//! A picture of the application, before it is drawn, and who draws it.

use std::pin::Pin;

use egui::{ColorImage, Theme};

use crate::theme;
use bxdf::error::Result;
use bxdf_study::colors;
use bxdf_study::export::Format;
use bxdf_study::export::figure::{Page, Use};
use bxdf_study::session::{Session, ViewId};

/// A picture to be made.
#[derive(Clone)]
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
    /// What makes a figure of it, where it is one; else it is a copy of what is on the screen.
    pub figure: Option<Figure>,
}

/// What makes a figure of the picture of a view.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    /// What it says above the view.
    pub title: Title,
    /// The page, where it is not as large as on the screen.
    pub page: Option<Page>,
}

/// What a figure says above the view.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum Title {
    /// What is shown, of which materials, for which directions.
    #[default]
    Automatic,
    /// These words in place of those for what is shown.
    Own(String),
    /// Nothing.
    None,
}

/// How large a view is on the screen: its size in points, and pixels per point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OnScreen {
    /// Width and height in points.
    pub size: [u32; 2],
    /// Pixels per point.
    pub scale: f32,
}

impl Picture {
    /// A view of `session` as a figure for this use; `screen`: how large it is on the screen.
    #[must_use]
    pub fn of_figure(
        session: Session,
        view: ViewId,
        (purpose, title, theme): (Use, Title, colors::Theme),
        screen: OnScreen,
    ) -> Self {
        let page = purpose.spec().page;
        let OnScreen { size, scale } = page.map_or(screen, |page| OnScreen {
            size: page.size.map(|points| points as u32),
            scale: page.scale() as f32,
        });
        Self {
            session,
            only: Some(view),
            size,
            scale,
            theme: theme::as_drawn(theme),
            figure: Some(Figure { title, page }),
        }
    }
}

/// Puts a picture into the clipboard.
pub type PutPicture = Box<dyn FnMut(&egui::Context, ColorImage) -> Result<()>>;

/// What is being made: in a browser it has to be waited for.
pub type InMaking<T> = Pin<Box<dyn Future<Output = Result<T>>>>;

/// What makes files of pictures: the application that a picture shows is made by it, and not known here.
#[derive(Clone, Copy)]
pub struct Maker {
    /// Makes the file of what a picture shows.
    pub file: fn(Picture, Format) -> InMaking<Vec<u8>>,
    /// Draws a picture.
    pub image: fn(Picture) -> InMaking<ColorImage>,
}
