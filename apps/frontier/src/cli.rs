//! What can be asked for, and one line of complaint for what cannot.

use std::path::PathBuf;

use clap::{Arg, ArgAction, Command, value_parser};
use draw::data;
use draw::outcome::{Asked, ask, given};

/// How much to measure, and where it goes.
pub struct Options {
    pub quick: bool,
    pub add: bool,
    pub draw: bool,
    pub only: String,
    pub caption: String,
    pub peers: Option<PathBuf>,
    pub out: PathBuf,
}

fn command() -> Command {
    let flag = |name: &'static str, help: &'static str| Arg::new(name).long(name).action(ArgAction::SetTrue).help(help);
    let text = |name: &'static str, help: &'static str| {
        Arg::new(name)
            .long(name)
            .value_name("TEXT")
            .default_value("")
            .help(help)
    };
    let path = |name: &'static str, value: &'static str, help: &'static str| {
        Arg::new(name)
            .long(name)
            .value_name(value)
            .value_parser(value_parser!(PathBuf))
            .help(help)
    };
    Command::new("frontier").about(ABOUT).args([
        flag(
            "quick",
            "Few points and passes: the files and the errors are right, the times are not",
        ),
        flag(
            "add",
            "Join the records of the folder's frontier.csv: the least times of all runs",
        ),
        flag("draw", "Measure nothing: draw the folder's frontier.csv again"),
        text(
            "only",
            "Measure only what has the text in its key, keep the folder's other records",
        ),
        text("caption", "Machine and date, to stand under the charts"),
        path(
            "peers",
            "FILE",
            "Rivals that were measured just now, instead of those in benches/peers/peers.csv",
        ),
        path(
            "out",
            "DIR",
            "Folder to write to, made if there is none [default: target/frontier]",
        ),
    ])
}

const ABOUT: &str = "\
Times everything that terrella computes, one by one and in batch, measures its
largest error, and draws it beside its rivals.";

/// Reads the command line.
pub fn parse() -> Result<Asked<Options>, String> {
    Ok(match ask(command())? {
        Asked::Run(arguments) => Asked::Run(Options {
            quick: arguments.get_flag("quick"),
            add: arguments.get_flag("add"),
            draw: arguments.get_flag("draw"),
            only: given(&arguments, "only")?,
            caption: given(&arguments, "caption")?,
            peers: given(&arguments, "peers").ok(),
            out: given(&arguments, "out").unwrap_or_else(|_| data::target("frontier")),
        }),
        Asked::Help(text) => Asked::Help(text),
    })
}
