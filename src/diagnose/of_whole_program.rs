//! Mistakes of a whole program, which are made in few ways: they are tried by themselves before any two together, and
//! beside each of the others.

use super::formula::{AnglesOf, Chain, LeftOnStack, Offsets, Parents, Popped, Reached, Unfilled};
use super::mistake::{Mistake, SKELETON, SLIDERS, reading};
use super::of_angles::{
    ANGLE_REPEATED, ANGLES_EXCHANGED, ANGLES_ROUNDED, ANGLES_SHIFTED, CURRENT_ROTATION_TRANSPOSED,
    ONLY_ONE_AXIS, ONLY_ROOT_TURNED, QUATERNION_ORDER, ROOT_ANGLES_MISSING, ROTATION_REPEATED,
    SINE_COSINE_EXCHANGED,
};
use super::of_collada::{
    ANGLES_ABOUT_BONES, AXES_NOT_CONVERTED, BIND_SHAPE_MISSING, SKIN_LIST_IGNORED,
};
use super::of_product::INVERSE_BIND_SHARED;
use super::of_weighted_sum::{
    INFLUENCES_CUT_FEWER, LAST_RESULT_SKINNED, SMALL_WEIGHTS_LEFT_OUT, SUM_BEGUN_AT_REST,
    SUM_DIVIDED, SUM_OVERWRITTEN, WEIGHTS_IGNORED, WEIGHTS_ROUNDED, WRONG_INVERSE,
};

/// A mistake at roots alone, which other joints do not share.
static ROOT_ROTATED_FIRST: Mistake = Mistake {
    id: "root-rotated-before-translation",
    meaning: "the transform of the root alone is R · T instead of T · R, so that its offset turns with it",
    section: SLIDERS,
    look_at: "where the root's transform is made or the figure is turned as a whole: the offset comes last to a vertex \
              and so stands on the left",
    readings: &[reading("", |formula| {
        formula.joint.roots_rotate_first = true
    })],
};

/// A mistake in all parents that the skeleton's file has.
pub(super) static PARENTS_MISREAD: Mistake = Mistake {
    id: "parents-misread",
    meaning: "joints hang on other parents than the file says",
    section: SKELETON,
    look_at: "where the .skel file is read: the last number of a line is the index of the parent, from 0, and \
              -1 for a root",
    readings: &[
        reading("each on the joint of the line before", |formula| {
            formula.parents = Parents::LineBefore
        }),
        reading("all on the first joint", |formula| {
            formula.parents = Parents::First
        }),
        reading(
            "each on the one whose index is that of its parent less 1, those on the first on that",
            |formula| formula.parents = Parents::BeforeOwn,
        ),
        reading(
            "each on the one whose index is that of its parent less 1, those on the first on none",
            |formula| formula.parents = Parents::BeforeOwnOrNone,
        ),
    ],
};

/// A mistake in all offsets that it has.
static OFFSETS_MISREAD: Mistake = Mistake {
    id: "offsets-misread",
    meaning: "offsets of joints are taken for their places in the model, so that each joint is offset by the difference \
              from its parent's",
    section: SKELETON,
    look_at: "where the .skel file is read: the first three numbers of a line are the offset from the parent already, and \
              nothing is subtracted from them",
    readings: &[reading("", |formula| formula.offsets_are_places = true)],
};

/// What comes of a stack that no joint is popped from.
macro_rules! on_visited {
    ($where:literal) => {
        concat!(
            "each joint hangs on the one that was visited before it",
            $where
        )
    };
}

