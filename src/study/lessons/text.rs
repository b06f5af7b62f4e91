//! The text of a lesson: a small part of Markdown, with words for things on the screen, numbers that follow the state, and
//! formulas.
//!
//! | written | is |
//! |---|---|
//! | `*so*`, `**so**` | emphasis |
//! | `[the light](#light)` | words for a thing: see [`Thing`] |
//! | `` `= rho_dh at light 80` `` | a number, computed: see [`Expression`](super::Expression) |
//! | `$\cos\theta$`, `$$...$$` | a formula in a line, and one by itself |
//! | `- so`, `1. so` | lists |

use std::ops::Range;

use percent_encoding::percent_decode_str;
use pulldown_cmark::{Event, Options, Parser, Tag, TagEnd};

use super::expression::Expression;
use super::formula;

/// A part of a text.
#[derive(Clone, Debug, PartialEq)]
pub enum Block {
    /// Running text.
    Paragraph(Vec<Span>),
    /// A list; `first`: the number of the first item, where they are numbered.
    List {
        /// The number of the first item; `None` for points.
        first: Option<u64>,
        /// The items.
        items: Vec<Vec<Block>>,
    },
    /// A formula by itself, in TeX.
    Formula(String),
}

/// A piece of running text.
#[derive(Clone, Debug, PartialEq)]
pub enum Span {
    /// Words.
    Words {
        /// What they say.
        text: String,
        /// How they are set.
        style: Style,
    },
    /// A number that follows the state.
    Number(Expression),
    /// A formula in the line, in TeX.
    Formula(String),
    /// What is typed or read on the screen, as it is.
    Code(String),
}

/// How words are set.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Style {
    /// Whether they are stressed.
    pub is_emphasis: bool,
    /// Whether they are stressed more.
    pub is_strong: bool,
    /// The thing that they are the words for.
    pub thing: Option<Thing>,
}

/// A thing on the screen that words stand for: pointing at the one marks the other.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Thing {
    /// The direction to the light: `#light`.
    Light,
    /// The direction to the viewer: `#viewer`.
    Viewer,
    /// The normal: `#n`.
    Normal,
    /// The half vector of light and viewer: `#h`.
    Half,
    /// The lobe: `#lobe`.
    Lobe,
    /// The mirror direction: `#mirror`.
    Mirror,
    /// A material by its number in the list, from 1 on: `#material-2`.
    Material(usize),
    /// A view by the id of its kind: `#view-polar`.
    View(String),
    /// A control of the window by its accessible name: `#control-Fixed`; spaces and parentheses are written as in
    /// addresses, `%20`, `%28` and `%29`.
    Control(String),
}

/// What things are called in a text.
const THINGS: &str =
    "#light, #viewer, #n, #h, #lobe, #mirror, #material-2, #view-polar, #control-Name";

impl Thing {
    /// The thing that has this name in pictures of directions.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        match name {
            "n" => Some(Self::Normal),
            "mirror" => Some(Self::Mirror),
            _ => None,
        }
    }

    /// The thing that a link leads to.
    ///
    /// # Errors
    /// A sentence with all that is allowed.
    pub fn read(link: &str) -> Result<Self, String> {
        let refused = || format!("a link to '{link}': allowed is {THINGS}");
        let name = link.strip_prefix('#').ok_or_else(refused)?;
        let behind = |begin: &str| {
            let rest = name.strip_prefix(begin)?;
            Some(percent_decode_str(rest).decode_utf8_lossy().into_owned())
        };
        Ok(match name {
            "light" => Self::Light,
            "viewer" => Self::Viewer,
            "n" => Self::Normal,
            "h" => Self::Half,
            "lobe" => Self::Lobe,
            "mirror" => Self::Mirror,
            _ => {
                if let Some(number) = behind("material-") {
                    Self::Material(number.parse().map_err(|_| refused())?)
                } else if let Some(id) = behind("view-") {
                    let kind = crate::views::find(&id).map_err(|error| error.to_string())?;
                    Self::View(kind.id.to_owned())
                } else {
                    Self::Control(behind("control-").ok_or_else(refused)?)
                }
            }
        })
    }
}

/// The events of Markdown, with the bytes that they are of.
pub(super) fn events(text: &str) -> impl Iterator<Item = (Event<'_>, Range<usize>)> {
    Parser::new_ext(text, Options::ENABLE_MATH).into_offset_iter()
}

/// A problem with the text from this byte on.
pub(super) type Problem = (usize, String);

/// Reads blocks from events until there are no more. `'e`: as long as the text lives.
pub(super) struct BlockReader {
    /// The lists that are open, each with its items.
    lists: Vec<(Option<u64>, Vec<Vec<Block>>)>,
    /// The blocks that are finished.
    blocks: Vec<Block>,
    /// The paragraph that is open.
    spans: Vec<Span>,
    style: Style,
}

impl BlockReader {
    pub(super) fn new() -> Self {
        Self {
            lists: Vec::new(),
            blocks: Vec::new(),
            spans: Vec::new(),
            style: Style::default(),
        }
    }

    /// Takes the blocks that are finished.
    pub(super) fn take(&mut self) -> Vec<Block> {
        self.close_paragraph();
        std::mem::take(&mut self.blocks)
    }

