//! How expressions are read: `rho_dh at light 80 < 1 - share(diffuse)`.
//!
//! ```text
//! condition  = comparison { "and" comparison }
//! comparison = sum [ "<" | "<=" | ">" | ">=" | "~" ] sum ]     a ~ b: within one in a hundred
//! sum        = product { ("+" | "-") product }
//! product    = factor { ("*" | "/") factor }
//! factor     = [ "-" ] term [ "^" factor ]
//! term       = number | "pi" | function "(" sum ")" | "(" sum ")" | quantity
//! function   = "sqrt" | "abs" | "cos" | "sin" | "tan"          of angles in degrees
//! quantity   = word [ "(" given { "," given } ")" ] [ "at" setting { "," setting } ]
//! setting    = ("light" | "viewer" | "material" | parameter) ( number | word | "text" )
//! ```

use std::f64::consts::PI;

use super::call::{Call, Setting};
use super::node::{Comparison, FUNCTIONS, Node, Operator, Relation};
use super::tokens::{Token, Tokens};
use bxdf_lab::quantities::find;

/// How deep an expression may be nested: a text that asks for more is broken.
const MAX_DEPTH: usize = 32;

pub(super) fn comparison(tokens: &mut Tokens<'_>) -> Result<Comparison, String> {
    let left = sum(tokens, 0)?;
    let relation = match tokens.next() {
        Some(Token::Sign("<")) => Relation::Less,
        Some(Token::Sign("<=")) => Relation::AtMost,
        Some(Token::Sign(">")) => Relation::More,
        Some(Token::Sign(">=")) => Relation::AtLeast,
        Some(Token::Sign("~")) => Relation::About,
        other => return Err(Tokens::refused(other, "a comparison: <, <=, >, >= or ~")),
    };
    let right = sum(tokens, 0)?;
    Ok(Comparison {
        left,
        relation,
        right,
    })
}

fn two(operator: Operator, left: Node, right: Node) -> Node {
    Node::Two(operator, Box::new([left, right]))
}

pub(super) fn sum(tokens: &mut Tokens<'_>, depth: usize) -> Result<Node, String> {
    let mut node = product(tokens, depth)?;
    loop {
        let operator = if tokens.takes("+") {
            Operator::Plus
        } else if tokens.takes("-") {
            Operator::Minus
        } else {
            return Ok(node);
        };
        node = two(operator, node, product(tokens, depth)?);
    }
}

fn product(tokens: &mut Tokens<'_>, depth: usize) -> Result<Node, String> {
    let mut node = factor(tokens, depth)?;
    loop {
        let operator = if tokens.takes("*") {
            Operator::Times
        } else if tokens.takes("/") {
            Operator::Over
        } else {
            return Ok(node);
        };
        node = two(operator, node, factor(tokens, depth)?);
    }
}

fn factor(tokens: &mut Tokens<'_>, depth: usize) -> Result<Node, String> {
    if depth > MAX_DEPTH {
        return Err(format!("it is nested more than {MAX_DEPTH} deep"));
    }
    if tokens.takes("-") {
        return Ok(Node::Negative(Box::new(factor(tokens, depth + 1)?)));
    }
    let base = term(tokens, depth)?;
    if tokens.takes("^") {
        return Ok(two(Operator::Power, base, factor(tokens, depth + 1)?));
    }
    Ok(base)
}

fn term(tokens: &mut Tokens<'_>, depth: usize) -> Result<Node, String> {
    match tokens.next() {
        Some(Token::Number(number)) => Ok(Node::Number(number)),
        Some(Token::Sign("(")) => {
            let node = sum(tokens, depth + 1)?;
            tokens.require(")")?;
            Ok(node)
        }
        Some(Token::Word("pi")) => Ok(Node::Number(PI)),
        Some(Token::Word(word)) => {
            let function = FUNCTIONS.iter().find(|(name, _)| *name == word);
            match function {
                Some((_, function)) => {
                    let of = in_parentheses(tokens, depth)?;
                    Ok(Node::Applied(*function, Box::new(of)))
                }
                None => quantity(tokens, word).map(|call| Node::Of(Box::new(call))),
            }
        }
        other => Err(Tokens::refused(other, "a number or a quantity")),
    }
}

fn in_parentheses(tokens: &mut Tokens<'_>, depth: usize) -> Result<Node, String> {
    tokens.require("(")?;
    let node = sum(tokens, depth + 1)?;
    tokens.require(")")?;
    Ok(node)
}

fn quantity(tokens: &mut Tokens<'_>, word: &str) -> Result<Call, String> {
    let quantity = find(word).map_err(|error| error.to_string())?;
    let mut given = Vec::new();
    if tokens.takes("(") {
        loop {
            given.push(tokens.given("an argument")?);
            if !tokens.takes(",") {
                break;
            }
        }
        tokens.require(")")?;
    }
    let checked = quantity.check(&given);
    checked.map_err(|problem| format!("{}: {problem}", quantity.id))?;
    let mut settings = Vec::new();
    if tokens.takes_word("at") {
        loop {
            let name = match tokens.next() {
                Some(Token::Word(name)) => name.to_owned(),
                other => {
                    let allowed = "light, viewer, material or the name of a parameter";
                    return Err(Tokens::refused(other, allowed));
                }
            };
            let value = tokens.given("its value")?;
            let azimuth = match name.as_str() {
                "light" | "viewer" if tokens.takes_word("azimuth") => Some(Setting {
                    name: format!("{name} azimuth"),
                    value: tokens.given("an azimuth")?,
                }),
                _ => None,
            };
            settings.push(Setting { name, value });
            settings.extend(azimuth);
            if !tokens.takes(",") {
                break;
            }
        }
    }
    Ok(Call {
        quantity,
        given,
        settings,
    })
}
