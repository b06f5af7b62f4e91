//! Parts of the window that are no view.

pub mod badges;
pub mod chart;
pub mod choice;
pub mod components;
pub mod deltas;
pub mod directions;
pub mod draw;
pub mod help;
pub mod layouts;
pub mod legend;
pub mod materials;
pub mod notice;
pub mod options;
pub mod params;
pub mod picker;
pub mod pictures;
pub mod search;
pub mod shares;
pub mod status;
pub mod thumbnails;
