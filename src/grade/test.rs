//! One test: a character in a pose, and what a file of it is.

mod other_tests;
mod shown_mesh;

use super::found::{explanations, hint, nearly, outcome, owned};
use super::graded::{Graded, Outcome, rounded};
use super::nearness::nearness;
use super::thumbnail::{MeshThumbnail, of_silhouette};
use crate::character::{Character, Pose};
use crate::compare::MeshFinding;
use crate::diagnose::{
    Diagnosis, JOINT_NOT_TURNED, NoNumbers, OfTheWhole, POSE_NOT_APPLIED, PictureError, Verdict,
    diagnose, diagnose_picture, has_silhouette, measure,
};
use crate::geometry::Mesh;
use crate::io::image::{self, PictureFormat};
use crate::io::{
    RIGHT_BUT_FOR_DIGITS, RIGHT_BUT_FOR_FEW, TestData, TestKind, has_vertices, in_utf8, markup,
    read_posed_vertices, without_v,
};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use glam::Vec3;
use std::fmt::Write;
use std::path::Path;
use std::sync::Arc;

/// Width of the smallest picture by that of the test's.
const LEAST_SCALE: f64 = 0.25;

/// Most warnings about a file that are told.
const TOLD: usize = 3;

/// A test that is ready to grade files.
#[derive(Debug)]
pub struct Test {
    data: TestData,
    character: Arc<Character>,
    pose: Pose,
    /// The exact vertices, in model space.
    exact: Vec<Vec3>,
    fingerprint: u32,
}

/// See [`Test::fingerprint`].
fn fingerprint(data: &TestData, character: &Character, pose: &Pose) -> u32 {
    let mut digest = Digest::default();
    let joints = character.skeleton().joints();
    let mesh = character.bind_mesh();
    // Writing to a digest never fails.
    let _ = write!(digest, "{:?}{pose:?}{joints:?}", data.kind);
    let _ = write!(digest, "{:?}{:?}", mesh.positions, mesh.triangles);
    for influences in character.attachments().vertices() {
        let _ = write!(digest, "{influences:?}");
    }
    digest.0.finalize()
}

impl Test {
    /// The test `data` with its files, read.
    pub fn new(data: TestData, character: Arc<Character>, pose: Pose) -> Self {
        let exact = character.skin_pose(&pose);
        Self {
            fingerprint: fingerprint(&data, &character, &pose),
            data,
            character,
            pose,
            exact,
        }
    }

    /// What the file of tests says of it.
    pub fn data(&self) -> &TestData {
        &self.data
    }

    /// Name of the file that a submission has for it.
    pub fn file_name(&self) -> String {
        format!("{}.{}", self.data.name, self.data.kind.extension())
    }

    /// A number that says whether results of an earlier run still hold: it follows from all that they
    /// depend on but the files of the submission.
    pub fn fingerprint(&self) -> u32 {
        self.fingerprint
    }

