//! Objects in the caller's memory, and what a pointer may be.
//!
//! A handle is a struct of C that holds an object of Rust as it is, and a mark that it does. Its `init` writes both, or takes
//! the mark away if it is refused; all else reads the object. What is in it has no destructor and points to nothing, so that it
//! can be copied by assignment, and forgotten.

use core::mem::{align_of, size_of};

use crate::status::terrella_status::{self, TERRELLA_NOT_MADE, TERRELLA_NULL};

/// What stands in a handle that was made.
const MADE: u32 = 0x7e44_e11a;

/// A struct of C in which an object fits, and a mark.
///
/// # Safety
/// The struct must be at least as large and as aligned as the object, which [`handles`] asserts.
pub unsafe trait Handle {
    /// What is in it.
    type Object: Copy;

    /// Where its mark is.
    ///
    /// # Safety
    /// `handle` points to a struct.
    unsafe fn mark(handle: *const Self) -> *mut u32;
}

/// `handles! { name [word; words]: Object; … }`: declares structs of as many words of 4 or 8 bytes, and the mark.
macro_rules! handles {
    ($($(#[$doc:meta])* $name:ident [$word:ty; $words:literal]: $object:ty;)*) => {$(
        $(#[$doc])*
        #[repr(C)]
        pub struct $name {
            words: [$word; $words],
            made: u32,
        }

        const _: () = $crate::handle::fits::<[$word; $words], $object>();

        // SAFETY: asserted above.
        unsafe impl $crate::handle::Handle for $name {
            type Object = $object;

            unsafe fn mark(handle: *const Self) -> *mut u32 {
                // SAFETY: the caller's.
                unsafe { (&raw const (*handle).made).cast_mut() }
            }
        }
    )*};
}
pub(crate) use handles;

/// Fails to compile unless an object fits into words, and little is left over: counters are shorter on machines of 32 bits.
pub const fn fits<H, O>() {
    assert!(
        size_of::<O>() <= size_of::<H>() && size_of::<H>() < size_of::<O>() + 33 && align_of::<O>() <= align_of::<H>()
    );
}

/// Writes an object into a handle, or that there is none.
///
/// # Safety
/// `handle` is NULL, or points to a struct that may be written.
pub unsafe fn init<H: Handle>(
    handle: *mut H,
    object: impl FnOnce() -> Result<H::Object, terrella_status>,
) -> Result<(), terrella_status> {
    if handle.is_null() {
        return Err(TERRELLA_NULL);
    }
    // SAFETY: the object and the mark fit there. The object is made before the mark is touched: it may be made of this handle.
    unsafe {
        let object = object();
        H::mark(handle).write(if object.is_ok() { MADE } else { 0 });
        handle.cast::<H::Object>().write(object?);
    }
    Ok(())
}

/// The object of a handle.
///
/// # Safety
/// `handle` is NULL, or points to a struct.
pub unsafe fn object<'a, H: Handle>(handle: *const H) -> Result<&'a H::Object, terrella_status> {
    if handle.is_null() {
        return Err(TERRELLA_NULL);
    }
    // SAFETY: as above; a struct that is marked holds an object.
    unsafe {
        if H::mark(handle).read() != MADE {
            return Err(TERRELLA_NOT_MADE);
        }
        Ok(&*handle.cast::<H::Object>())
    }
}

/// A struct of C that is an object, as long as it: for arrays. Any bits of it are an object.
///
/// # Safety
/// As for [`Handle`], and each bit pattern must be safe to read.
pub unsafe trait Row {
    /// What it is.
    type Object: Copy;
}

/// Writes an object of a row.
///
/// # Safety
/// `row` is NULL, or may be written.
pub unsafe fn init_row<R: Row>(row: *mut R, object: R::Object) -> Result<(), terrella_status> {
    if row.is_null() {
        return Err(TERRELLA_NULL);
    }
    // SAFETY: as above.
    unsafe { row.cast::<R::Object>().write(object) };
    Ok(())
}

/// Objects in a row.
///
/// # Safety
/// `handles` is NULL, or points to `count` of them that were written by [`init_row`].
pub unsafe fn objects<'a, H: Row>(handles: *const H, count: usize) -> Result<&'a [H::Object], terrella_status> {
    // One object is as long as one struct, or they would not stand in a row.
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
