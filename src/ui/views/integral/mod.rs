//! The integral over the hemisphere: patches of equal solid angle that fall on the disc, and the bar that they fill.

use std::sync::Arc;

use egui::{Color32, Rect, Role, Sense, Ui, WidgetInfo, vec2};
use glam::DVec3;

use super::context::ViewContext;
use super::settings;
use crate::widgets::number::Number;
use crate::widgets::pictures::{self, Cell, ColorScale, ScaleKind};
use crate::widgets::{choice, draw};
use bxdf_lab::analysis::Channel;
use bxdf_lab::analysis::hemisphere::Range;
use bxdf_lab::analysis::integral::{Exact, Integrand, Request, Sum};
use bxdf_lab::analysis::reflectance::has_flux;
use bxdf_study::cursor::Cursor;
use bxdf_study::format;
use bxdf_study::session::{EntryId, MaterialEntry};
use bxdf_study::views::integral::{Options, PATCHES_LOG2, SECONDS};
use bxdf_study::views::{DECADES, ViewOptions as _};

use figure::{Figure, luminance};
use kept::Place;
use panel::Standing;
use play::Moment;
use scene::Scene;

mod figure;
mod kept;
mod panel;
mod play;
mod scene;
mod small;
mod words;

/// In a room wider than this, for each half of the sphere, the numbers stand beside the one picture, in points; and how wide they
/// are there.
const BESIDE: f32 = 400.0;
const PANEL: [f32; 2] = [230.0, 340.0];

/// A sum with what it comes near to.
struct Known {
    entry: EntryId,
    sum: Arc<Sum>,
    exact: Arc<Exact>,
}

pub(super) fn show(ui: &mut Ui, cx: &mut ViewContext<'_, Options>) {
    settings::show(ui, cx, controls);
    if let Some(note) = bxdf_study::export::nothing_to_show(cx.session) {
        draw::centred_note(ui, note);
        return;
    }
    if cx.options.is_of_held() && !has_flux(cx.session.held()) {
        draw::centred_note(ui, "No light arrives, of which a share could be summed");
        return;
    }
    let request = cx.options.request(cx.session);
    let meaning = words::meaning(request, cx.session);
    ui.label(egui::RichText::new(meaning).small().weak());
    let known = known(cx, request);
    let moment = play::moment(ui, cx);
    let range = Range::of(
        known
            .iter()
            .flat_map(|one| one.sum.parts.iter().map(luminance)),
    );
    let scale = scale(range, cx.options.is_logarithmic);
    let halves = if request.is_sphere { 2 } else { 1 };
    let is_beside = known.len() == 1 && ui.available_width() > BESIDE * halves as f32;
    let shown = |known| Shown {
        known,
        request,
        scale,
        moment,
    };
    if let ([one], false) = (&known[..], is_beside) {
        for (note, color) in shown(one).notes(cx, None) {
            ui.label(egui::RichText::new(note).small().color(color));
        }
    }
    let room = ui.available_rect_before_wrap();
    let width = (0.34 * room.width()).clamp(PANEL[0], PANEL[1]);
    let mut pictures = if is_beside {
        room.with_max_x(room.right() - width)
    } else {
        room
    };
    if request.integrand != Integrand::One && range.highest > 0.0 {
        let name = cx.options.quantity_name();
        pictures = pictures::color_bar(ui, pictures, scale, &name, cx.palette);
    }
    let cells = if is_beside {
        pictures::cells(ui, pictures, known.len(), Scene::aspect(halves))
    } else {
        small::cells(ui, pictures, known.len(), halves)
    };
    for (cell, one) in cells.into_iter().zip(&known) {
        let shown = shown(one);
        if is_beside {
            let cell = Cell {
                picture: pictures.intersect(room),
                ..cell
            };
            let linked = shown.figure(ui, cx, cell.picture);
            let panel = room.with_min_x(room.right() - width + 12.0);
            shown.panel(ui, cx, panel, linked);
        } else {
            pictures::title(ui, cell, one.entry, cx.session, cx.palette);
            shown.small(ui, cx, cell.picture);
        }
    }
    ui.advance_cursor_after_rect(room);
}

fn controls(ui: &mut Ui, cx: &mut ViewContext<'_, Options>) {
    ui.horizontal_wrapped(|ui| {
        let hint = "What is summed over the directions: 1, the cosine, f cos θ of the material, or the density of its sampler";
        let options = &mut *cx.options;
        choice::choice(
            ui,
            ("Integrand", hint),
            &mut options.integrand,
            &Integrand::ALL,
            Integrand::title,
        );
        let hint = "Into how many patches a hemisphere is cut, in equal steps of z and φ: a power of 2";
        let log2 = &mut options.count_log2;
        choice::power_of_two(ui, ("Patches", hint), log2, &PATCHES_LOG2);
        play::button(ui, cx);
        let options = &mut *cx.options;
        let hint = "How long playing takes, in seconds";
        let number = Number::new("Duration", SECONDS).speed(0.1);
        choice::number(ui, ("Duration", hint), &number, &mut options.seconds);
        let hint = "Colours by decades below the highest value";
        choice::switch(ui, ("By decades", hint), &mut options.is_logarithmic);
    });
}

