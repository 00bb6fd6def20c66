//! The command line.

use std::path::PathBuf;

use clap::builder::PossibleValuesParser;
use clap::{Args, Parser, Subcommand};
use clap_complete::Shell;
use ertel::case::study::MOST_POINTS;
use ertel_input::csv::{ColumnMap, CsvParams, Decimal};

use crate::colour::When;
use crate::init::InitArgs;
use crate::schema::SchemaArgs;

/// Film thickness and pressure of elastohydrodynamic contacts.
#[derive(Debug, Parser)]
#[command(name = "ertel", version, arg_required_else_help = true)]
#[command(after_help = "\
Exit codes: 0 solved, 1 results could not be written or a validation does not hold, 2 bad input or usage, 3 not converged (a point of a curve or study, too), 130 interrupted.")]
pub struct Cli {
    /// Folder with your lubricants and materials, `fluids/NAME.toml` and `solids/NAME.toml` [env: ERTEL_DATA]
    #[arg(long = "data", global = true, value_name = "DIR")]
    pub own_data: Option<PathBuf>,
    /// When messages and reports are coloured.
    #[arg(
        long,
        global = true,
        value_name = "WHEN",
        value_enum,
        default_value_t,
        hide_possible_values = true,
        help = "Colour of messages and reports: auto (on terminals; NO_COLOR, CLICOLOR and CLICOLOR_FORCE count), always, never"
    )]
    pub color: When,
    /// The subcommand.
    #[command(subcommand)]
    pub command: Command,
}

/// The subcommands.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Solve a case file and write the results into a folder
    Solve(SolveArgs),
    /// Solve every point of a study: a base case and axes over any of its inputs
    Sweep(SweepArgs),
    /// Solve a case at the points of a table of measurements, and compare films and tractions
    Compare(CompareArgs),
    /// Estimate a case file by formulas, without solving it
    Estimate(EstimateArgs),
    /// Show results in the browser, several of them side by side with their differences
    View(ViewArgs),
    /// Compute published cases and compare
    Validate(ValidateArgs),
    /// Fit the constants of a law to measured states
    Fit(FitArgs),
    /// List the lubricants of the database, or show one of them
    Fluids(FluidsArgs),
    /// List the solids of the database, or show one of them
    Solids(SolidsArgs),
    /// Explain the code of a warning: meaning, limit, what to do
    Explain(ExplainArgs),
    /// Write a case file to start from: a bearing, a gear, a rig, a cam
    Init(InitArgs),
    /// Print the JSON schema of case or study files, for editors
    Schema(SchemaArgs),
    /// Print the completions of a shell
    Completions(CompletionsArgs),
    /// Print the manual page, or write those of all commands
    Man(ManArgs),
}

/// Report options of the commands that solve.
#[derive(Debug, Args)]
pub struct ReportArgs {
    /// Exit code 0 also where an error bar is wider than half of a figure
    #[arg(long)]
    pub accept_unresolved: bool,
    /// No progress on stderr and no report on stdout
    #[arg(short, long)]
    pub quiet: bool,
}

/// How commands that solve many points share the computer.
#[derive(Debug, Args)]
pub struct WorkerArgs {
    /// Points solved at the same time [default: as many as cores]
    #[arg(short, long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub jobs: Option<u16>,
    /// Threads of each point
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u16).range(1..))]
    pub threads: u16,
}

