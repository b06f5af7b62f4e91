//! The kinds of views: one file each, and the one list of them.

use bxdf::error::{Error, Result};

mod cartesian;
mod decomposition;
mod hemisphere;
mod inspector;
mod kind;
mod lobe3d;
mod polar;
mod reflectance;
mod sampling;
mod slice;
mod sphere;
mod stability;
mod tradeoff;

pub use kind::ViewKind;

/// The one list of the kinds of views, in the order of the window: gives their ids to the macro `then`, which makes of them
/// whatever there is one of for each.
#[macro_export]
macro_rules! view_kinds {
    ($then:ident) => {
        $then! {
            polar lobe3d cartesian hemisphere reflectance slice sphere sampling decomposition tradeoff stability inspector
        }
    };
}

macro_rules! list {
    ($($id:ident)*) => {
        /// Every kind of view, in the order of the window.
        pub static VIEWS: [ViewKind; [$(stringify!($id)),*].len()] = [$($id::KIND),*];
    };
}
view_kinds!(list);

/// The kind of view with this id.
///
/// # Errors
/// [`Error::UnknownId`], with the nearest ids.
pub fn find(id: &str) -> Result<&'static ViewKind> {
    VIEWS
        .iter()
        .find(|view| view.id == id)
        .ok_or_else(|| Error::unknown("view", id, VIEWS.iter().map(|view| view.id)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_is_found_by_its_file_s_name() {
        macro_rules! ids {
            ($($id:ident)*) => { [$(stringify!($id)),*] };
        }
        let ids = view_kinds!(ids);
        assert!(VIEWS.iter().map(|view| view.id).eq(ids));
        assert!(ids.iter().all(|id| find(id).is_ok()));
        assert!(find("pola").is_err_and(|error| error.to_string().contains("nearest: polar")));
    }
}