    /// Mistakes that the test does not show, since a mesh that has one of them is right in its pose.
    pub fn unseen(&self) -> Vec<&'static str> {
        if self.data.kind != TestKind::Mesh {
            return Vec::new();
        }
        let triangles = self.character.bind_mesh().triangles.clone();
        let right = Mesh::new(self.exact.clone(), triangles);
        diagnose(&self.character, &self.pose, &right).map_or(Vec::new(), |found| found.unseen)
    }

    /// The exact result as a PNG, as Base64.
    pub fn picture(&self) -> Option<String> {
        let triangles = &self.character.bind_mesh().triangles;
        as_base64(&match self.data.kind {
            TestKind::Mesh => self.thumbnail().of_exact(),
            TestKind::Picture { camera, size } => {
                of_silhouette(None, size, &camera, &self.exact, triangles)
            }
        })
    }

    /// What the file with the content `bytes` is. Where it is the exact result of another one of `tests`, it was
    /// handed in under a wrong name.
    pub fn grade(&self, bytes: &[u8], tests: &[Self]) -> Graded {
        if bytes.trim_ascii().is_empty() {
            return Graded::without(Outcome::Blank, "the file is empty");
        }
        match self.data.kind {
            TestKind::Mesh => self.grade_mesh(bytes, tests),
            TestKind::Picture { .. } => self.grade_picture(bytes, tests),
        }
    }

    fn grade_mesh(&self, bytes: &[u8], tests: &[Self]) -> Graded {
        let name = self.file_name();
        let bytes = &*in_utf8(bytes);
        if let Ok(text) = std::str::from_utf8(bytes)
            && markup(text).is_none()
            && !has_vertices(text)
        {
            return Graded::without(Outcome::Blank, no_vertices(text));
        }
        let no_numbers = NoNumbers::find(bytes);
        let readable = no_numbers.as_ref().map_or(bytes, |found| &found.without);
        let model = self.character.bind_mesh();
        let read = read_posed_vertices(Path::new(&name), readable, model);
        let (theirs, mut warnings) = match read {
            Ok(read) => (
                read.value,
                read.warnings
                    .iter()
                    .map(ToString::to_string)
                    .collect::<Vec<_>>(),
            ),
            Err(diagnostic) => {
                return Graded::without(Outcome::Unreadable, diagnostic.to_string());
            }
        };
        if let Some(found) = no_numbers.as_ref().filter(|found| found.are_all()) {
            return Graded::without(Outcome::Blank, found.told(&name));
        }
        warnings.extend(no_numbers.as_ref().map(|found| found.told(&name)));
        let places = theirs.positions.iter().map(|place| place.as_dvec3());
        if places.len() > 1
            && let Some(found) = MeshFinding::one_place(places)
        {
            return Graded::without(Outcome::Blank, OfTheWhole(found).to_string());
        }
        match diagnose(&self.character, &self.pose, &theirs) {
            Ok(found) => {
                // A joint that is not turned beside a mistake may as well be as the pose of another test has it.
                let is_open = matches!(found.verdict, Verdict::OtherPose | Verdict::Unexplained)
                    || found.causes.contains(&JOINT_NOT_TURNED.id);
                let of_other = self.other_of(tests, |test| is_open && test.is_right(&theirs));
                let in_pose_of = self.other_of(tests, |test| {
                    is_open && of_other.is_none() && self.is_in_pose_of(test, &theirs)
                });
                let found = match of_other.or(in_pose_of).is_none() && is_open {
                    true => self.or_of_kept(found, &theirs, tests),
                    false => found,
                };
                let with_mistakes = match found.verdict {
                    Verdict::OtherPose | Verdict::Unexplained
                        if of_other.or(in_pose_of).is_none() =>
                    {
                        self.other_with_mistakes(tests, &found, &theirs)
                    }
                    _ => None,
                };
                let mut graded = self.diagnosed_mesh(&found, &theirs);
                if let Some(no_numbers) = &no_numbers {
                    let found = no_numbers.put_back_into(&found);
                    graded.text = found.to_string();
                    graded.error = rounded(found.error_from_exact);
                    if graded.outcome == Outcome::Unexplained && graded.hint.is_none() {
                        let what = no_numbers.what();
                        graded.hint = Some(format!("{}: {what}", graded.outcome.word()));
                    }
                }
                if graded.outcome != Outcome::Right {
                    let told = warnings.iter().take(TOLD);
                    graded
                        .text
                        .extend(told.map(|warning| format!("\n  warning  {warning}")));
                }
                graded.of_tests = match &with_mistakes {
                    Some(other) => vec![other.clone()],
                    None if graded.may_be_of_other_pose() => self.others_of_mesh(tests, &theirs),
                    None => Vec::new(),
                };
                match (of_other, in_pose_of) {
                    (Some(test), _) => graded.of_other_test(&test.data.name),
                    (None, Some(test)) => graded.in_pose_of_other_test(&test.data.name),
                    (None, None) => match with_mistakes {
                        Some(other) => graded.of_other_test_with(&other),
                        None => graded,
                    },
                }
            }
            Err(error) => Graded::without(Outcome::Unreadable, format!("{name}: {error}")),
        }
    }

    fn diagnosed_mesh(&self, found: &Diagnosis, theirs: &Mesh) -> Graded {
        let is_right = found.is_right();
        let measure = measure(&self.character, &self.exact, &theirs.positions);
        let count = theirs.positions.len().max(1) as f64;
        // Of one vertex more or less the others are known, and otherwise not which is which.
        let agrees = match &measure {
            _ if is_right => 1.0,
            Some(measure) => (theirs.positions.len() - measure.off) as f64 / count,
            None => found.agrees,
        };
        let near = measure.as_ref().map_or(found.agrees, nearness);
        // Beside another mistake no vertex may be near, and the loop still come to nearly all.
        let near = match found.reached < 1.0 {
            true => near.max(found.reached),
            false => near,
        };
        let drawn = || as_base64(&self.thumbnail().of_theirs(theirs, measure.as_ref()));
        let mut causes = explanations(found.together(), &found.same_as);
        if self.pose.is_bind() {
            // There is no pose to apply: whatever else gives the same counts first.
            causes.sort_by_key(|ids| ids.iter().any(|id| id == POSE_NOT_APPLIED));
        }
        if found.verdict == Verdict::Explained {
            for mistakes in &mut causes {
                let of_faces = found.faces.mistakes();
                mistakes.extend(of_faces.map(|mistake| mistake.id.to_owned()));
                mistakes.extend(found.coarse.map(|_| RIGHT_BUT_FOR_DIGITS.to_owned()));
            }
        }
        Graded {
            outcome: outcome(found.verdict),
            text: found.to_string(),
            hint: hint(found),
            causes,
            nearly: owned(&nearly(found)),
            slight: owned(&found.slight),
            posed: found
                .other_pose
                .as_ref()
                .and_then(|other| rounded(other.as_expected))
                .unwrap_or(0.0),
            error: rounded(found.error_from_exact),
            agrees: rounded(agrees).unwrap_or(0.0),
            near: rounded(near).unwrap_or(0.0),
            shows: None,
            of_tests: Vec::new(),
            picture: if is_right { None } else { drawn() },
        }
    }

    fn grade_picture(&self, bytes: &[u8], tests: &[Self]) -> Graded {
        let TestKind::Picture { camera, size } = self.data.kind else {
            return Graded::without(Outcome::Unreadable, "expected a mesh, found a picture");
        };
        let name = self.file_name();
        let picture = match image::decode(Path::new(&name), bytes) {
            Ok(picture) => picture,
            Err(diagnostic) => {
                return Graded::without(Outcome::Unreadable, diagnostic.to_string());
            }
        };
        let [width, height] = size;
        if !is_as_wide(size, [picture.width, picture.height]) {
            let found = format!("{}×{}", picture.width, picture.height);
            let text = format!(
                "{name}: expected {width}×{height} pixels, or a picture of the same shape at least a quarter as wide, found {found}"
            );
            return Graded::without(Outcome::Unreadable, text);
        }
        let seen = camera.clip_from_world(width as f32 / height as f32);
        let found = match diagnose_picture(&self.character, &self.pose, &picture, seen) {
            Ok(found) => found,
            Err(PictureError::Blank) => {
                let text = "there is nothing in the picture but its background";
                return Graded::without(Outcome::Blank, text);
            }
        };
        let told = found.mistakes.iter().map(|mistake| mistake.id).collect();
        let triangles = &self.character.bind_mesh().triangles;
        let drawn = || {
            as_base64(&of_silhouette(
                Some(&picture),
                [picture.width, picture.height],
                &camera,
                &self.exact,
                triangles,
            ))
        };
        let agrees = rounded((1.0 - found.error_from_exact).clamp(0.0, 1.0)).unwrap_or(0.0);
        let graded = Graded {
            outcome: outcome(found.verdict),
            text: found.to_string(),
            hint: found.is_nearly_right().then(|| {
                let off = 100.0 * found.error_from_exact;
                format!("all but {off:.1} % of the silhouette")
            }),
            causes: explanations(told, &found.same_as),
            error: rounded(found.error_from_exact),
            nearly: match found.is_nearly_right() {
                true => vec![RIGHT_BUT_FOR_FEW.to_owned()],
                false => Vec::new(),
            },
            slight: Vec::new(),
            posed: 0.0,
            agrees,
            near: agrees,
            shows: None,
            of_tests: Vec::new(),
            picture: if found.verdict == Verdict::Right {
                None
            } else {
                drawn()
            },
        };
        match found.verdict {
            Verdict::Unexplained => {
                let is_of =
                    |test: &Self| has_silhouette(&test.character, &test.pose, &picture, seen);
                match self.other_of(tests, is_of) {
                    Some(test) => graded.of_other_test(&test.data.name),
                    None => graded,
                }
            }
            _ => graded,
        }
    }

    fn thumbnail(&self) -> MeshThumbnail<'_> {
        let facing = self.character.skeleton().facing();
        MeshThumbnail::new(&self.exact, &self.character.bind_mesh().triangles, facing)
    }
}

