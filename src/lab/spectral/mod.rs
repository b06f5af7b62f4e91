//! Light by wavelength: optical constants of substances, and the colour that a spectrum has.

mod colour;
mod constants;
mod table;

pub use colour::{RANGE_NM, rgb_weights, white_chromaticity};
pub use constants::{CHANNELS_NM, Constants, agrees, find};
