//! A section of the lobes.

use serde::{Deserialize, Serialize};

use super::caption::{Caption, Subjects, value_of_f};
use super::kind::{Deltas, TableKind, ViewKind, ViewOptions};
use super::scale::{Arrangement, Scale};
use super::section::OwnSection;
use crate::answers::Answers;
use crate::export::names::Names;
use crate::export::table::{Table, shown};
use crate::format;
use crate::number::Numbers;
use crate::session::Session;
use bxdf_lab::analysis::polar::{Point, Request};

pub(super) const KIND: ViewKind = ViewKind {
    id: "polar",
    title: "Polar plot",
    what_you_see: "A section of the lobe through the normal n: the length of a ray is the \
        value f in its direction",
    says_hidden: false,
    deltas: Deltas::Marked,
    with_cosine: true,
    table: TableKind::Computed,
    is_mesh: false,
};

/// Which section is shown, and how.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Options {
    /// How values become radii.
    #[serde(skip_serializing_if = "Scale::is_first")]
    pub scale: Scale,
    /// How several materials stand.
    #[serde(skip_serializing_if = "Arrangement::is_first")]
    pub arrangement: Arrangement,
    /// A section of its own.
    #[serde(skip_serializing_if = "OwnSection::is_absent")]
    pub own_section_deg: OwnSection,
}

impl Options {
    /// The section.
    #[must_use]
    pub fn request(&self, session: &Session) -> Request {
        Request {
            phi: self.own_section_deg.of(session).phi(),
            with_cosine: session.with_cosine,
            scale: self.scale.lengths,
        }
    }
}

impl ViewOptions for Options {
    fn caption(&self, session: &Session) -> Caption {
        let section = self.own_section_deg.of(session);
        let azimuth = format::degrees(section.azimuth_deg);
        let value = value_of_f(session);
        Caption::of(format!("{value} in the section at azimuth {azimuth}"))
            .naming(self.arrangement.subjects(Subjects::Lines))
    }

    fn own_section(&mut self) -> Option<&mut OwnSection> {
        Some(&mut self.own_section_deg)
    }

    fn radial_scale(&mut self) -> Option<&mut Scale> {
        Some(&mut self.scale)
    }

    fn arrangement(&mut self) -> Option<&mut Arrangement> {
        Some(&mut self.arrangement)
    }

    fn numbers(&mut self) -> Numbers<'_> {
        let mut all = self.scale.numbers();
        all.extend(self.own_section_deg.number());
        all
    }

    /// The section.
    fn table(&self, session: &Session, answers: &mut Answers) -> Table {
        let columns = ["material", "angle (degrees)"];
        let mut table = Table::named(Names::of_lobe(session, self.scale).columns(&columns));
        for (entry, title) in shown(session) {
            let section = answers.ask(session, entry, self.request(session));
            for Point { angle, value } in section.lower.iter().chain(&section.upper) {
                table.push_value(&title, [angle.to_degrees()], *value);
            }
            table.push_stems(&title, &section.stems);
        }
        table
    }
}
