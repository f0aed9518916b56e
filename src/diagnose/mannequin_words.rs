//! What to look at in programs that read Collada files, as for the Virtual Mannequin: they have neither the course's files
//! nor its functions.

use super::diagnosis::{Diagnosis, ToldMistake};
use super::mistake::{MESH, Mistake, SKELETON, SLIDERS};
use super::nearest::Nearest;
use super::other_pose::OtherPose;
use super::picture::PictureDiagnosis;

/// What to look at where joints of the skin are confused.
const JOINTS: &str = "where the skin is read: numbers in <v> count in the skin's own list of joints, whose names lead to \
                      the bones, and not in a list of bones";
/// Where rows of weights are.
const ROWS: &str = "where the skin is read: <vcount> says how many pairs of numbers in <v> each vertex of the mesh has, \
                    vertex by vertex";
/// Where the matrix of a bone is that the shader is given.
const BONE_MATRICES: &str = "the matrix that the shader is given for a bone: its transform in the pose · its inverse bind \
                             matrix, which comes first to the vertex and so stands on the right";
/// Where the vertex gets into the frames of bones.
const OWN_FRAMES: &str = "the vertex shader: each bone moves the vertex from its own frame, to which its own inverse bind matrix \
                          leads; where the shader is given the vertex in the frames of four bones, each goes with its bone";
/// Where matrices are filled.
const TRANSPOSED: &str = "wherever a matrix is filled: Collada writes rows one after the other, WebGL takes columns; and \
                          the vertex is a column on the right of the matrix";
/// Where bones are placed.
const BONES: &str = "where a bone's transform is made, from the roots down: it is parent · own, with the parent's on the left, \
                     and the bone's offset and rotation in its own";
/// Where a bone is turned.
const ROTATIONS: &str = "where a bone's rotation is made, and what it is made of: the axes, their order, the signs and the \
                         units of angles, and what was there before";
/// Where bones are given a pose.
const POSE: &str = "whether the rotations of the bones reach the matrices that the shader is given, and whether inverse \
                    bind matrices are left as they are";
/// Where the mesh is read.
const OF_MESH: &str = "where the mesh is read: <p> has an index for each input, vertices are those of the positions, and \
                       each has the weights of its place in the skin";
/// Where the vertices are summed.
const SUM: &str = "the sum in the vertex shader, and the weights that it is given: every joint that moves the vertex counts, \
                   once and by its weight, as it is in the file";
/// Where vertices are gone through.
const LOOP: &str = "the loop over the vertices, which goes from the first one, 0, to the last";
/// Where a vertex becomes a vector of four.
const POINT: &str = "the vertex shader: a vertex is a point, the fourth coordinate of which is 1";

/// What to look at for mistakes for which that does not follow from their section; `None` for those that are told alike for
/// all programs.
const LOOK_AT: &[(&[&str], Option<&str>)] = &[
    (
        &[
            "weights-shifted",
            "weights-shifted-on",
            "weights-exchanged",
            "joints-by-depth",
            "skin-list-ignored",
        ],
        Some(JOINTS),
    ),
    (
        &[
            "weight-rows-shifted",
            "weight-rows-drift",
            "vertices-without-weights",
        ],
        Some(ROWS),
    ),
    (
        &[
            "no-inverse-bind",
            "inverse-bind-only",
            "bind-not-inverted",
            "factors-swapped",
            "wrong-inverse",
            "bind-parent-missing",
            "bind-of-other-pose",
        ],
        Some(BONE_MATRICES),
    ),
    (&["inverse-bind-shared"], Some(OWN_FRAMES)),
    (&["matrix-transposed"], Some(TRANSPOSED)),
    (
        &["pose-not-applied", "joint-not-turned", "only-root-turned"],
        Some(POSE),
    ),
    (
        &[
            "rotation-before-translation",
            "root-rotated-before-translation",
            "translation-overwritten",
            "rotation-of-children-only",
            "root-not-moved",
        ],
        Some(BONES),
    ),
    (&["vertex-without-w"], Some(POINT)),
    (&["vertices-not-reached"], Some(LOOP)),
    (
        &[
            "moved-as-a-whole",
            "mesh-mirrored",
            "bind-shape-missing",
            "axes-not-converted",
            "angles-about-bones",
            "picture-turned",
            "quaternion-order",
            "current-rotation-transposed",
        ],
        None,
    ),
];

