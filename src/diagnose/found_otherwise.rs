//! Mistakes that are found otherwise than by making each in every way, and beside every other: in the faces of a mesh,
//! and those that are hardly made beside another one.

use super::mistakes::{MESH, Mistake, SKELETON, SLIDERS, SSD};

/// A mistake in the faces of a mesh, which no formula for its vertices gives. Grading counts it.
pub(super) static TRIANGLES_TURNED: Mistake = Mistake {
    id: "triangles-turned",
    meaning: "triangles wind the other way, so that normals point the other way",
    section: MESH,
    look_at: "where faces are read and written: the order of their three corners",
    readings: &[],
};

/// The same where triangles of the character are missing, whether or not there are others in their place.
pub(super) static TRIANGLES_DIFFER: Mistake = Mistake {
    id: "triangles-differ",
    meaning: "triangles of the model are missing, or others are in their place",
    section: MESH,
    look_at: "where faces are read and written: whether all of them are, each with the indices of its own three \
              vertices, which count from 1 in the file",
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

/// A mistake at roots alone, which other joints do not share.
pub(super) static ROOT_ROTATED_FIRST: Mistake = Mistake {
    id: "root-rotated-before-translation",
    meaning: "the transform of the root alone is R · T instead of T · R, so that its offset turns with it",
    section: SLIDERS,
    look_at: "where the root's transform is made or the figure is turned as a whole: the offset comes last to a vertex \
              and so stands on the left",
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

/// A mistake with the matrix stack.
pub(super) static STACK_NOT_POPPED: Mistake = Mistake {
    id: "stack-not-popped",
    meaning: "the matrix stack is not popped, so that each joint hangs on the one that was visited before it",
    section: SKELETON,
    look_at: "the end of the recursion over a joint's children: each push needs its pop",
    readings: &[],
};

/// A mistake in the weighted sum.
pub(super) static SUM_BEGUN_AT_REST: Mistake = Mistake {
    id: "sum-begun-at-rest",
    meaning: "the sum for each vertex begins with its place at rest instead of 0",
    section: SSD,
    look_at: "updateMeshVertices: the vertex is set to 0 before what the joints give is added",
    readings: &[],
};

/// A mistake in the weights of one joint, which is found joint by joint.
pub(super) static JOINT_LEFT_OUT: Mistake = Mistake {
    id: "joint-left-out",
    meaning: "the weights of one joint are left out",
    section: SSD,
    look_at: "updateMeshVertices: the loop over the joints, from the first to the last",
    readings: &[],
};

/// All of them.
pub(super) static FOUND_OTHERWISE: [&Mistake; 9] = [
    &TRIANGLES_TURNED,
    &TRIANGLES_DIFFER,
    &ONE_WRONG_PARENT,
    &ONE_WRONG_OFFSET,
    &ROOT_ROTATED_FIRST,
    &WEIGHTS_EXCHANGED,
    &STACK_NOT_POPPED,
    &SUM_BEGUN_AT_REST,
    &JOINT_LEFT_OUT,
];
