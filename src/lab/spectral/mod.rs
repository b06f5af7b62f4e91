//! Light by wavelength: optical constants of substances, and the colour that a spectrum has.

mod channels;
mod colour;
mod constants;
mod interface;
mod table;

pub use channels::MATCHED_DEG;
pub use colour::{FINEST, RANGE_NM, rgb_weights, white_chromaticity};
pub use constants::{Constants, agrees, colour, find, metals};
pub use interface::{AtWavelength, OverWavelength, OverWavelengths};
