//! The views: one file each, and the one list of them.

use egui::{Label, RichText, Ui};

use crate::widgets::{choice, small};
use bxdf_lab::analysis::reflectance::has_flux;
use bxdf_study::session::Session;
use bxdf_study::views::{OWN_SECTION, Options};
pub use context::{ViewContext, ViewState};

mod cartesian;
mod context;
mod decomposition;
mod direction;
mod formula_card;
mod fresnel;
mod half_vector;
pub mod heading;
mod hemisphere;
mod inspector;
mod integral;
mod kept_scale;
mod lobe3d;
mod polar;
mod reflectance;
mod sampling;
mod settings;
mod side_by_side;
mod slice;
mod sphere;
mod stability;
mod tradeoff;

macro_rules! list {
    ($($id:ident)*) => {
        /// Draws the view into the space left in the `Ui`, with these options of whichever kind.
        fn show_kind(ui: &mut Ui, cx: &mut ViewContext<'_>, options: &mut Options) {
            match options {
                $(Options::$id(options) => $id::show(ui, &mut cx.with(options)),)*
            }
        }
    };
}
bxdf_study::view_kinds!(list);

/// Draws the view, and above it what all views have to say and to set alike.
pub fn show(ui: &mut Ui, cx: &mut ViewContext<'_>, options: &mut Options) {
    warn_of_held(ui, cx, options);
    if !cx.state.is_picture {
        set_own_section(ui, cx.session, options);
    }
    show_kind(ui, cx, options);
}

/// The azimuth of the view's own section, where it has one.
fn set_own_section(ui: &mut Ui, session: &Session, options: &mut Options) {
    let Some(section) = options.own_section() else {
        return;
    };
    let mut is_own = true;
    let Some(azimuth) = &mut section.0 else {
        return;
    };
    ui.horizontal_wrapped(|ui| {
        let hint = "The azimuth of the section that this view has for itself";
        choice::angle(ui, ("Own section", hint), azimuth, &OWN_SECTION);
        let hint = "Show the section of the other views again";
        is_own = !ui
            .add(small::button(ui, "As the others"))
            .on_hover_text(hint)
            .clicked();
    });
    if !is_own {
        section.set(false, session);
    }
}

/// Where the held direction lies in the surface plane, or below opaque materials, and the view is of it: says so, and offers the
/// way back from below.
fn warn_of_held(ui: &mut Ui, cx: &mut ViewContext<'_>, options: &Options) {
    let is_picture = cx.state.is_picture;
    let session = &mut *cx.session;
    if !has_flux(session.held()) && options.is_of_held() {
        let text = format!(
            "The {} is in the surface plane: at θ = 90° no light arrives (cos θ = 0), and f is set to 0",
            session.held_name()
        );
        ui.add(Label::new(RichText::new(text).weak()).wrap());
        return;
    }
    let is_told = session.is_held_below() && options.is_of_held();
    if !is_told {
        return;
    }
    let name = session.held_name();
    ui.horizontal_wrapped(|ui| {
        let text = format!(
            "The {name} is below the surface, and nothing shown lets light through: all values above it are 0"
        );
        ui.colored_label(ui.visuals().error_fg_color, text);
        if is_picture {
            return;
        }
        let hint = "Mirror it above the surface";
        let button = ui.button(format!("Bring the {name} above"));
        if button.on_hover_text(hint).clicked() {
            session.raise_held();
        }
    });
}
