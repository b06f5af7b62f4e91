//! The integral over the hemisphere, patch by patch.

use serde::{Deserialize, Serialize};

use super::caption::{Caption, Directions, Subjects};
use super::kind::{Deltas, TableKind, ViewKind, ViewOptions};
use crate::answers::Answers;
use crate::export::names::{self, Names};
use crate::export::table::{Table, Value, shown};
use crate::number::{NumberSpec, Numbers, Refused};
use crate::session::Session;
use bxdf_lab::analysis::Channel;
use bxdf_lab::analysis::integral::{COUNT_LOG2, ExactRequest, Integrand, Request};

pub(super) const KIND: ViewKind = ViewKind {
    id: "integral",
    title: "Integral",
    what_you_see: "The hemisphere in patches of equal solid angle, each over its shadow on the \
        disc: a bar fills with their sum towards the exact integral",
    says_hidden: true,
    deltas: Deltas::Marked,
    with_cosine: false,
    table: TableKind::Computed,
    is_mesh: false,
};

/// The number of patches on a side as a power of 2.
pub static PATCHES_LOG2: NumberSpec = NumberSpec::new(
    "integral.count_log2",
    [COUNT_LOG2[0] as f64, COUNT_LOG2[1] as f64],
)
.whole();

/// How long it takes to play, in seconds.
pub static SECONDS: NumberSpec = NumberSpec::new("integral.seconds", [1.0, 60.0]).unit("seconds");

/// What is summed, and how it is played.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Options {
    /// What is summed.
    pub integrand: Integrand,
    /// The number of patches on a side, as a power of 2.
    pub count_log2: u8,
    /// How long it takes to play, in seconds.
    pub seconds: f64,
    /// Whether colours go by decades.
    pub is_logarithmic: bool,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            integrand: Integrand::default(),
            count_log2: 8,
            seconds: 8.0,
            is_logarithmic: false,
        }
    }
}

impl Options {
    /// The sum: over the whole sphere where the views show what is below the surface.
    #[must_use]
    pub fn request(&self, session: &Session) -> Request {
        let [least, most] = COUNT_LOG2;
        Request {
            integrand: self.integrand,
            count_log2: self.count_log2.clamp(least, most),
            is_sphere: session.shows_lower_half(),
        }
    }

    /// What the sum comes near to.
    #[must_use]
    pub fn exact_request(&self, session: &Session) -> ExactRequest {
        ExactRequest {
            integrand: self.integrand,
            is_sphere: session.shows_lower_half(),
        }
    }
}

impl Options {
    /// What is summed, with its unit.
    #[must_use]
    pub fn quantity_name(&self) -> String {
        names::with_unit(self.integrand.title(), self.integrand.unit())
    }
}

impl ViewOptions for Options {
    fn caption(&self, _: &Session) -> Caption {
        let caption = Caption::of(format!("sum of {}", self.quantity_name()));
        if self.is_of_held() {
            caption.naming(Subjects::Apart).at(Directions::Held)
        } else {
            caption.naming(Subjects::None).at(Directions::None)
        }
    }

    fn is_of_held(&self) -> bool {
        self.integrand.is_of_surface()
    }

    fn numbers(&mut self) -> Numbers<'_> {
        vec![(&SECONDS, &mut self.seconds)]
    }

    fn check_whole(&self) -> Result<(), Refused> {
        PATCHES_LOG2.checked(f64::from(self.count_log2)).map(|_| ())
    }

    /// The patches and the deltas, each with what it adds to the sum that is shown.
    fn table(&self, session: &Session, answers: &mut Answers) -> Table {
        let (integrand, request) = (self.integrand, self.request(session));
        let names = Names::new(integrand.id(), integrand.unit(), self.is_logarithmic);
        let first = [
            "material",
            "w_x",
            "w_y",
            "w_z",
            "solid_angle (sr)",
            "shadow",
        ];
        let mut columns = names.columns(&first);
        columns.push("part_luminance".to_owned());
        let mut table = Table::named(columns);
        for (entry, title) in shown(session) {
            let sum = answers.ask(session, entry, request);
            let parts = sum.parts.iter().map(|part| {
                let sizes = [part.patch.solid_angle(), part.patch.shadow()];
                let values: Vec<f64> = names::value(part.value).collect();
                (part.patch.middle(), sizes, values, part.share())
            });
            let points = sum.deltas.iter().map(|point| {
                let values: Vec<f64> = names::delta(point.share).collect();
                (point.direction, [f64::NAN; 2], values, point.share)
            });
            for (w, sizes, values, share) in parts.chain(points) {
                let numbers = w.to_array().into_iter().chain(sizes).chain(values);
                let share = Channel::Luminance.of(share);
                let numbers = numbers.chain([share]).map(Value::Number);
                let row = [Value::Text(title.clone())].into_iter().chain(numbers);
                table.rows.push(row.collect());
            }
        }
        table
    }
}
