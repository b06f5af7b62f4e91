//! What the expressions of a text are worth, asked as views ask: it may take longer than a frame.

use std::hash::{Hash, Hasher};
use std::sync::Arc;

use rustc_hash::FxHasher;

use super::expression::Expression;
use super::scenes::Scenes;
use bxdf_lab::analysis::{Basis, Detail, IsWanted, Query, Subject};

/// The query what an expression is worth.
#[derive(Clone)]
pub struct Worth {
    /// The expression.
    pub expression: Expression,
    /// What it is asked of.
    pub scenes: Arc<Scenes>,
}

impl PartialEq for Worth {
    fn eq(&self, other: &Self) -> bool {
        let is_same = Arc::ptr_eq(&self.scenes, &other.scenes) || self.scenes == other.scenes;
        is_same && self.expression == other.expression
    }
}

impl Query for Worth {
    /// `None` before it is known; a phrase where there is no such number.
    type Answer = Option<Result<f64, String>>;

    const BASIS: Basis = Basis::Material;

    fn place(&self) -> usize {
        let mut hasher = FxHasher::default();
        self.expression.text().hash(&mut hasher);
        hasher.finish() as usize
    }

    fn answer(&self, _: &Subject<'_>, _: Detail, _: IsWanted<'_>) -> Option<Self::Answer> {
        Some(Some(self.expression.value(&self.scenes)))
    }
}