/// The sums of the materials shown. What is of the sphere alone is summed once.
fn known(cx: &mut ViewContext<'_, Options>, request: Request) -> Vec<Known> {
    let (session, answers) = (&*cx.session, &mut *cx.answers);
    let exact = cx.options.exact_request(session);
    let known = |entry: &MaterialEntry| Known {
        entry: entry.id(),
        sum: answers.ask(session, entry, request),
        exact: answers.ask(session, entry, exact),
    };
    let most = if request.integrand.is_of_surface() {
        usize::MAX
    } else {
        1
    };
    session.materials.shown().take(most).map(known).collect()
}

/// The colours of values that reach so far.
fn scale(range: Range, is_logarithmic: bool) -> ColorScale {
    let largest = if range.highest > 0.0 {
        range.highest
    } else {
        1.0
    };
    if is_logarithmic {
        let least = largest * 10_f64.powf(-DECADES);
        ColorScale {
            range: [range.smallest_positive.clamp(least, 0.5 * largest), largest],
            kind: ScaleKind::Logarithmic,
        }
    } else {
        ColorScale {
            range: [0.0, largest],
            kind: ScaleKind::Linear,
        }
    }
}

/// A sum as it is shown.
struct Shown<'a> {
    known: &'a Known,
    request: Request,
    scale: ColorScale,
    moment: Moment,
}

