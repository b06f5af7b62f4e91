//! The parts of an expression, and what they are worth.

use super::call::Call;
use super::scenes::Scenes;

/// What an expression is worth, or a phrase why there is no such number.
pub type Value<T> = Result<T, String>;

/// How near two numbers are that are said to be about the same.
const ABOUT: f64 = 0.01;

/// How near two numbers are that differ by rounding alone: an angle of 50 degrees is one whatever it was computed by.
const EQUAL: f64 = 1e-9;

#[derive(Clone, Debug, PartialEq)]
pub(super) enum Node {
    Number(f64),
    Of(Box<Call>),
    Negative(Box<Node>),
    Applied(Function, Box<Node>),
    Two(Operator, Box<[Node; 2]>),
}

/// A function of one number; angles are in degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Function {
    Root,
    Absolute,
    Cosine,
    Sine,
    Tangent,
}

/// The functions, by their names.
pub(super) const FUNCTIONS: [(&str, Function); 5] = [
    ("sqrt", Function::Root),
    ("abs", Function::Absolute),
    ("cos", Function::Cosine),
    ("sin", Function::Sine),
    ("tan", Function::Tangent),
];

impl Function {
    fn of(self, x: f64) -> f64 {
        match self {
            Self::Root => x.sqrt(),
            Self::Absolute => x.abs(),
            Self::Cosine => x.to_radians().cos(),
            Self::Sine => x.to_radians().sin(),
            Self::Tangent => x.to_radians().tan(),
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Operator {
    Plus,
    Minus,
    Times,
    Over,
    Power,
}

#[derive(Clone, Debug, PartialEq)]
pub(super) struct Comparison {
    pub(super) left: Node,
    pub(super) relation: Relation,
    pub(super) right: Node,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Relation {
    Less,
    AtMost,
    More,
    AtLeast,
    About,
}

impl Node {
    pub(super) fn value(&self, scenes: &Scenes) -> Value<f64> {
        let value = match self {
            Self::Number(number) => *number,
            Self::Of(call) => return scenes.value(call),
            Self::Negative(of) => -of.value(scenes)?,
            Self::Applied(function, of) => function.of(of.value(scenes)?),
            Self::Two(operator, both) => {
                let [left, right] = &**both;
                let (a, b) = (left.value(scenes)?, right.value(scenes)?);
                match operator {
                    Operator::Plus => a + b,
                    Operator::Minus => a - b,
                    Operator::Times => a * b,
                    Operator::Over => a / b,
                    Operator::Power => a.powf(b),
                }
            }
        };
        if value.is_finite() {
            Ok(value)
        } else {
            Err("the number is undefined here".to_owned())
        }
    }
}

impl Comparison {
    /// Whether it is so.
    pub(super) fn holds(&self, scenes: &Scenes) -> Value<bool> {
        let (a, b) = (self.left.value(scenes)?, self.right.value(scenes)?);
        let is_equal = (a - b).abs() <= EQUAL * b.abs();
        Ok(match self.relation {
            Relation::Less => a < b && !is_equal,
            Relation::AtMost => a < b || is_equal,
            Relation::More => a > b && !is_equal,
            Relation::AtLeast => a > b || is_equal,
            Relation::About => (a - b).abs() <= ABOUT * b.abs(),
        })
    }
}
