//! The object that calls are about: the module holds one of each type, and the package makes it anew where a call is about
//! another. So nothing is allocated, and nothing need be freed.

use core::cell::UnsafeCell;

/// One object of a type, when there is one.
pub struct Current<H>(UnsafeCell<Option<H>>);

// SAFETY: a module without threads has one.
unsafe impl<H> Sync for Current<H> {}

impl<H> Current<H> {
    pub const fn none() -> Self {
        Self(UnsafeCell::new(None))
    }

    /// Puts an object in; returns whether there is one.
    pub fn put(&self, object: Option<H>) -> bool {
        // SAFETY: what `get` lends ends with the call that asked for it, and this one asked for nothing.
        let place = unsafe { &mut *self.0.get() };
        *place = object;
        place.is_some()
    }

    /// The object. The package has put one in before.
    #[allow(clippy::mut_from_ref)] // one thread, and each exported function asks once
    pub fn get(&'static self) -> &'static mut H {
        // SAFETY: as above.
        let object = unsafe { &mut *self.0.get() };
        object.as_mut().unwrap_or_else(|| core::arch::wasm32::unreachable())
    }
}
