//! Submissions, graded side by side.

use super::command::{CommandFailure, TestCommand};
use super::interruption::Interruption;
use super::kept::{KeptResult, KeptResults, Store};
use super::missing::{missing, times, unwritten};
use super::submissions::Submission;
use crate::cli::CliError;
use crate::cli::output::{Progress, eprint_line};
use crate::disk::{ScratchFolder, read_at_most};
use crate::grade::{Graded, Outcome, Test};
use crate::io::Diagnostic;
use std::collections::BTreeMap;
use std::io::{ErrorKind, Read};
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};

/// Size of the largest file of a submission, in bytes.
const LARGEST: u64 = 64 << 20;

/// What all submissions are graded by.
#[derive(Debug)]
pub(super) struct Work<'a> {
    pub tests: &'a [Test],
    pub command: Option<TestCommand>,
    pub store: &'a Store,
    /// Tells this build of the program from others, which may grade otherwise.
    pub program: String,
}

/// A submission that is done.
struct Done {
    name: String,
    graded: Vec<Graded>,
    /// Whether everything was kept from an earlier run.
    is_kept: bool,
}

/// What came of a file: nothing is known of one whose making was interrupted.
enum Made {
    Graded(Box<Graded>),
    Interrupted,
}

impl Work<'_> {
    /// The results of all tests by submission. Progress goes to standard error.
    ///
    /// # Errors
    /// If results cannot be kept, or it is interrupted.
    pub fn all(
        &self,
        submissions: &[Submission],
        jobs: Option<NonZeroUsize>,
    ) -> Result<BTreeMap<String, Vec<Graded>>, CliError> {
        let processors = || std::thread::available_parallelism().unwrap_or(NonZeroUsize::MIN);
        let jobs = jobs.unwrap_or_else(processors).get().min(submissions.len());
        let interruption = Interruption::watched();
        let (next, done) = (AtomicUsize::new(0), Mutex::new(Vec::new()));
        let (started, progress) = (Instant::now(), Progress::new());
        progress.show(format_args!("0 of {} graded", submissions.len()));
        let work = || {
            while let Some(submission) = submissions.get(next.fetch_add(1, Ordering::Relaxed)) {
                if interruption.is_asked() {
                    break;
                }
                let one = self.one(submission, &interruption);
                // What another thread left there is whole.
                let mut done = done.lock().unwrap_or_else(PoisonError::into_inner);
                done.push(one);
                progress.show(left(
                    done.len(),
                    submissions.len(),
                    started.elapsed(),
                    &submission.name,
                ));
            }
        };
        std::thread::scope(|scope| {
            for _ in 0..jobs {
                scope.spawn(work);
            }
        });
        drop(progress);
        if interruption.is_asked() {
            let message =
                "interrupted; started again with the same report it resumes where it stopped";
            return Err(CliError::Other(message.to_owned()));
        }
        let done = done.into_inner().unwrap_or_else(PoisonError::into_inner);
        let done: Vec<Done> = done.into_iter().collect::<Result<_, _>>()?;
        let kept = done.iter().filter(|one| one.is_kept).count();
        let seconds = started.elapsed().as_secs_f64();
        let before = match kept {
            0 => String::new(),
            kept => format!(", {kept} of them before"),
        };
        let plural = if done.len() == 1 { "" } else { "s" };
        eprint_line(format_args!(
            "graded {} submission{plural} in {seconds:.1} s{before}",
            done.len()
        ));
        Ok(done.into_iter().map(|one| (one.name, one.graded)).collect())
    }

    fn one(&self, submission: &Submission, interruption: &Interruption) -> Result<Done, CliError> {
        let before = self.store.results(&submission.name);
        let mut results = KeptResults::default();
        let of_folder = |command: &TestCommand| {
            let folder = fingerprint_of_folder(&submission.folder);
            format!("{}-{folder}", command.fingerprint())
        };
        let at_first = self.command.as_ref().map(of_folder);
        let mut has_run = false;
        for test in self.tests {
            let name = &test.data().name;
            let known = before.0.get(name);
            let result = match (&self.command, &at_first) {
                (Some(command), Some(files)) => {
                    let known = known.filter(|known| has_made_a_file(&known.graded));
                    match known.filter(|known| self.holds(known, test, files)) {
                        Some(known) => known.clone(),
                        None => match self.make(test, submission, command, interruption)? {
                            Made::Graded(graded) => {
                                has_run = true;
                                KeptResult {
                                    key: self.key(test, files, &graded),
                                    graded: *graded,
                                }
                            }
                            Made::Interrupted => {
                                return Err(CliError::Other("interrupted".to_owned()));
                            }
                        },
                    }
                }
                _ => self.of_file(test, submission, known),
            };
            results.0.insert(name.clone(), result);
        }
        // A command may leave files in the folder; as the last one leaves it, so the next run finds it.
        if let Some(files) = self.command.as_ref().filter(|_| has_run).map(of_folder) {
            for test in self.tests {
                if let Some(result) = results.0.get_mut(&test.data().name) {
                    result.key = self.key(test, &files, &result.graded);
                }
            }
        }
        let in_order = self.tests.iter().filter_map(|test| {
            let result = results.0.get(&test.data().name)?;
            Some(result.graded.clone())
        });
        let graded = in_order.collect();
        let is_kept = results == before;
        if !is_kept {
            self.store.keep(&submission.name, &results)?;
        }
        Ok(Done {
            name: submission.name.clone(),
            graded,
            is_kept,
        })
    }

    /// The result of the file that a submission has for a test.
    fn of_file(
        &self,
        test: &Test,
        submission: &Submission,
        known: Option<&KeptResult>,
    ) -> KeptResult {
        let name = test.file_name();
        let missing = || {
            let others = self.tests.iter().map(Test::file_name);
            let others: Vec<String> = others.filter(|other| *other != name).collect();
            missing(&submission.folder, &name, &others)
        };
        let read = read(&submission.folder.join(&name), &name, missing);
        let mut file = match &read {
            Ok(bytes) => fingerprint(bytes),
            Err(graded) => graded.text.clone(),
        };
        // A picture may show the mesh that is handed in beside it.
        let mesh = test.mesh_test(self.tests).map(Test::file_name);
        let mesh = mesh.and_then(|name| {
            let nothing = || String::new();
            self::read(&submission.folder.join(&name), &name, nothing).ok()
        });
        file.extend(mesh.iter().map(|bytes| format!("-{}", fingerprint(bytes))));
        if let Some(known) = known.filter(|known| self.holds(known, test, &file)) {
            return known.clone();
        }
        let graded = match read {
            Ok(bytes) => {
                let graded = test.grade(&bytes, self.tests);
                // Another pose, too, may be the one that the mesh is in.
                let is_open = matches!(graded.outcome, Outcome::Unexplained | Outcome::OtherPose);
                let shown = mesh.filter(|mesh| is_open && test.shows(&bytes, mesh));
                let mesh = shown.and(test.mesh_test(self.tests));
                Graded {
                    shows: mesh.map(|mesh| mesh.data().name.clone()),
                    ..graded
                }
            }
            Err(graded) => *graded,
        };
        KeptResult {
            key: self.key(test, &file, &graded),
            graded,
        }
    }

    /// The file that the command makes for a test, graded.
    fn make(
        &self,
        test: &Test,
        submission: &Submission,
        command: &TestCommand,
        interruption: &Interruption,
    ) -> Result<Made, CliError> {
        let name = test.file_name();
        let scratch = ScratchFolder::new()?;
        let output = scratch.path().join(&name);
        let before = times(&submission.folder);
        let ran = command.run(test.data(), &submission.folder, &output, interruption);
        let nothing = || unwritten(&name, &submission.folder, &before, scratch.path());
        let written = read(&output, &name, nothing);
        // A second signal ends the program, and should find no folder to leave behind.
        drop(scratch);
        let without = |text: &str| Graded::without(Outcome::Missing, told(text, submission, &name));
        let graded = match ran {
            Ok(()) => match written {
                Ok(bytes) => test.grade(&bytes, self.tests),
                Err(graded) if graded.outcome == Outcome::Missing => without(&graded.text),
                Err(graded) => *graded,
            },
            Err(CommandFailure::Interrupted) => return Ok(Made::Interrupted),
            Err(CommandFailure::Missing(text)) => without(&text),
            Err(CommandFailure::Failed(text)) => Graded::without(Outcome::Failed, text),
        };
        Ok(Made::Graded(graded.into()))
    }

    /// Whether a result of an earlier run is that of the same files.
    fn holds(&self, known: &KeptResult, test: &Test, files: &str) -> bool {
        known.key == self.key(test, files, &known.graded)
    }

    /// What a result follows from.
    fn key(&self, test: &Test, files: &str, graded: &Graded) -> String {
        let key = format!("{}-{:08x}-{files}", self.program, test.fingerprint());
        if !graded.is_of_all_tests() {
            return key;
        }
        let all = self.tests.iter();
        let all = all.map(|test| format!("{} {:08x}", test.data().name, test.fingerprint()));
        let all = all.collect::<Vec<_>>().join("\n");
        format!("{key}-{}", fingerprint(all.as_bytes()))
    }
}