/// A mistake with the matrix stack.
static STACK_NOT_POPPED: Mistake = Mistake {
    id: "stack-not-popped",
    meaning: "the matrix stack is not popped",
    section: SKELETON,
    look_at: "the end of the recursion over a joint's children: each push needs its pop, that of the root as well",
    readings: &[
        reading(on_visited!(", in T and in B"), |formula| {
            formula.popped = [Popped::None; 2]
        }),
        reading(on_visited!(", in T"), |formula| {
            formula.popped = [Popped::None, Popped::All]
        }),
        reading(on_visited!(", in B"), |formula| {
            formula.popped = [Popped::All, Popped::None]
        }),
        reading(
            on_visited!(", and T goes on with what B has left on it"),
            |formula| {
                formula.popped = [Popped::None; 2];
                formula.left_on_stack = LeftOnStack::LastVisited(1);
            },
        ),
        reading(
            on_visited!(", and T goes on with what B and T at rest have left on it"),
            |formula| {
                formula.popped = [Popped::None; 2];
                formula.left_on_stack = LeftOnStack::LastVisited(2);
            },
        ),
        reading(
            on_visited!(", in T, which goes on with what T at rest has left on it"),
            |formula| {
                formula.popped = [Popped::None, Popped::All];
                formula.left_on_stack = LeftOnStack::LastVisited(1);
            },
        ),
        reading("after a joint without children, in T and in B", |formula| {
            formula.popped = [Popped::ButLeaves; 2];
        }),
        reading("after a joint without children, in T", |formula| {
            formula.popped = [Popped::ButLeaves, Popped::All];
        }),
        reading("after a joint with children, in T and in B", |formula| {
            formula.popped = [Popped::Leaves; 2];
        }),
        reading("after a joint with children, in T", |formula| {
            formula.popped = [Popped::Leaves, Popped::All];
        }),
        reading(
            "the root stays on it, so that T begins with B of the root",
            |formula| {
                formula.left_on_stack = LeftOnStack::Root;
            },
        ),
    ],
};

/// The ways not to come to joints, by what a program has for these.
macro_rules! reached {
    ($($to:literal = $reached:ident),+) => {
        &[$(
            reading(concat!($to, ", and the matrices of the others stay 0"), |formula| {
                formula.reached = Some((Reached::$reached, Unfilled::Zero));
            }),
            reading(concat!($to, ", and vertices of the others stay at rest"), |formula| {
                formula.reached = Some((Reached::$reached, Unfilled::IdentityInBoth));
            }),
            reading(concat!($to, ", and T of the others stays the identity"), |formula| {
                formula.reached = Some((Reached::$reached, Unfilled::Identity));
            }),
        )+]
    };
}

/// A mistake in the loop over the children of a joint.
static JOINTS_NOT_REACHED: Mistake = Mistake {
    id: "joints-not-reached",
    meaning: "the recursion over the joints does not come to all of them",
    section: SKELETON,
    look_at: "the recursion over the joints: it works out each joint's matrices, those of joints without children as well, \
              and its loop goes over all children, from the first to the last",
    readings: reached!(
        "only to the first child of each" = First,
        "only to the last child of each" = Last,
        "not to the first child of each" = ButFirst,
        "not to the last child of each" = ButLast,
        "not to those without children" = ButLeaves
    ),
};

/// A mistake in how the pose comes to joints.
static TRANSLATION_OVERWRITTEN: Mistake = Mistake {
    id: "translation-overwritten",
    meaning: "the rotation of a joint that the pose turns overwrites its offset",
    section: SLIDERS,
    look_at: "setJointTransform: the fourth column of a joint's transform must stay its offset",
    readings: &[reading("", |formula| {
        formula.joint.offsets = Offsets::OfUnposed;
    })],
};

/// Another one in that, as of `transform = transform * T * R`.
static OFFSET_REPEATED: Mistake = Mistake {
    id: "offset-repeated",
    meaning: "the offset of a joint from its parent is multiplied on twice",
    section: SLIDERS,
    look_at: "setJointTransform: it sets the rotation beside the offset that the joint has, instead of multiplying both onto \
              what is there",
    readings: &[
        reading("in T, of joints that the pose turns", |formula| {
            formula.joint.offsets = Offsets::TwiceOfPosed;
        }),
        reading("in T", |formula| formula.joint.offsets = Offsets::Twice),
        reading("in T and in B", |formula| {
            formula.joint.offsets = Offsets::Twice;
            formula.joint.bind_offsets = Offsets::Twice;
        }),
    ],
};

/// A mistake at roots alone, which moves the mesh as a whole.
static ROOT_TRANSLATION_MISSING: Mistake = Mistake {
    id: "root-translation-missing",
    meaning: "the root has no offset",
    section: SKELETON,
    look_at: "where the .skel file is read: the root's line has an offset as well; and the recursion over the joints, \
              which begins with the root's own transform, not with that of its children",
    readings: &[
        reading("in T and in B", |formula| {
            formula.joint.offsets = Offsets::ButOfRoots;
            formula.joint.bind_offsets = Offsets::ButOfRoots;
        }),
        reading("in T", |formula| {
            formula.joint.offsets = Offsets::ButOfRoots
        }),
    ],
};

