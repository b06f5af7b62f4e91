//! What views draw with, what they keep between frames, and what several of them draw alike.

use std::any::{Any, TypeId};
use std::collections::HashMap;
use std::sync::Arc;

use egui::{Rect, Ui};
use glam::DVec3;

use crate::theme::{Dash, Palette};
use crate::widgets::chart::{self, Axis, Mark};
use crate::widgets::legend::{self, Swatch};
use crate::widgets::pictures::{ColorScale, Textures, Turned, Turns};
use crate::widgets::{choice, deltas as widgets_deltas, draw};
use bxdf_lab::analysis::hemisphere::Map;
use bxdf_lab::analysis::{Hold, deltas, polar as section};
use bxdf_lab::timing::Stopwatch;
use bxdf_study::answers::Answers;
use bxdf_study::cursor::Cursor;
use bxdf_study::export::Format;
use bxdf_study::jobs::Clock;
use bxdf_study::lessons::Thing;
use bxdf_study::memo::Same;
use bxdf_study::session::{EntryId, Materials, Section, Session, ViewId};

/// What a view draws with; `O`: its options, by the type that its kind has for them.
pub struct ViewContext<'a, O = ()> {
    /// The view.
    pub view: ViewId,
    /// What to show; gestures change it.
    pub session: &'a mut Session,
    /// What the view shows of it, and how: the view's own affair.
    pub options: &'a mut O,
    /// What is answered about the session.
    pub answers: &'a mut Answers,
    /// What the views keep between frames.
    pub state: &'a mut ViewState,
    /// The direction pointed at, which every view shows.
    pub cursor: Option<Cursor>,
    /// The direction that is marked, and how strongly, 0 to 1: the one pointed at, and for a moment the one that was.
    pub mark: Option<(Cursor, f32)>,
    /// Where the view says what is pointed at in it, in every frame: what no view says any more is not pointed at.
    pub pointed: &'a mut Option<Cursor>,
    /// The colours.
    pub palette: &'a Palette,
}

/// What views keep between frames; nothing of it is worth saving.
#[derive(Default)]
pub struct ViewState {
    is_dragging: bool,
    kept_lower_half: Option<bool>,
    pub(super) textures: Textures,
    /// Those of each view's maps.
    contours: HashMap<(ViewId, EntryId), Contours>,
    /// What each view keeps for itself.
    own: HashMap<(ViewId, TypeId), Box<dyn Any>>,
    /// The number given last.
    number: u64,
    /// Whether a picture is made, in which nobody can click.
    pub(crate) is_picture: bool,
    /// Whether a drawing is made, in which lines over a picture are lines.
    pub(crate) is_drawing: bool,
    /// Of a figure: whether it has a title.
    pub(crate) has_title: Option<bool>,
    /// What scenes of the graphics processor fill in this frame: they have no shapes to be measured.
    pub(crate) filled: Option<Rect>,
    /// By how much what is shown in this frame is too low to be legible, in points.
    pub(crate) lacking: f32,
    /// What measures the times of trade-offs.
    pub(crate) stopwatch: Stopwatch,
    /// A file that a view asks to be written.
    pub(super) wished_file: Option<(ViewId, Format)>,
    /// The handle that is to have the focus.
    wished_focus: Option<WishedFocus>,
}

/// For how many frames a focus is wished: a command that runs between two frames has a whole one for its view.
const OLDEST_WISH: u8 = 2;

/// A handle that is to have the focus.
#[derive(Clone, Copy)]
struct WishedFocus {
    of: Hold,
    view: ViewId,
    /// The frames for which it has been wished: first it is that of its view, then any.
    age: u8,
}

/// The lines of a map in a scale.
type Contours = Turned<(Same<Map>, ColorScale), Lines>;

/// Lines of equal value, as places of a picture.
pub(super) type Lines = Vec<Vec<[f64; 2]>>;

