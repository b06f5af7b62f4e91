//! The window, and pictures of it. The only module that knows egui.

#[doc = include_str!("DECISIONS.md")]
pub mod decisions {}

pub mod app;
#[cfg(not(target_arch = "wasm32"))]
mod clipboard;
pub mod commands;
#[cfg(not(target_arch = "wasm32"))]
mod dialogs;
pub mod export;
pub mod headless;
pub mod pacing;
pub mod scene3d;
mod screens;
mod shell;
mod side;
pub mod theme;
pub mod tiles;
pub mod views;
pub mod widgets;
#[cfg(not(target_arch = "wasm32"))]
mod window;

#[cfg(not(target_arch = "wasm32"))]
pub use window::run;
