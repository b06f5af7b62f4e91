//! What the title of a figure says of a view.

use crate::session::Session;

/// What the title of a figure says of a view.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Caption {
    /// What is shown, with its unit.
    pub quantity: String,
    /// Where the materials are named.
    pub names: Subjects,
    /// Which directions it is shown at.
    pub directions: Directions,
}

/// Where the materials of a view are named.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Subjects {
    /// They share one picture, told apart by their lines: in the title.
    Lines,
    /// They share one picture, told apart by their colours: in the title.
    Colors,
    /// Each has a picture or a row of its own: there, where there are several.
    Apart,
    /// They share one picture, with a legend of its own where there are several: there.
    Legend,
    /// The selected one is all that is shown.
    Selected,
    /// It is of no material.
    None,
}

/// The directions that a view is shown at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Directions {
    /// Light and viewer.
    Both,
    /// The held one.
    Held,
    /// None of them.
    None,
}

impl Caption {
    /// Of a view in which all materials share one picture, with light and viewer.
    pub(super) fn of(quantity: impl Into<String>) -> Self {
        Self {
            quantity: quantity.into(),
            names: Subjects::Lines,
            directions: Directions::Both,
        }
    }

    /// Of a view in which materials are named so.
    pub(super) fn naming(mut self, names: Subjects) -> Self {
        self.names = names;
        self
    }

    /// Of a view at these directions.
    pub(super) fn at(mut self, directions: Directions) -> Self {
        self.directions = directions;
        self
    }
}

/// f, with the cosine where the session says so, and its unit.
#[must_use]
pub fn value_of_f(session: &Session) -> &'static str {
    if session.with_cosine {
        "f |cos θ| (1/sr)"
    } else {
        "f (1/sr)"
    }
}
