//! Mistakes of a whole program in the weighted sum: in what is summed, and in the weights.

use super::formula::{Begun, Columns, Factors, Halves, Kept, Rescaled, Rounded};
use super::mistake::{EVERY_JOINT_COUNTS, Mistake, SSD, reading};

/// A mistake in the weighted sum.
pub(super) static SUM_BEGUN_AT_REST: Mistake = Mistake {
    id: "sum-begun-at-rest",
    meaning: "the sum for each vertex begins with its place at rest instead of 0",
    section: SSD,
    look_at: "updateMeshVertices: the vertex is set to 0 before what the joints give is added",
    readings: &[reading("", |formula| formula.begun = Begun::AtRest)],
};

/// A mistake in the weighted sum.
pub(super) static SUM_OVERWRITTEN: Mistake = Mistake {
    id: "sum-overwritten",
    meaning: "what one joint gives overwrites what those before it gave, so that there is no sum",
    section: SSD,
    look_at: "updateMeshVertices: what each joint gives is added (+=), not assigned (=)",
    readings: &[
        reading("the last one with a weight counts", |formula| {
            formula.weights.is_overwritten = true;
        }),
        reading(
            "the last one with a weight counts, as if it weighed 1",
            |formula| {
                formula.weights.rescaled = Rescaled::ToOnes;
                formula.weights.is_overwritten = true;
            },
        ),
        reading(
            "the last one of all counts, whatever its weight",
            |formula| {
                formula.weights.columns = Columns::LastAlone;
            },
        ),
    ],
};

/// A mistake in what is skinned, of which grading also knows the results of other tests.
pub static LAST_RESULT_SKINNED: Mistake = Mistake {
    id: "last-result-skinned",
    meaning: "the last result is skinned instead of the mesh at rest",
    section: SSD,
    look_at: "updateMeshVertices: it reads bindVertices and writes currentVertices, never the other way round",
    readings: &[reading("that of the same pose", |formula| {
        formula.moves_twice = true;
    })],
};

/// A mistake in what is inverted.
pub(super) static WRONG_INVERSE: Mistake = Mistake {
    id: "wrong-inverse",
    meaning: "T is inverted instead of B",
    section: SSD,
    look_at: "whether both are what their names say: currentJointToWorldTransform is T, bindWorldToJointTransform is the \
              inverse of B",
    readings: &[
        reading("the inverse of T on the left of B", |formula| {
            formula.factors = Factors::InverseOfCurrent
        }),
        reading("the inverse of T on the right of B", |formula| {
            formula.factors = Factors::InverseOfCurrentFirst;
        }),
    ],
};

/// A mistake in which weights are used, of which programs make that with four most often: see `influences-cut-4`.
pub(super) static INFLUENCES_CUT_FEWER: Mistake = Mistake {
    id: "influences-cut-fewer",
    meaning: "fewer than four weights of a vertex are used",
    section: SSD,
    look_at: EVERY_JOINT_COUNTS,
    readings: &[
        reading("the two largest", |formula| {
            formula.weights.kept = Kept::Largest(2);
        }),
        reading("the two largest, divided by their sum", |formula| {
            formula.weights.kept = Kept::Largest(2);
            formula.weights.rescaled = Rescaled::ToOne;
        }),
        reading("the three largest", |formula| {
            formula.weights.kept = Kept::Largest(3);
        }),
        reading("the three largest, divided by their sum", |formula| {
            formula.weights.kept = Kept::Largest(3);
            formula.weights.rescaled = Rescaled::ToOne;
        }),
        reading("the first", |formula| formula.weights.kept = Kept::First(1)),
        reading("the first, as if it weighed 1", |formula| {
            formula.weights.kept = Kept::First(1);
            formula.weights.rescaled = Rescaled::ToOne;
        }),
        reading(
            "that of the first joint of all, even if it is 0",
            |formula| {
                formula.weights.columns = Columns::FirstAlone;
            },
        ),
        reading("those before the first one that is 0", |formula| {
            formula.weights.kept = Kept::BeforeZero;
        }),
        reading("the first two", |formula| {
            formula.weights.kept = Kept::First(2)
        }),
        reading("the first three", |formula| {
            formula.weights.kept = Kept::First(3)
        }),
    ],
};

/// A mistake in which weights are used. From which on they are is worked out from the mesh; beside another mistake it is
/// one of the numbers that programs have most often.
pub(super) static SMALL_WEIGHTS_LEFT_OUT: Mistake = Mistake {
    id: "small-weights-left-out",
    meaning: "weights below a number are not used",
    section: SSD,
    look_at: "where weights are read or summed: small ones count as well, and only those of 0 may be skipped",
    readings: &[
        reading("those below 0.1", |formula| {
            formula.weights.kept = Kept::From(0.1)
        }),
        reading("those below 0.05", |formula| {
            formula.weights.kept = Kept::From(0.05)
        }),
        reading("those below 0.01", |formula| {
            formula.weights.kept = Kept::From(0.01)
        }),
        reading("those below 0.001", |formula| {
            formula.weights.kept = Kept::From(0.001)
        }),
    ],
};

/// A mistake in which weights are not used at all, but for which of them are 0.
pub(super) static WEIGHTS_IGNORED: Mistake = Mistake {
    id: "weights-ignored",
    meaning: "every joint with a weight counts alike, however large the weight is",
    section: SSD,
    look_at: "updateMeshVertices: what each joint gives is multiplied by its weight",
    readings: &[
        reading("the mean of what they give", |formula| {
            formula.weights.rescaled = Rescaled::ToMean;
        }),
        reading("the sum of what they give", |formula| {
            formula.weights.rescaled = Rescaled::ToOnes;
        }),
    ],
};

/// A mistake in the weighted sum.
pub(super) static SUM_DIVIDED: Mistake = Mistake {
    id: "sum-divided",
    meaning: "the weighted sum is divided by how many joints it is of",
    section: SSD,
    look_at: "updateMeshVertices: the weights make the sum a mean already, and nothing is left to divide",
    readings: &[reading("", |formula| {
        formula.weights.rescaled = Rescaled::ByCount;
    })],
};

/// A mistake in the type of weights.
pub(super) static WEIGHTS_ROUNDED: Mistake = Mistake {
    id: "weights-rounded",
    meaning: "weights are rounded",
    section: SSD,
    look_at: "where the .attach file is read: weights are float, and no int, up to the sum, and keep all their digits \
              where they are written on the way",
    readings: &[
        reading("down to whole numbers", |formula| {
            formula.weights.rounded = Rounded::Down;
        }),
        reading("to the nearest whole number", |formula| {
            formula.weights.rounded = Rounded::ToDigits(0, Halves::Up);
        }),
        reading("to one digit after the point", |formula| {
            formula.weights.rounded = Rounded::ToDigits(1, Halves::Up);
        }),
        reading("to two digits after the point", |formula| {
            formula.weights.rounded = Rounded::ToDigits(2, Halves::Up);
        }),
    ],
};