/// A text that tells this build of the program from others: any of its parts may change what is graded.
pub(super) fn fingerprint_of_program() -> String {
    fingerprint_of_build(std::env::current_exe())
}

/// The same for the program in the file `path`. One that cannot be read may be any: it is told from all
/// others, and from itself when it is started again.
fn fingerprint_of_build(path: std::io::Result<PathBuf>) -> String {
    let read = path.and_then(|path| fingerprint_on_disk(&path));
    read.unwrap_or_else(|_| {
        let since = SystemTime::now().duration_since(UNIX_EPOCH);
        let since = since.unwrap_or_default().as_nanos();
        format!("unread-{}-{since}", std::process::id())
    })
}

/// Whether a command has made a file. What it lacked may be there by now, such as a program that it starts: it is tried
/// again.
fn has_made_a_file(graded: &Graded) -> bool {
    !matches!(graded.outcome, Outcome::Missing | Outcome::Failed)
}

/// Why a command made no file, with a word on one called `name` that the submission has nevertheless.
fn told(text: &str, submission: &Submission, name: &str) -> String {
    if submission.folder.join(name).exists() {
        format!("{text}; the {name} that is there is not read, since the tests have a command")
    } else {
        text.to_owned()
    }
}

/// The content of the file at `path`, called `name`, or what there is in its place; `missing` says that there is none.
fn read(path: &Path, name: &str, missing: impl Fn() -> String) -> Result<Vec<u8>, Box<Graded>> {
    let metadata = match std::fs::symlink_metadata(path) {
        Ok(metadata) => metadata,
        Err(error) if error.kind() == ErrorKind::PermissionDenied => {
            let text = format!("{name}: there is no permission to open its folder");
            return Err(Graded::without(Outcome::Unreadable, text).into());
        }
        Err(_) => return Err(Graded::without(Outcome::Missing, missing()).into()),
    };
    // It may lead to the file of another submission.
    if metadata.is_symlink() {
        let text = format!("{name}: expected a file, found a symbolic link");
        return Err(Graded::without(Outcome::Unreadable, text).into());
    }
    read_at_most(path, LARGEST).map_err(|diagnostic| {
        let told = Diagnostic {
            path: name.into(),
            ..diagnostic
        };
        Graded::without(Outcome::Unreadable, told.to_string()).into()
    })
}

