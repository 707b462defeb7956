//! The signs, letters, numbers and marks of which angles are written.

/// A letter N, S, E or W.
#[derive(Clone, Copy, Debug)]
pub(super) struct Hemisphere {
    pub is_latitude: bool,
    /// South or west.
    pub is_negative: bool,
}

/// What a mark stands for, from the largest to the smallest.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub(super) enum Unit {
    Degrees,
    Minutes,
    Seconds,
}

/// What a text is made of.
#[derive(Clone, Copy, Debug)]
pub(super) enum Token {
    Space,
    /// A comma or semicolon.
    Comma,
    Colon,
    Sign {
        negative: bool,
    },
    Hemisphere(Hemisphere),
    Mark(Unit),
    /// Digits, at least one, and at most one point.
    Number,
    Other,
}

/// The tokens of a part of a text, each with its first byte and the byte after its last.
pub(super) fn tokens(text: &str, (start, end): (usize, usize)) -> impl Iterator<Item = ((usize, usize), Token)> {
    let mut rest = text.get(start..end).unwrap_or_default();
    let mut at = start;
    core::iter::from_fn(move || {
        let (token, length) = first(rest)?;
        let begin = at;
        at += length;
        rest = rest.get(length..).unwrap_or_default();
        Some(((begin, at), token))
    })
}

/// The first token, and its length in bytes.
fn first(text: &str) -> Option<(Token, usize)> {
    let mut characters = text.chars();
    let character = characters.next()?;
    let length = character.len_utf8();
    let hemisphere = |is_latitude, is_negative| {
        Token::Hemisphere(Hemisphere {
            is_latitude,
            is_negative,
        })
    };
    // Marks as in GeographicLib's `DMS::Decode`.
    let token = match character {
        '0'..='9' | '.' => return Some(number(text)),
        ',' | ';' => Token::Comma,
        ':' => Token::Colon,
        '+' => Token::Sign { negative: false },
        '-' | '\u{2010}' | '\u{2011}' | '\u{2013}' | '\u{2212}' => Token::Sign { negative: true },
        'N' | 'n' => hemisphere(true, false),
        'S' | 's' => hemisphere(true, true),
        'E' | 'e' => hemisphere(false, false),
        'W' | 'w' => hemisphere(false, true),
        '°' | 'd' | 'D' | 'º' | '\u{2070}' | '˚' | '∘' => Token::Mark(Unit::Degrees),
        '"' | '″' | '“' | '”' | '\u{2ba}' | '\u{2dd}' => Token::Mark(Unit::Seconds),
        '\'' | '′' | '‘' | '’' | '´' | '`' | '\u{2b9}' => {
            // Two marks of minutes are one of seconds.
            if characters.next() == Some(character) {
                return Some((Token::Mark(Unit::Seconds), 2 * length));
            }
            Token::Mark(Unit::Minutes)
        }
        space if space.is_whitespace() => {
            let end = text.find(|c: char| !c.is_whitespace()).unwrap_or(text.len());
            return Some((Token::Space, end));
        }
        _ => Token::Other,
    };
    Some((token, length))
}

/// The number that a text begins with; a point alone is none.
fn number(text: &str) -> (Token, usize) {
    let digits = |text: &str| text.bytes().take_while(u8::is_ascii_digit).count();
    let whole = digits(text);
    let fraction = match text.get(whole..).and_then(|rest| rest.strip_prefix('.')) {
        Some(rest) => 1 + digits(rest),
        None => 0,
    };
    let length = whole + fraction;
    if length == 1 && whole == 0 {
        (Token::Other, 1)
    } else {
        (Token::Number, length)
    }
}
