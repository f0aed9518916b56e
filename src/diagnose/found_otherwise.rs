//! Mistakes that are found otherwise than by making each in every way: in the faces of a mesh, in single joints, and with
//! numbers from the mesh.

use super::formula::{Begun, Columns, Formula, Offsets};
use super::mistake::{LOOK_AT_PLACE, MESH, Mistake, SKELETON, SLIDERS, SSD, reading};
use std::f64::consts::PI;

/// A mistake in the faces of a mesh, which no formula for its vertices gives. Grading counts it.
pub(super) static TRIANGLES_TURNED: Mistake = Mistake {
    id: super::TRIANGLES_TURNED,
    meaning: "triangles wind the other way, so that normals point the other way",
    section: MESH,
    look_at: "where faces are read and written: the order of their three corners",
    readings: &[],
};

/// The same where triangles of the character are missing, whether or not there are others in their place.
pub(super) static TRIANGLES_DIFFER: Mistake = Mistake {
    id: super::TRIANGLES_DIFFER,
    meaning: "triangles of the model are missing, or others are in their place",
    section: MESH,
    look_at: "where faces are read and written: whether all of them are, each with the indices of its own three \
              vertices, which count from 1 in the file",
    readings: &[],
};

/// A mistake in the number of vertices, which is found beside every other one.
pub(super) static VERTEX_TOO_MANY: Mistake = Mistake {
    id: super::VERTEX_TOO_MANY,
    meaning: "there is one vertex more than the model has",
    section: MESH,
    look_at: "where the .obj file is read: a loop until eof() goes on once more after the last line, with what it has \
              read before; and whether there is an element before the first",
    readings: &[],
};

/// The same where one is missing.
pub(super) static VERTEX_MISSING: Mistake = Mistake {
    id: super::VERTEX_MISSING,
    meaning: "there is one vertex fewer than the model has",
    section: MESH,
    look_at: "where vertices are read and where they are written: each loop goes from the first one, 0, to the last, which \
              is one less than their number",
    readings: &[],
};

/// A mistake in which vertices are posed, which all of them show together.
pub static VERTICES_NOT_REACHED: Mistake = Mistake {
    id: "vertices-not-reached",
    meaning: "the loop over the vertices does not come to all of them, so that the others stay where they were",
    section: SSD,
    look_at: "updateMeshVertices: the loop over the vertices goes from the first one, 0, to the last; of vertices at the \
              origin also where the .attach file is read, which has a row of weights for each",
    readings: &[],
};

/// A mistake in which vertices have weights, which those in between show together.
pub static VERTICES_WITHOUT_WEIGHTS: Mistake = Mistake {
    id: "vertices-without-weights",
    meaning: "the sum for some vertices is of nothing, as where they have no weights, so that they are at the origin",
    section: SSD,
    look_at: "where the .attach file is read: it has a row of weights for each vertex, none of which is skipped; then the \
              sum in updateMeshVertices",
    readings: &[],
};

/// A mistake in one line of the skeleton, which is found joint by joint and parent by parent.
pub(super) static ONE_WRONG_PARENT: Mistake = Mistake {
    id: "one-wrong-parent",
    meaning: "one joint hangs on another parent than the file says",
    section: SKELETON,
    look_at: "where the .skel file is read: the last number of a line is the index of the parent, from 0, and \
              -1 for a root",
    readings: &[],
};

/// A mistake in one line of the skeleton, whose offset is worked out from the mesh.
pub(super) static ONE_WRONG_OFFSET: Mistake = Mistake {
    id: "one-wrong-offset",
    meaning: "one joint has another offset from its parent than the file says",
    section: SKELETON,
    look_at: "where the .skel file is read: the first three numbers of a line are the offset from the parent, \
              which nothing may change",
    readings: &[],
};

/// A mistake in two columns of the weights, which are found pair by pair.
pub(super) static WEIGHTS_EXCHANGED: Mistake = Mistake {
    id: "weights-exchanged",
    meaning: "two joints have each other's weights",
    section: SSD,
    look_at: "where the .attach file is read: column c has the weights of joint c + 1, in the order of the .skel file",
    readings: &[],
};

/// A mistake in the weights of one joint, which is found joint by joint, or of the last one beside another mistake.
pub(super) static JOINT_LEFT_OUT: Mistake = Mistake {
    id: "joint-left-out",
    meaning: "the weights of one joint are left out",
    section: SSD,
    look_at: "updateMeshVertices and where the .attach file is read: the loops over the joints, from the first to the last",
    readings: &[reading("the last one", |formula| {
        formula.weights.columns = Columns::WithoutLast;
    })],
};

/// A mistake in the weighted sum, for which the mesh is looked at from vertex to vertex, and in grading from test to test.
pub static SUM_NOT_RESET: Mistake = Mistake {
    id: "sum-not-reset",
    meaning: "the sum is not set to 0 first, so that it goes on from what it was",
    section: SSD,
    look_at: "updateMeshVertices: the sum is set to 0 inside of the loop over the vertices, each time that it runs",
    readings: &[
        reading("from what the mesh at rest was skinned to", |formula| {
            formula.begun = Begun::Summed
        }),
        reading(
            "from the mesh at rest and what that was skinned to",
            |formula| formula.begun = Begun::AtRestAndSummed,
        ),
    ],
};

