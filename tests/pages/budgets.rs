//! The table of flash in VALIDATION.md: the budgets that `audit/flash/run` holds.

use testkit::generated;

#[test]
fn budgets_of_flash_are_shown() {
    let path = format!("{}/audit/flash/budgets.tsv", env!("CARGO_MANIFEST_DIR"));
    let mut table = String::from("| function | Cortex-M4F | Cortex-M7 |\n|---|--:|--:|\n");
    for row in std::fs::read_to_string(path).unwrap().lines().skip(1) {
        let cells: Vec<&str> = row.split('\t').collect();
        table += &format!("| `{}` | {} | {} |\n", cells[0], cells[1], cells[2]);
    }
    generated::section("VALIDATION.md", "| function | Cortex-M4F |", &table);
}
