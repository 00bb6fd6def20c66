//! The `ertel` command.

// These panic where the output is closed or its disk is full: `print` does not.
#![deny(clippy::print_stdout, clippy::print_stderr)]
#![cfg_attr(not(test), deny(clippy::unwrap_used, clippy::expect_used))]

mod args;
mod cases;
mod check;
mod checkpoint;
mod colour;
mod compare;
mod estimate;
mod events;
mod explain;
mod failure;
mod fit;
mod fluids;
mod given;
mod init;
mod inputs;
mod interrupt;
mod machine;
mod manual;
mod monte_carlo;
mod own_data;
mod picture;
mod print;
mod progress;
mod provenance;
mod results;
mod schema;
mod solids;
mod solve;
mod sweep;
mod sweep_progress;
mod table;
mod transient;
mod validate;
mod view;
mod wrap;

use std::process::ExitCode;

use clap::Parser;

use args::{Cli, Command};

fn main() -> ExitCode {
    let cli = Cli::parse();
    colour::set(cli.color);
    let result = own_data::set(cli.own_data.as_deref()).and_then(|()| match cli.command {
        Command::Solve(arguments) => solve::run(&arguments),
        Command::Sweep(arguments) => sweep::run(&arguments),
        Command::Compare(arguments) => compare::run(&arguments),
        Command::Estimate(arguments) => estimate::run(&arguments),
        Command::View(arguments) => view::run(&arguments),
        Command::Validate(arguments) => validate::run(&arguments),
        Command::Fit(arguments) => fit::run(&arguments),
        Command::Fluids(arguments) => fluids::run(&arguments),
        Command::Solids(arguments) => solids::run(&arguments),
        Command::Explain(arguments) => explain::run(&arguments),
        Command::Init(arguments) => init::run(&arguments),
        Command::Schema(arguments) => schema::run(&arguments),
        Command::Completions(arguments) => manual::completions(&arguments),
        Command::Man(arguments) => manual::man(&arguments),
    });
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            print::stderr(&format!("error: {failure}"));
            failure.exit_code()
        }
    }
}
