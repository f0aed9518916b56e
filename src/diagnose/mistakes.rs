//! The mistakes that are known, as one table.

use super::formula::{
    AngleUnits, AtEnd, Chain, Columns, Factors, JointOrder, JointsBy, Kept, Offsets, Rescaled,
    Rotations, Rows, VertexOrder,
};
use super::mistake::{
    EVERY_JOINT_COUNTS, MESH, Mistake, POSE_NOT_APPLIED, SKELETON, SLIDERS, SSD, rare_reading,
    reading,
};
use super::of_product::{
    BIND_NOT_INVERTED, FACTORS_SWAPPED, INVERSE_BIND_ONLY, MATRIX_TRANSPOSED, NO_INVERSE_BIND,
};

/// A mistake that is made in one way.
macro_rules! one_way {
    ($id:literal, $section:ident, $meaning:expr, $look_at:expr, $make:expr) => {
        Mistake {
            id: $id,
            meaning: $meaning,
            section: $section,
            look_at: $look_at,
            readings: &[reading("", $make)],
        }
    };
}

macro_rules! euler {
    ($id:literal, $product:literal, $order:expr) => {
        one_way!(
            $id,
            SLIDERS,
            concat!("the rotation is ", $product, " instead of Rx · Ry · Rz"),
            "setJointTransform: the order in which the three rotations are multiplied",
            |formula| formula.joint.order = $order
        )
    };
}

macro_rules! in_other_units {
    ($id:literal, $units:ident, $meaning:literal, $look_at:literal) => {
        Mistake {
            id: $id,
            meaning: $meaning,
            section: SLIDERS,
            look_at: $look_at,
            // Programs seldom have it about one axis alone, where degrees taken for radians hardly turn at all.
            readings: &[
                reading("", |formula| formula.joint.units = [AngleUnits::$units; 3]),
                rare_reading("about x alone", |formula| {
                    formula.joint.units[0] = AngleUnits::$units
                }),
                rare_reading("about y alone", |formula| {
                    formula.joint.units[1] = AngleUnits::$units
                }),
                rare_reading("about z alone", |formula| {
                    formula.joint.units[2] = AngleUnits::$units
                }),
            ],
        }
    };
}

macro_rules! axis_ignored {
    ($id:literal, $axis:literal, $index:literal) => {
        one_way!(
            $id,
            SLIDERS,
            concat!("the angle about ", $axis, " is not used"),
            "setJointTransform: whether all three angles are passed on and multiplied",
            |formula| formula.joint.angles[$index] *= 0.0
        )
    };
}

macro_rules! sign_flipped {
    ($id:literal, $axis:literal, $index:literal) => {
        one_way!(
            $id,
            SLIDERS,
            concat!("joints turn the other way about ", $axis),
            "setJointTransform: the signs of the sines in the rotation, and of the angles",
            |formula| formula.joint.angles[$index] *= -1.0
        )
    };
}