impl<O> ViewContext<'_, O> {
    /// The same, with these options.
    pub(super) fn with<'b, P>(&'b mut self, options: &'b mut P) -> ViewContext<'b, P> {
        ViewContext {
            view: self.view,
            session: self.session,
            options,
            answers: self.answers,
            state: self.state,
            cursor: self.cursor,
            mark: self.mark,
            pointed: self.pointed,
            palette: self.palette,
        }
    }

    /// The pair of directions pointed at, wo and wi; that of the session while nobody points, or where nothing is: below
    /// surfaces that let no light through.
    pub(super) fn pair(&self) -> (DVec3, DVec3) {
        let is_lit = |w: &DVec3| w.z >= 0.0 || self.session.shows_lower_half();
        let pointed = self.cursor.map(|cursor| cursor.direction).filter(is_lit);
        self.pair_with(pointed.unwrap_or_else(|| self.session.other()))
    }

    /// The pair of directions that is marked, and how strongly.
    pub(super) fn marked_pair(&self) -> Option<(DVec3, DVec3, f32)> {
        let (cursor, strength) = self.mark?;
        let (wo, wi) = self.pair_with(cursor.direction);
        Some((wo, wi, strength))
    }

    /// The held direction and this one as wo and wi.
    fn pair_with(&self, free: DVec3) -> (DVec3, DVec3) {
        let held = self.session.held();
        match self.session.hold {
            Hold::Light => (free, held),
            Hold::Viewer => (held, free),
        }
    }

    /// Holds one direction of this pair, and puts the other one.
    pub(super) fn hold_pair(&mut self, wo: DVec3, wi: DVec3) {
        let (held, free) = match self.session.hold {
            Hold::Light => (wi, wo),
            Hold::Viewer => (wo, wi),
        };
        self.session.set_held(held);
        self.session.put_other(free);
    }

    /// The light and the viewer with the name of each at the screen, its colour, and whether it is held. The held one comes
    /// last, and so lies over the other.
    pub(super) fn directions(&self) -> [Named; 2] {
        let (session, palette) = (&*self.session, self.palette);
        let other = match session.hold {
            Hold::Light => Hold::Viewer,
            Hold::Viewer => Hold::Light,
        };
        let named = |direction, name, of, is_held| Named {
            direction,
            name,
            color: palette.held(of),
            of,
            is_held,
        };
        [
            named(session.other(), session.free_name(), other, false),
            named(session.held(), session.held_name(), session.hold, true),
        ]
    }

    /// Says that a scene fills `rect`.
    pub(super) fn fill(&mut self, rect: Rect) {
        let filled = &mut self.state.filled;
        *filled = Some(filled.map_or(rect, |other| other.union(rect)));
    }

    /// Says by how much something is too low to be legible, in points: the page of a figure grows by that.
    pub(super) fn lacks(&mut self, height: f32) {
        self.state.lacking = self.state.lacking.max(height);
    }

    /// The names of the materials shown, above the view, where no title has them; a click selects one.
    pub(super) fn legend(&mut self, ui: &mut Ui, swatch: Swatch) {
        if !self.state.is_titled() {
            legend::show(ui, swatch, &[], self.session, self.palette);
        }
    }

    /// The same with a number of each material behind its name; no title has those.
    pub(super) fn legend_of_numbers(&mut self, ui: &mut Ui, swatch: Swatch, numbers: &[String]) {
        legend::show(ui, swatch, numbers, self.session, self.palette);
    }

    /// Puts the light or the viewer at the direction `w`.
    pub(super) fn put(&mut self, of: Hold, w: DVec3) {
        if of == self.session.hold {
            self.session.set_held(w);
        } else {
            self.session.set_other(w);
        }
    }
}

/// The light or the viewer, as views show it.
#[derive(Clone, Copy)]
pub(super) struct Named {
    /// Where it is, a unit vector.
    pub(super) direction: DVec3,
    /// Its name at the screen.
    pub(super) name: &'static str,
    /// Its colour.
    pub(super) color: egui::Color32,
    /// Which of the two it is.
    pub(super) of: Hold,
    /// Whether the lobe is over the other one.
    pub(super) is_held: bool,
}

impl Named {
    /// What words that name it stand for.
    pub(super) fn thing(&self) -> Thing {
        match self.of {
            Hold::Light => Thing::Light,
            Hold::Viewer => Thing::Viewer,
        }
    }
}

