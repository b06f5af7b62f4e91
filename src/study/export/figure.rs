//! Figures: what a picture of one view is made for, and what follows from that.

use serde::{Deserialize, Serialize};

use crate::colors::Theme;

/// What a picture is made for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Use {
    /// A slide of a talk.
    Slide,
    /// A column of a printed page.
    Column,
    /// A page of the web.
    #[default]
    Web,
    /// What is on the screen, as large as it is there.
    Screen,
}

/// What there is to say of a use.
pub struct UseSpec {
    /// The use.
    pub purpose: Use,
    /// The word for it on the command line.
    pub id: &'static str,
    /// The name at the screen.
    pub title: &'static str,
    /// Its size, in words.
    pub meaning: &'static str,
    /// The page; where there is none, whoever asks has a size.
    pub page: Option<Page>,
}

/// The page that a figure is drawn on. Its texts have the sizes of the window's, in points of the page: no text of 11.5
/// points, the smallest there, is lower than 1/35 of a page of 402 points, nor than 7 printed points in a column of 409.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Page {
    /// Width and height in points, the most where the page is cut to what it shows.
    pub size: [f64; 2],
    /// Width of the picture in pixels, where the page is as wide as that.
    pub pixels: f64,
    /// Which sides are cut to what there is to see.
    pub cut: Cut,
    /// The width in print, in millimetres, where it has one.
    pub print_width_mm: Option<f64>,
}

/// Which sides of a page are cut to what there is to see.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cut {
    /// None: what there is fills the page.
    None,
    /// The height; it may be more than that of the page, too.
    Height,
    /// Both.
    Both,
}

/// Every use, in the order of the window.
pub static USES: [UseSpec; 4] = [
    UseSpec {
        purpose: Use::Slide,
        id: "slide",
        title: "Slide",
        meaning: "1920 × 1080 pixels, for a projector",
        page: Some(Page {
            size: [704.0, 396.0],
            pixels: 1920.0,
            cut: Cut::None,
            print_width_mm: None,
        }),
    },
    UseSpec {
        purpose: Use::Column,
        id: "column",
        title: "Column",
        meaning: "88 mm wide, for a column of print, no text below 7 points; as a picture 600 dots per inch",
        page: Some(Page {
            size: [400.0, 300.0],
            pixels: 2079.0,
            cut: Cut::Height,
            print_width_mm: Some(88.0),
        }),
    },
    UseSpec {
        purpose: Use::Web,
        id: "web",
        title: "Web",
        meaning: "At most 640 × 400 points at two pixels each, for a page or a text",
        page: Some(Page {
            size: [640.0, 400.0],
            pixels: 1280.0,
            cut: Cut::Both,
            print_width_mm: None,
        }),
    },
    UseSpec {
        purpose: Use::Screen,
        id: "screen",
        title: "As on screen",
        meaning: "In the size that the view has in the window",
        page: None,
    },
];

impl Use {
    /// What there is to say of it.
    #[must_use]
    pub fn spec(self) -> &'static UseSpec {
        let [slide, column, web, screen] = &USES;
        match self {
            Self::Slide => slide,
            Self::Column => column,
            Self::Web => web,
            Self::Screen => screen,
        }
    }

    /// The theme where none is chosen: figures are for paper and for bright rooms.
    #[must_use]
    pub fn theme(self) -> Theme {
        match self.spec().page {
            Some(_) => Theme::Light,
            None => Theme::default(),
        }
    }
}

impl Page {
    /// Pixels for each point of the page.
    #[must_use]
    pub fn scale(&self) -> f64 {
        let [width, _] = self.size;
        self.pixels / width
    }
}

/// How figures are made: what a person chose last.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct FigureChoice {
    /// What for.
    pub purpose: Use,
    /// Dark or light.
    pub theme: Theme,
    /// Whether it says above what it shows.
    pub has_title: bool,
}

impl Default for FigureChoice {
    fn default() -> Self {
        let purpose = Use::default();
        Self {
            purpose,
            theme: purpose.theme(),
            has_title: true,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The smallest text of the window, in points.
    const SMALLEST: f64 = 11.5;

    #[test]
    fn uses_are_found_by_themselves_and_their_texts_are_legible() {
        for spec in &USES {
            assert!(std::ptr::eq(spec.purpose.spec(), spec), "{}", spec.id);
            let Some(page) = spec.page else { continue };
            let [width, height] = page.size;
            match page.print_width_mm {
                Some(mm) => {
                    let printed = SMALLEST * mm / 25.4 * 72.0 / width;
                    assert!(printed >= 7.0, "{}: {printed} points", spec.id);
                    let dots = page.pixels / (mm / 25.4);
                    assert!((dots - 600.0).abs() < 0.5, "{}: {dots} dots", spec.id);
                }
                None => assert!(35.0 * SMALLEST >= height, "{}: {height}", spec.id),
            }
        }
        let slide = Use::Slide.spec().page.unwrap();
        assert!((slide.size[1] * slide.scale() - 1080.0).abs() < 1e-9);
    }
}
