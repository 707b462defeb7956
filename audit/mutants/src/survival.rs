//! Each mutant against the tests that reach it.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;
use std::sync::atomic::{AtomicU32, Ordering::Relaxed};
use std::time::Duration;

use indicatif::{ParallelProgressIterator, ProgressBar, ProgressStyle};
use rayon::prelude::*;

use crate::Failure;
use crate::suite::Test;

pub enum Fate {
    Caught(String),
    Survived,
    /// By no test.
    NotReached,
    NotCompiled,
    /// A constant's, which cannot choose.
    NotWoven,
}

impl Fate {
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Caught(_) => "caught",
            Self::Survived => "survived",
            Self::NotReached => "not reached",
            Self::NotCompiled => "does not compile",
            Self::NotWoven => "not tried",
        }
    }
}

impl fmt::Display for Fate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Caught(test) => write!(f, "caught by {test}"),
            _ => f.write_str(self.kind()),
        }
    }
}

/// The tests that pass without a mutant, and what they reach.
pub fn known(tests: &[Test]) -> Result<Vec<Known<'_>>, Failure> {
    let reached: Vec<Option<Known>> = parallel("reach", tests, Known::of)?;
    Ok(reached.into_iter().flatten().collect())
}

/// Of each mutant that is woven, by its number. `places` has for each the place where it is chosen.
pub fn of_each(places: &BTreeMap<usize, usize>, known: &[Known]) -> Result<BTreeMap<usize, Fate>, Failure> {
    let mutants: Vec<_> = places.iter().collect();
    let fates = parallel("mutants", &mutants, |(mutant, place)| {
        Ok((**mutant, of_one(**mutant, **place, known)?))
    })?;
    Ok(fates.into_iter().collect())
}

fn of_one(mutant: usize, place: usize, tests: &[Known]) -> Result<Fate, Failure> {
    let mut tests: Vec<_> = tests
        .iter()
        .filter(|test| test.reaches.contains(&place))
        .map(|test| (test.price(), test))
        .collect();
    tests.sort_by(|a, b| a.0.total_cmp(&b.0));
    for (_, test) in &tests {
        let caught = test.test.catches(mutant, test.time)?;
        test.tries.fetch_add(1, Relaxed);
        if caught {
            test.catches.fetch_add(1, Relaxed);
            return Ok(Fate::Caught(test.test.title.clone()));
        }
    }
    Ok(if tests.is_empty() {
        Fate::NotReached
    } else {
        Fate::Survived
    })
}

/// A test, and what is known of it.
pub struct Known<'a> {
    test: &'a Test,
    time: Duration,
    reaches: BTreeSet<usize>,
    tries: AtomicU32,
    catches: AtomicU32,
}

impl<'a> Known<'a> {
    fn of(test: &'a Test) -> Result<Option<Self>, Failure> {
        let Some((time, reaches)) = test.reach()? else {
            eprintln!("LEFT OUT: {} fails without a mutant", test.title);
            return Ok(None);
        };
        Ok(Some(Self {
            test,
            time,
            reaches,
            tries: AtomicU32::new(0),
            catches: AtomicU32::new(0),
        }))
    }

    /// Time for each mutant that it may catch: the cheapest is asked first.
    fn price(&self) -> f64 {
        let (tries, catches) = (self.tries.load(Relaxed), self.catches.load(Relaxed));
        self.time.as_secs_f64() * f64::from(tries + 2) / f64::from(catches + 1)
    }
}

fn parallel<'a, A: Sync, B: Send>(
    what: &'static str,
    all: &'a [A],
    each: impl Fn(&'a A) -> Result<B, Failure> + Send + Sync,
) -> Result<Vec<B>, Failure> {
    let style = ProgressStyle::with_template("{msg} {pos}/{len} [{elapsed}]")?;
    all.par_iter()
        .progress_with(ProgressBar::new(all.len() as u64).with_style(style).with_message(what))
        .map(each)
        .collect()
}