/// Another one at roots alone.
static ROOT_TRANSFORM_MISSING: Mistake = Mistake {
    id: "root-transform-missing",
    meaning: "the root's transform, its offset and its rotation, is left out",
    section: SKELETON,
    look_at: "the recursion over the joints: it begins with the root itself, not with its children",
    readings: &[
        reading("in T and in B", |formula| {
            formula.joint.offsets = Offsets::ButOfRoots;
            formula.joint.bind_offsets = Offsets::ButOfRoots;
            formula.joint.angles_of = AnglesOf::ItselfButRoots;
        }),
        reading("in T", |formula| {
            formula.joint.offsets = Offsets::ButOfRoots;
            formula.joint.angles_of = AnglesOf::ItselfButRoots;
        }),
        reading("in B", |formula| {
            formula.joint.bind_offsets = Offsets::ButOfRoots
        }),
    ],
};

/// And another.
static ROOT_TRANSFORM_REPEATED: Mistake = Mistake {
    id: "root-transform-repeated",
    meaning: "the root's transform, its offset and its rotation, is multiplied on twice",
    section: SKELETON,
    look_at: "the recursion over the joints: the root is pushed where the recursion comes to it, and not before it begins, \
              too",
    readings: &[
        reading("in T and in B", |formula| formula.roots_twice = [true; 2]),
        reading("in T", |formula| formula.roots_twice = [true, false]),
        reading("in B", |formula| formula.roots_twice = [false, true]),
    ],
};

/// A mistake in what is kept of the recursion over the joints. In T and in B it gives the same as
/// [`ROTATION_OF_CHILDREN_ONLY`], since the joint's offset is in neither then.
static OWN_TRANSFORM_MISSING: Mistake = Mistake {
    id: "own-transform-missing",
    meaning: "what is kept for a joint is the transform of its parent, without its own",
    section: SKELETON,
    look_at: "updateCurrentJointToWorldTransforms: the joint's own transform is pushed before the top of the stack is kept",
    readings: &[
        reading("in T and in B", |formula| formula.keeps_parents = [true; 2]),
        reading("in T", |formula| formula.keeps_parents = [true, false]),
        reading("in B", |formula| formula.keeps_parents = [false, true]),
    ],
};

/// Another one in that.
static ROTATION_OF_CHILDREN_ONLY: Mistake = Mistake {
    id: "rotation-of-children-only",
    meaning: "the rotation of a joint turns its children but not itself",
    section: SLIDERS,
    look_at: "updateCurrentJointToWorldTransforms: what is kept for a joint has its own rotation, too; and \
              updateMeshVertices: a weight is that of the joint, and not of the one it hangs on",
    readings: &[reading("", |formula| {
        formula.joint.angles_of = AnglesOf::Parent;
        formula.joint.rotates_first = true;
    })],
};

/// A mistake in what the recursion over the joints hands down.
static ABOVE_PARENTS_MISSING: Mistake = Mistake {
    id: "above-parents-missing",
    meaning: "a joint's transform has that of its parent, but not of those above the parent",
    section: SKELETON,
    look_at: "the recursion over the joints: it hands down the product so far, and not the joint's own transform",
    readings: &[
        reading("in T and in B", |formula| {
            formula.chain = Chain::ParentsOwn;
            formula.bind_chain = Chain::ParentsOwn;
        }),
        reading("in T", |formula| formula.chain = Chain::ParentsOwn),
    ],
};

/// Another one in that.
static PARENTS_ROTATIONS_MISSING: Mistake = Mistake {
    id: "parents-rotations-missing",
    meaning: "a joint follows the offsets of those above it, but not their rotations",
    section: SKELETON,
    look_at: "the recursion over the joints: what is pushed on the matrix stack has the joint's rotation, too",
    readings: &[
        reading("neither in its place nor in its rotation", |formula| {
            formula.chain = Chain::WithoutRotations
        }),
        reading(
            "in its rotation, while the parent's own turns its place",
            |formula| formula.chain = Chain::OwnRotation,
        ),
        reading(
            "in its rotation, while all of them turn its place",
            |formula| {
                formula.chain = Chain::OwnRotationInPlace;
            },
        ),
        reading(
            "nor what the pose moves the root by, as if those above it were at rest",
            |formula| formula.chain = Chain::ParentAtRest,
        ),
    ],
};

