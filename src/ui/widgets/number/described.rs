//! What a number that is typed is called, what it may be, and how it is written.

use egui::{Align2, Area, Frame, Order, Response, RichText, Ui, accesskit, vec2};

use super::parse;
use crate::widgets::hint;
use bxdf_study::format;
use bxdf_study::number::{NumberSpec, plain};

/// Says why a number is refused though it is within its range.
pub type Check<'a> = &'a dyn Fn(f64) -> Result<(), String>;

/// A number, and how it is edited.
pub struct Number<'a> {
    pub(super) name: &'a str,
    pub(super) spec: NumberSpec,
    pub(super) prefix: &'a str,
    /// By how much a drag of one point changes it; a share of the value where `is_logarithmic`.
    pub(super) speed: f64,
    pub(super) is_logarithmic: bool,
    /// The steps and the decimals of its slider.
    pub(super) step: f64,
    pub(super) decimals: usize,
    pub(super) check: Option<Check<'a>>,
}

/// A drag over this many points crosses the range of a slider.
const POINTS_FOR_ALL: f64 = 200.0;
/// A drag of one point changes a number that grows by ratios by this share.
pub(super) const LOGARITHMIC_SPEED: f64 = 0.02;
/// The decimals that a slider sets.
const SLIDER_DECIMALS: usize = 4;

impl<'a> Number<'a> {
    /// A number that tests and screen readers know by `name`.
    #[must_use]
    pub fn new(name: &'a str, spec: NumberSpec) -> Self {
        let [low, high] = spec.soft;
        Self {
            name,
            spec,
            prefix: "",
            speed: (high - low) / POINTS_FOR_ALL,
            is_logarithmic: false,
            step: 0.0,
            decimals: SLIDER_DECIMALS,
            check: None,
        }
    }

    /// With this text before it.
    #[must_use]
    pub fn prefix(mut self, prefix: &'a str) -> Self {
        self.prefix = prefix;
        self
    }

    /// Changed by this much by a drag of one point.
    #[must_use]
    pub fn speed(mut self, speed: f64) -> Self {
        self.speed = speed;
        self
    }

    /// Changed by ratios rather than by differences, if so.
    #[must_use]
    pub fn logarithmic(mut self, is_logarithmic: bool) -> Self {
        self.is_logarithmic = is_logarithmic;
        self
    }

    /// With a slider of such steps, 0 for none, and at most so many decimals.
    #[must_use]
    pub fn steps(mut self, step: f64, decimals: usize) -> Self {
        self.step = step;
        self.decimals = decimals;
        self
    }

    /// Refused where `check` says why.
    #[must_use]
    pub fn check(mut self, check: Check<'a>) -> Self {
        self.check = Some(check);
        self
    }

    /// The number for a text, or why it is none that is accepted.
    pub(super) fn read(&self, text: &str) -> Result<f64, String> {
        let allowed = self.spec.allowed();
        let said = || crate::widgets::draw::clipped(text.trim(), LONGEST_QUOTE);
        let Some(x) = parse::number(text, self.spec.unit) else {
            let what = if text.trim().is_empty() {
                "An empty text".to_owned()
            } else {
                format!("'{}'", said())
            };
            return Err(format!("{what} is no number; {allowed}"));
        };
        if !self.spec.admits(x) {
            let what = if self.spec.is_whole && x.fract() != 0.0 {
                "has a fraction"
            } else {
                "is out of range"
            };
            return Err(format!("{} {what}; {allowed}", said()));
        }
        let mut stored = x;
        self.spec.put(&mut stored, x);
        self.check.map_or(Ok(()), |check| check(stored))?;
        Ok(stored)
    }

    /// The change of one step from `value`.
    pub(super) fn step_at(&self, value: f64) -> f64 {
        let [low, high] = self.spec.soft;
        let step = if self.is_logarithmic {
            // From 0 no ratio leads away.
            (LOGARITHMIC_SPEED * value.abs()).max(1e-6 * (high - low))
        } else if self.step > 0.0 {
            self.step
        } else {
            self.speed
        };
        if self.spec.is_whole {
            step.max(1.0)
        } else {
            step
        }
    }

    /// The value as it stands in the field while nobody types: five digits, four decimals.
    #[must_use]
    pub fn shown(&self, value: f64) -> String {
        if self.spec.is_whole {
            self.with_unit(&plain(value))
        } else {
            self.with_unit(&shortened(value))
        }
    }

    /// The value as it stands there while it is dragged: three digits, more could not be read; but no fewer than steps change.
    pub(super) fn shown_moving(&self, value: f64) -> String {
        let short = format::typed(value);
        let is_near = |x: f64| (x - value).abs() < 0.5 * self.step_at(value);
        if short.parse().is_ok_and(is_near) {
            self.with_unit(&short)
        } else {
            self.shown(value)
        }
    }

