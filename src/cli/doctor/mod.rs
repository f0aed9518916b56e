//! `editor doctor`: what this machine has for the program, and what helps where something is
//! missing.

mod machine;
mod probe;
mod trouble;

use super::output::{json_text, visible};
use super::{CliError, print};
use machine::{Display, Server, Settings};
use probe::{OpenGl, Outcome, Trial, Way};
use serde::Serialize;
use std::fmt::Write;

/// Tell what this machine has to draw with, and what helps where something is missing.
///
/// Ends with 0 where pictures can be drawn (`editor render`), whether or not there is a display,
/// and with 1 otherwise.
#[derive(Debug, clap::Args)]
pub struct Args {
    /// Print one JSON object instead of text
    #[arg(long)]
    json: bool,
}

/// Output of `--json`, besides the advice.
#[derive(Debug, Serialize)]
struct Report {
    version: &'static str,
    system: String,
    display: Display,
    /// `None` where there is no display.
    window: Option<Outcome>,
    egl: Outcome,
    osmesa: Outcome,
    settings: Settings,
}

#[derive(Serialize)]
struct WithAdvice<'a> {
    #[serde(flatten)]
    report: &'a Report,
    /// Way by which `editor render` draws.
    render: Option<&'static str>,
    help: &'a [&'static str],
}

/// Carries the command out.
///
/// # Errors
/// If no picture can be drawn, after that was printed.
pub fn run(args: &Args) -> Result<(), CliError> {
    if let Some(way) = Way::asked_for() {
        let outcome = serde_json::to_string(&probe::try_here(way));
        let outcome = outcome.map_err(|error| CliError::Other(error.to_string()))?;
        // On a line of its own, whatever the driver has printed before.
        return print(&format!("\n{outcome}\n"));
    }
    let report = Report::of_this_machine();
    let help = trouble::advice(&report);
    let text = if args.json {
        let (render, help) = (report.render(), &help[..]);
        json_text(&WithAdvice {
            report: &report,
            render,
            help,
        })?
    } else {
        in_words(&report, &help)
    };
    print(&text)?;
    match report.render() {
        Some(_) => Ok(()),
        None => Err(CliError::Reported),
    }
}

impl Report {
    fn of_this_machine() -> Self {
        let display = Display::of_environment();
        // All at once, since each waits for its driver.
        let window = (display.server != Server::None).then(|| Trial::start(Way::Window));
        let (egl, osmesa) = (Trial::start(Way::Egl), Trial::start(Way::Osmesa));
        Self {
            version: env!("CARGO_PKG_VERSION"),
            system: machine::system(),
            display,
            window: window.map(Trial::outcome),
            egl: egl.outcome(),
            osmesa: osmesa.outcome(),
            settings: Settings::of_user(),
        }
    }

    /// Way by which `editor render` draws: the first one that works.
    fn render(&self) -> Option<&'static str> {
        let ways = [("egl", &self.egl), ("osmesa", &self.osmesa)];
        let works = |(_, outcome): &(&str, &Outcome)| outcome.works().is_some();
        ways.into_iter().find(works).map(|(name, _)| name)
    }

    /// The driver that the user sees most of: the window's, or that of the pictures.
    fn best(&self) -> Option<&OpenGl> {
        let ways = [self.window.as_ref(), Some(&self.egl), Some(&self.osmesa)];
        ways.into_iter().flatten().find_map(Outcome::works)
    }
}

fn in_words(report: &Report, help: &[&str]) -> String {
    let mut out = format!("editor {}\n", report.version);
    // Writing to a string cannot fail.
    let mut line = |name: &str, value: &str| {
        let _ = writeln!(out, "  {name:<16} {}", visible(value));
    };
    line("system", &report.system);
    line("display", &report.display.in_words());
    let ways = [
        ("window", report.window.as_ref()),
        ("EGL", Some(&report.egl)),
        ("OSMesa", Some(&report.osmesa)),
    ];
    for (name, outcome) in ways {
        match outcome {
            None => line(name, "not tried, for there is no display"),
            Some(Outcome::Fails(failure)) => {
                line(name, &format!("does not work: {}", failure.message));
            }
            Some(Outcome::Works(driver)) => {
                line(name, &format!("OpenGL {}", driver.version));
                let kind = match driver.software {
                    true => "on the processor",
                    false => "on the graphics card",
                };
                let renderer = format!("{} ({}), {kind}", driver.renderer, driver.vendor);
                line("  renderer", &renderer);
                let limits = format!(
                    "textures of {} pixels, pictures of {} pixels, {} samples a pixel",
                    driver.max_texture_side, driver.max_picture_side, driver.max_samples
                );
                line("  at most", &limits);
            }
        }
    }
    let settings = match (&report.settings.folder, report.settings.writable) {
        (None, _) => "no folder, for there is no home folder".to_owned(),
        (Some(folder), true) => format!("{}, writable", folder.display()),
        (Some(folder), false) => format!("{}, not writable", folder.display()),
    };
    line("settings", &settings);
    let render = match report.render() {
        Some(_) => "works",
        None => "does not work",
    };
    line("editor render", render);
    for help in help {
        let _ = write!(out, "\n{help}\n");
    }
    out
}