/// Whether a picture shows what one of the size `wanted` does: it may be taken on a scaled screen, but is large enough to
/// tell mistakes apart.
fn is_as_wide(wanted: [u32; 2], [width, height]: [u32; 2]) -> bool {
    let [wanted_width, wanted_height] = wanted.map(f64::from);
    let [by_width, by_height] = [
        f64::from(width) / wanted_width,
        f64::from(height) / wanted_height,
    ];
    // Sides are whole numbers of pixels.
    let rounding = 1.0 / wanted_width.min(wanted_height);
    (by_width - by_height).abs() <= rounding * by_width.max(1.0) && by_width >= LEAST_SCALE
}

/// A picture as PNG in Base64.
fn as_base64(picture: &crate::geometry::Picture) -> Option<String> {
    let png = image::encode(picture, PictureFormat::Png);
    png.ok().map(|png| STANDARD.encode(png))
}

/// The digest of a text that is too long to be kept.
#[derive(Default)]
struct Digest(crc32fast::Hasher);

impl Write for Digest {
    fn write_str(&mut self, text: &str) -> std::fmt::Result {
        self.0.update(text.as_bytes());
        Ok(())
    }
}

/// That a file has no vertices, and whether it has what may be meant for them.
fn no_vertices(text: &str) -> String {
    let meant = without_v(text).map_or(String::new(), |meant| format!(": {meant}"));
    format!("the file has no vertices{meant}")
}