/// `ertel solve`.
#[derive(Debug, Args)]
#[command(after_help = "\
Files of a result: report.html (a page with maps), report.txt, result.json (all figures), case.toml, centreline.csv, surface.vtu, pictures; on request
result.nc (`netcdf = true` in [output]), body.vtu (`body_field = true`), temperature.vtu (`field = true` in [thermal]); of a case in time
fields.pvd (`vtu = true`) and animation.png (`animation = true`). A curve has curve.csv and
curve.json, a machine machine.csv and machine.json.")]
pub struct SolveArgs {
    /// The case files (TOML), each solved into a separate folder; `-` reads one from standard input
    #[arg(value_name = "CASE.toml", required = true)]
    pub cases: Vec<PathBuf>,
    /// Folder for the results, for several cases the parent of their folders (default: `output.folder` of the case, else `results/<name of the
    /// case file>`)
    #[arg(short, long, value_name = "DIR")]
    pub output: Option<PathBuf>,
    /// Replace a value of the file, such as "contact.load=50 N" (may be repeated)
    #[arg(long, value_name = "KEY=VALUE")]
    pub set: Vec<String>,
    /// Print events as JSON lines instead of progress and report
    #[arg(long)]
    pub json: bool,
    /// Also write PNG pictures
    #[arg(long)]
    pub png: bool,
    /// Also write PDF pictures
    #[arg(long)]
    pub pdf: bool,
    /// Read and check the case, then stop
    #[arg(long)]
    pub check: bool,
    /// Also solve N samples of the uncertain inputs, in the folder `<results>-monte-carlo`; a stopped run continues there
    #[arg(long, value_name = "N")]
    pub monte_carlo: Option<usize>,
    /// Random seed: the same seed gives the same samples
    #[arg(long, value_name = "S", default_value_t = 1, requires = "monte_carlo")]
    pub seed: u64,
    /// Solve the case by the other method, too (finite elements or finite volumes), and compare every figure with its error bars; exit code 3
    /// where one differs by more than the sum of both
    #[arg(long, conflicts_with_all = ["check", "monte_carlo"])]
    pub cross_check: bool,
    /// For a case in time: write a checkpoint to `<results>.checkpoint` at this interval of wall time, such as "10 min",
    /// and on Ctrl-C
    #[arg(long, value_name = "TIME", conflicts_with = "check")]
    pub checkpoint: Option<String>,
    /// For a case in time: continue from `<results>.checkpoint`
    #[arg(long, conflicts_with = "check")]
    pub resume: bool,
    /// Report options.
    #[command(flatten)]
    pub report: ReportArgs,
    /// Verbose: also print files read, every iteration, the meshes and the files written
    #[arg(short, long, conflicts_with_all = ["quiet", "json"])]
    pub verbose: bool,
}

/// `ertel sweep`.
#[derive(Debug, Args)]
#[command(after_help = "\
A run that was stopped or killed continues when it is started again.")]
pub struct SweepArgs {
    /// The study file (TOML)
    #[arg(
        value_name = "STUDY.toml",
        required_unless_present = "merge",
        conflicts_with = "merge"
    )]
    pub study: Option<PathBuf>,
    /// Folder of the study [default: `results/<name of the study file>`, of a shard `shards/i-of-n` within]
    #[arg(short, long, value_name = "DIR")]
    pub output: Option<PathBuf>,
    /// Replace a value of the base case, such as "contact.load=50 N" (may be repeated)
    #[arg(long, value_name = "KEY=VALUE", conflicts_with = "merge")]
    pub set: Vec<String>,
    /// Print events as JSON lines instead of progress and report
    #[arg(long)]
    pub json: bool,
    /// List the points, each with the point whose solution it starts from, then stop
    #[arg(long)]
    pub dry_run: bool,
    /// Also write the results of each point into a separate folder
    #[arg(long)]
    pub folders: bool,
    /// Retry failed points
    #[arg(long)]
    pub retry: bool,
    /// Solve part I of N of the points, for jobs on a cluster
    #[arg(long, value_name = "I/N", value_parser = shard)]
    pub shard: Option<ertel::sweep::Shard>,
    /// Join parts: the folder of the whole, then those of the parts
    #[arg(long, value_names = ["OUT", "PART"], num_args = 2..)]
    pub merge: Option<Vec<PathBuf>>,
    /// How many points and threads.
    #[command(flatten)]
    pub workers: WorkerArgs,
    /// Report options.
    #[command(flatten)]
    pub report: ReportArgs,
    /// Verbose: also print files read, a line for each point, failures and warnings
    #[arg(short, long, conflicts_with_all = ["quiet", "json"])]
    pub verbose: bool,
}

/// How the columns of a table are read.
#[derive(Debug, Args)]
pub struct TableArgs {
    /// Which column holds a quantity, by its title or its number, such as film="Film (nm)", film=Film:nm, film=#3:nm (may be repeated)
    #[arg(long, value_name = "NAME=TITLE[:UNIT]", value_parser = ColumnMap::parse)]
    pub column: Vec<ColumnMap>,
    /// Decimal mark of the table, where its numbers are ambiguous
    #[arg(long, value_name = "MARK", value_parser = PossibleValuesParser::new(["point", "comma"]))]
    pub decimal: Option<String>,
}

impl TableArgs {
    /// Options for reading a table, with the titles of columns to ignore.
    pub fn params(&self, ignored: &[String]) -> CsvParams {
        CsvParams {
            columns: self.column.clone(),
            ignored: ignored.to_vec(),
            decimal: self.decimal.as_ref().map(|mark| match mark.as_str() {
                "comma" => Decimal::Comma,
                _ => Decimal::Point,
            }),
        }
    }
}

