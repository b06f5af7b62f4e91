//! Parts of the window that are no view.

pub mod badges;
pub mod chart;
pub mod choice;
pub mod components;
mod data;
pub mod deltas;
pub mod directions;
pub mod draw;
pub mod handle;
pub mod hits;
pub mod layouts;
pub mod legend;
pub mod materials;
pub mod notice;
pub mod number;
pub mod options;
pub mod params;
pub mod path_field;
pub mod picker;
pub mod pictures;
pub mod reset;
pub mod said;
pub mod saved;
pub mod search;
pub mod shares;
pub mod status;
pub mod thumbnails;