/// A mistake that gives the same mesh as joints without offsets, whatever the pose: it is named with it.
pub(super) static VERTEX_WITHOUT_W: Mistake = Mistake {
    id: "vertex-without-w",
    meaning: "the fourth coordinate of vertices is 0, so that no offset moves them",
    section: SSD,
    look_at: "updateMeshVertices: a vertex is a point, the fourth coordinate of which is 1",
    readings: &[
        reading("in T and in B", |formula| {
            formula.joint.offsets = Offsets::None;
            formula.joint.bind_offsets = Offsets::None;
        }),
        reading("in T alone, after the inverse of B", |formula| {
            formula.joint.offsets = Offsets::None;
        }),
    ],
};

/// A mistake in when B is made, which grading finds in the poses of other tests.
pub static BIND_OF_OTHER_POSE: Mistake = Mistake {
    id: "bind-of-other-pose",
    meaning: "B is made in another pose than the bind pose",
    section: SSD,
    look_at: "computeBindWorldToJointTransforms: it runs once, before any joint is turned",
    readings: &[],
};

/// A mistake in what is left of other poses, which grading finds in those of other tests.
pub static ANGLES_KEPT: Mistake = Mistake {
    id: "angles-kept",
    meaning: "angles of an earlier pose are still there",
    section: SLIDERS,
    look_at: "setJointTransform: it sets the joint's rotation anew (=), and for joints that are not turned as well",
    readings: &[],
};

/// A mistake in what is done first, which grading finds in the results of all tests.
pub static POSE_LATE: Mistake = Mistake {
    id: "pose-late",
    meaning: "the mesh is that of the pose before",
    section: SLIDERS,
    look_at: "the order in which things are done: once the angles are set updateCurrentJointToWorldTransforms and then \
              updateMeshVertices run, and the mesh is written or drawn only after that",
    readings: &[],
};

/// A mistake in how weights are read, which changes all rows.
pub(super) static WEIGHT_ROWS_DRIFT: Mistake = Mistake {
    id: "weight-rows-drift",
    meaning: "rows of weights are read with one number too many or too few, so that they drift from vertex to vertex",
    section: SSD,
    look_at: "where the .attach file is read: a row has a number for each joint but the root",
    readings: &[],
};

/// A mistake in the pose, which is found joint by joint. It is named beside another one; a mesh with it alone is right in
/// another pose.
pub static JOINT_NOT_TURNED: Mistake = Mistake {
    id: "joint-not-turned",
    meaning: "one joint is not turned",
    section: SLIDERS,
    look_at: "whether the angles of this joint reach setJointTransform, in the loop over the joints and where the pose is \
              read",
    readings: &[],
};

/// A mistake in where all of a mesh is, which nothing but the mesh itself shows. It is named beside another one; a mesh
/// with it alone is nearly right.
pub(super) static MOVED_AS_A_WHOLE: Mistake = Mistake {
    id: super::MOVED_AS_A_WHOLE,
    meaning: "the mesh is moved, scaled or given other axes as a whole",
    section: SSD,
    look_at: LOOK_AT_PLACE,
    readings: &[],
};

/// A mistake in how a picture is written, which its silhouette shows.
pub(super) static PICTURE_TURNED: Mistake = Mistake {
    id: super::PICTURE_TURNED,
    meaning: "the picture is upside down or mirrored",
    section: SSD,
    look_at: "where the picture is written: glReadPixels begins with the lowest row, and picture files with the highest; \
              columns go from left to right in both",
    readings: &[],
};

/// π as programs often have it.
#[expect(clippy::approx_constant, reason = "it is meant to be coarse")]
const COARSE_PI: f64 = 3.14;

/// A mistake in the units of the angles, whose factor is worked out from the mesh; beside another mistake it is one that
/// programs often have.
pub(super) static ANGLES_SCALED: Mistake = Mistake {
    id: "angles-scaled",
    meaning: "all angles are too large or too small by the same factor",
    section: SLIDERS,
    look_at: "setJointTransform: the conversion of degrees to radians, the digits of its π, and the half of the angle if \
              it makes a quaternion",
    readings: &[
        reading("by a π of 3.14", |formula| {
            scale_angles(formula, COARSE_PI)
        }),
        reading("by a π of 22/7", |formula| {
            scale_angles(formula, 22.0 / 7.0)
        }),
        reading("each is 2 times as large", |formula| {
            scale_angles(formula, 2.0 * PI)
        }),
        reading("each is 0.5 times as large", |formula| {
            scale_angles(formula, 0.5 * PI)
        }),
    ],
};

/// Converts degrees to radians with another π.
fn scale_angles(formula: &mut Formula, pi: f64) {
    for factor in &mut formula.joint.angles {
        *factor *= pi / PI;
    }
}

/// All of them.
pub(super) static FOUND_OTHERWISE: [&Mistake; 20] = [
    &TRIANGLES_TURNED,
    &TRIANGLES_DIFFER,
    &VERTEX_TOO_MANY,
    &VERTEX_MISSING,
    &VERTICES_NOT_REACHED,
    &VERTICES_WITHOUT_WEIGHTS,
    &ONE_WRONG_PARENT,
    &ONE_WRONG_OFFSET,
    &WEIGHTS_EXCHANGED,
    &JOINT_LEFT_OUT,
    &SUM_NOT_RESET,
    &ANGLES_SCALED,
    &WEIGHT_ROWS_DRIFT,
    &VERTEX_WITHOUT_W,
    &BIND_OF_OTHER_POSE,
    &ANGLES_KEPT,
    &POSE_LATE,
    &JOINT_NOT_TURNED,
    &MOVED_AS_A_WHOLE,
    &PICTURE_TURNED,
];