impl Shown<'_> {
    fn color(&self, cx: &ViewContext<'_, Options>) -> Color32 {
        let entry = cx.session.materials.get(self.known.entry);
        entry.map_or(cx.palette.ink, |entry| cx.palette.material(entry.slot()))
    }

    /// The halves with their discs. Returns the index of the patch that is linked with its shadow.
    fn figure(&self, ui: &Ui, cx: &mut ViewContext<'_, Options>, rect: Rect) -> Option<usize> {
        let sum = &*self.known.sum;
        let scenes: Vec<Scene> = if self.request.is_sphere {
            let (left, right) = rect.split_left_right_at_fraction(0.5);
            vec![Scene::new(left, true), Scene::new(right, false)]
        } else {
            vec![Scene::new(rect, true)]
        };
        let entry = cx.session.materials.get(self.known.entry);
        let name = entry.map_or_else(String::new, |entry| cx.session.materials.title(entry));
        let id = ui.scope_id().with(("patches", self.known.entry));
        let response = ui.interact(rect, id, Sense::hover());
        response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, &name));
        let pointer = response.hover_pos();
        let direction = pointer.and_then(|at| scenes.iter().find_map(|scene| scene.direction(at)));
        let pointed = direction.map(|w| {
            let below = if w.z > 0.0 { 0 } else { sum.grid.count() };
            below + sum.grid.index_of(w)
        });
        let eye = scenes.first().map_or(DVec3::Z, |scene| scene.eye);
        let linked = pointed.or_else(|| figure::linked(sum, self.moment, eye));
        let figure = Figure {
            sum,
            scale: self.scale,
            moment: self.moment,
            linked,
            color: self.color(cx),
            palette: cx.palette,
        };
        let painter = ui.painter_at(rect);
        let all = || {
            scenes
                .iter()
                .flat_map(|scene| figure.shapes(scene))
                .collect()
        };
        let shapes = if self.moment.is_playing() {
            Arc::new(all())
        } else {
            let place = Place {
                rect,
                request: self.request,
                theme: ui.theme(),
                color: self.color(cx),
            };
            let sum = (self.known.entry, &self.known.sum);
            kept::shapes(ui, cx, sum, (place, self.scale), all)
        };
        painter.extend(shapes.iter().cloned());
        for scene in &scenes {
            figure.draw_link(&painter, scene);
        }
        let mut taken = Vec::new();
        let has_held = self.request.integrand.is_of_surface();
        let directions = cx.directions();
        let directions = if has_held { &directions[..] } else { &[] };
        let drawn = (&scenes[..], directions);
        figure::name_directions(ui, &painter, drawn, &mut taken, cx.palette);
        figure.draw_deltas(ui, &painter, &scenes, &mut taken);
        if let (Some(pointer), Some(direction)) = (pointer, direction) {
            let text = pointed.and_then(|index| self.product(index));
            let cursor = Cursor {
                material: self.known.entry,
                direction,
            };
            let text = format!(
                "{}\n{}",
                draw::cursor_place(&cursor, cx.session),
                text.unwrap_or_default()
            );
            draw::pointer_note(ui, pointer, ui.clip_rect(), &text, cx.palette);
            *cx.pointed = Some(cursor);
        }
        linked
    }

    /// What a patch adds, as a product.
    fn product(&self, index: usize) -> Option<String> {
        let part = self.known.sum.parts.get(index)?;
        let title = match self.request.integrand {
            Integrand::One => String::new(),
            integrand => format!("{} ", integrand.title()),
        };
        let [value, solid_angle] = [luminance(part), part.patch.solid_angle()].map(format::value);
        let share = format::value(Channel::Luminance.of(part.share()));
        Some(format!("{title}{value} × {solid_angle} sr = {share}"))
    }

    /// How the sum stands.
    fn standing<'a>(&'a self, cx: &'a ViewContext<'_, Options>) -> Standing<'a> {
        let (sum, exact) = (&*self.known.sum, &*self.known.exact);
        let counted = self.moment.counted(sum.parts.len() + sum.deltas.len());
        let integrand = self.request.integrand;
        let so_far = sum.luminance_of_first(counted);
        let error = exact.value.map_or_else(String::new, |value| {
            words::error(integrand, so_far, Channel::Luminance.of(value), self.moment)
        });
        let symbol = words::symbol(self.request, cx.session);
        Standing {
            sum,
            exact,
            scale: self.scale,
            counted,
            lines: [
                words::counted(sum, self.moment),
                words::exact(symbol, exact),
                error,
            ],
            color: self.color(cx),
            palette: cx.palette,
        }
    }

    /// What is worth a note: lobes that are missed, samples that are elsewhere.
    fn notes(
        &self,
        cx: &ViewContext<'_, Options>,
        linked: Option<usize>,
    ) -> Vec<(String, Color32)> {
        let (sum, exact) = (&*self.known.sum, &*self.known.exact);
        let mut notes = Vec::new();
        let product = linked.and_then(|index| self.product(index));
        notes.extend(product.map(|text| (format!("Outlined patch: {text}"), cx.palette.faint_ink)));
        if !self.moment.is_playing() {
            let missed = exact.missed(sum);
            notes.extend(
                missed
                    .iter()
                    .map(|one| (words::missed(one), cx.palette.warning)),
            );
        }
        if self.request.integrand == Integrand::Density {
            notes.extend(words::elsewhere(exact).map(|text| (text, cx.palette.ink)));
        }
        let is_dark = sum.parts.iter().all(|part| part.value == [0.0; 3]);
        if is_dark && !sum.parts.is_empty() {
            let text = if sum.deltas.is_empty() {
                "All values are 0: nothing falls"
            } else {
                "All light is in Dirac deltas: only points fall"
            };
            notes.push((text.to_owned(), cx.palette.ink));
        }
        notes
    }

    /// The bar and the numbers beside the picture.
    fn panel(&self, ui: &mut Ui, cx: &ViewContext<'_, Options>, room: Rect, linked: Option<usize>) {
        let symbol = words::symbol(self.request, cx.session);
        self.standing(cx)
            .show(ui, room, symbol, &self.notes(cx, linked));
    }

    /// The picture with a slim bar, and the numbers below it.
    fn small(&self, ui: &mut Ui, cx: &mut ViewContext<'_, Options>, rect: Rect) {
        let font = draw::small_font(ui);
        let is_narrow = small::is_narrow(rect.width());
        let (line, lines) = (small::line_height(ui), small::lines(ui, rect));
        let picture = rect.with_max_y(rect.bottom() - lines as f32 * line);
        let bar = picture
            .with_min_x(picture.right() - small::BAR)
            .shrink2(vec2(0.0, 6.0));
        let picture = picture.with_max_x(bar.left() - small::BAR_GAP);
        self.figure(ui, cx, picture);
        let standing = self.standing(cx);
        standing.bar(ui.painter(), bar.translate(vec2(-5.0, 0.0)));
        let [counted, exact, error] = &standing.lines;
        let missed = self.known.exact.missed(&self.known.sum);
        let is_missed = !missed.is_empty() && !self.moment.is_playing();
        let so_far = words::number(standing.so_far());
        let texts = if is_narrow {
            standing.short_lines(&so_far)
        } else {
            let verdict = if is_missed { ", too coarse" } else { "" };
            let first = format!("{counted}: {so_far}{verdict}");
            vec![first, format!("{exact}, {}", error.to_lowercase())]
        };
        let color = if is_missed {
            cx.palette.warning
        } else {
            cx.palette.ink
        };
        let painter = ui.painter_at(rect);
        let galleys = texts
            .into_iter()
            .map(|text| painter.layout_no_wrap(text, font.clone(), color))
            .filter(|galley| galley.size().x <= rect.width());
        for (row, galley) in galleys.take(lines).enumerate() {
            let at = egui::pos2(rect.left(), picture.bottom() + row as f32 * line);
            painter.galley(at, galley, color);
        }
    }
}
