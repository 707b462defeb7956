//! The same bits everywhere: a hash of what every function gives for fixed arguments, equal with and without `std`, in debug and
//! release builds, on every machine. `proof/bits/run` compares other machines with this one.
#![allow(missing_docs)] // tests

#[test]
fn bits_are_the_same_everywhere() {
    let mut expected = include_str!("bits.tsv").lines();
    let mut differ = Vec::new();
    calls::hashes(|function, scalar, hash| {
        let found = format!("{function}\t{scalar}\t{hash:016x}");
        if expected.next() != Some(&found) {
            differ.push(found);
        }
    });
    // A change of the arithmetic changes the hashes on purpose, then `proof/bits/run --update`; a change of machine or features never does.
    assert!(
        differ.is_empty() && expected.next().is_none(),
        "other bits: {differ:#?}"
    );
}
