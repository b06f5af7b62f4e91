//! The window, and pictures of it. The only module that knows egui.

pub mod app;
pub mod commands;
pub mod data;
pub mod export;
pub mod format;
pub mod headless;
pub mod history;
pub mod jobs;
pub mod measured;
pub mod memo;
pub mod number;
pub mod pacing;
pub mod platform;
pub mod scene3d;
pub mod session;
pub mod store;
pub mod theme;
pub mod tiles;
pub mod views;
pub mod widgets;
#[cfg(not(target_arch = "wasm32"))]
mod window;

#[cfg(not(target_arch = "wasm32"))]
pub use window::run;