/// A text that tells `bytes` from others.
fn fingerprint(bytes: &[u8]) -> String {
    format!("{}-{:08x}", bytes.len(), crc32fast::hash(bytes))
}

/// The same for all files in a folder with their names.
fn fingerprint_of_folder(folder: &Path) -> String {
    let (mut open, mut files) = (vec![folder.to_owned()], Vec::new());
    while let Some(folder) = open.pop() {
        for entry in std::fs::read_dir(folder).into_iter().flatten().flatten() {
            // Links may lead round in a circle.
            match entry.file_type() {
                Ok(kind) if kind.is_dir() => open.push(entry.path()),
                _ => files.push(entry.path()),
            }
        }
    }
    files.sort();
    let mut all = crc32fast::Hasher::new();
    for path in &files {
        let content = fingerprint_on_disk(path).unwrap_or_else(|error| error.kind().to_string());
        let name = path.strip_prefix(folder).unwrap_or(path).as_os_str();
        all.update(name.as_encoded_bytes());
        all.update(content.as_bytes());
    }
    format!("{}-{:08x}", files.len(), all.finalize())
}

/// The same for what is at `path`: a file of any size, a link by where it leads, or anything else by
/// its kind.
fn fingerprint_on_disk(path: &Path) -> std::io::Result<String> {
    let metadata = std::fs::symlink_metadata(path)?;
    if metadata.is_symlink() {
        let target = std::fs::read_link(path)?;
        let target = fingerprint(target.as_os_str().as_encoded_bytes());
        return Ok(format!("link-{target}"));
    }
    // Opening a pipe would wait until someone writes to it.
    if !metadata.is_file() {
        return Ok("special".to_owned());
    }
    let mut file = std::fs::File::open(path)?;
    let (mut digest, mut length) = (crc32fast::Hasher::new(), 0);
    let mut block = vec![0; 1 << 16];
    loop {
        match file.read(&mut block)? {
            0 => return Ok(format!("{length}-{:08x}", digest.finalize())),
            read => {
                digest.update(&block[..read]);
                length += read;
            }
        }
    }
}

/// What is done and what is left, in words.
fn left(done: usize, all: usize, elapsed: Duration, name: &str) -> String {
    let left = all - done;
    let seconds = elapsed.as_secs_f64() / done.max(1) as f64 * left as f64;
    let time = match seconds {
        seconds if seconds < 90.0 => format!("{seconds:.0} s"),
        seconds => format!("{:.0} min", seconds / 60.0),
    };
    let name = crate::cli::output::visible(name);
    format!("{done} of {all} graded, {left} left, about {time}; {name} is done")
}

#[cfg(test)]
mod tests {
    use super::fingerprint_of_build;
    use std::path::PathBuf;

    #[test]
    fn a_program_that_cannot_be_read_is_told_from_all_others_and_from_itself() {
        let nowhere = || fingerprint_of_build(Ok(PathBuf::from("/nowhere/editor")));
        assert_ne!(nowhere(), nowhere());
        let unknown = || fingerprint_of_build(Err(std::io::ErrorKind::NotFound.into()));
        assert_ne!(unknown(), unknown());
        let folder = tempfile::tempdir().unwrap();
        let program = folder.path().join("editor");
        std::fs::write(&program, "program").unwrap();
        let read = || fingerprint_of_build(Ok(program.clone()));
        assert_eq!(read(), read());
    }
}