/// `ertel compare`.
#[derive(Debug, Args)]
#[command(after_help = "\
A run that was stopped or killed continues when it is started again. How tables and exports of rigs are read: \
docs/guide/compare.md.")]
pub struct CompareArgs {
    /// The case file (TOML); the columns of the table vary its values
    #[arg(value_name = "CASE.toml")]
    pub case: PathBuf,
    /// Measured films or tractions: a table with units in its titles, or an export of a PCS rig (EHD2, MTM, ETM)
    #[arg(value_name = "MEASURED.csv")]
    pub measured: PathBuf,
    /// Folder for the results [default: `results/<name of the case file>-<name of the table>`]
    #[arg(short, long, value_name = "DIR")]
    pub output: Option<PathBuf>,
    /// Read and check case and measurements, then stop
    #[arg(long)]
    pub check: bool,
    /// Ignore a column of the table, by its whole title (may be repeated)
    #[arg(long, value_name = "TITLE")]
    pub ignore: Vec<String>,
    /// How the columns are read.
    #[command(flatten)]
    pub table: TableArgs,
    /// Use only this step of a rig's export, by its number (may be repeated)
    #[arg(long, value_name = "N")]
    pub step: Vec<usize>,
    /// Thermometer of a rig that measures the temperature of the lubricant
    #[arg(long, value_name = "WHERE", default_value = "lubricant", value_parser = PossibleValuesParser::new(["lubricant", "pot"]))]
    pub thermometer: String,
    /// Also write a PNG picture
    #[arg(long)]
    pub png: bool,
    /// Also write a PDF picture
    #[arg(long)]
    pub pdf: bool,
    /// Retry failed points
    #[arg(long)]
    pub retry: bool,
    /// How many points and threads.
    #[command(flatten)]
    pub workers: WorkerArgs,
    /// Report options.
    #[command(flatten)]
    pub report: ReportArgs,
}

/// `3/8`.
fn shard(text: &str) -> Result<ertel::sweep::Shard, String> {
    let parts = text.split_once('/');
    let numbers = parts.and_then(|(i, n)| Some((i.trim().parse().ok()?, n.trim().parse().ok()?)));
    let shard = numbers.and_then(|(index, n)| ertel::sweep::Shard::new(index, n));
    shard.ok_or_else(|| {
        format!(
            "write it as 3/8: the third of eight parts, of which there are at most {MOST_POINTS}"
        )
    })
}

/// `ertel estimate`.
#[derive(Debug, Args)]
pub struct EstimateArgs {
    /// The case file (TOML); `-` reads it from standard input
    #[arg(value_name = "CASE.toml")]
    pub case: PathBuf,
    /// Replace a value of the file, such as "contact.load=50 N" (may be repeated)
    #[arg(long, value_name = "KEY=VALUE")]
    pub set: Vec<String>,
    /// Print JSON instead of text
    #[arg(long)]
    pub json: bool,
}

/// `ertel view`.
#[derive(Debug, Args)]
pub struct ViewArgs {
    /// Folders of results, or their pages `report.html`
    #[arg(value_name = "RESULT", required = true)]
    pub results: Vec<PathBuf>,
    /// Write the page into this file, to keep it or to send it
    #[arg(short, long, value_name = "FILE.html")]
    pub output: Option<PathBuf>,
    /// Start no browser; print the path of the page
    #[arg(long)]
    pub no_browser: bool,
}

/// `ertel validate`.
#[derive(Debug, Args)]
pub struct ValidateArgs {
    /// Studies to run [default: all]
    #[arg(value_name = "NAME")]
    pub names: Vec<String>,
    /// Folder with the studies
    #[arg(long, value_name = "DIR", default_value = "validation")]
    pub folder: PathBuf,
    /// Only the runs that take seconds
    #[arg(long)]
    pub quick: bool,
    /// Write all comparisons as one table into this file
    #[arg(long, value_name = "FILE.csv")]
    pub table: Option<PathBuf>,
    /// Write the page `validation.md` and its pictures into this folder; with NAMEs, only their sections of the page
    #[arg(long, value_name = "DIR")]
    pub write: Option<PathBuf>,
    /// Update the Newton iterations stated in the studies to those taken, and show the changes
    #[arg(long)]
    pub update: bool,
}

/// `ertel fit`.
#[derive(Debug, Args)]
pub struct FitArgs {
    /// The subcommand.
    #[command(subcommand)]
    pub command: FitCommand,
}

