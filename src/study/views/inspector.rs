//! Every number at the cursor.

use super::kind::ViewKind;

pub(super) const KIND: ViewKind = ViewKind {
    id: "inspector",
    title: "Inspector",
    is_of_held: |_| true,
    what_you_see: "Every material's numbers at the held direction and the one last pointed at \
        in any view; at first the mirror direction",
    table: None,
    is_mesh: false,
};
