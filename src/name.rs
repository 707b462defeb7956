//! Lists whose entries have names: their text in and out, and the error for a name that is not in the list.

use core::fmt::{self, Write};

/// The first characters of a text, as many as fit into 30 bytes.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub struct Name {
    bytes: [u8; 30],
    length: u8,
    cut: bool,
}

impl Name {
    pub fn new(text: &str) -> Self {
        let mut bytes = [0; 30];
        let ends = text.char_indices().map(|(at, letter)| at + letter.len_utf8());
        let length = ends.take_while(|&end| end <= bytes.len()).last().unwrap_or(0);
        for (kept, byte) in bytes.iter_mut().zip(text.bytes().take(length)) {
            *kept = byte;
        }
        Self {
            bytes,
            length: length as u8,
            cut: length < text.len(),
        }
    }

    /// The characters that were kept.
    pub fn as_str(&self) -> &str {
        let kept = self.bytes.get(..self.length.into()).unwrap_or_default();
        core::str::from_utf8(kept).unwrap_or_default()
    }
}

impl fmt::Debug for Name {
    /// Writes the characters in quotation marks, with `…` after them if the text was longer.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Debug::fmt(self.as_str(), f)?;
        if self.cut { f.write_char('…') } else { Ok(()) }
    }
}

#[cfg(feature = "defmt")]
impl defmt::Format for Name {
    fn format(&self, f: defmt::Formatter<'_>) {
        defmt::write!(f, "{=str:?}", self.as_str());
    }
}

/// `unknown!(UnknownThing, "thing", names)`: declares the error for a name that is not in a list.
macro_rules! unknown {
    ($error:ident, $what:literal, $known:expr) => {
        #[doc = concat!("The error for a name that no ", $what, " has.")]
        ///
        /// It keeps the first 30 bytes of the name. Its text lists the names that are known.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        pub struct $error($crate::name::Name);

        impl $error {
            pub(crate) fn new(name: &str) -> Self {
                Self($crate::name::Name::new(name))
            }

            /// Returns the name that was refused, cut after at most 30 bytes.
            #[must_use]
            pub fn name(&self) -> &str {
                self.0.as_str()
            }
        }

        impl core::fmt::Display for $error {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                write!(f, concat!("unknown ", $what, " {:?}; expected one of:"), self.0)?;
                $known.enumerate().try_for_each(|(i, name)| {
                    f.write_str(if i == 0 { " " } else { ", " })?;
                    write!(f, "{name}")
                })
            }
        }

        impl core::error::Error for $error {}
    };
}

/// `by_name!(Thing, UnknownThing, "thing")`: implements `Display` and `FromStr` for a list with `ALL` and
/// `name`, and declares the error.
macro_rules! by_name {
    ($thing:ident, $error:ident, $what:literal) => {
        impl core::fmt::Display for $thing {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                f.pad(self.name())
            }
        }

        impl core::str::FromStr for $thing {
            type Err = $error;

            fn from_str(name: &str) -> Result<Self, $error> {
                let mut all = Self::ALL.iter().copied();
                all.find(|thing| thing.name() == name)
                    .ok_or_else(|| $error::new(name))
            }
        }

        $crate::name::unknown!($error, $what, $thing::ALL.iter());
    };
}
pub(crate) use {by_name, unknown};