/// One in what is moved by turns about places, without a transform for each joint.
static TURNS_ORDER: Mistake = Mistake {
    id: "turns-order",
    meaning: "what turns a joint about its place at rest is multiplied as own · parent instead of parent · own, so that the \
              turns of those above it come first",
    section: SKELETON,
    look_at: "where turns about places at rest are multiplied, or come to a vertex one after the other: a joint's own comes \
              first to a vertex, and the root's last",
    readings: &[reading("", |formula| formula.chain = Chain::TurnsOwnParent)],
};

/// One in how rotations are combined, such as quaternions, where places are not.
static PARENT_ROTATION_ORDER: Mistake = Mistake {
    id: "parent-rotation-order",
    meaning: "a joint's rotation is own · parent instead of parent · own, while its place is right",
    section: SKELETON,
    look_at: "where a joint's rotation is combined with its parent's, such as two quaternions: the parent's stands on the \
              left",
    readings: &[reading("", |formula| {
        formula.chain = Chain::OwnParentRotation
    })],
};

/// One in where joints are.
static OFFSET_NOT_TURNED: Mistake = Mistake {
    id: "offset-not-turned",
    meaning: "the offset of a joint from its parent does not turn with the parent",
    section: SKELETON,
    look_at: "where a joint's place follows from its parent's: the parent's rotation turns the offset before it is added",
    readings: &[reading("", |formula| {
        formula.chain = Chain::OffsetsNotTurned
    })],
};

/// A mistake at roots alone, of poses that move them.
static ROOT_NOT_MOVED: Mistake = Mistake {
    id: "root-not-moved",
    meaning: "a root is not moved by the offset that the pose has for it",
    section: SLIDERS,
    look_at: "where the pose comes to a root's transform: it has the file's offset and what the pose moves the root by",
    readings: &[reading("", |formula| formula.joint.roots_are_moved = false)],
};

/// All of them, in the order in which they are named where they give the same.
pub(super) static OF_WHOLE_PROGRAM: [&Mistake; 43] = [
    &BIND_SHAPE_MISSING,
    &AXES_NOT_CONVERTED,
    &ANGLES_ABOUT_BONES,
    &SKIN_LIST_IGNORED,
    &ROOT_ROTATED_FIRST,
    &ROOT_ANGLES_MISSING,
    &ONLY_ROOT_TURNED,
    &ROOT_NOT_MOVED,
    &STACK_NOT_POPPED,
    &JOINTS_NOT_REACHED,
    &PARENTS_MISREAD,
    &OFFSETS_MISREAD,
    &TRANSLATION_OVERWRITTEN,
    &OFFSET_REPEATED,
    &ROOT_TRANSLATION_MISSING,
    &ROOT_TRANSFORM_MISSING,
    &ROOT_TRANSFORM_REPEATED,
    &SUM_BEGUN_AT_REST,
    &SUM_OVERWRITTEN,
    &LAST_RESULT_SKINNED,
    &ANGLES_ROUNDED,
    &ANGLES_EXCHANGED,
    &ANGLES_SHIFTED,
    &OWN_TRANSFORM_MISSING,
    &ROTATION_OF_CHILDREN_ONLY,
    &INFLUENCES_CUT_FEWER,
    &WEIGHTS_IGNORED,
    &SUM_DIVIDED,
    &WEIGHTS_ROUNDED,
    &SMALL_WEIGHTS_LEFT_OUT,
    &ABOVE_PARENTS_MISSING,
    &PARENTS_ROTATIONS_MISSING,
    &PARENT_ROTATION_ORDER,
    &OFFSET_NOT_TURNED,
    &TURNS_ORDER,
    &WRONG_INVERSE,
    &INVERSE_BIND_SHARED,
    &ROTATION_REPEATED,
    &CURRENT_ROTATION_TRANSPOSED,
    &QUATERNION_ORDER,
    &SINE_COSINE_EXCHANGED,
    &ONLY_ONE_AXIS,
    &ANGLE_REPEATED,
];
