//! The explorer as a page in a browser: the same application, with what a page has in place of a window, of files and of
//! dialogs. For any other target the package is empty.

#![cfg(target_arch = "wasm32")]

#[doc = include_str!("DECISIONS.md")]
pub mod decisions {}

mod dialogs;
mod files;
mod page;
mod probe;

use wasm_bindgen::prelude::*;
use web_sys::HtmlCanvasElement;

use page::Page;

/// Starts the explorer on a canvas. `number`: which of the pages of this browser it is, from 1 on; 0 where that is not known.
///
/// # Errors
/// Where the browser can draw neither by WebGPU nor by WebGL 2.
#[wasm_bindgen]
pub async fn start(canvas: HtmlCanvasElement, number: u32) -> Result<(), JsValue> {
    let runner = eframe::WebRunner::new();
    let create = Box::new(move |cc: &eframe::CreationContext<'_>| {
        let page: Box<dyn eframe::App> = Box::new(Page::new(cc, number));
        Ok(page)
    });
    runner
        .start(canvas, eframe::WebOptions::default(), create)
        .await?;
    page::keep_when_left(&runner)
}
