//! Mistakes in the product of T and the inverse of B, which moves a vertex with a joint.

use super::formula::{Chain, Divided, Factors, Shaped};
use super::mistake::{Mistake, SSD, rare_reading, reading};

/// A way to make a mistake: the parts of the formula that are other ones.
macro_rules! way {
    ($how:expr, $($part:ident = $other:expr),+) => {
        way!(reading, $how, $($part = $other),+)
    };
    ($reading:ident, $how:expr, $($part:ident = $other:expr),+) => {
        $reading($how, |formula| {
            $(formula.$part = $other;)+
        })
    };
}

/// A factor that is left out.
pub(super) const NO_INVERSE_BIND: Mistake = Mistake {
    id: "no-inverse-bind",
    meaning: "vertices are moved by T alone, without the inverse of B",
    section: SSD,
    look_at: "updateMeshVertices: whether bindWorldToJointTransform is multiplied at all, and is filled",
    readings: &[
        way!("", factors = Factors::NoInverseBind),
        way!(
            "in the frames of a Collada file",
            factors = Factors::NoInverseBindOfFile
        ),
    ],
};

/// The other one.
pub(super) const INVERSE_BIND_ONLY: Mistake = Mistake {
    id: "inverse-bind-only",
    meaning: "vertices are moved by the inverse of B alone, without T",
    section: SSD,
    look_at: "updateMeshVertices: whether currentJointToWorldTransform is multiplied at all, and is filled",
    readings: &[way!("", factors = Factors::InverseBindOnly)],
};

/// A mistake with the inverse of B, which a vertex has to be multiplied by for each of its joints.
pub(super) static INVERSE_BIND_SHARED: Mistake = Mistake {
    id: "inverse-bind-shared",
    meaning: "the inverse of B of a vertex's first joint is used for all of its joints",
    section: SSD,
    look_at: "updateMeshVertices: T and the inverse of B are those of the same joint, and both change from one joint of the \
              sum to the next",
    readings: &[way!("", factors = Factors::InverseBindOfFirst)],
};

/// B for its inverse.
pub(super) const BIND_NOT_INVERTED: Mistake = Mistake {
    id: "bind-not-inverted",
    meaning: "vertices are moved by T and B, which is not inverted",
    section: SSD,
    look_at: "computeBindWorldToJointTransforms: it must keep the inverse",
    readings: &[
        way!("by T · B", factors = Factors::BindNotInverted),
        way!(
            "by T and the transpose of B, as if B only turned",
            factors = Factors::BindTransposed
        ),
        way!(
            "by B · T, the wrong way round as well",
            factors = Factors::BindNotInvertedFirst
        ),
    ],
};

/// The wrong order.
pub(super) const FACTORS_SWAPPED: Mistake = Mistake {
    id: "factors-swapped",
    meaning: "the inverse of B and T are multiplied the wrong way round",
    section: SSD,
    look_at: "updateMeshVertices: the order of T and the inverse of B, of which the latter comes first to the vertex \
              and so stands on the right",
    readings: &[
        way!("", factors = Factors::Swapped),
        way!(
            "with those of a Collada file, whose axes are converted last",
            factors = Factors::SwappedInFile
        ),
        way!(
            "with those of a Collada file, whose axes are converted in T",
            factors = Factors::SwappedWithFile
        ),
    ],
};

/// Rows that are taken for columns.
pub(super) const MATRIX_TRANSPOSED: Mistake = Mistake {
    id: "matrix-transposed",
    meaning: "rows and columns of what moves a vertex are exchanged",
    section: SSD,
    look_at: "updateMeshVertices: the vertex is a column on the right of the matrix; and wherever a matrix is filled, \
              whether that goes by rows or by columns",
    readings: &[
        way!(
            "of T and the inverse of B together, as by v · M",
            factors = Factors::Transposed
        ),
        way!(
            "of both, and the sum is divided by its fourth coordinate",
            factors = Factors::Transposed,
            divided = Divided::Sum
        ),
        way!(
            "of both, and what each joint gives is divided by its fourth coordinate",
            factors = Factors::Transposed,
            divided = Divided::Each
        ),
        way!("of T", factors = Factors::CurrentTransposed),
        way!(
            "of the inverse of B",
            factors = Factors::InverseBindTransposed
        ),
        way!(
            "of the inverse of B in a Collada file",
            factors = Factors::InverseBindOfFileTransposed
        ),
        way!(
            "of the inverse of B in a Collada file, and the sum is divided by its fourth coordinate",
            factors = Factors::InverseBindOfFileTransposed,
            divided = Divided::Sum
        ),
        way!(
            "of both with the inverse of B in a Collada file",
            factors = Factors::TransposedInFile
        ),
        way!(
            "of both with the inverse of B in a Collada file, and the sum is divided by its fourth coordinate",
            factors = Factors::TransposedInFile,
            divided = Divided::Sum
        ),
        way!(
            rare_reading,
            "of the skin's own matrix in a Collada file",
            shaped = Shaped::Transposed
        ),
        way!(
            rare_reading,
            "of the skin's own matrix in a Collada file, after which the fourth coordinate is 1 again",
            shaped = Shaped::TransposedAsPoints
        ),
        way!(
            rare_reading,
            "of the skin's own matrix, after which the fourth coordinate is 1 again, and of the inverse of B in a \
             Collada file",
            shaped = Shaped::TransposedAsPoints,
            factors = Factors::InverseBindOfFileTransposed
        ),
        way!(
            rare_reading,
            "of the skin's own matrix and of the inverse of B in a Collada file",
            shaped = Shaped::Transposed,
            factors = Factors::InverseBindOfFileTransposed
        ),
        way!(
            rare_reading,
            "of the skin's own matrix and of the inverse of B in a Collada file, and the sum is divided by its fourth \
             coordinate",
            shaped = Shaped::Transposed,
            factors = Factors::InverseBindOfFileTransposed,
            divided = Divided::Sum
        ),
        // A product of transposed matrices is that of the others the other way round, transposed. Its fourth row has the
        // offsets, which are lost, whether in B as well or not.
        way!(
            "of each joint's own transform, so that offsets are lost",
            chain = Chain::OwnParent,
            bind_chain = Chain::OwnParent,
            factors = Factors::EachTransposed
        ),
    ],
};