    /// # Errors
    /// What is no part of lessons, and formulas and expressions that are broken.
    pub(super) fn read(&mut self, event: Event<'_>, range: &Range<usize>) -> Result<(), Problem> {
        let at = |problem| (range.start, problem);
        match event {
            Event::Start(tag) => self.start(tag).map_err(at)?,
            Event::End(tag) => self.end(tag),
            Event::Text(text) => self.words(&text),
            Event::SoftBreak | Event::HardBreak => self.words(" "),
            Event::Code(code) => {
                let span = match code.strip_prefix('=') {
                    Some(text) => Span::Number(Expression::read(text).map_err(at)?),
                    None => Span::Code(code.into_string()),
                };
                self.spans.push(span);
            }
            Event::InlineMath(tex) => {
                formula::check(&tex).map_err(at)?;
                self.spans.push(Span::Formula(tex.into_string()));
            }
            Event::DisplayMath(tex) => {
                formula::check(&tex).map_err(at)?;
                self.close_paragraph();
                self.push(Block::Formula(tex.into_string()));
            }
            Event::Html(_) | Event::InlineHtml(_) => return Err(at(not_part("HTML"))),
            Event::FootnoteReference(_) => return Err(at(not_part("a footnote"))),
            Event::Rule => return Err(at(not_part("a rule"))),
            Event::TaskListMarker(_) => return Err(at(not_part("a list of tasks"))),
        }
        Ok(())
    }

    fn start(&mut self, tag: Tag<'_>) -> Result<(), String> {
        match tag {
            Tag::Paragraph => {}
            Tag::List(first) => {
                self.close_paragraph();
                self.lists.push((first, Vec::new()));
            }
            Tag::Item => {
                if let Some((_, items)) = self.lists.last_mut() {
                    items.push(Vec::new());
                }
            }
            Tag::Emphasis => self.style.is_emphasis = true,
            Tag::Strong => self.style.is_strong = true,
            Tag::Link { dest_url, .. } => self.style.thing = Some(Thing::read(&dest_url)?),
            Tag::Heading { .. } => {
                return Err(not_part("a heading but '## ' and the title of a step"));
            }
            Tag::CodeBlock(_) => {
                return Err("a block: allowed is state, show and ask".to_owned());
            }
            Tag::Image { .. } => return Err(not_part("a picture: a view shows it")),
            Tag::Table(_) => return Err(not_part("a table")),
            _ => return Err(not_part("this Markdown")),
        }
        Ok(())
    }

    fn end(&mut self, tag: TagEnd) {
        match tag {
            TagEnd::Paragraph | TagEnd::Item => self.close_paragraph(),
            TagEnd::List(_) => {
                self.close_paragraph();
                if let Some((first, items)) = self.lists.pop() {
                    self.push(Block::List { first, items });
                }
            }
            TagEnd::Emphasis => self.style.is_emphasis = false,
            TagEnd::Strong => self.style.is_strong = false,
            TagEnd::Link => self.style.thing = None,
            _ => {}
        }
    }

    /// Adds words to the paragraph.
    fn words(&mut self, text: &str) {
        if let Some(Span::Words { text: last, style }) = self.spans.last_mut()
            && *style == self.style
        {
            last.push_str(text);
            return;
        }
        self.spans.push(Span::Words {
            text: text.to_owned(),
            style: self.style.clone(),
        });
    }

    fn close_paragraph(&mut self) {
        let spans = std::mem::take(&mut self.spans);
        if !spans.is_empty() {
            self.push(Block::Paragraph(spans));
        }
    }

    /// Puts a block where it belongs: into the last item of the list that is open, or among all.
    fn push(&mut self, block: Block) {
        let item = self
            .lists
            .last_mut()
            .and_then(|(_, items)| items.last_mut());
        item.unwrap_or(&mut self.blocks).push(block);
    }
}

fn not_part(what: &str) -> String {
    format!("{what} is no part of a lesson")
}

/// The spans of a line of text, as of a question.
///
/// # Errors
/// As for blocks; and where it is not one paragraph.
pub(super) fn line(text: &str) -> Result<Vec<Span>, String> {
    let mut reader = BlockReader::new();
    for (event, range) in events(text) {
        reader.read(event, &range).map_err(|(_, problem)| problem)?;
    }
    match <[Block; 1]>::try_from(reader.take()) {
        Ok([Block::Paragraph(spans)]) => Ok(spans),
        _ => Err(format!(
            "'{}': expected one line of text",
            bxdf::error::shown(text)
        )),
    }
}

/// All spans of blocks, in the order in which they are read.
#[must_use]
pub fn spans(blocks: &[Block]) -> Vec<&Span> {
    let each = blocks.iter().flat_map(|block| match block {
        Block::Paragraph(spans) => spans.iter().collect(),
        Block::List { items, .. } => items.iter().flat_map(|item| spans(item)).collect(),
        Block::Formula(_) => Vec::new(),
    });
    each.collect()
}

/// Blocks as plain text, paragraphs by themselves: numbers as `value` says them.
pub fn plain(blocks: &[Block], value: &dyn Fn(&Expression) -> String) -> String {
    let each = blocks.iter().map(|block| match block {
        Block::Paragraph(spans) => plain_spans(spans, value),
        Block::Formula(tex) => tex.trim().to_owned(),
        Block::List { first, items } => {
            let items = items.iter().enumerate().map(|(index, item)| {
                let sign = match first {
                    Some(first) => format!("{}.", first + index as u64),
                    None => "-".to_owned(),
                };
                format!("{sign} {}", plain(item, value))
            });
            items.collect::<Vec<_>>().join("\n")
        }
    });
    each.collect::<Vec<_>>().join("\n\n")
}

/// Running text without its style.
pub fn plain_spans(spans: &[Span], value: &dyn Fn(&Expression) -> String) -> String {
    let each = spans.iter().map(|span| match span {
        Span::Words { text, .. } | Span::Code(text) => text.clone(),
        Span::Number(number) => value(number),
        Span::Formula(tex) => tex.trim().to_owned(),
    });
    each.collect()
}
