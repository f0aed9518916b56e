//! Folders of submissions.

use crate::diagnose::figures::{Figure, Format, obj, turned};
use crate::diagnose::student::Student;
use crate::program::{Ran, editor_in};
use glam::Vec3;
use serde_json::{Value, json};
use std::fs;
use std::path::{Path, PathBuf};
use tempfile::TempDir;

/// A class: its tests, and a folder for the submissions.
pub struct Class {
    folder: TempDir,
    /// Names of the tests, each with its character in its pose.
    pub tests: Vec<(String, Figure)>,
}

impl Class {
    /// A class that poses the built-in characters `models`, each in a pose of its own.
    pub fn new(models: &[&str]) -> Self {
        let tests = (1..).zip(models).map(|(seed, model)| {
            (
                format!("{model}-{seed}"),
                Figure::builtin(model, turned(seed)),
            )
        });
        let class = Self {
            folder: tempfile::tempdir().unwrap(),
            tests: tests.collect(),
        };
        for (name, figure) in &class.tests {
            class.write_pose(name, figure);
        }
        let tests: Vec<Value> = class
            .tests
            .iter()
            .map(|(name, figure)| {
                json!({
                    "name": name,
                    "character": figure.name,
                    "pose": format!("{name}.json"),
                    "points": {"3.2": 4, "3.4": 6, "4.2": 10},
                })
            })
            .collect();
        class.set_tests(&json!({ "tests": tests }));
        class.write("class/readme.txt", "no submission");
        class
    }

    pub fn path(&self) -> &Path {
        self.folder.path()
    }

    /// Writes the pose of a test.
    fn write_pose(&self, test: &str, figure: &Figure) {
        let joints = figure.degrees.iter().enumerate();
        let joints: serde_json::Map<String, Value> = joints
            .map(|(joint, degrees)| (joint.to_string(), json!(degrees.to_array())))
            .collect();
        let pose = json!({ "joints": joints }).to_string();
        self.write(&format!("{test}.json"), pose);
    }

    /// Gives the test at the place `test` another pose.
    pub fn set_pose(&mut self, test: usize, degrees: Vec<Vec3>) {
        self.tests[test].1.degrees = degrees;
        let (name, figure) = &self.tests[test];
        self.write_pose(name, figure);
    }

    pub fn set_tests(&self, tests: &Value) {
        self.write("tests.json", tests.to_string());
    }

    pub fn tests_file(&self) -> Value {
        serde_json::from_slice(&self.read("tests.json")).unwrap()
    }

    /// Writes a file and the folders that it is in.
    pub fn write(&self, path: &str, content: impl AsRef<[u8]>) {
        let path = self.path().join(path);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, content).unwrap();
    }

    pub fn read(&self, path: &str) -> Vec<u8> {
        fs::read(self.path().join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
    }

    /// A submission with what `student` gives for every test.
    pub fn submit(&self, name: &str, student: &Student, format: Format) {
        for (test, figure) in &self.tests {
            let text = obj(&student.skin(figure), figure, format);
            self.write(&format!("class/{name}/{test}.obj"), text);
        }
    }

    /// Runs `editor grade` with the words of `line`.
    pub fn run(&self, line: &str) -> Ran {
        let words: Vec<&str> = ["grade"].into_iter().chain(line.split(' ')).collect();
        editor_in(self.path(), &words)
    }

    /// Grades the class; returns `grade.json`.
    #[track_caller]
    pub fn graded(&self) -> Value {
        let ran = self.run("class --tests tests.json -o report");
        assert_eq!(ran.code, Some(0), "{}", ran.err);
        serde_json::from_slice(&self.read("report/grade.json")).unwrap()
    }

    /// Paths of the files of a report, without their folder.
    pub fn files_of(&self, report: &str) -> Vec<PathBuf> {
        let (root, mut open, mut files) = (self.path().join(report), Vec::new(), Vec::new());
        open.push(root.clone());
        while let Some(folder) = open.pop() {
            for entry in fs::read_dir(folder).unwrap() {
                let path = entry.unwrap().path();
                if path.is_dir() {
                    open.push(path);
                } else {
                    files.push(path.strip_prefix(&root).unwrap().to_owned());
                }
            }
        }
        files.sort();
        files
    }

    /// Checks that two reports have the same files with the same bytes.
    #[track_caller]
    pub fn assert_same(&self, a: &str, b: &str) {
        assert_eq!(self.files_of(a), self.files_of(b));
        for file in self.files_of(a) {
            let [one, other] =
                [a, b].map(|report| self.read(&format!("{report}/{}", file.display())));
            assert!(one == other, "{} differs", file.display());
        }
    }
}

/// The result that `grade.json` has of a submission for a test.
#[track_caller]
pub fn result<'a>(report: &'a Value, submission: &str, test: &str) -> &'a Value {
    let named = |list: &'a Value, key: &str, name: &str| {
        let mut all = list.as_array().unwrap().iter();
        all.find(|one| one[key] == name)
            .unwrap_or_else(|| panic!("no {name} in {list}"))
    };
    let submission = named(&report["submissions"], "name", submission);
    named(&submission["tests"], "test", test)
}