/// The directions of the section that have names.
pub(super) fn section_marks(session: &Session, shown: Section, palette: &Palette) -> Vec<Mark> {
    let held = section::signed_angle(session.held(), shown.phi()).to_degrees();
    let dash = if shown.holds_held {
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
pub(super) fn chart_stem(
    stem: &deltas::Stem,
    of: &str,
    color: egui::Color32,
    outside: &str,
) -> chart::Stem {
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
pub(super) const OUTSIDE_SECTION: &str = ", outside this section";

/// The axis upwards where all light is in deltas: their shares.
pub(super) fn share_axis(shares: impl Iterator<Item = f64>) -> Axis {
    let (least, largest) = shares.fold((0.0_f64, 1.0_f64), |(low, high), share| {
        (low.min(share), high.max(share))
    });
    Axis::of_values("share of the flux", [least, largest], None)
}

/// The choice of the material that others are compared with.
pub(super) fn reference_choice(ui: &mut Ui, materials: &mut Materials) {
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
    /// To be called before the views of a frame are drawn. What views kept that are closed is dropped.
    pub fn begin_frame(&mut self, session: &Session) {
        self.textures.begin_frame();
        self.filled = None;
        self.lacking = 0.0;
        let is_open = |view: &ViewId| session.views.get(*view).is_some();
        self.contours
            .retain(|(view, entry), _| is_open(view) && session.materials.get(*entry).is_some());
        self.own.retain(|(view, _), _| is_open(view));
        self.wished_focus = self.wished_focus.and_then(|wish| {
            let age = wish.age + 1;
            (age <= OLDEST_WISH).then_some(WishedFocus { age, ..wish })
        });
        if !std::mem::take(&mut self.is_dragging) {
            self.kept_lower_half = None;
        }
    }

    /// Nothing kept yet; `clock` measures what a frame takes, so that pictures share it out.
    pub(crate) fn by(clock: Option<Clock>) -> Self {
        let mut state = Self::default();
        state.textures.turns = Turns::by(clock);
        state
    }

    /// What `view` keeps for itself, of this type; at first its default.
    pub(super) fn own<T: Default + 'static>(&mut self, view: ViewId) -> &mut T {
        let kept = self.own.entry((view, TypeId::of::<T>()));
        let kept = kept.or_insert_with(|| Box::new(T::default()));
        kept.downcast_mut()
            .unwrap_or_else(|| unreachable!("it is kept by its type"))
    }

    /// A number that was not given before.
    pub(super) fn unused_number(&mut self) -> u64 {
        self.number += 1;
        self.number
    }

    /// The file that a view asks to be written; told once.
    pub fn take_wished_file(&mut self) -> Option<(ViewId, Format)> {
        self.wished_file.take()
    }

    /// Wishes the focus for the handle of the light or the viewer: in this view, or else in any that has one.
    pub(crate) fn wish_focus(&mut self, of: Hold, view: ViewId) {
        let age = 0;
        self.wished_focus = Some(WishedFocus { of, view, age });
    }

    /// Whether the handle of the light or the viewer in this view is to have the focus; told once.
    pub(super) fn take_focus(&mut self, of: Hold, view: ViewId) -> bool {
        let is_meant = |wish: &mut WishedFocus| {
            wish.of == of && (wish.view == view || wish.age == OLDEST_WISH)
        };
        self.wished_focus.take_if(is_meant).is_some()
    }

    /// The contours of a map in a scale, computed anew only where one of them is another one; those before where they have to
    /// wait for their turn.
    pub(super) fn contours(
        &mut self,
        ctx: &egui::Context,
        of: (ViewId, EntryId),
        map: &Arc<Map>,
        scale: ColorScale,
        compute: impl FnOnce(&Map) -> Lines,
    ) -> Arc<Lines> {
        let key = (Same(Arc::clone(map)), scale);
        let kept = self.contours.entry(of).or_default();
        kept.get((&mut self.textures.turns, ctx), key, || compute(map))
    }

    /// Whether a figure is made: what the pointer would tell is written there.
    pub(crate) fn is_figure(&self) -> bool {
        self.has_title.is_some()
    }

    /// Whether a title names what has no name in the view itself.
    pub(crate) fn is_titled(&self) -> bool {
        self.has_title == Some(true)
    }

    /// The picture behind a texture, if it is one of the views'.
    pub(crate) fn image(&self, id: egui::TextureId) -> Option<Arc<egui::ColorImage>> {
        self.textures.image(id)
    }

    /// Whether the views show what is below the surface. While the held direction is dragged they stay as they were:
    /// a plot that rearranged itself under the pointer would make the angle jump.
    pub(super) fn shows_lower_half(&self, session: &Session) -> bool {
        self.kept_lower_half
            .unwrap_or_else(|| session.shows_lower_half())
    }

    /// Keeps the arrangement `has_lower` through the next frame.
    pub(super) fn keep_arrangement(&mut self, has_lower: bool) {
        self.is_dragging = true;
        self.kept_lower_half = Some(has_lower);
    }
}
