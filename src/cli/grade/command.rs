//! The command that makes the files of a submission, within limits.

use super::interruption::Interruption;
use crate::cli::CliError;
use crate::disk::{self, ScratchFolder, files};
use crate::io::{CommandData, Diagnostic, PoseFile, TestData, builtin, pose_of_several};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

#[cfg(unix)]
mod process;

/// A command with the files that it is given.
#[derive(Debug)]
pub(super) struct TestCommand {
    data: CommandData,
    /// Character and pose by name of test, as absolute paths.
    given: BTreeMap<String, [PathBuf; 2]>,
    /// Where some of these poses are.
    _poses: SinglePoses,
}

/// Why a command made no file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum CommandFailure {
    /// There is no such program.
    Missing(String),
    /// It failed, or was ended.
    Failed(String),
    /// This program was asked to end.
    Interrupted,
}

/// Files with one pose each, of files with several, which other programs need not read.
#[derive(Debug, Default)]
struct SinglePoses {
    folder: Option<ScratchFolder>,
}

impl SinglePoses {
    /// The path of a file with the pose that `named` is in the test of this number, if that is one of several.
    ///
    /// # Errors
    /// If there is no such pose, or it cannot be written.
    fn of_several(&mut self, number: usize, named: &Path) -> Result<Option<PathBuf>, CliError> {
        let files = files();
        if pose_of_several(&files, named).is_none() {
            return Ok(None);
        }
        let pose = PoseFile::open(&files, named)?;
        let folder = match self.folder.take() {
            Some(folder) => folder,
            None => ScratchFolder::new()?,
        };
        let folder = self.folder.insert(folder);
        let path = folder.path().join(format!("pose-{number}.json"));
        disk::write_whole(&path, pose.data().to_json().as_bytes())?;
        Ok(Some(path))
    }
}

impl TestCommand {
    /// The command `data` for tests of the file at `path`.
    ///
    /// # Errors
    /// If a character or a pose that the command is given is built in, which other programs cannot read, or this system
    /// knows no groups of processes.
    pub fn new(data: &CommandData, tests: &[TestData], path: &Path) -> Result<Self, CliError> {
        if cfg!(not(unix)) {
            let message = "expected a system on which commands can be limited: Linux or macOS";
            return Err(Diagnostic::new(path, message).into());
        }
        let mut given = BTreeMap::new();
        let mut poses = SinglePoses::default();
        for (number, test) in tests.iter().enumerate() {
            let places = [
                ("{character}", &test.character.path),
                ("{pose}", &test.pose.path),
            ];
            for (place, file) in places {
                let is_given = data.run.iter().any(|word| word.contains(place));
                if is_given && file.to_string_lossy().starts_with(builtin::PREFIX) {
                    let found = file.display();
                    let message =
                        format!("expected a file for {place} of the command, found {found}");
                    return Err(Diagnostic::new(path, message).into());
                }
            }
            let absolute = |file: &Path| {
                let file = super::beside(path, file);
                std::path::absolute(&file).unwrap_or(file)
            };
            let pose = match poses.of_several(number, &super::beside(path, &test.pose.path))? {
                Some(alone) => alone,
                None => absolute(&test.pose.path),
            };
            given.insert(test.name.clone(), [absolute(&test.character.path), pose]);
        }
        Ok(Self {
            data: data.clone(),
            given,
            _poses: poses,
        })
    }

    /// A number that tells this command from others.
    pub fn fingerprint(&self) -> String {
        let CommandData {
            run,
            seconds,
            memory,
        } = &self.data;
        let text = format!("{run:?} {seconds} {memory}");
        format!("{:08x}", crc32fast::hash(text.as_bytes()))
    }

    /// Runs it in `folder` for `test`, so that it writes `output`.
    ///
    /// # Errors
    /// If it fails or goes beyond a limit; when `interruption` is set it is ended.
    pub fn run(
        &self,
        test: &TestData,
        folder: &Path,
        output: &Path,
        interruption: &Interruption,
    ) -> Result<(), CommandFailure> {
        let [character, pose] = match self.given.get(&test.name) {
            Some(given) => given,
            None => return Err(CommandFailure::Failed("the test is unknown".to_owned())),
        };
        let folder = std::path::absolute(folder).unwrap_or_else(|_| folder.to_owned());
        let [character, pose, written] =
            [character, pose, output].map(|path| path.to_string_lossy());
        let places = [
            ("{character}", &*character),
            ("{pose}", &*pose),
            ("{output}", &*written),
            ("{test}", &*test.name),
        ];
        let words = self.data.run.iter().map(|word| filled_in(word, &places));
        let words: Vec<String> = words.collect();
        execute(&self.data, &words, &folder, output, interruption)
    }
}

/// `word` with the values in place of the names of `places`. What a value holds is no name again.
fn filled_in(word: &str, places: &[(&str, &str)]) -> String {
    let (mut filled, mut rest) = (String::new(), word);
    while let Some(at) = rest.find('{') {
        let (before, from) = rest.split_at(at);
        filled.push_str(before);
        let named = places
            .iter()
            .find_map(|(name, value)| Some((from.strip_prefix(name)?, *value)));
        let (after, value) = named.unwrap_or((&from[1..], "{"));
        filled.push_str(value);
        rest = after;
    }
    filled + rest
}

#[cfg(unix)]
fn execute(
    data: &CommandData,
    words: &[String],
    folder: &Path,
    output: &Path,
    interruption: &Interruption,
) -> Result<(), CommandFailure> {
    let ran = process::run(data, words, folder, interruption);
    // The name of a temporary file differs from run to run.
    let told = |text: String| text.replace(&*output.to_string_lossy(), "OUTPUT");
    ran.map_err(|failure| match failure {
        CommandFailure::Failed(text) => CommandFailure::Failed(told(text)),
        other => other,
    })
}

#[cfg(not(unix))]
fn execute(
    _: &CommandData,
    _: &[String],
    _: &Path,
    _: &Path,
    _: &AtomicBool,
) -> Result<(), CommandFailure> {
    Err(CommandFailure::Failed(
        "commands cannot be run here".to_owned(),
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_value_that_looks_like_a_name_is_not_replaced_again() {
        let places = [
            ("{character}", "a {pose}.obj"),
            ("{pose}", "b {test}.json"),
            ("{test}", "{character}"),
        ];
        for (word, expected) in [
            ("{character}", "a {pose}.obj"),
            ("--pose={pose},{test}", "--pose=b {test}.json,{character}"),
            ("{{test}} {other} {", "{{character}} {other} {"),
            ("", ""),
        ] {
            assert_eq!(filled_in(word, &places), expected);
        }
    }
}
