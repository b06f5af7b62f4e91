//! The picture of one view as a figure: its title, and what is seen of it.

use egui::epaint::ClippedShape;
use egui::layers::ShapeIdx;
use egui::{Context, Rect, Shape, Ui};

use super::{App, Figure, Title};
use crate::widgets::still;
use bxdf_study::views::Subjects;

/// How far letters reach beyond the place of their text at most, in points: a coarse picture has wide pixels.
const BLUR: f32 = 4.0;

/// The title of a figure, above the view or beside it.
pub struct Heading {
    /// The words in place of those for what is shown.
    pub(crate) own: Option<String>,
    /// Its width in points where it stands beside the view.
    pub(crate) beside: Option<f32>,
}

impl Heading {
    pub(super) fn of(figure: &Figure) -> Option<Self> {
        let own = match &figure.title {
            Title::None => return None,
            Title::Automatic => None,
            Title::Own(words) => Some(words.clone()),
        };
        Some(Self { own, beside: None })
    }
}

impl App {
    /// Writes the title of the figure beside the view from now on, this many points wide.
    pub fn put_title_beside(&mut self, width: f32) {
        if let Some(heading) = &mut self.heading {
            heading.beside = Some(width);
        }
    }

    /// Leaves this much free above the title and below the view from now on, in points.
    pub fn leave_free(&mut self, height: f32) {
        self.free = height;
    }

    /// Whether the figure has a title.
    #[must_use]
    pub fn has_title(&self) -> bool {
        self.heading.is_some()
    }

    /// Whether it shows a scene of the graphics processor, which is as large as the room is high.
    #[must_use]
    pub fn has_scene(&self) -> bool {
        self.state.filled.is_some()
    }

    /// How many materials have a picture of their own: 1 where all share one.
    #[must_use]
    pub fn number_apart(&self) -> usize {
        let options = self.only.and_then(|view| self.session.views.get(view));
        let caption = options.map(|options| options.caption(&self.session));
        let is_apart = caption.is_some_and(|caption| caption.names == Subjects::Apart);
        if is_apart {
            self.session.materials.shown().count().max(1)
        } else {
            1
        }
    }

    /// The room of the one view that is shown.
    #[must_use]
    pub fn room_of_view(&self) -> Rect {
        self.room_of_views
    }

    /// By how much that room is too low for the view, in points.
    #[must_use]
    pub fn lacking(&self) -> f32 {
        self.lacking
    }

    /// The part of that room in which there is something to see, of the last frame's `shapes`.
    #[must_use]
    pub fn seen(&self, ctx: &Context, shapes: &[ClippedShape]) -> Rect {
        let room = self.room_of_views;
        let followers = still::followers(ctx);
        let is_counted = |rect: &Rect| {
            // The ground behind all is nothing to see.
            rect.is_positive()
                && room.expand(1.0).contains_rect(*rect)
                && !followers
                    .iter()
                    .any(|other| other.expand(BLUR).contains_rect(*rect))
        };
        let of_shape = |clipped: &ClippedShape| match &clipped.shape {
            Shape::Callback(_) => Rect::NOTHING,
            shape => shape.visual_bounding_rect().intersect(clipped.clip_rect),
        };
        let seen = shapes.iter().map(of_shape).filter(is_counted);
        seen.chain(self.state.filled)
            .fold(Rect::NOTHING, Rect::union)
    }

    /// Draws the axes of scenes as lines over their pictures from now on.
    pub fn draw_axes_as_lines(&mut self) {
        self.state.is_drawing = true;
    }

    /// Paints only what the graphics processor draws from now on, or all again: a drawing holds a picture of it.
    pub fn paint_scenes_alone(&mut self, is_alone: bool) {
        self.has_scenes_alone = is_alone;
    }

    /// Takes back what was painted in the layer of `ui`, but for scenes of the graphics processor.
    pub(crate) fn keep_scenes(&self, ui: &Ui) {
        if !self.has_scenes_alone {
            return;
        }
        ui.ctx().graphics_mut(|layers| {
            let list = layers.entry(ui.layer_id());
            for index in 0..list.next_idx().0 {
                list.mutate_shape(ShapeIdx(index), |clipped| {
                    if !matches!(clipped.shape, Shape::Callback(_)) {
                        clipped.shape = Shape::Noop;
                    }
                });
            }
        });
    }
}
