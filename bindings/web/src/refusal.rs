//! Words of errors on their way out, in a fixed place of the module's memory. Numbers in them are written by JavaScript,
//! which has the code for that already.

use core::cell::UnsafeCell;
use core::fmt::{self, Debug, Display, Write};

use terrella::batch::InvalidBatch;

/// How many bytes of words there are; longer ones are cut.
const BYTES: usize = 256;

struct Words(UnsafeCell<([u8; BYTES], usize)>);

// SAFETY: a module without threads has one.
unsafe impl Sync for Words {}

static WORDS: Words = Words(UnsafeCell::new(([0; BYTES], 0)));

/// Where the words are.
#[unsafe(no_mangle)]
extern "C" fn words() -> *mut u8 {
    WORDS.0.get().cast()
}

/// How many bytes of them there are.
#[unsafe(no_mangle)]
extern "C" fn words_length() -> usize {
    // SAFETY: nothing is lent between calls.
    unsafe { (*WORDS.0.get()).1 }
}

unsafe extern "C" {
    /// Writes a number's text to a place that has room for it, and returns its bytes.
    safe fn write_number(number: f64, to: *mut u8) -> usize;
}

/// The bytes of the longest text of a number.
const LONGEST: usize = 32;

/// A number in an error.
#[derive(Clone, Copy, PartialEq)]
pub struct Value(pub f64);

impl Debug for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut text = [0; LONGEST];
        let length = write_number(self.0, text.as_mut_ptr());
        f.write_str(str::from_utf8(text.get(..length).unwrap_or_default()).unwrap_or_default())
    }
}

impl Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        Debug::fmt(self, f)
    }
}

struct Writer<'a>(&'a mut ([u8; BYTES], usize));

impl Write for Writer<'_> {
    fn write_str(&mut self, words: &str) -> fmt::Result {
        let (bytes, length) = &mut *self.0;
        for (slot, byte) in bytes.iter_mut().skip(*length).zip(words.bytes()) {
            *slot = byte;
            *length += 1;
        }
        Ok(())
    }
}

/// An error whose numbers can be handed to JavaScript.
pub trait Refusal {
    /// The same with [`Value`]s.
    type Words: Display;

    fn words(self) -> Self::Words;
}

fn leave(why: impl Refusal) {
    // SAFETY: nothing is lent: this is called where a function ends.
    let memory = unsafe { &mut *WORDS.0.get() };
    memory.1 = 0;
    let _ = write!(Writer(memory), "{}", why.words());
}

/// What a result holds, or nothing and the words of its error.
pub fn or_words<T>(result: Result<T, impl Refusal>) -> Option<T> {
    result.map_err(leave).ok()
}

/// The number of elements that a batch refused; leaves the index of the first in the first column, and its words.
pub fn refused<E: Refusal>(result: Result<(), InvalidBatch<E>>) -> usize {
    match result {
        Ok(()) => 0,
        Err(InvalidBatch::Elements { count, first, why }) => {
            leave(why);
            crate::columns::leave([first as f64]);
            count
        }
        // The package hands over columns of one length.
        Err(InvalidBatch::Lengths { .. }) => usize::MAX,
    }
}

/// Errors of the crate, variant by variant.
macro_rules! refusals {
    ($($error:ident { $($variant:ident ( $inner:ident ))* })*) => {$(
        impl Refusal for $error<f64> {
            type Words = $error<Value>;

            fn words(self) -> Self::Words {
                match self {
                    $(Self::$variant(why) => $error::$variant(refusals!(@ $inner why)),)*
                }
            }
        }
    )*};
    (@ number $why:ident) => { Value($why) };
    (@ refusal $why:ident) => { $why.words() };
}
pub(crate) use refusals;

mod common {
    use terrella::{InvalidEllipsoid, InvalidLatLon};

    use super::{Refusal, Value};

    refusals! {
        InvalidLatLon { Latitude(number) Longitude(number) }
        InvalidEllipsoid { SemiMajorAxis(number) Flattening(number) }
    }

    impl Refusal for terrella::latitude::UnsupportedFlattening<f64> {
        type Words = terrella::latitude::UnsupportedFlattening<Value>;

        fn words(self) -> Self::Words {
            terrella::latitude::UnsupportedFlattening(Value(self.0))
        }
    }
}
