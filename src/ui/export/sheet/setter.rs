//! Sets text for paper with the widgets of the window.

use std::sync::Arc;

use egui::{
    Align, Color32, Context, Layout, RawInput, Rect, RichText, Shape, Theme, Ui, Vec2, vec2,
};

use super::columns::{COLUMN, Item, WIDTH};
use crate::export::painted::Painted;
use crate::theme::{self, Palette};
use crate::widgets::lesson::Prose;
use bxdf_study::answers::Answers;
use bxdf_study::lessons::{Block, Scenes};
use bxdf_study::session::Session;

/// The size of letters, in points: 9 in print.
pub(super) const TEXT: f32 = 14.4;

/// The size of letters of what is not to be read at first, in points: 7 in print.
pub(super) const SMALL: f32 = 11.2;

/// The sizes of titles: of the sheet, of a lesson on a sheet of several, of a step.
pub(super) const TITLES: [f32; 3] = [27.0, 20.0, 17.0];

/// Pixels per point: letters are placed to a part of a pixel.
const FINENESS: f32 = 8.0;

/// More than the height of anything that is set at a time, in points.
const ROOM: f32 = 1.0e5;

/// How often a thing is laid out: what is centred knows its size from the time before.
const PASSES: usize = 2;

/// The length of the line for a name, in points.
const NAME_LINE: f32 = 190.0;

/// What sets text.
pub(super) struct Setter {
    ctx: Context,
    palette: Palette,
    answers: Answers,
}

impl Setter {
    /// One for paper of this theme.
    pub(super) fn new(theme: Theme) -> Self {
        let ctx = Context::default();
        theme::apply(&ctx);
        ctx.set_theme(theme);
        Self {
            ctx,
            palette: Palette::of(theme),
            answers: Answers::at_once(),
        }
    }

    /// What is added to a column that is this wide.
    fn set(&mut self, width: f32, mut add: impl FnMut(&mut Self, &mut Ui)) -> Painted {
        let ctx = self.ctx.clone();
        let room = Rect::from_min_size(egui::Pos2::ZERO, vec2(width, ROOM));
        let mut size = Vec2::ZERO;
        let mut shapes = Vec::new();
        for _ in 0..PASSES {
            let mut input = RawInput {
                screen_rect: Some(room),
                ..RawInput::default()
            };
            let screen = input.viewports.entry(input.viewport_id).or_default();
            screen.native_pixels_per_point = Some(FINENESS);
            let mut output = ctx.run_ui(input, |ui| {
                ui.set_max_width(width);
                ui.scope(|ui| add(self, ui));
                size = vec2(width, ui.min_rect().bottom());
            });
            // Nothing draws the letters but the page, which has their fonts.
            output.textures_delta.clear();
            shapes = output.shapes;
        }
        shapes.retain(|clipped| !matches!(clipped.shape, Shape::Noop));
        Painted::of_shapes(size, shapes)
    }

    /// Prose about a session.
    pub(super) fn prose(
        &mut self,
        session: &Session,
        add: impl FnMut(&mut Ui, &mut Prose<'_>),
    ) -> Painted {
        self.prose_of(TEXT, session, add)
    }

    /// Prose about a session, in letters of this size.
    pub(super) fn prose_of(
        &mut self,
        size: f32,
        session: &Session,
        mut add: impl FnMut(&mut Ui, &mut Prose<'_>),
    ) -> Painted {
        let scenes = Arc::new(Scenes::of(session));
        self.answers.begin_frame(session);
        self.set(COLUMN, |setter, ui| {
            let mut prose = Prose {
                scenes: &scenes,
                session,
                answers: &mut setter.answers,
                palette: &setter.palette,
                size,
            };
            add(ui, &mut prose);
        })
    }

    /// Text about a session, block by block: what leads to a formula stays with it.
    pub(super) fn blocks(&mut self, session: &Session, blocks: &[Block]) -> Vec<Item> {
        let nexts = blocks.iter().skip(1).map(Some).chain([None]);
        let mut items = Vec::new();
        for (block, next) in blocks.iter().zip(nexts) {
            let painted = self.prose(session, |ui, prose| {
                prose.blocks(ui, std::slice::from_ref(block));
            });
            let item = Item::of(painted);
            let leads = matches!(next, Some(Block::Formula(_)));
            items.push(if leads { item.bound() } else { item });
        }
        items
    }

    /// A title.
    pub(super) fn title(&mut self, words: &str, size: f32) -> Painted {
        self.set(COLUMN, |_, ui| {
            ui.label(RichText::new(words).size(size).strong());
        })
    }

    /// What is said beside the text.
    pub(super) fn note(&mut self, words: &str) -> Painted {
        self.set(COLUMN, |_, ui| {
            ui.label(RichText::new(words).size(TEXT).weak());
        })
    }

    /// The head of the first page; `has_name`: whether there is a line for a name.
    pub(super) fn head(&mut self, title: &str, about: &str, has_name: bool) -> Painted {
        self.set(WIDTH, |setter, ui| {
            ui.horizontal(|ui| {
                ui.label(RichText::new(title).size(TITLES[0]).strong());
                if has_name {
                    ui.with_layout(Layout::right_to_left(Align::BOTTOM), |ui| {
                        rule(ui, NAME_LINE, setter.palette.ink);
                        ui.label(RichText::new("Name").size(TEXT));
                    });
                }
            });
            ui.label(RichText::new(about).size(TEXT));
            ui.add_space(4.0);
            rule(ui, WIDTH, setter.palette.faint_ink);
            ui.add_space(8.0);
        })
    }

    /// The foot of a page.
    pub(super) fn foot(&mut self, title: &str, page: usize, count: usize) -> Painted {
        self.set(WIDTH, |_, ui| {
            ui.horizontal(|ui| {
                let words = |text: String| RichText::new(text).size(TEXT - 2.0).weak();
                ui.label(words(format!("BRDF Explorer: {title}")));
                ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                    ui.label(words(format!("{page} / {count}")));
                });
            });
        })
    }
}

/// A line to write on, or between parts of a page.
pub(super) fn rule(ui: &mut Ui, length: f32, color: Color32) {
    let height = if length < WIDTH { TEXT } else { 1.0 };
    let (rect, _) = ui.allocate_exact_size(vec2(length, height), egui::Sense::hover());
    let stroke = egui::Stroke::new(0.8, color);
    ui.painter().hline(rect.x_range(), rect.bottom(), stroke);
}
