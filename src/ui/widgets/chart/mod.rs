//! A chart: curves over a named axis, linear or by decades, with marks and a pointer that reads out.

use std::fmt::Write as _;

use egui::{IdSalt, Pos2, Rect, Response, Role, Sense, Ui, WidgetInfo, vec2};
use egui_plot::{
    AxisHints, FilledArea, HLine, Line, Plot, PlotMemory, PlotPoint, PlotPoints, PlotTransform,
    PlotUi, Points, VLine,
};

use super::{choice, deltas, draw, reset, still};
use crate::theme::{self, Palette};
pub use axis::Axis;
use bxdf_study::format;
pub use series::{Band, Dots, Mark, Series, Stem, style};

mod axis;
mod labels;
mod marks;
mod series;
mod stems;

/// Room at the right of a plot for half a number, and the least height of one, in points.
const END_ROOM: f32 = 12.0;
const LEAST_HEIGHT: f32 = 30.0;

/// Numbers of the axis to the right and of that upwards are written where they are farther apart than this, in points, and as
/// strong there as anywhere: faint ones cannot be read.
const NUMBERS: [f32; 2] = [60.0, 20.0];

/// A chart is legible from this height on, as a share of its width.
const LEGIBLE: f32 = 0.42;

/// Room below what is drawn, as a share of its height.
const FOOT: f64 = 0.03;

/// Room that the numbers of one axis take from the name of the other, in points.
const AXIS_ROOM: f32 = 44.0;

/// All that a chart shows.
#[derive(Clone, Debug, PartialEq)]
pub struct Chart {
    /// Its name for screen readers and tests.
    pub name: String,
    /// The axis to the right.
    pub x: Axis,
    /// The axis upwards.
    pub y: Axis,
    /// The curves; later ones lie over earlier ones.
    pub series: Vec<Series>,
    /// Areas under the curves.
    pub bands: Vec<Band>,
    /// Single values, over the curves.
    pub dots: Vec<Dots>,
    /// Dirac deltas, over the curves: their heights are shares of the flux, whatever the axis upwards measures.
    pub stems: Vec<Stem>,
    /// Lines at an x.
    pub marks: Vec<Mark>,
    /// Lines at a y.
    pub levels: Vec<Mark>,
    /// Whether the names of the curves stand above it.
    pub has_names: bool,
    /// Whether the names of the curves stand beside them, where there is room.
    pub has_labels: bool,
}

/// A chart on the screen.
pub struct Shown {
    /// What the pointer does with it.
    pub response: Response,
    /// Where values lie.
    transform: PlotTransform,
}

impl Chart {
    /// A chart of `series` over these axes, and nothing else.
    #[must_use]
    pub fn of(name: &str, [x, y]: [Axis; 2], series: Vec<Series>) -> Self {
        Self {
            name: name.to_owned(),
            x,
            y,
            series,
            bands: Vec::new(),
            dots: Vec::new(),
            stems: Vec::new(),
            marks: Vec::new(),
            levels: Vec::new(),
            has_names: false,
            has_labels: false,
        }
    }

    /// Leaves out the names of axes, marks and curves, where there is no room for them: the pointer reads them out.
    pub fn leave_out_words(&mut self) {
        (self.has_names, self.has_labels) = (false, false);
        for name in [&mut self.x.name, &mut self.y.name] {
            name.clear();
        }
        for mark in self.marks.iter_mut().chain(&mut self.levels) {
            mark.name.clear();
        }
        for stem in &mut self.stems {
            stem.name.clear();
        }
    }

