//! Physical check badges: which laws a material keeps, as symbols with words, and the way to where it breaks them.

use std::fmt::Write as _;

use egui::{Color32, Response, RichText, Role, Ui, WidgetInfo};

use super::{covered, small};
use crate::theme::{self, Palette};
use bxdf::Material;
use bxdf_lab::contract::{LawId, LawReport, PHYSICAL, PhysicalLaws, Status, Witness};
use bxdf_study::answers::Answers;
use bxdf_study::format;
use bxdf_study::lessons::Cover;
use bxdf_study::session::MaterialEntry;

/// What is known of a law for a material.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Finding {
    /// It holds.
    Kept,
    /// The lobe turns with the surface.
    Isotropic,
    /// The lobe does not turn with the surface.
    Anisotropic,
    /// It is being computed.
    Awaited,
    /// It breaks as the model declares.
    Declared,
    /// It breaks.
    Broken,
}

impl Finding {
    fn of(report: &LawReport) -> Self {
        match report.status {
            Status::Violated | Status::Misdeclared => Self::Broken,
            Status::Declared => Self::Declared,
            Status::Ok if report.law != LawId::Isotropy => Self::Kept,
            Status::Ok if report.worst <= report.error => Self::Isotropic,
            Status::Ok => Self::Anisotropic,
        }
    }

    /// The word for it, read out and in hints.
    const fn word(self) -> &'static str {
        match self {
            Self::Kept => "kept",
            Self::Isotropic => "isotropic",
            Self::Anisotropic => "anisotropic",
            Self::Awaited => "being computed",
            Self::Declared => "broken as published",
            Self::Broken => "broken",
        }
    }

    const fn symbol(self) -> &'static str {
        match self {
            Self::Kept => "✔",
            Self::Isotropic => "○",
            Self::Anisotropic => "↔",
            Self::Awaited => "…",
            Self::Declared => "⚠",
            Self::Broken => "✖",
        }
    }

    fn color(self, palette: &Palette) -> Color32 {
        match self {
            Self::Kept => palette.kept,
            Self::Isotropic | Self::Anisotropic | Self::Awaited => palette.faint_ink,
            Self::Declared => palette.light,
            Self::Broken => palette.warning,
        }
    }
}

/// The badges of one material, about to be shown.
pub(super) struct Badges<'a> {
    /// How the material is called.
    pub(super) title: &'a str,
    /// What was found; `None` while it is being computed.
    pub(super) reports: Option<&'a [LawReport]>,
}

impl Badges<'_> {
    fn report(&self, law: LawId) -> Option<&LawReport> {
        self.reports?.iter().find(|report| report.law == law)
    }

    fn finding(&self, law: LawId) -> Finding {
        self.report(law).map_or(Finding::Awaited, Finding::of)
    }

    /// The law that comes out worst. Isotropy is no virtue: it is named last.
    fn worst(&self) -> (LawId, Finding) {
        let found = PHYSICAL.map(|law| (law, self.finding(law)));
        let [first, others @ ..] = found;
        let worse = |a: (LawId, Finding), b: (LawId, Finding)| if b.1 > a.1 { b } else { a };
        let is_law = |(law, finding): &(LawId, Finding)| {
            *law != LawId::Isotropy || *finding == Finding::Broken
        };
        others.into_iter().filter(is_law).fold(first, worse)
    }

    /// One symbol for all laws. Returns where to go, if it is clicked.
    pub(super) fn summary(&self, ui: &mut Ui, palette: &Palette) -> Option<Witness> {
        if covered::is_covered(ui.ctx(), Cover::Laws) {
            ui.weak("–").on_hover_text(covered::WHY);
            return None;
        }
        let (law, finding) = self.worst();
        let name = match finding {
            Finding::Kept => format!("Laws of {}: kept", self.title),
            Finding::Awaited => format!("Laws of {}: being computed", self.title),
            _ => format!("Laws of {}: {} {}", self.title, law.title(), finding.word()),
        };
        let text = RichText::new(finding.symbol()).color(finding.color(palette));
        let badge = ui.add(small::button(ui, text).frame(false));
        badge.widget_info(|| WidgetInfo::labeled(Role::Button, true, &name));
        let mut hint = String::new();
        for law in PHYSICAL {
            let finding = self.finding(law);
            // Writing to a string cannot fail.
            let _ = writeln!(
                hint,
                "{}  {}: {}",
                finding.symbol(),
                law.title(),
                finding.word()
            );
        }
        hint += if finding > Finding::Awaited {
            "Click to hold the direction where it breaks most"
        } else {
            "Select it for the details"
        };
        let is_clicked = badge.on_hover_text(hint).clicked() && finding > Finding::Awaited;
        self.report(law)
            .filter(|_| is_clicked)
            .map(|report| report.witness.clone())
    }

    /// Each law as a symbol with its name. Returns where to go, if one is clicked.
    pub(super) fn all(&self, ui: &mut Ui, palette: &Palette) -> Option<Witness> {
        let mut wished = None;
        ui.horizontal_wrapped(|ui| {
            let spacing = ui.spacing_mut();
            (spacing.item_spacing, spacing.button_padding) = theme::BADGE_SPACING;
            if spacing.interact_size.y < theme::TOUCHED {
                spacing.interact_size.y = theme::BADGE_HEIGHT;
            }
            for law in PHYSICAL {
                // No law, but what kind of surface it is: on a line of its own, so that all stay where they are.
                if law == LawId::Isotropy {
                    ui.end_row();
                }
                if self.badge(ui, law, palette).clicked() {
                    wished = self.report(law).map(|report| report.witness.clone());
                }
            }
        });
        wished
    }

    fn badge(&self, ui: &mut Ui, law: LawId, palette: &Palette) -> Response {
        let finding = self.finding(law);
        let label = match (law, finding) {
            (_, Finding::Anisotropic) => "Anisotropic",
            (_, Finding::Isotropic) => "Isotropic",
            (LawId::Finite, _) => "f ≥ 0",
            _ => law.title(),
        };
        let text = RichText::new(format!("{} {label}", finding.symbol()));
        let text = text.small().color(finding.color(palette));
        let button = small::button(ui, text).frame_when_inactive(false);
        let badge = ui.add(button);
        let name = format!("{} of {}: {}", law.title(), self.title, finding.word());
        badge.widget_info(|| WidgetInfo::labeled(Role::Button, true, &name));
        badge.on_hover_text(self.hint(law, finding))
    }

    /// The law, what became of it, and where.
    fn hint(&self, law: LawId, finding: Finding) -> String {
        let mut hint = format!("{}: {}\n{}", law.title(), finding.word(), meaning(law));
        let Some(report) = self.report(law) else {
            return hint;
        };
        if let Some(sentence) = report.sentence() {
            hint = format!("{hint}\n{sentence}");
        }
        if law == LawId::Finite && report.worst == 0.0 {
            return format!("{hint}\nTried at {} places, in every precision", report.n);
        }
        let [worst, error] = [report.worst, report.error].map(format::value);
        let measure = law.measure();
        hint =
            format!("{hint}\nAt worst {worst} ({measure}); rounding and integration allow {error}");
        if !report.witness.text.is_empty() {
            hint = format!("{hint}\n{}\nClick to go there", report.witness);
        }
        hint
    }
}

