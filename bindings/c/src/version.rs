/// The major version of this header.
pub const TERRELLA_VERSION_MAJOR: i32 = 0;
/// The minor version of this header.
pub const TERRELLA_VERSION_MINOR: i32 = 1;
/// The patch version of this header.
pub const TERRELLA_VERSION_PATCH: i32 = 0;

/// Returns 10 000 × major + 100 × minor + patch of the library that is linked; compare it with the header's.
#[unsafe(no_mangle)]
pub extern "C" fn terrella_version() -> i32 {
    10_000 * TERRELLA_VERSION_MAJOR + 100 * TERRELLA_VERSION_MINOR + TERRELLA_VERSION_PATCH
}