    /// Draws it into the room left, or into this height, the names of the curves above.
    pub fn show(&self, ui: &mut Ui, height: Option<f32>, palette: &Palette) -> Shown {
        let top = ui.cursor().top();
        if self.has_names {
            self.name_series(ui);
        }
        let height = height.map_or_else(
            || ui.available_height(),
            |height| (height - (ui.cursor().top() - top)).max(LEAST_HEIGHT),
        );
        // The last number below stands half beside the plot.
        let room = vec2(ui.available_width() - END_ROOM, height);
        let fits = |room: f32| {
            let (painter, font) = (ui.painter(), egui::TextStyle::Body.resolve(ui.style()));
            move |name: &str| {
                let galley = painter.layout_no_wrap(name.to_owned(), font.clone(), palette.ink);
                galley.size().x <= room - AXIS_ROOM
            }
        };
        let ([x_low, x_high], [y_low, y_high]) = (self.x.ends(), self.y.ends());
        let y_low = if self.x.is_angle && x_low < 0.0 {
            // The lowest number at the left stands above the sign of the first one below.
            y_low - FOOT * (y_high - y_low)
        } else {
            y_low
        };
        let salt = ("chart", &self.name, self.y.is_logarithmic, &self.x.name);
        let id = ui.make_persistent_id(IdSalt::new(salt));
        let plot = Plot::new(salt)
            .id(id)
            .width(room.x)
            .height(room.y)
            .custom_x_axes(vec![self.x.hints(
                AxisHints::new_x(),
                NUMBERS[0],
                fits(room.x),
            )])
            .custom_y_axes(vec![self.y.hints(
                AxisHints::new_y(),
                NUMBERS[1],
                fits(room.y),
            )])
            .set_margin_fraction(vec2(0.0, 0.0))
            .include_x(x_low)
            .include_x(x_high)
            .include_y(y_low)
            .include_y(y_high)
            .auto_bounds(true)
            .grid_color(palette.grid)
            .show_background(false)
            .show_x(false)
            .show_y(false)
            .show_crosshair(false)
            .allow_boxed_zoom(false)
            .allow_scroll(false)
            .sense(still::sense(ui, Sense::click_and_drag()))
            .allow_axis_zoom_drag(!still::is(ui))
            .label_formatter(|_| None);
        let plot = if self.x.is_angle {
            plot.x_grid_spacer(|input| axis::angle_marks(input.bounds))
        } else if self.x.is_logarithmic {
            plot.x_grid_spacer(|input| axis::decade_marks(input.bounds))
        } else {
            plot
        };
        let plot = if self.y.is_logarithmic {
            plot.y_grid_spacer(|input| axis::decade_marks(input.bounds))
        } else {
            plot
        };
        // How much room its numbers and names take is known from the second frame on.
        let names = [&self.x.name, &self.y.name].map(String::is_empty);
        let look = (names, [room.x, room.y].map(f32::to_bits));
        let before = ui.data_mut(|data| {
            let kept = data.get_temp_mut_or_default::<Option<([bool; 2], [u32; 2])>>(id);
            kept.replace(look)
        });
        if before != Some(look) {
            ui.ctx().request_repaint();
        }
        let shown = plot.show(ui, |plot_ui| {
            draw::zoom_by_scrolling(plot_ui);
            self.draw(plot_ui);
        });
        let memory = PlotMemory::load(ui.ctx(), id);
        let is_moved = memory.is_some_and(|memory| !memory.auto_bounds.all());
        reset::of_plot(ui, id, *shown.transform.frame(), is_moved);
        let response = shown.response;
        response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, &self.name));
        let shown = Shown {
            response,
            transform: shown.transform,
        };
        let mut taken = self.name_marks(ui, &shown, palette);
        self.draw_stems(ui, &shown, &mut taken, palette);
        if self.has_labels {
            self.label_series(ui, &shown, &mut taken, palette);
        }
        shown
    }

    fn draw(&self, plot_ui: &mut PlotUi<'_>) {
        for band in &self.bands {
            let of = |index: usize| {
                let points = band.points.iter().filter_map(|point| point.get(index));
                points.copied().collect::<Vec<f64>>()
            };
            let place = |values: Vec<f64>| -> Vec<f64> {
                values
                    .into_iter()
                    .map(|value| self.y.place(value))
                    .collect()
            };
            let area = FilledArea::new("", &of(0), &place(of(1)), &place(of(2)));
            plot_ui.add(
                area.fill_color(theme::fill_of(band.color))
                    .allow_hover(false),
            );
        }
        for series in &self.series {
            for line in &series.lines {
                let places = line
                    .iter()
                    .map(|[x, y]| [self.x.place(*x), self.y.place(*y)]);
                for piece in self.y.cut(places.collect()) {
                    let line = Line::new("", PlotPoints::from(piece))
                        .stroke((series.width, series.color))
                        .style(style(series.dash))
                        // The line itself, every point of it: a band is thin where the curve is steep.
                        .allow_band(false)
                        .allow_hover(false);
                    plot_ui.line(line);
                }
            }
        }
        for dots in &self.dots {
            let places = dots.points.iter();
            let places = places.map(|[x, y]| [self.x.place(*x), self.y.place(*y)]);
            let points = Points::new("", places.collect::<PlotPoints<'_>>())
                .shape(dots.shape)
                .radius(dots.radius)
                .color(dots.color)
                .filled(dots.is_filled);
            plot_ui.points(points.allow_hover(false));
        }
        for mark in &self.marks {
            let line = VLine::new("", self.x.place(mark.at)).stroke((1.5, mark.color));
            plot_ui.vline(line.style(style(mark.dash)).allow_hover(false));
        }
        for level in &self.levels {
            let line = HLine::new("", self.y.place(level.at)).stroke((1.5, level.color));
            plot_ui.hline(line.style(style(level.dash)).allow_hover(false));
        }
    }

    /// The x and y under the pointer, in the units of the axes.
    #[must_use]
    pub fn pointed(&self, shown: &Shown) -> Option<[f64; 2]> {
        let pointer = shown.response.hover_pos()?;
        Some(self.value_at(shown, pointer))
    }

    /// The x and y at a place of the screen, in the units of the axes.
    #[must_use]
    pub fn value_at(&self, shown: &Shown, place: Pos2) -> [f64; 2] {
        let place = shown.transform.value_from_position(place);
        [self.x.value(place.x), self.y.value(place.y)]
    }

    /// Where the values x and y lie on the screen.
    #[must_use]
    pub fn position_of(&self, shown: &Shown, [x, y]: [f64; 2]) -> Pos2 {
        shown.position([self.x.place(x), self.y.place(y)])
    }

    /// The dot under the pointer: which of [`Self::dots`], and which of its points.
    #[must_use]
    pub fn pointed_dot(&self, shown: &Shown) -> Option<[usize; 2]> {
        const REACH: f32 = 9.0;
        let pointer = shown.response.hover_pos()?;
        let all = self.dots.iter().enumerate().flat_map(|(kind, dots)| {
            let places = dots.points.iter().enumerate();
            places.map(move |(index, point)| ([kind, index], *point))
        });
        all.map(|(which, point)| (which, self.position_of(shown, point).distance(pointer)))
            .filter(|(_, distance)| *distance <= REACH)
            .min_by(|a, b| a.1.total_cmp(&b.1))
            .map(|(which, _)| which)
    }

    /// A line at `x`, which is pointed at in another view, with a dot on each curve there, as strong as it is marked.
    pub fn mark(&self, ui: &Ui, shown: &Shown, x: f64, look: (&Palette, f32)) {
        let (palette, strength) = look;
        let frame = shown.frame();
        let painter = ui.painter_at(frame);
        let across = shown.position([self.x.place(x), 0.0]).x;
        painter.vline(across, frame.y_range(), (1.0, draw::cursor_color(look)));
        for series in &self.series {
            if let Some(y) = series.value_at(x) {
                let place = shown.position([self.x.place(x), self.y.place(y)]);
                let [color, edge] =
                    [series.color, palette.background].map(|color| color.gamma_multiply(strength));
                painter.circle(place, 3.5, color, (1.0, edge));
            }
        }
    }

    /// A line at `x` with a dot on each curve there, and a note beside the pointer: `heading`, then each curve's value.
    pub fn read_out(&self, ui: &Ui, shown: &Shown, x: f64, heading: &str, palette: &Palette) {
        self.mark(ui, shown, x, (palette, 1.0));
        let mut text = heading.to_owned();
        for series in &self.series {
            if let Some(y) = series.value_at(x) {
                // Writing to a string cannot fail.
                let _ = write!(text, "\n{}  {}", series.name, format::value(y));
            }
        }
        for stem in self.stems_near(shown, x) {
            let _ = write!(text, "\n{}  {}", stem.of, deltas::label(stem.share));
        }
        if let Some(pointer) = shown.response.hover_pos() {
            draw::pointer_note(ui, pointer, shown.frame(), &text, palette);
        }
    }
}

impl Shown {
    fn position(&self, [x, y]: [f64; 2]) -> Pos2 {
        self.transform.position_from_point(&PlotPoint::new(x, y))
    }

    /// The rectangle between the axes.
    #[must_use]
    pub fn frame(&self) -> Rect {
        *self.transform.frame()
    }

    /// By how much it is too low to be legible, in points.
    #[must_use]
    pub fn lacking(&self) -> f32 {
        let size = self.frame().size();
        (LEGIBLE * size.x - size.y).max(0.0)
    }
}
