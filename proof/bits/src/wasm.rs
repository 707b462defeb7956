#[link(wasm_import_module = "host")]
unsafe extern "C" {
    /// Takes a line of text in UTF-8.
    fn line(start: *const u8, length: usize);
}

/// Hands the lines to the host.
#[unsafe(no_mangle)]
pub extern "C" fn bits() {
    // SAFETY: the host reads the text before it returns.
    crate::lines(|text| unsafe { line(text.as_ptr(), text.len()) });
}
