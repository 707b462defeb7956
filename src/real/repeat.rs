/// A block as often as a count says, up to eight times, without a loop: what is inside a loop over points
/// must have none of its own.
macro_rules! repeat {
    ($count:expr, $body:block) => {{
        let count = $count;
        if count > 0 $body
        if count > 1 $body
        if count > 2 $body
        if count > 3 $body
        if count > 4 $body
        if count > 5 $body
        if count > 6 $body
        if count > 7 $body
    }};
}
pub(crate) use repeat;
