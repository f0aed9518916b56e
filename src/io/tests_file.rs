//! The file that a class is graded by: tests, the rubric, and the command that makes what is graded.

use super::json::Json;
use super::rubric_data::{Points, RubricData};
use super::scanner::quoted;
use super::{Diagnostic, Position};
use crate::scene::Camera;
use serde::{Deserialize, Serialize};
use serde_spanned::Spanned;
use std::collections::{BTreeMap, HashSet};
use std::path::{Path, PathBuf};

/// Longest side of a picture, in pixels.
const MOST_A_SIDE: u32 = 8192;
/// Size of a picture whose test says none, in pixels.
const DEFAULT_SIZE: [u32; 2] = [800, 600];

/// The content of a `TESTS.json`.
#[derive(Clone, Debug, PartialEq)]
pub struct TestsFile {
    /// What the report is called.
    pub title: String,
    /// Tests in the order of the file, of which there is at least one; names are used once.
    pub tests: Vec<TestData>,
    /// How points are given.
    pub rubric: RubricData,
    /// What makes the files of a submission; without it they lie in its folder.
    pub command: Option<CommandData>,
}

/// One test: a character in a pose.
#[derive(Clone, Debug, PartialEq)]
pub struct TestData {
    /// Its name, which the file of a submission has.
    pub name: String,
    /// The character.
    pub character: NamedFile,
    /// The pose.
    pub pose: NamedFile,
    /// What a submission shows.
    pub kind: TestKind,
    /// Points by section of the assignment.
    pub points: BTreeMap<String, Points>,
}

/// A file that a test names.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedFile {
    /// Its path, as the file of tests has it.
    pub path: PathBuf,
    /// Where it is named there.
    pub at: Position,
}

/// What is graded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TestKind {
    /// A posed mesh, `TEST.obj`.
    Mesh,
    /// A picture of it, `TEST.png`.
    Picture {
        /// What it is seen with.
        camera: Camera,
        /// Width and height in pixels.
        size: [u32; 2],
    },
}

impl TestKind {
    /// Extension of the file, without a dot.
    pub fn extension(self) -> &'static str {
        match self {
            Self::Mesh => "obj",
            Self::Picture { .. } => "png",
        }
    }
}

/// A command that makes the file of one test.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct CommandData {
    /// The program and its arguments.
    pub run: Vec<String>,
    /// Time that it may take, in seconds.
    #[serde(default = "default_seconds")]
    pub seconds: f32,
    /// Memory that it may take with all that it starts, in MiB.
    #[serde(default = "default_memory")]
    pub memory: f32,
}

/// What stands for the files of a test in a command, and for its name.
pub const PLACES: [&str; 4] = ["{character}", "{pose}", "{output}", "{test}"];

/// A word in braces that stands for nothing, if there is one. Variables of a shell, `${name}`, are none.
fn unknown_place(word: &str) -> Option<&str> {
    let starts = word.match_indices('{').map(|(at, _)| at);
    let mut places = starts.filter_map(|at| {
        let length = word[at..].find('}')? + 1;
        let place = &word[at..at + length];
        let name = &place[1..length - 1];
        let is_name = !name.is_empty() && name.bytes().all(|byte| byte.is_ascii_lowercase());
        (is_name && !word[..at].ends_with('$')).then_some(place)
    });
    places.find(|place| !PLACES.contains(place))
}

fn default_seconds() -> f32 {
    60.0
}

