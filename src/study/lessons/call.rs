//! A quantity as an expression asks for it.

use std::fmt;

use bxdf_lab::quantities::{Given, Quantity};

/// A quantity with what is given, and where.
#[derive(Clone)]
pub(super) struct Call {
    pub(super) quantity: &'static Quantity,
    pub(super) given: Vec<Given>,
    pub(super) settings: Vec<Setting>,
}

impl PartialEq for Call {
    fn eq(&self, other: &Self) -> bool {
        self.quantity.id == other.quantity.id
            && self.given == other.given
            && self.settings == other.settings
    }
}

impl fmt::Debug for Call {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{}{:?} at {:?}",
            self.quantity.id, self.given, self.settings
        )
    }
}

/// What is other than in the state, where a quantity is asked for.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Setting {
    pub(super) name: String,
    pub(super) value: Given,
}
