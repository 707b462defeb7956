pub fn hold(what: &str, double: f64, single: f64) {
    println!("{what:28} {double:.3e} {single:.3e}");
}