fn default_memory() -> f32 {
    1024.0
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct WrittenFile {
    #[serde(default)]
    title: String,
    tests: Vec<WrittenTest>,
    #[serde(default)]
    rubric: RubricData,
    command: Option<Spanned<CommandData>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct WrittenTest {
    name: Spanned<String>,
    character: Spanned<String>,
    pose: Spanned<String>,
    #[serde(default)]
    kind: Kind,
    camera: Option<Spanned<Vec<f32>>>,
    size: Option<Spanned<Vec<u32>>>,
    points: BTreeMap<String, Points>,
}

#[derive(Clone, Copy, Default, PartialEq, Deserialize)]
#[serde(rename_all = "lowercase")]
enum Kind {
    #[default]
    Mesh,
    Picture,
}

impl TestsFile {
    /// Reads a `TESTS.json`.
    ///
    /// # Errors
    /// If it is no JSON, or not of this form, or has no test; at a test whose name is no name of a
    /// file or that another one has, at a camera or a size of a picture that is none, and at points
    /// given by hand that are more than their section is worth.
    pub fn read(path: &Path, bytes: &[u8]) -> Result<Self, Diagnostic> {
        let json = Json::parse(path, bytes)?;
        let text = json.text();
        let written: WrittenFile = json.read()?;
        let wrong = |at: usize, message: String| Diagnostic {
            position: Some(Position::in_text(text, at)),
            ..Diagnostic::new(path, message)
        };
        if written.tests.is_empty() {
            return Err(Diagnostic::new(path, "expected a test, found none"));
        }
        let named = |file: Spanned<String>| NamedFile {
            at: Position::in_text(text, file.span().start),
            path: file.into_inner().into(),
        };
        let mut names = HashSet::new();
        let mut tests = Vec::with_capacity(written.tests.len());
        for test in written.tests {
            let name = test.name.get_ref();
            let at = test.name.span().start;
            if !is_name(name) {
                let message = format!(
                    "expected a name that a file may have, found {}",
                    quoted(name)
                );
                return Err(wrong(at, message));
            }
            if !names.insert(name.to_lowercase()) {
                let message = format!("expected each name once, found {} again", quoted(name));
                return Err(wrong(at, message));
            }
            let kind = test.kind().map_err(|(at, message)| wrong(at, message))?;
            tests.push(TestData {
                name: test.name.into_inner(),
                character: named(test.character),
                pose: named(test.pose),
                kind,
                points: test.points,
            });
        }
        if let Some(command) = &written.command {
            let checked = command.get_ref().check();
            checked.map_err(|message| wrong(command.span().start, message))?;
        }
        let file = Self {
            title: written.title,
            tests,
            rubric: written.rubric,
            command: written.command.map(Spanned::into_inner),
        };
        let checked = file.check_given();
        checked.map_err(|(at, message)| wrong(at, message))?;
        Ok(file)
    }

    /// Points that tests have for a section, by its number or name; `None` where no test has any.
    pub fn points_of_tests(&self, section: &str) -> Option<f64> {
        let tests = self.tests.iter();
        let points = tests.filter_map(|test| Some(test.points.get(section)?.0));
        points.reduce(|all, points| all + points)
    }

    /// Points that a section is worth; `None` where neither the rubric nor a test says so.
    pub fn worth(&self, section: &str) -> Option<f64> {
        let of_rubric = self.rubric.sections.get(section);
        let of_rubric = of_rubric.and_then(|section| section.points);
        let of_rubric = of_rubric.map(|points| points.0);
        of_rubric.or_else(|| self.points_of_tests(section))
    }

    /// Whether no more points are given by hand than there are, or the first that are more: the byte
    /// where they start, and what is wrong.
    fn check_given(&self) -> Result<(), (usize, String)> {
        for (section, points) in self.rubric.given.values().flatten() {
            let found = points.get_ref().0;
            if let Some(most) = self.worth(section).filter(|most| found > *most) {
                let expected = format!("expected at most the {most} points of section {section}");
                return Err((points.span().start, format!("{expected}, found {found}")));
            }
        }
        Ok(())
    }
}

/// Whether files can have this name on every system.
fn is_name(name: &str) -> bool {
    let fits = |c: char| !c.is_control() && !"/\\:*?\"<>|".contains(c);
    name == name.trim()
        && !name.starts_with('.')
        && (1..=100).contains(&name.len())
        && name.chars().all(fits)
}

impl WrittenTest {
    /// What is graded, or what is wrong and the byte where it starts.
    fn kind(&self) -> Result<TestKind, (usize, String)> {
        if self.kind == Kind::Mesh {
            let camera = self.camera.as_ref().map(|camera| camera.span().start);
            let size = self.size.as_ref().map(|size| size.span().start);
            return match camera.or(size) {
                None => Ok(TestKind::Mesh),
                Some(at) => Err((
                    at,
                    "cameras and sizes are for pictures, found a mesh".to_owned(),
                )),
            };
        }
        let camera = match &self.camera {
            None => Camera::default(),
            Some(numbers) => Camera::from_numbers(numbers.get_ref())
                .map_err(|message| (numbers.span().start, message))?,
        };
        let size = match &self.size {
            None => DEFAULT_SIZE,
            Some(size) => {
                let sides = <[u32; 2]>::try_from(&**size.get_ref()).ok();
                let fits =
                    |sides: &[u32; 2]| sides.iter().all(|side| (1..=MOST_A_SIDE).contains(side));
                sides.filter(fits).ok_or_else(|| {
                    let expected = format!(
                        "expected a width and a height from 1 to {MOST_A_SIDE} such as [800, 600]"
                    );
                    (
                        size.span().start,
                        format!("{expected}, found {:?}", size.get_ref()),
                    )
                })?
            }
        };
        Ok(TestKind::Picture { camera, size })
    }
}

impl CommandData {
    fn check(&self) -> Result<(), String> {
        if self.run.first().is_none_or(String::is_empty) {
            return Err("expected a program in `run`, found none".to_owned());
        }
        if let Some(found) = self.run.iter().find_map(|word| unknown_place(word)) {
            let expected = PLACES.join(", ");
            return Err(format!("expected one of {expected}, found {found}"));
        }
        if !self.run.iter().any(|word| word.contains("{output}")) {
            return Err("expected {output} for the file to write in `run`, found none".to_owned());
        }
        for (name, limit) in [("seconds", self.seconds), ("memory", self.memory)] {
            if limit <= 0.0 {
                return Err(format!(
                    "expected a number above 0 for `{name}`, found {limit}"
                ));
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::io::Share;

    fn read(text: &str) -> Result<TestsFile, String> {
        TestsFile::read(Path::new("t.json"), text.as_bytes()).map_err(|error| error.to_string())
    }

    #[test]
    fn a_file_has_tests_a_rubric_and_a_command() {
        let file = read(
            r#"{"title": "A1",
            "tests": [{"name": "walk", "character": "a.obj", "pose": "w.json", "points": {"4.2": 10}},
                      {"name": "side", "character": "a.obj", "pose": "w.json", "kind": "picture",
                       "camera": [80, 10, 3], "size": [640, 480], "points": {"4.2": 2.5}}],
            "rubric": {"sections": {"artifact": {"points": 8}}, "mistakes": {"euler-zyx": 0.75},
                       "given": {"ada": {"artifact": 7}}},
            "command": {"run": ["./a", "{pose}", "{output}"], "seconds": 2}}"#,
        )
        .unwrap();
        assert_eq!(file.title, "A1");
        assert_eq!(file.tests[0].kind, TestKind::Mesh);
        let TestKind::Picture { camera, size } = file.tests[1].kind else {
            panic!("{file:?}");
        };
        assert_eq!((camera.radius, size), (3.0, [640, 480]));
        assert_eq!(file.tests[1].points["4.2"], Points(2.5));
        assert_eq!(
            (file.rubric.mistake, file.rubric.unexplained),
            (Share(0.5), Share(0.5))
        );
        let command = file.command.unwrap();
        assert_eq!((command.seconds, command.memory), (2.0, 1024.0));
    }

    #[test]
    fn what_is_wrong_is_told_at_its_place() {
        let test = |more: &str| {
            format!(
                r#"{{"tests": [{{"name": "a", "character": "b", "pose": "c", "points": {{}}{more}}}]}}"#
            )
        };
        for (text, error) in [
            (
                "{\"tests\": []}".to_owned(),
                "t.json: expected a test, found none",
            ),
            (
                r#"{"tests": [], "rubric": {"mistakes": {"euler-zxx": 1}}}"#.to_owned(),
                "t.json:1:39: expected the name of a mistake such as euler-zyx, found “euler-zxx”",
            ),
            (
                test(r#", "kind": "film""#),
                "t.json:1:79: expected `mesh` or `picture`, found “film”",
            ),
            (
                test(r#", "camera": [1, 2, 3]"#),
                "t.json:1:81: cameras and sizes are for pictures, found a mesh",
            ),
            (
                test(r#", "kind": "picture", "camera": [1, 2]"#),
                "t.json:1:100: expected three numbers THETA, PHI, RADIUS or six with TX, TY, TZ, found 2",
            ),
            (
                test(r#", "kind": "picture", "size": [0, 2]"#),
                "t.json:1:98: expected a width and a height from 1 to 8192 such as [800, 600], found [0, 2]",
            ),
            (
                test("").replace("{}", r#"{"4.2": -1}"#),
                "t.json:1:75: expected a number from 0 to 1000000, found -1",
            ),
            (
                test("").replace("\"a\"", "\"a/b\""),
                "t.json:1:21: expected a name that a file may have, found “a/b”",
            ),
            (
                test("").replace("]}", r#"], "command": {"run": []}}"#),
                "t.json:1:84: expected a program in `run`, found none",
            ),
            (
                test("").replace(
                    "]}",
                    r#"], "command": {"run": ["a", "{output}"], "seconds": 0}}"#,
                ),
                "t.json:1:84: expected a number above 0 for `seconds`, found 0",
            ),
            (
                test("").replace(
                    "]}",
                    r#"], "command": {"run": ["a", "${home}/{pose}", "x{outptu}"]}}"#,
                ),
                "t.json:1:84: expected one of {character}, {pose}, {output}, {test}, found {outptu}",
            ),
            (
                test("").replace("]}", r#"], "command": {"run": ["a", "{pose}"]}}"#),
                "t.json:1:84: expected {output} for the file to write in `run`, found none",
            ),
        ] {
            assert_eq!(read(&text).unwrap_err(), error, "{text}");
        }
        let twice = r#"{"tests": [{"name": "a", "character": "b", "pose": "c", "points": {}},
{"name": "A", "character": "b", "pose": "c", "points": {}}]}"#;
        let error = "t.json:2:10: expected each name once, found “A” again";
        assert_eq!(read(twice).unwrap_err(), error);
    }
}
