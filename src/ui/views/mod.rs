//! The views: one file each, and the one list of them.

use std::collections::HashMap;
use std::sync::Arc;

use egui::Ui;
use glam::DVec3;

use super::theme::{Dash, Palette};
use super::widgets::chart::{self, Axis, Mark};
use super::widgets::pictures::{ColorScale, Textures};
use super::widgets::{choice, deltas as widgets_deltas, draw};
use bxdf_lab::analysis::hemisphere::Map;
use bxdf_lab::analysis::{Hold, deltas, polar as section};
use bxdf_lab::stability::map as stability_map;
use bxdf_study::cursor::Cursor;
use bxdf_study::data::Data;
use bxdf_study::export::{Format, nothing_to_show};
use bxdf_study::memo::{Memo, Same};
use bxdf_study::session::{EntryId, Materials, Session, ViewId};
use bxdf_study::views::ViewKind;

mod cartesian;
mod decomposition;
mod hemisphere;
mod inspector;
mod lobe3d;
mod polar;
mod reflectance;
mod sampling;
mod slice;
mod sphere;
mod stability;
mod tradeoff;

/// What draws a view into the space left in the `Ui`.
type Show = fn(&mut Ui, &mut ViewContext<'_>);

macro_rules! list {
    ($($id:ident)*) => {
        /// What draws each kind of view, by its id.
        static SHOW: [(&str, Show); [$(stringify!($id)),*].len()] = [$((stringify!($id), $id::show)),*];
    };
}
bxdf_study::view_kinds!(list);

/// Draws the view.
pub fn show(ui: &mut Ui, cx: &mut ViewContext<'_>) {
    let mut all = SHOW.iter();
    if let Some((_, show)) = all.find(|(id, _)| *id == cx.view.id) {
        show(ui, cx);
    }
}

/// What a view draws with.
pub struct ViewContext<'a> {
    /// The view.
    pub view: &'static ViewKind,
    /// What to show; gestures change it.
    pub session: &'a mut Session,
    /// The data of the session.
    pub data: &'a mut Data,
    /// What the views keep between frames.
    pub state: &'a mut ViewState,
    /// The direction last pointed at, which every view shows; set by the view that has the pointer.
    pub cursor: &'a mut Option<Cursor>,
    /// The colours.
    pub palette: &'a Palette,
}

/// What views keep between frames; nothing of it is worth saving.
#[derive(Default)]
pub struct ViewState {
    drawing: lobe3d::DrawingMemo,
    is_dragging: bool,
    kept_lower_half: Option<bool>,
    textures: Textures,
    contours: HashMap<EntryId, Memo<(Same<Map>, ColorScale), Lines>>,
    chosen: tradeoff::Chosen,
    /// The lines of equal condition number of a map of errors.
    kappas: Memo<Same<stability_map::Map>, Lines>,
    /// Whether a picture is made, in which nobody can click.
    pub(super) is_picture: bool,
    /// A file that a view asks to be written.
    wished_file: Option<(ViewId, Format)>,
}

/// Lines of equal value, as places of a picture.
type Lines = Vec<Vec<[f64; 2]>>;

impl ViewContext<'_> {
    /// The pair of directions that the pointer was at last, wo and wi; the mirror direction before it was anywhere.
    fn pair(&self) -> (DVec3, DVec3) {
        let held = self.session.held();
        let mirror = DVec3::new(-held.x, -held.y, held.z);
        let free = self.cursor.map_or(mirror, |cursor| cursor.direction);
        match self.session.hold {
            Hold::Light => (free, held),
            Hold::Viewer => (held, free),
        }
    }

    /// Holds one direction of this pair, and points at the other.
    fn hold_pair(&mut self, wo: DVec3, wi: DVec3) {
        let (held, free) = match self.session.hold {
            Hold::Light => (wi, wo),
            Hold::Viewer => (wo, wi),
        };
        self.session.set_held(held);
        *self.cursor = Some(Cursor {
            material: self.session.materials.selected().id(),
            direction: free,
        });
    }
}

/// The directions of the section that have names.
fn section_marks(session: &Session, palette: &Palette) -> Vec<Mark> {
    let azimuth = session.section_azimuth_deg().to_radians();
    let held = section::signed_angle(session.held(), azimuth).to_degrees();
    let dash = if session.section_holds_held() {
        Dash::Solid
    } else {
        Dash::Dashed
    };
    let mark = |name: &str, at: f64, color, dash| Mark {
        name: name.to_owned(),
        at,
        color,
        dash,
    };
    vec![
        mark(session.held_name(), held, palette.held(session.hold), dash),
        mark("mirror", -held, palette.mirror, Dash::Dashed),
        mark("n", 0.0, palette.faint_ink, Dash::Dotted),
    ]
}

