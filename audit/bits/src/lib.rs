//! For wasm: hands the lines that the program prints elsewhere to the host.
#![cfg(target_family = "wasm")]

#[link(wasm_import_module = "host")]
unsafe extern "C" {
    /// Takes a line of text in UTF-8.
    fn line(start: *const u8, length: usize);
}

/// A line for each function and scalar.
#[unsafe(no_mangle)]
pub extern "C" fn bits() {
    calls::hashes(|function, scalar, hash| {
        let text = format!("{function}\t{scalar}\t{hash:016x}");
        // SAFETY: the host reads the text before it returns.
        unsafe { line(text.as_ptr(), text.len()) }
    });
}
