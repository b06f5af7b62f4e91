//! The kinds of views: one file each, and the one list of them.

use serde::{Deserialize, Serialize};

use crate::answers::Answers;
use crate::export::table::Table;
use crate::number::{Numbers, Refused};
use crate::session::Session;
use bxdf::error::{Error, Result};

mod caption;
pub mod cartesian;
pub mod decomposition;
pub mod formula_card;
pub mod fresnel;
pub mod hemisphere;
pub mod inspector;
pub mod integral;
mod kind;
pub mod lobe3d;
pub mod polar;
pub mod reflectance;
pub mod sampling;
mod scale;
mod section;
pub mod slice;
pub mod sphere;
pub mod stability;
pub mod tradeoff;
mod words;

pub use caption::{Caption, Directions, Subjects, value_of_f};
pub use kind::{Deltas, TableKind, ViewKind, ViewOptions};
pub use scale::{Arrangement, DECADES, Scale, ScaleChoice};
pub use section::{OWN_SECTION, OwnSection};

/// The one list of the kinds of views, in the order of the window: gives their ids to the macro `then`, which makes of them
/// whatever there is one of for each.
#[macro_export]
macro_rules! view_kinds {
    ($then:ident) => {
        $then! {
            polar lobe3d cartesian hemisphere integral reflectance fresnel slice sphere sampling decomposition tradeoff stability inspector formula_card
        }
    };
}

macro_rules! list {
    ($($id:ident)*) => {
        /// Every kind of view, in the order of the window.
        pub static VIEWS: [ViewKind; [$(stringify!($id)),*].len()] = [$($id::KIND),*];

        /// The options of an instance of whichever kind: all that it shows besides the session.
        #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
        #[serde(tag = "kind")]
        #[expect(non_camel_case_types, reason = "each has the id of its kind")]
        pub enum Options {
            $(
                #[doc = concat!("Those of the kind `", stringify!($id), "`.")]
                $id($id::Options),
            )*
        }

        impl Options {
            /// The options that an instance of this kind has at first.
            #[must_use]
            pub fn of(kind: &ViewKind) -> Self {
                $(if kind.id == stringify!($id) {
                    return Self::$id($id::Options::default());
                })*
                unreachable!("every kind is one of the list")
            }

            /// The kind that they are of.
            #[must_use]
            pub fn kind(&self) -> &'static ViewKind {
                match self {
                    $(Self::$id(_) => &$id::KIND,)*
                }
            }

            /// See [`ViewOptions::is_of_held`].
            #[must_use]
            pub fn is_of_held(&self) -> bool {
                match self {
                    $(Self::$id(options) => options.is_of_held(),)*
                }
            }

            /// See [`ViewOptions::caption`].
            #[must_use]
            pub fn caption(&self, session: &Session) -> Caption {
                match self {
                    $(Self::$id(options) => options.caption(session),)*
                }
            }

            /// See [`ViewOptions::own_section`].
            #[must_use]
            pub fn own_section(&mut self) -> Option<&mut OwnSection> {
                match self {
                    $(Self::$id(options) => options.own_section(),)*
                }
            }

            /// See [`ViewOptions::radial_scale`].
            #[must_use]
            pub fn radial_scale(&mut self) -> Option<&mut Scale> {
                match self {
                    $(Self::$id(options) => options.radial_scale(),)*
                }
            }

            /// See [`ViewOptions::arrangement`].
            pub(crate) fn arrangement(&mut self) -> Option<&mut Arrangement> {
                match self {
                    $(Self::$id(options) => options.arrangement(),)*
                }
            }

            /// See [`ViewOptions::numbers`].
            #[must_use]
            pub fn numbers(&mut self) -> Numbers<'_> {
                match self {
                    $(Self::$id(options) => options.numbers(),)*
                }
            }

            /// See [`ViewOptions::check_whole`].
            pub(crate) fn check_whole(&self) -> std::result::Result<(), Refused> {
                match self {
                    $(Self::$id(options) => options.check_whole(),)*
                }
            }

            /// See [`ViewOptions::texts`].
            pub(crate) fn texts(&self) -> Vec<&str> {
                match self {
                    $(Self::$id(options) => options.texts(),)*
                }
            }

            /// See [`ViewOptions::table`].
            pub fn table(&self, session: &Session, answers: &mut Answers) -> Table {
                match self {
                    $(Self::$id(options) => options.table(session, answers),)*
                }
            }
        }

        $(impl OfKind for $id::Options {
            const KIND: &'static ViewKind = &$id::KIND;

            fn among(options: &Options) -> Option<&Self> {
                match options {
                    Options::$id(own) => Some(own),
                    _ => None,
                }
            }

            fn among_mut(options: &mut Options) -> Option<&mut Self> {
                match options {
                    Options::$id(own) => Some(own),
                    _ => None,
                }
            }
        }

        impl From<$id::Options> for Options {
            fn from(options: $id::Options) -> Self {
                Self::$id(options)
            }
        })*
    };
}
view_kinds!(list);

/// The options of one kind, as one of [`Options`].
pub trait OfKind: ViewOptions + Clone + Into<Options> {
    /// The kind.
    const KIND: &'static ViewKind;

    /// The options, where they are of this kind.
    fn among(options: &Options) -> Option<&Self>;

    /// The options, to be changed, where they are of this kind.
    fn among_mut(options: &mut Options) -> Option<&mut Self>;
}

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

    #[test]
    fn options_are_of_their_kind_and_say_so_in_a_file() {
        for view in &VIEWS {
            let options = Options::of(view);
            assert_eq!(options.kind().id, view.id);
            let table = toml::Table::try_from(&options).unwrap();
            assert_eq!(table["kind"].as_str(), Some(view.id));
            assert_eq!(table.try_into(), Ok(options));
        }
    }
}