/// The subcommands of `ertel fit`.
#[derive(Debug, Subcommand)]
pub enum FitCommand {
    /// A viscosity law: cheng, roelands, wlf, yasutomi, doolittle, barus, mcewen, paluch, mcewen-paluch, walther
    Viscosity(FitLawArgs),
    /// A density law: tait, dowson-higginson
    Density(FitLawArgs),
    /// A film-thickness formula h = c R sqrt(2U) M^a L^b
    Film(FitFilmArgs),
    /// Boundary friction coefficient and roughness by a measured Stribeck curve
    Stribeck(FitStribeckArgs),
}

/// `ertel fit stribeck`.
#[derive(Debug, Args)]
pub struct FitStribeckArgs {
    /// Table with the friction (traction_coefficient) at several speeds, and columns as those of `ertel compare`
    #[arg(value_name = "DATA.csv")]
    pub data: PathBuf,
    /// The case file (TOML) with asperities; the columns of the table vary its values
    #[arg(long, value_name = "CASE.toml")]
    pub case: PathBuf,
    /// Also fit the asperity group σβη
    #[arg(long)]
    pub asperity_group: bool,
    /// Ignore a column of the table, by its whole title (may be repeated)
    #[arg(long, value_name = "TITLE")]
    pub ignore: Vec<String>,
    /// How the columns are read.
    #[command(flatten)]
    pub table: TableArgs,
    /// No progress on stderr
    #[arg(short, long)]
    pub quiet: bool,
}

/// `ertel fit film`.
#[derive(Debug, Args)]
pub struct FitFilmArgs {
    /// Table with the columns film_central_m or film_minimum_m, and those that the form needs
    #[arg(value_name = "RESULTS.csv")]
    pub results: PathBuf,
    /// How the columns are read.
    #[command(flatten)]
    pub table: TableArgs,
    /// The form: moes, h = c R sqrt(2U) M^a L^b; hamrock-dowson, h = c R U^a G^b W^d; elliptical, the same with ellipticity and
    /// the angle of the motion; blend, of the elastic asymptotes of the central film; speed, h = c u^a; speed-load, h = c u^a F^b
    #[arg(long, value_name = "FORM", default_value = "moes", value_parser = PossibleValuesParser::new(ertel::fit::FilmForm::NAMES))]
    pub form: String,
    /// Reduced radius of all films, such as "12.7 mm" (default: the column radius_m)
    #[arg(long, value_name = "R")]
    pub radius: Option<String>,
    /// Also compare the films with the form with given constants, as in "central=1.96,-0.1111,0" (may be repeated)
    #[arg(long = "given", alias = "beside", value_name = "FILM=C,...", value_parser = given_formula)]
    pub given_formulas: Vec<(ertel::fit::FilmKind, Vec<f64>)>,
    /// Confidence of the intervals
    #[arg(long, value_name = "P", default_value_t = 0.95)]
    pub confidence: f64,
    /// Write the parity plot into this file
    #[arg(long, value_name = "FILE.svg|pdf|png")]
    pub plot: Option<PathBuf>,
    /// Overwrite a file that exists
    #[arg(long)]
    pub force: bool,
    /// List every film next to the formula
    #[arg(short, long)]
    pub verbose: bool,
}

/// `central=1.96,-0.1111,0`.
fn given_formula(text: &str) -> Result<(ertel::fit::FilmKind, Vec<f64>), String> {
    use ertel::fit::FilmKind;
    let help = || {
        "write the film, central or minimum, and the constants of the form, such as c, a and b: central=1.96,-0.1111,0"
            .to_owned()
    };
    let (kind, constants) = text.split_once('=').ok_or_else(help)?;
    let kind = match kind.trim() {
        "central" => FilmKind::Central,
        "minimum" => FilmKind::Minimum,
        _ => return Err(help()),
    };
    let constants: Option<Vec<f64>> = constants
        .split(',')
        .map(|c| c.trim().parse().ok().filter(|c: &f64| c.is_finite()))
        .collect();
    let constants = constants.ok_or_else(help)?;
    Ok((kind, constants))
}