    fn with_unit(&self, short: &str) -> String {
        let suffix = match self.spec.unit {
            "degrees" => "°".to_owned(),
            "" => String::new(),
            unit => format!(" {unit}"),
        };
        format!("{short}{suffix}")
    }
}

/// The most characters of a refused text that are said again.
const LONGEST_QUOTE: usize = 16;

/// A number in five digits and at most four decimals, where that says what it is.
fn shortened(value: f64) -> String {
    /// A value that four decimals change by more than this share is shown in three digits and a power of ten.
    const SHARE: f64 = 1e-3;
    const MOST: f64 = 1e6;
    let magnitude = value.abs().max(1.0).log10().floor();
    let decimals = (4.0 - magnitude).max(0.0) as usize;
    let text = format!("{value:.decimals$}");
    let rounded: f64 = text.parse().unwrap_or(value);
    if value.abs() >= MOST || (rounded - value).abs() > SHARE * value.abs() {
        return format::typed(value);
    }
    if !text.contains('.') {
        return text;
    }
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// A field that was drawn.
pub struct Shown {
    /// What became of it.
    pub response: Response,
    /// Why the text in it is refused, if it is.
    pub refusal: Option<String>,
}

impl Shown {
    /// With this tooltip.
    #[must_use]
    pub fn on_hover_text(self, text: &str) -> Self {
        let response = hint::at_number(self.response, text);
        // The tooltip is the description too: the reason goes before it.
        if let Some(words) = self.refusal.clone() {
            let describe = |node: &mut accesskit::Node| node.set_description(words);
            response.ctx.accesskit_node_builder(response.id, describe);
        }
        Self { response, ..self }
    }

    /// Says why the text is refused, if it is, where the next thing is drawn.
    pub fn explain(&self, ui: &mut Ui) {
        if let Some(words) = &self.refusal {
            let color = ui.visuals().error_fg_color;
            ui.label(RichText::new(words).small().color(color));
        }
    }

    /// The same above the field, for a bar in which nothing can stand below it.
    pub fn explain_above(&self, ui: &Ui) {
        /// Between the words and the field, in points.
        const GAP: f32 = 6.0;
        let Some(words) = &self.refusal else { return };
        let color = ui.visuals().error_fg_color;
        Area::new(self.response.id.with("refusal"))
            .order(Order::Tooltip)
            .interactable(false)
            .pivot(Align2::LEFT_BOTTOM)
            .fixed_pos(self.response.rect.left_top() - vec2(0.0, GAP))
            .show(ui.ctx(), |ui| {
                let words = egui::Label::new(RichText::new(words).color(color)).extend();
                Frame::popup(ui.style()).show(ui, |ui| ui.add(words));
            });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_shortened_where_nobody_types() {
        for (value, text) in [
            (0.0, "0"),
            (0.3, "0.3"),
            (0.123_456_789, "0.1235"),
            (0.000_123_4, "1.23e-4"),
            (-129.75, "-129.75"),
            (179.987_6, "179.99"),
            (10_000.0, "10000"),
            (1e10, "1e10"),
            (1e-12, "1e-12"),
        ] {
            assert_eq!(shortened(value), text);
        }
    }

    #[test]
    fn numbers_that_move_have_three_digits_unless_steps_are_finer() {
        let number = |high| Number::new("x", NumberSpec::new("x", [0.0, high])).speed(1e-3 * high);
        for (high, value, text) in [
            (1.0, 0.123_456, "0.123"),
            (1.0, 0.5, "0.5"),
            (100.0, 45.678, "45.7"),
            (1000.0, 999.04, "999"),
            (10.0, 9.9949, "9.99"),
        ] {
            assert_eq!(number(high).shown_moving(value), text);
        }
        let fine = number(10.0);
        assert_eq!(fine.speed(1e-4).shown_moving(4.1234), "4.1234");
    }

    #[test]
    fn refusals_say_what_is_allowed() {
        let seed = Number::new("Seed", NumberSpec::new("seed", [0.0, 9.0]).whole());
        for (text, words) in [
            ("", "An empty text is no number; "),
            ("abc", "'abc' is no number; "),
            ("1.5", "1.5 has a fraction; "),
            ("12", "12 is out of range; "),
            (&"x".repeat(40), "'xxxxxxxxxxxxxxxx…' is no number; "),
        ] {
            let said = seed.read(text).unwrap_err();
            assert_eq!(
                said,
                format!("{words}allowed is a whole number from 0 to 9")
            );
        }
        let is_even = |x: f64| match x % 2.0 {
            0.0 => Ok(()),
            _ => Err("odd".to_owned()),
        };
        let even = seed.check(&is_even);
        assert_eq!(
            (even.read("4"), even.read("5")),
            (Ok(4.0), Err("odd".to_owned()))
        );
    }
}