/// A delta in a chart over the free direction's angle; `outside` says where one is that lies elsewhere.
fn chart_stem(stem: &deltas::Stem, of: &str, color: egui::Color32, outside: &str) -> chart::Stem {
    let share = stem.share();
    let place = if stem.is_inside { "" } else { outside };
    chart::Stem {
        name: format!("{}{place}", widgets_deltas::label(share)),
        of: of.to_owned(),
        at: stem.x_deg,
        share,
        color,
        dash: if stem.is_inside {
            Dash::Solid
        } else {
            Dash::Dashed
        },
    }
}

/// What is said of deltas that a section does not hold.
const OUTSIDE_SECTION: &str = ", outside this section";

/// The axis upwards where all light is in deltas: their shares.
fn share_axis(shares: impl Iterator<Item = f64>) -> Axis {
    let (least, largest) = shares.fold((0.0_f64, 1.0_f64), |(low, high), share| {
        (low.min(share), high.max(share))
    });
    Axis::of_values("share of the flux", [least, largest], None)
}

/// Where the held direction lies below opaque materials and the view is of it: says so, and offers the way back.
pub(super) fn warn_of_held(ui: &mut egui::Ui, cx: &mut ViewContext<'_>) {
    let view = cx.view;
    let session = &mut *cx.session;
    let is_told = session.is_held_below() && (view.is_of_held)(session);
    if !is_told {
        return;
    }
    let name = session.held_name();
    ui.horizontal_wrapped(|ui| {
        let text = format!(
            "The {name} is below the surface, and nothing shown lets light through: all values above it are 0"
        );
        ui.colored_label(ui.visuals().error_fg_color, text);
        let hint = "As far above the surface as it is below now";
        let button = ui.button(format!("Bring the {name} above"));
        if button.on_hover_text(hint).clicked() {
            session.raise_held();
        }
    });
}

/// The choice of the material that others are compared with.
fn reference_choice(ui: &mut Ui, materials: &mut Materials) {
    let hint = "The material that the others are compared with";
    let mut chosen = materials.reference().id();
    let title = materials.title(materials.reference());
    let shown = draw::clipped(&title, LONGEST_REFERENCE);
    choice::named_combo(ui, ("Reference", "with", hint), &shown, |ui| {
        for entry in materials.iter() {
            ui.selectable_value(&mut chosen, entry.id(), materials.title(entry));
        }
    });
    if chosen != materials.reference().id() {
        materials.compare_with(chosen);
    }
}

/// The most characters of the name of the reference.
const LONGEST_REFERENCE: usize = 18;

impl ViewState {
    /// To be called before the views of a frame are drawn.
    pub fn begin_frame(&mut self) {
        self.textures.begin_frame();
        if !std::mem::take(&mut self.is_dragging) {
            self.kept_lower_half = None;
        }
    }

    /// The file that a view asks to be written; told once.
    pub fn take_wished_file(&mut self) -> Option<(ViewId, Format)> {
        self.wished_file.take()
    }

    /// The contours of a map in a scale, computed anew only where one of them is another one.
    fn contours(
        &mut self,
        entry: EntryId,
        map: &Arc<Map>,
        scale: ColorScale,
        compute: impl FnOnce(&Map) -> Lines,
    ) -> Arc<Lines> {
        let key = (Same(Arc::clone(map)), scale);
        let memo = self.contours.entry(entry).or_default();
        memo.get(key, || compute(map))
    }

    /// The picture behind a texture, if it is one of the views'.
    pub(super) fn image(&self, id: egui::TextureId) -> Option<Arc<egui::ColorImage>> {
        self.textures.image(id)
    }

    /// Whether the views show what is below the surface. While the held direction is dragged they stay as they were:
    /// a plot that rearranged itself under the pointer would make the angle jump.
    fn shows_lower_half(&self, session: &Session) -> bool {
        self.kept_lower_half
            .unwrap_or_else(|| session.shows_lower_half())
    }

    /// Keeps the arrangement `has_lower` through the next frame.
    fn keep_arrangement(&mut self, has_lower: bool) {
        self.is_dragging = true;
        self.kept_lower_half = Some(has_lower);
    }
}