/// The badges of `entry`, called `title`, and what there is to be said and done of its energy. Returns where to go, if that is
/// asked for; `material`, which becomes the entry's, is scaled where that is.
pub fn show(
    ui: &mut Ui,
    title: &str,
    entry: &MaterialEntry,
    material: &mut Material,
    answers: &mut Answers,
    palette: &Palette,
) -> Option<Witness> {
    if let Some(lack) = entry.material.lack() {
        let text = RichText::new(format!("Not shown: {lack}")).small();
        ui.label(text.color(palette.warning));
        return None;
    }
    if covered::is_covered(ui.ctx(), Cover::Laws) {
        covered::stand_in(ui, "Laws");
        return None;
    }
    let checks = answers.of_material(entry, PhysicalLaws);
    let badges = Badges {
        title,
        reports: checks.as_ref().map(|checks| checks.as_slice()),
    };
    let wished = badges.all(ui, palette);
    let Some(energy) = badges.report(LawId::Energy) else {
        return wished;
    };
    let asked = remedy(ui, energy, material, Finding::of(energy).color(palette));
    wished.or(asked)
}

/// What happens where `energy` is created, and what can be done; nothing where it is kept.
fn remedy(
    ui: &mut Ui,
    energy: &LawReport,
    material: &mut Material,
    color: Color32,
) -> Option<Witness> {
    let sentence = energy.sentence()?;
    ui.label(RichText::new(sentence).small().color(color));
    ui.horizontal(|ui| {
        let text = |text| RichText::new(text).small();
        let go = ui
            .add(small::button(ui, text("Go there")))
            .on_hover_text("Hold the light where most of it leaves");
        // An upper limit of what leaves, where there is one: then no more leaves than arrives.
        let largest = 1.0 + energy.worst + energy.error;
        let scaled = material.with_weights_over(largest).ok();
        let scaled = scaled.filter(|_| largest.is_finite());
        let scale = ui
            .add_enabled(
                scaled.is_some(),
                small::button(ui, text("Scale the weights")),
            )
            .on_hover_text(format!(
                "Divide the weight of every lobe by {}, the largest share of the arriving light that leaves",
                format::value(largest)
            ));
        if let Some(scaled) = scaled
            && scale.clicked()
        {
            *material = scaled;
        }
        go.clicked().then(|| energy.witness.clone())
    })
    .inner
}

/// What a law asks, for a newcomer.
const fn meaning(law: LawId) -> &'static str {
    match law {
        LawId::Reciprocity => "Light and viewer may change places",
        LawId::Energy => "No more light leaves than arrives",
        LawId::Finite => "No value is negative, infinite or not a number",
        LawId::Isotropy => "Whether the lobe stays as it is when the surface turns, as measured",
        other => other.measure(),
    }
}