/// Every mistake that is known, the most telling first: where several give the same mesh, they are
/// named in this order.
pub static MISTAKES: &[Mistake] = &[
    Mistake {
        id: "weights-shifted",
        meaning: "column c of the weights is taken for joint c instead of joint c + 1",
        section: SSD,
        look_at: "where the .attach file is read: it has no column for the root, so the first column \
                  belongs to joint 1",
        readings: &[
            reading("the first one for the root", |formula| {
                formula.weights.columns = Columns::Before(AtEnd::OfAll);
            }),
            reading("the first one not at all", |formula| {
                formula.weights.columns = Columns::Before(AtEnd::Lost);
            }),
            reading("the first one for itself", |formula| {
                formula.weights.columns = Columns::Before(AtEnd::Same);
            }),
            // Of two joints that is each other's weights.
            rare_reading("the first one for the last joint", |formula| {
                formula.weights.columns = Columns::Before(AtEnd::OtherColumn);
            }),
        ],
    },
    Mistake {
        id: "weights-shifted-on",
        meaning: "column c of the weights is taken for joint c + 2 instead of joint c + 1",
        section: SSD,
        look_at: "where the .attach file is read and weights are summed: the root's missing column is to be made up \
                  for in one of the two, not in both",
        readings: &[
            reading("the last one for none", |formula| {
                formula.weights.columns = Columns::After(AtEnd::OfAll);
            }),
            reading("the last one for itself", |formula| {
                formula.weights.columns = Columns::After(AtEnd::Same);
            }),
            // Of two joints that is each other's weights.
            rare_reading("the last one for the joint that has the first", |formula| {
                formula.weights.columns = Columns::After(AtEnd::OtherColumn);
            }),
            rare_reading("the last one for the root", |formula| {
                formula.weights.columns = Columns::After(AtEnd::OtherEnd);
            }),
        ],
    },
    Mistake {
        id: "weight-rows-shifted",
        meaning: "vertices have the weights of their neighbors in the file",
        section: SSD,
        look_at: "where the .attach file is read: row i belongs to the i-th v line, so no row may be read \
                  and dropped, or put in before the first",
        readings: &[
            reading("of the vertex after them", |formula| {
                formula.weights.rows = Rows::After;
            }),
            reading("of the vertex before them", |formula| {
                formula.weights.rows = Rows::Before;
            }),
        ],
    },
    NO_INVERSE_BIND,
    INVERSE_BIND_ONLY,
    BIND_NOT_INVERTED,
    FACTORS_SWAPPED,
    MATRIX_TRANSPOSED,
    Mistake {
        id: "parent-missing",
        meaning: "a joint's transform is its own alone, without those of its parents",
        section: SKELETON,
        look_at: "the recursion over the joints: what is pushed on the matrix stack, and whether its \
                  top is what the joint gets",
        readings: &[
            reading("in T and in B", |formula| {
                formula.chain = Chain::Own;
                formula.bind_chain = Chain::Own;
            }),
            reading("in T", |formula| formula.chain = Chain::Own),
        ],
    },
    one_way!(
        "bind-parent-missing",
        SSD,
        "B of a joint is its own alone, without those of its parents",
        "computeBindWorldToJointTransforms: it goes down the joints with a stack, as T does",
        |formula| formula.bind_chain = Chain::Own
    ),
    one_way!(
        "parent-order",
        SKELETON,
        "a joint's transform is own · parent instead of parent · own",
        "MatrixStack::push: the new matrix belongs on the right of the top",
        |formula| {
            formula.chain = Chain::OwnParent;
            formula.bind_chain = Chain::OwnParent;
        }
    ),
    // Before all that is about angles: of what looks like the bind pose the simplest is that nothing was done, though
    // angles that are tiny, or of which some are not used, may give the same.
    Mistake {
        id: POSE_NOT_APPLIED,
        meaning: "the mesh is in the bind pose",
        section: SLIDERS,
        look_at: "whether angles reach setJointTransform, whether the recursion comes to the joints below the root, and \
                  whether updateCurrentJointToWorldTransforms and updateMeshVertices run after it, but not \
                  computeBindWorldToJointTransforms, which would make B of the pose",
        readings: &[
            reading("as the formula gives it", |formula| {
                formula.joint.has_pose = false
            }),
            reading("as the file has it", |formula| {
                formula.factors = Factors::Nothing
            }),
        ],
    },
    // Reversed as a whole first: of orders that give the same that is the one which programs have most often.
    euler!("euler-zyx", "Rz · Ry · Rx", [2, 1, 0]),
    euler!("euler-xzy", "Rx · Rz · Ry", [0, 2, 1]),
    euler!("euler-yxz", "Ry · Rx · Rz", [1, 0, 2]),
    euler!("euler-yzx", "Ry · Rz · Rx", [1, 2, 0]),
    euler!("euler-zxy", "Rz · Rx · Ry", [2, 0, 1]),
    in_other_units!(
        "degrees-as-radians",
        Degrees,
        "angles in degrees are used as if they were radians",
        "setJointTransform: what the functions that make rotations expect"
    ),
    in_other_units!(
        "radians-as-degrees",
        ConvertedTwice,
        "angles in radians are converted once more, as if they were degrees",
        "setJointTransform: whether angles are converted twice, there and where they come from"
    ),
    one_way!(
        "rotation-transposed",
        SLIDERS,
        "rotations are transposed, so that joints turn the other way",
        "setJointTransform: rows and columns of the rotation, of which a constructor may want the columns",
        |formula| formula.joint.rotations = Rotations::Transposed
    ),
    one_way!(
        "angles-negated",
        SLIDERS,
        "the sign of all three angles is wrong, so that joints turn the other way about each axis",
        "setJointTransform: the sign of the angles, and the signs of the sines in the rotations",
        |formula| formula.joint.angles = formula.joint.angles.map(|factor| -factor)
    ),
    one_way!(
        "rotation-before-translation",
        SLIDERS,
        "a joint's transform is R · T instead of T · R, so that its offset turns with it",
        "setJointTransform: the offset comes last to a vertex and so stands on the left",
        |formula| formula.joint.rotates_first = true
    ),
    Mistake {
        id: "translation-missing",
        meaning: "joints have no offset from their parents",
        section: SKELETON,
        look_at: "setJointTransform and where the .skel file is read: the fourth column of a joint's \
                  transform must stay its offset",
        readings: &[
            reading("in T and in B", |formula| {
                formula.joint.offsets = Offsets::None;
                formula.joint.bind_offsets = Offsets::None;
            }),
            reading("in T", |formula| formula.joint.offsets = Offsets::None),
            reading("in T and in B, but roots have theirs", |formula| {
                formula.joint.offsets = Offsets::OfRoots;
                formula.joint.bind_offsets = Offsets::OfRoots;
            }),
            reading("in T, but roots have theirs", |formula| {
                formula.joint.offsets = Offsets::OfRoots;
            }),
        ],
    },
    Mistake {
        id: "influences-cut-4",
        meaning: "only four weights of a vertex are used",
        section: SSD,
        look_at: EVERY_JOINT_COUNTS,
        readings: &[
            reading("the largest", |formula| {
                formula.weights.kept = Kept::Largest(4)
            }),
            reading("the first", |formula| formula.weights.kept = Kept::First(4)),
        ],
    },
    Mistake {
        id: "influences-cut-4-renormalized",
        meaning: "only four weights of a vertex are used, and made larger for those left out",
        section: SSD,
        look_at: EVERY_JOINT_COUNTS,
        readings: &[
            reading("the largest, divided by their sum", |formula| {
                formula.weights.kept = Kept::Largest(4);
                formula.weights.rescaled = Rescaled::ToOne;
            }),
            reading("the largest, where there are more", |formula| {
                formula.weights.kept = Kept::Largest(4);
                formula.weights.rescaled = Rescaled::ToOneWhereCut;
            }),
            reading("the largest, to sum to what all did", |formula| {
                formula.weights.kept = Kept::Largest(4);
                formula.weights.rescaled = Rescaled::ToSumOfAll;
            }),
            reading("the first, divided by their sum", |formula| {
                formula.weights.kept = Kept::First(4);
                formula.weights.rescaled = Rescaled::ToOne;
            }),
        ],
    },
    Mistake {
        id: "weights-normalized",
        meaning: "the weights of a vertex are made to sum to 1",
        section: SSD,
        look_at: "where weights are read or summed: they count as they are in the .attach file",
        readings: &[
            reading("they are divided by their sum", |formula| {
                formula.weights.is_normalized = true
            }),
            reading("the root is given what they lack", |formula| {
                formula.weights.is_completed = true
            }),
            // The same unless another mistake leaves out a joint.
            reading(
                "they are divided by the sum of those that are used",
                |formula| formula.weights.rescaled = Rescaled::ToOneOfUsed,
            ),
        ],
    },
    one_way!(
        "weights-doubled",
        SSD,
        "every weight counts twice, so that the mesh is twice as large",
        "updateMeshVertices: whether each joint is added once, and all of the sum is begun anew for each \
         vertex; then what is written",
        |formula| formula.weights.factor *= 2.0
    ),
    Mistake {
        id: "strongest-joint-only",
        meaning: "a vertex goes with the joint of its largest weight alone",
        section: SSD,
        look_at: "updateMeshVertices: the sum over all joints with a weight",
        readings: &[
            reading("as if it weighed 1", |formula| {
                formula.weights.kept = Kept::Largest(1);
                formula.weights.rescaled = Rescaled::ToOne;
            }),
            reading("with its weight", |formula| {
                formula.weights.kept = Kept::Largest(1)
            }),
        ],
    },
    Mistake {
        id: "vertices-renumbered",
        meaning: "vertices are not in the order of the .obj file",
        section: MESH,
        look_at: "what reads the .obj file: importers number vertices anew, and row i of the .attach \
                  file belongs to the i-th v line",
        readings: &[
            reading(
                "in the order in which faces use them, with the weights of other vertices",
                |formula| formula.vertex_order = VertexOrder::FirstUseOfPositions,
            ),
            reading("in the order in which faces use them", |formula| {
                formula.vertex_order = VertexOrder::FirstUse;
            }),
            reading(
                "while they are skinned, so that they have the weights of other vertices",
                |formula| formula.vertex_order = VertexOrder::FirstUseInside,
            ),
            reading("repeated for each corner of each face", |formula| {
                formula.vertex_order = VertexOrder::Corners;
            }),
        ],
    },
    Mistake {
        id: "joints-by-depth",
        meaning: "joints are numbered in the order of the tree instead of the file's",
        section: SKELETON,
        look_at: "where joints are put into the list that indices refer to: line i of the .skel file \
                  is joint i",
        readings: &[
            reading("depth first, for weights and angles", |formula| {
                formula.joint_order = by(JointsBy::Depth, true);
            }),
            reading("depth first, for weights", |formula| {
                formula.joint_order = by(JointsBy::Depth, false);
            }),
            reading("level by level, for weights and angles", |formula| {
                formula.joint_order = by(JointsBy::Level, true);
            }),
            reading("level by level, for weights", |formula| {
                formula.joint_order = by(JointsBy::Level, false);
            }),
            reading(
                "by the number of joints above, for weights and angles",
                |formula| {
                    formula.joint_order = by(JointsBy::Height, true);
                },
            ),
            reading("by the number of joints above, for weights", |formula| {
                formula.joint_order = by(JointsBy::Height, false);
            }),
        ],
    },
    axis_ignored!("one-axis-ignored-x", "x", 0),
    axis_ignored!("one-axis-ignored-y", "y", 1),
    axis_ignored!("one-axis-ignored-z", "z", 2),
    sign_flipped!("sign-flipped-x", "x", 0),
    sign_flipped!("sign-flipped-y", "y", 1),
    sign_flipped!("sign-flipped-z", "z", 2),
    Mistake {
        id: super::MESH_MIRRORED,
        meaning: "the mesh is mirrored",
        section: SSD,
        look_at: "where vertices are read and written: the signs of their coordinates",
        readings: &[
            reading("along x", |formula| formula.written[0] *= -1.0),
            reading("along y", |formula| formula.written[1] *= -1.0),
            reading("along z", |formula| formula.written[2] *= -1.0),
        ],
    },
];

const fn by(by: JointsBy, has_angles: bool) -> JointOrder {
    JointOrder { by, has_angles }
}