/// `ertel fit viscosity` and `ertel fit density`.
#[derive(Debug, Args)]
pub struct FitLawArgs {
    /// Table with columns such as pressure_MPa, temperature_degC, viscosity_mPa_s (or density_kg_per_m3)
    #[arg(value_name = "DATA.csv")]
    pub data: PathBuf,
    /// How the columns are read.
    #[command(flatten)]
    pub table: TableArgs,
    /// The law; `all` ranks the laws by cross-validation over the isotherms, and takes the best
    #[arg(long, value_name = "LAW")]
    pub law: String,
    /// Exit code 3 where the fitted law is implausible, such as a viscosity that falls with pressure or an rms above 10 %;
    /// the entry is still written
    #[arg(long)]
    pub strict: bool,
    /// Where the data come from, for the entry (default: the name of the file)
    #[arg(long, value_name = "TEXT")]
    pub source: Option<String>,
    /// Title of the entry (default: the name of the file)
    #[arg(long, value_name = "TEXT")]
    pub title: Option<String>,
    /// Keep a constant at a value, such as "mu_0=0.465 mPa.s" (may be repeated)
    #[arg(long, value_name = "KEY=VALUE")]
    pub hold: Vec<String>,
    /// Fit a constant that is fixed by default, such as p_0 or mu_g (may be repeated)
    #[arg(long, value_name = "KEY")]
    pub free: Vec<String>,
    /// Reference temperature of the law (default: the isotherm in the middle of the data)
    #[arg(long, value_name = "T", allow_hyphen_values = true)]
    pub reference_temperature: Option<String>,
    /// Minimise absolute deviations, not relative ones
    #[arg(long)]
    pub absolute: bool,
    /// Confidence of the intervals
    #[arg(long, value_name = "P", default_value_t = 0.95)]
    pub confidence: f64,
    /// Fluid of the database or entry with the density: its Tait equation gives the volume to Doolittle's law; Walther's law and tables of
    /// kinematic viscosities take any density law, or `density_15` with `base_oil`
    #[arg(long, value_name = "NAME|FILE.toml")]
    pub density: Option<String>,
    /// How the viscosity of Walther's law grows with pressure [default: roelands]
    #[arg(long, value_name = "LAW", value_parser = PossibleValuesParser::new(["roelands", "barus"]))]
    pub pressure_law: Option<String>,
    /// Write the entry into this file, and the picture next to it
    #[arg(short, long, value_name = "ENTRY.toml")]
    pub output: Option<PathBuf>,
    /// Write the picture of the law over the data into this file
    #[arg(long, value_name = "FILE.svg|pdf|png")]
    pub plot: Option<PathBuf>,
    /// Overwrite files that exist, the entry as well as the picture
    #[arg(long)]
    pub force: bool,
    /// List every state next to the law
    #[arg(short, long)]
    pub verbose: bool,
}

/// `ertel fluids`.
#[derive(Debug, Args)]
pub struct FluidsArgs {
    /// The subcommand; default `list`.
    #[command(subcommand)]
    pub command: Option<FluidsCommand>,
}

/// The subcommands of `ertel fluids`.
#[derive(Debug, Subcommand)]
pub enum FluidsCommand {
    /// List all names
    List,
    /// Show the data of one fluid with units, sources, status and range
    Show {
        /// Name of the fluid
        name: String,
        /// Temperature of the viscosity table, such as "60 degC" (default: that of the data)
        #[arg(short, long, value_name = "T")]
        temperature: Option<String>,
        /// Write the viscosity over pressure as a picture
        #[arg(long, value_name = "FILE.svg|pdf|png")]
        plot: Option<PathBuf>,
        /// Overwrite a file that exists
        #[arg(long)]
        force: bool,
    },
}

/// `ertel explain`.
#[derive(Debug, Args)]
pub struct ExplainArgs {
    /// The code in brackets after a warning, such as `friction`; without it all codes are listed
    #[arg(value_name = "CODE")]
    pub code: Option<String>,
}

/// `ertel solids`.
#[derive(Debug, Args)]
pub struct SolidsArgs {
    /// The subcommand; default `list`.
    #[command(subcommand)]
    pub command: Option<SolidsCommand>,
}

/// The subcommands of `ertel solids`.
#[derive(Debug, Subcommand)]
pub enum SolidsCommand {
    /// List all names
    List,
    /// Show the data of one solid with units, sources and status
    Show {
        /// Name of the solid
        name: String,
    },
}

/// `ertel completions`.
#[derive(Debug, Args)]
#[command(after_help = "\
Bash: ertel completions bash > ~/.local/share/bash-completion/completions/ertel
Zsh:  ertel completions zsh > \"${fpath[1]}/_ertel\"
Fish: ertel completions fish > ~/.config/fish/completions/ertel.fish")]
pub struct CompletionsArgs {
    /// The shell
    #[arg(value_name = "SHELL", value_enum)]
    pub shell: Shell,
}

/// `ertel man`.
#[derive(Debug, Args)]
pub struct ManArgs {
    /// Write the pages of all commands, `ertel.1`, `ertel-solve.1` and so on, into this folder; former pages there are replaced
    #[arg(short, long, value_name = "DIR")]
    pub output: Option<PathBuf>,
}
