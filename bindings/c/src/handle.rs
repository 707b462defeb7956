//! Objects in the caller's memory, and what a pointer may be.
//!
//! A handle is a struct of C that holds an object of Rust as it is. Its first `init` writes the object; all else reads it, or
//! changes it in place. What is in it has no destructor and points to nothing, so that it can be copied by assignment, and
//! forgotten.

use core::mem::{align_of, size_of};

use crate::status::terrella_status::{self, TERRELLA_NULL};

/// A struct of C in which an object fits.
///
/// # Safety
/// The struct must be at least as large and as aligned as the object, which [`handles`] asserts.
pub unsafe trait Handle {
    /// What is in it.
    type Object: Copy;
}

/// `handles! { name words alignment: Object; … }`: declares structs of as many words of 4 or 8 bytes.
macro_rules! handles {
    ($($(#[$doc:meta])* $name:ident [$word:ty; $words:literal]: $object:ty;)*) => {$(
        $(#[$doc])*
        #[repr(C)]
        pub struct $name {
            words: [$word; $words],
        }

        const _: () = $crate::handle::fits::<$name, $object>();

        // SAFETY: asserted above.
        unsafe impl $crate::handle::Handle for $name {
            type Object = $object;
        }
    )*};
}
pub(crate) use handles;

/// Fails to compile unless an object fits into a struct, and little is left over: counters are shorter on machines of 32 bits.
pub const fn fits<H, O>() {
    assert!(
        size_of::<O>() <= size_of::<H>() && size_of::<H>() < size_of::<O>() + 33 && align_of::<O>() <= align_of::<H>()
    );
}

/// Writes an object into a handle.
///
/// # Safety
/// `handle` is NULL, or points to a struct that may be written.
pub unsafe fn init<H: Handle>(handle: *mut H, object: H::Object) -> Result<(), terrella_status> {
    if handle.is_null() {
        return Err(TERRELLA_NULL);
    }
    // SAFETY: the object fits there.
    unsafe { handle.cast::<H::Object>().write(object) };
    Ok(())
}

/// The object of a handle.
///
/// # Safety
/// `handle` is NULL, or was written by [`init`].
pub unsafe fn object<'a, H: Handle>(handle: *const H) -> Result<&'a H::Object, terrella_status> {
    // SAFETY: as above.
    unsafe { handle.cast::<H::Object>().as_ref() }.ok_or(TERRELLA_NULL)
}

/// Handles in a row.
///
/// # Safety
/// `handles` is NULL, or points to `count` handles that were written by [`init`].
pub unsafe fn objects<'a, H: Handle>(handles: *const H, count: usize) -> Result<&'a [H::Object], terrella_status> {
    // One object is as long as one handle, or they would not stand in a row.
    const { assert!(size_of::<H>() == size_of::<H::Object>()) };
    if handles.is_null() {
        return if count == 0 { Ok(&[]) } else { Err(TERRELLA_NULL) };
    }
    // SAFETY: as above.
    Ok(unsafe { core::slice::from_raw_parts(handles.cast(), count) })
}

/// Writes a result to where it is wanted.
///
/// # Safety
/// `to` is NULL, or may be written.
pub unsafe fn put<T>(to: *mut T, value: T) {
    if !to.is_null() {
        // SAFETY: as above.
        unsafe { to.write(value) };
    }
}
