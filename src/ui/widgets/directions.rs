//! The controls of the fixed direction and of the turn of the surface.

use egui::{Key, TextStyle, Ui};

use crate::widgets::choice::width_of;
use crate::widgets::covered;
use crate::widgets::hint::at_number;
use crate::widgets::number::Number;
use bxdf_lab::analysis::Hold;
use bxdf_study::lessons::Cover;
use bxdf_study::number::NumberSpec;
use bxdf_study::session::{PHI, ROTATION, Session};

/// An angle of the session.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Angle {
    /// The polar angle of the fixed direction.
    Theta,
    /// Its azimuth.
    Phi,
    /// By how much the surface is turned.
    Turn,
}

impl Angle {
    /// Every angle, in the order of the bar.
    pub const ALL: [Self; 3] = [Self::Theta, Self::Phi, Self::Turn];

    /// Its short name, which stands before it.
    #[must_use]
    pub const fn symbol(self) -> &'static str {
        match self {
            Self::Theta => "θ",
            Self::Phi => "φ",
            Self::Turn => "Turn",
        }
    }

    /// Its name for tests and screen readers.
    const fn name(self) -> &'static str {
        match self {
            Self::Theta => "θ from n",
            Self::Phi => "φ from s",
            Self::Turn => "Rotate surface about n",
        }
    }

    fn hint(self, ui: &Ui, session: &Session) -> String {
        let held = session.held_name();
        match self {
            Self::Theta => format!("θ: polar angle of the {held} from the normal n"),
            Self::Phi => format!("φ: azimuth of the {held} from the axis s"),
            Self::Turn => format!(
                "Turns the surface with its own axes (see its brush lines) under the fixed directions and the axes s and t.\n{}",
                turning(ui, session)
            ),
        }
    }

    /// Its number, and where it stands in the session.
    fn of(self, session: &mut Session) -> (NumberSpec, &mut f64) {
        match self {
            Self::Theta => (session.theta_spec(), &mut session.theta_deg),
            Self::Phi => (PHI, &mut session.phi_deg),
            Self::Turn => (ROTATION, &mut session.rotation_deg),
        }
    }

    /// Its name, a slider of this width where there is one, and the number. The slider has steps of a tenth of a degree as long
    /// as the value has no finer digits.
    pub fn show(self, ui: &mut Ui, session: &mut Session, rail: Option<f32>) {
        let hint = self.hint(ui, session);
        let (spec, value) = self.of(session);
        let is_tenth = (*value * 10.0).fract() == 0.0;
        let step = if is_tenth { 0.1 } else { 0.0 };
        let number = Number::new(self.name(), spec).steps(step, 4);
        let label = ui.label(self.symbol()).on_hover_text(&hint).id;
        if let Some(width) = rail {
            ui.spacing_mut().slider_width = width;
            let rail = at_number(number.rail(ui, value), &hint);
            rail.labelled_by(label).accessible_name(self.name());
        }
        let shown = number.field(ui, value).on_hover_text(&hint);
        shown.explain_above(ui);
    }
}

/// The key that gives the light or the viewer the focus: I for what comes in (wi), O for what goes out (wo).
#[must_use]
pub const fn key_of(direction: Hold) -> Key {
    match direction {
        Hold::Light => Key::I,
        Hold::Viewer => Key::O,
    }
}

/// The word before [`fixed`].
const FIXED: &str = "Fixed:";

/// The two directions that may be fixed, and what is shown then.
const HELD: [(Hold, &str, &str); 2] = [
    (
        Hold::Light,
        "Light",
        "Fix the light (wi): the lobe shows where its light goes, f over all wo",
    ),
    (
        Hold::Viewer,
        "Viewer",
        "Fix the viewer (wo): the lobe shows where the light that is seen comes from, f over all wi",
    ),
];

/// The width of [`fixed`], in points.
#[must_use]
pub fn fixed_width(ui: &Ui) -> f32 {
    let spacing = ui.spacing();
    let width = |text| width_of(ui, text, &TextStyle::Body) + spacing.item_spacing.x;
    let button = spacing.icon_width + spacing.icon_spacing;
    let names = HELD.map(|(_, name, _)| width(name) + button);
    width(FIXED) + names.iter().sum::<f32>()
}

/// Which direction is fixed.
pub fn fixed(ui: &mut Ui, session: &mut Session) {
    ui.label(FIXED);
    let mut chosen = session.hold;
    for (hold, name, hint) in HELD {
        ui.radio_value(&mut chosen, hold, name).on_hover_text(hint);
    }
    session.set_hold(chosen);
}

/// What the lobe shows, in words.
#[must_use]
pub fn shown(session: &Session) -> &'static str {
    match session.hold {
        Hold::Light => "Shown: where the light goes",
        Hold::Viewer => "Shown: where the light comes from",
    }
}

/// What turning the surface does, in words; nothing where a question asks for it.
#[must_use]
pub fn turning(ui: &Ui, session: &Session) -> &'static str {
    if covered::is_covered(ui.ctx(), Cover::Turning) {
        ""
    } else if session.material().is_isotropic() {
        "Isotropic: turning it changes nothing"
    } else {
        "Anisotropic: its lobe turns with it"
    }
}
