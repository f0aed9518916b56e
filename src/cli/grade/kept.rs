//! What a report folder keeps of a run: results by submission, so that a run that is started again
//! resumes where it stopped, and parts can be joined.

use super::submissions::Part;
use crate::disk::{self, Disk};
use crate::grade::Graded;
use crate::io::{Diagnostic, Files};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::path::{Component, Path, PathBuf};

/// Version of the form of what is kept.
pub(super) const VERSION: u32 = 5;

/// A run as a whole.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct KeptRun {
    /// Version of the form.
    pub version: u32,
    /// Text of the file of tests.
    pub tests: String,
    /// Numbers that follow from what tests depend on, by name.
    pub fingerprints: BTreeMap<String, u32>,
    /// Exact results as PNG in Base64, by name of test.
    pub pictures: BTreeMap<String, String>,
    /// Names of the submissions.
    pub submissions: Vec<String>,
    /// Which part of the class they are, and of how many; `None` for all of it.
    #[serde(default)]
    pub part: Option<Part>,
}

/// The results of a submission by test.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct KeptResults(pub BTreeMap<String, KeptResult>);

/// A result, and what it was made from.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct KeptResult {
    /// Tells the test and the files that it follows from.
    pub key: String,
    /// The result.
    pub graded: Graded,
}

/// The folder of a report.
#[derive(Clone, Debug)]
pub(super) struct Store {
    folder: PathBuf,
}

impl Store {
    pub fn new(folder: &Path) -> Self {
        Self {
            folder: folder.to_owned(),
        }
    }

    fn run_path(&self) -> PathBuf {
        self.folder.join("kept").join("run.json")
    }

    fn submission_path(&self, name: &str) -> PathBuf {
        let file = format!("{name}.json");
        self.folder.join("kept").join("submissions").join(file)
    }

    /// Whether this is the folder of a finished report.
    pub fn is_there(&self) -> bool {
        self.run_path().is_file()
    }

    /// Makes the folders.
    ///
    /// # Errors
    /// If the system refuses.
    pub fn prepare(&self) -> Result<(), Diagnostic> {
        // What is in it says nothing to its user.
        disk::make_folder_of(&self.submission_path("")).map_err(|why| Diagnostic {
            path: self.folder.clone(),
            ..why
        })
    }

    /// What is kept of a submission; nothing if that cannot be read.
    pub fn results(&self, name: &str) -> KeptResults {
        let read = Disk.read(&self.submission_path(name)).ok();
        let read = read.and_then(|bytes| serde_json::from_slice(&bytes).ok());
        read.unwrap_or_default()
    }

    /// # Errors
    /// If it cannot be written.
    pub fn keep(&self, name: &str, results: &KeptResults) -> Result<(), Diagnostic> {
        self.write(&self.submission_path(name), results)
    }

    /// The run whose report this is.
    ///
    /// # Errors
    /// If there is none, it is of another version, or a submission is not named like a folder.
    pub fn run(&self) -> Result<KeptRun, Diagnostic> {
        let wrong = |message: &str| Diagnostic::new(&self.folder, message);
        let read = Disk.read(&self.run_path());
        let bytes =
            read.map_err(|_| wrong("expected the finished report of `editor grade`, found none"))?;
        let run: Option<KeptRun> = serde_json::from_slice(&bytes).ok();
        let run = run
            .filter(|run| run.version == VERSION)
            .ok_or_else(|| wrong("expected a report of this version of `editor grade`"))?;
        // Results are read and written under these names.
        match run.submissions.iter().find(|name| !is_folder_name(name)) {
            Some(name) => Err(wrong(&format!(
                "expected the name of a folder, found “{name}”"
            ))),
            None => Ok(run),
        }
    }

    /// # Errors
    /// If it cannot be written.
    pub fn keep_run(&self, run: &KeptRun) -> Result<(), Diagnostic> {
        self.write(&self.run_path(), run)
    }

    fn write(&self, path: &Path, value: &impl Serialize) -> Result<(), Diagnostic> {
        let json = serde_json::to_vec_pretty(value);
        let json = json.map_err(|error| Diagnostic::new(path, error.to_string()))?;
        disk::write_whole(path, &json)
    }
}

/// Whether `name` is one part of a path, which leads to no other folder.
fn is_folder_name(name: &str) -> bool {
    let mut parts = Path::new(name).components();
    let first = parts.next();
    first == Some(Component::Normal(name.as_ref())) && parts.next().is_none()
}
