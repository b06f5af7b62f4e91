//! The words, numbers and signs of an expression.

use bxdf_lab::quantities::Given;

/// A piece of an expression.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Token<'a> {
    Number(f64),
    Word(&'a str),
    /// What stands in quotation marks.
    Text(&'a str),
    Sign(&'static str),
}

/// The signs, longer ones first.
const SIGNS: [&str; 13] = [
    "<=", ">=", "<", ">", "~", "+", "-", "*", "/", "^", "(", ")", ",",
];

/// The pieces of an expression, from the first one that is not taken yet.
pub(super) struct Tokens<'a> {
    tokens: std::iter::Peekable<std::vec::IntoIter<Token<'a>>>,
}

impl<'a> Tokens<'a> {
    /// # Errors
    /// A sentence, where there is a sign that none has, or a quotation mark too many.
    pub(super) fn of(text: &'a str) -> Result<Self, String> {
        let mut tokens = Vec::new();
        let mut rest = text.trim_start();
        while !rest.is_empty() {
            let (token, behind) = first(rest)?;
            tokens.push(token);
            rest = behind.trim_start();
        }
        Ok(Self {
            tokens: tokens.into_iter().peekable(),
        })
    }

    pub(super) fn next(&mut self) -> Option<Token<'a>> {
        self.tokens.next()
    }

    /// Takes the next piece, where it is this sign.
    pub(super) fn takes(&mut self, sign: &'static str) -> bool {
        self.tokens.next_if_eq(&Token::Sign(sign)).is_some()
    }

    /// Takes the next piece, where it is this word.
    pub(super) fn takes_word(&mut self, word: &'static str) -> bool {
        self.tokens.next_if_eq(&Token::Word(word)).is_some()
    }

    /// Takes this sign.
    pub(super) fn require(&mut self, sign: &'static str) -> Result<(), String> {
        match self.next() {
            Some(Token::Sign(found)) if found == sign => Ok(()),
            other => Err(Self::refused(other, &format!("'{sign}'"))),
        }
    }

    /// Takes a number, a word or a text.
    pub(super) fn given(&mut self, expected: &str) -> Result<Given, String> {
        if self.takes("-") {
            return match self.next() {
                Some(Token::Number(number)) => Ok(Given::Number(-number)),
                other => Err(Self::refused(other, expected)),
            };
        }
        match self.next() {
            Some(Token::Number(number)) => Ok(Given::Number(number)),
            Some(Token::Word(word) | Token::Text(word)) => Ok(Given::Word(word.to_owned())),
            other => Err(Self::refused(other, expected)),
        }
    }

    /// Says that the text ends here.
    pub(super) fn end(&mut self) -> Result<(), String> {
        match self.next() {
            None => Ok(()),
            other => Err(Self::refused(other, "the end")),
        }
    }

    /// A sentence: another piece stands where something was expected.
    pub(super) fn refused(found: Option<Token<'_>>, expected: &str) -> String {
        match found {
            None => format!("it ends where {expected} is expected"),
            Some(Token::Number(number)) => format!("'{number}' where {expected} is expected"),
            Some(Token::Word(word) | Token::Text(word) | Token::Sign(word)) => {
                format!("'{word}' where {expected} is expected")
            }
        }
    }
}

/// The first piece of a text that does not begin with white space, and what is behind it.
fn first(text: &str) -> Result<(Token<'_>, &str), String> {
    let begins = text.chars().next().unwrap_or_default();
    if let Some(quoted) = text.strip_prefix('"') {
        let found = quoted.split_once('"');
        let (inside, behind) = found.ok_or("a quotation mark is not closed")?;
        return Ok((Token::Text(inside), behind));
    }
    if begins.is_ascii_digit() || begins == '.' {
        let (number, behind) = text.split_at(number_length(text));
        let value = number.parse();
        let value = value.map_err(|_| format!("'{number}' is no number"))?;
        return Ok((Token::Number(value), behind));
    }
    if begins.is_ascii_alphabetic() {
        let is_in = |c: char| c.is_ascii_alphanumeric() || c == '_';
        let end = text.find(|c| !is_in(c)).unwrap_or(text.len());
        let (word, behind) = text.split_at(end);
        return Ok((Token::Word(word), behind));
    }
    let sign = SIGNS.iter().find(|sign| text.starts_with(**sign));
    let sign = sign.ok_or_else(|| format!("'{begins}' is no sign of an expression"))?;
    Ok((
        Token::Sign(sign),
        text.strip_prefix(sign).unwrap_or_default(),
    ))
}

/// How many bytes of the text are a number: digits, a point, and an exponent with its sign.
fn number_length(text: &str) -> usize {
    let mut length = 0;
    let mut last = '0';
    for c in text.chars() {
        let is_sign = matches!(c, '+' | '-') && matches!(last, 'e' | 'E');
        let is_exponent = matches!(c, 'e' | 'E') && last.is_ascii_digit();
        if !(c.is_ascii_digit() || c == '.' || is_sign || is_exponent) {
            break;
        }
        length += c.len_utf8();
        last = c;
    }
    length
}