/// What to look at for a mistake, the section of which is in the course's assignment.
fn look_at(id: &str, section: &str) -> Option<&'static str> {
    let by_id = LOOK_AT.iter().find(|(ids, _)| ids.contains(&id));
    by_id.map_or_else(
        || {
            Some(match section {
                SKELETON => BONES,
                SLIDERS => ROTATIONS,
                MESH => OF_MESH,
                _ => SUM,
            })
        },
        |(_, look_at)| *look_at,
    )
}

/// Whose program is told what is wrong with it, by the files and functions that it has.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ToldFor {
    /// The course's editor, which reads `.skel`, `.attach` and `.obj` files.
    #[default]
    CourseEditor,
    /// The Virtual Mannequin, which reads Collada files.
    VirtualMannequin,
}

impl ToldFor {
    /// The program that poses the character of a file, if it is of one.
    pub fn of_file(file: Option<&str>) -> Self {
        match file.is_some_and(|file| file.to_ascii_lowercase().ends_with(".dae")) {
            true => Self::VirtualMannequin,
            false => Self::CourseEditor,
        }
    }
}

impl Mistake {
    /// The mistake in words.
    pub fn told_for(&self, program: ToldFor) -> ToldMistake {
        ToldMistake::whole(self).told_for(program)
    }
}

impl ToldMistake {
    fn told_for(self, program: ToldFor) -> Self {
        if program == ToldFor::CourseEditor {
            return self;
        }
        Self {
            look_at: look_at(self.id, self.section).unwrap_or(self.look_at),
            section: match self.section {
                SKELETON => "Bones",
                SLIDERS => "Turning bones",
                MESH => "Mesh",
                _ => "Skinning",
            },
            meaning: match self.id {
                "weights-shifted" => "the weights of each joint are taken for the joint before it",
                "weights-shifted-on" => {
                    "the weights of each joint are taken for the joint after it"
                }
                "vertices-renumbered" => "vertices are not in the order of the file",
                _ => self.meaning,
            },
            ..self
        }
    }
}

/// All of them told for a program.
fn told_for(told: Vec<ToldMistake>, program: ToldFor) -> Vec<ToldMistake> {
    let told = told.into_iter();
    told.map(|mistake| mistake.told_for(program)).collect()
}

impl Diagnosis {
    /// The same told for a program.
    #[must_use]
    pub fn told_for(self, program: ToldFor) -> Self {
        Self {
            told_for: program,
            mistakes: told_for(self.mistakes, program),
            others: told_for(self.others, program),
            nearest: self.nearest.map(|nearest| Nearest {
                mistake: nearest.mistake.told_for(program),
                ..nearest
            }),
            other_pose: self.other_pose.map(|other| OtherPose {
                besides: other.besides.map(|mistake| mistake.told_for(program)),
                ..other
            }),
            ..self
        }
    }
}

impl PictureDiagnosis {
    /// The same told for a program.
    #[must_use]
    pub fn told_for(self, program: ToldFor) -> Self {
        Self {
            mistakes: told_for(self.mistakes, program),
            ..self
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_name_in_the_table_is_one_of_a_mistake() {
        for id in LOOK_AT.iter().flat_map(|(ids, _)| *ids) {
            assert!(Mistake::find(id).is_some(), "{id}");
        }
    }

    #[test]
    fn no_mistake_of_a_program_that_reads_collada_files_is_told_by_names_of_the_course() {
        for mistake in Mistake::all() {
            let told = mistake.told_for(ToldFor::VirtualMannequin);
            let words = format!("{} {} {}", told.meaning, told.section, told.look_at);
            for name in [
                ".attach",
                ".skel",
                ".obj",
                "column c",
                "Joint",
                "Transform",
                "Vertices",
                "Stack",
                "4.2",
                "3.4",
                "3.2",
                "4.1",
                "SSD",
                "slider",
            ] {
                assert!(!words.contains(name), "{}: {words}", mistake.id);
            }
        }
    }
}
