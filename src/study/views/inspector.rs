//! Every number at the cursor.

use serde::{Deserialize, Serialize};

use super::caption::{Caption, Subjects};
use super::kind::{Deltas, TableKind, ViewKind, ViewOptions};
use crate::session::Session;

pub(super) const KIND: ViewKind = ViewKind {
    id: "inspector",
    title: "Inspector",
    what_you_see: "Every material's numbers at the fixed direction and the one last pointed at \
        in any view; at first the mirror direction",
    says_hidden: false,
    deltas: Deltas::Marked,
    with_cosine: false,
    table: TableKind::None,
    is_mesh: false,
};

/// There is nothing to choose.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Options {}

impl ViewOptions for Options {
    fn caption(&self, _: &Session) -> Caption {
        Caption::of("values at one pair of directions").naming(Subjects::Colors)
    }
}
