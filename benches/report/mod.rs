mod growth;

use growth::Growth;
use std::fmt::Write;
use std::path::Path;

/// Where the page and its plots are.
const DOCS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/docs");
/// The folder of the plots there.
const PLOTS: &str = "benchmarks";

/// A ratio next to its target.
struct Line {
    what: String,
    found: f64,
    most: f64,
    costs: String,
}

/// Everything that was measured, printed as it comes and written to `docs/benchmarks.md` in the end.
pub struct Report {
    filter: Option<String>,
    lines: Vec<Line>,
    growths: Vec<Growth>,
    /// What was measured without a target, each with the heading that it comes under.
    told: Vec<(&'static str, String)>,
}

impl Report {
    /// A report of all benchmarks, or of those with `filter` in their names.
    pub fn new(filter: Option<String>) -> Self {
        println!("{}", machine());
        Self {
            filter,
            lines: Vec::new(),
            growths: Vec::new(),
            told: Vec::new(),
        }
    }

    /// Measures `one` against `other` if it is wanted, and reports the ratio of their costs in
    /// milliseconds.
    pub fn ratio(&mut self, what: &str, most: f64, measure: impl FnOnce() -> (f64, f64)) {
        self.ratio_in("ms", what, most, measure);
    }

    /// Does so with costs in another unit.
    pub fn ratio_in(
        &mut self,
        unit: &str,
        what: &str,
        most: f64,
        measure: impl FnOnce() -> (f64, f64),
    ) {
        if !self.is_wanted(what) {
            return;
        }
        let (one, other) = measure();
        let line = Line {
            what: what.to_owned(),
            found: one / other,
            most,
            costs: format!("{} {unit} to {} {unit}", in_digits(one), in_digits(other)),
        };
        println!(
            "{what}: {} (at most {}; {})",
            in_digits(line.found),
            in_digits(most),
            line.costs
        );
        self.lines.push(line);
    }

    /// Measures what each of several sizes costs, in milliseconds, if it is wanted, and reports the
    /// exponent by which the cost grows with the number `of` something.
    pub fn growth(
        &mut self,
        what: &str,
        of: &'static str,
        most: f64,
        measure: impl FnOnce() -> Vec<(f64, f64)>,
    ) {
        if !self.is_wanted(what) {
            return;
        }
        let growth = Growth {
            what: what.to_owned(),
            of,
            costs: measure(),
        };
        let costs = growth.costs.iter();
        let costs: Vec<String> = costs
            .map(|(size, cost)| format!("{size}: {} ms", in_digits(*cost)))
            .collect();
        let line = Line {
            what: format!("{what}: exponent by the number of {of}"),
            found: growth.exponent(),
            most,
            costs: costs.join(", "),
        };
        println!(
            "{}: {:.3} (at most {}; {})",
            line.what,
            line.found,
            in_digits(most),
            line.costs
        );
        self.lines.push(line);
        self.growths.push(growth);
    }

    /// Reports something without a target under a heading. What comes under the same one comes together.
    pub fn tell(&mut self, heading: &'static str, text: String) {
        println!("{heading}: {text}");
        self.told.push((heading, text));
    }

    /// Whether `what` is to be measured.
    pub fn is_wanted(&self, what: &str) -> bool {
        let filter = self.filter.as_ref();
        filter.is_none_or(|filter| what.contains(filter))
    }

    /// Writes the page and its plots, unless only a part was measured.
    pub fn finish(self) {
        if self.filter.is_some() {
            return;
        }
        let mut text = format!(
            "# Benchmarks\n\nWritten by `make bench`. {}\n\nRatios of CPU times of the whole process, threads \
             of the graphics driver included: the least of interleaved rounds of one run; of times by the clock \
             where a line says so. Those of skinning are for a million vertices: as many milliseconds as one takes nanoseconds.\n\n\
             | what | ratio | at most | of |\n|---|---|---|---|\n",
            machine()
        );
        for line in &self.lines {
            let missed = if line.found > line.most {
                " (missed)"
            } else {
                ""
            };
            let Line {
                what,
                found,
                most,
                costs,
            } = line;
            // Writing to a string cannot fail.
            let _ = writeln!(
                text,
                "| {what} | {}{missed} | {} | {costs} |",
                in_digits(*found),
                in_digits(*most)
            );
        }
        for part in self.told.chunk_by(|one, next| one.0 == next.0) {
            let _ = writeln!(text, "\n## {}\n", part[0].0);
            for (_, line) in part {
                let _ = writeln!(text, "- {line}");
            }
        }
        text += "\n## How costs grow\n\nThe numbers are in the table above.\n\n";
        let plots = Path::new(DOCS).join(PLOTS);
        // Plots of what is no longer measured would stay.
        let _ = std::fs::remove_dir_all(&plots);
        std::fs::create_dir_all(&plots).expect("a folder for plots");
        for growth in &self.growths {
            let name = growth.file_name();
            growth.plot(&plots.join(&name)).expect("a plot is written");
            let _ = writeln!(text, "![{}]({PLOTS}/{name})", growth.what);
        }
        let notes = include_str!("../notes.md");
        let path = Path::new(DOCS).join("benchmarks.md");
        std::fs::write(&path, format!("{text}\n{notes}")).expect("docs/benchmarks.md is written");
        println!("Written to {}", path.display());
    }
}

/// A number with three digits that count.
fn in_digits(number: f64) -> String {
    let decimals = match number {
        _ if number >= 100.0 => 0,
        _ if number >= 10.0 => 1,
        _ if number >= 1.0 => 2,
        _ => 4,
    };
    format!("{number:.decimals$}")
}

/// The processor and how many of its cores there are.
fn machine() -> String {
    let info = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let name = info
        .lines()
        .find_map(|line| line.strip_prefix("model name"));
    let name = name.map_or("unknown", |rest| rest.trim_start_matches([' ', '\t', ':']));
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    format!("Processor: {name}, {cores} cores.")
}
