//! What moves a vertex: the product of matrices that a joint has for it, and what is done before and after.

use glam::DVec4;

/// What the matrix of a Collada file's skin (`bind_shape_matrix`) does to vertices.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shaped {
    /// It places them.
    Exactly,
    /// Nothing.
    Not,
    /// It places them transposed.
    Transposed,
    /// The same, of which the fourth coordinate is 1 again then.
    TransposedAsPoints,
}

/// What moves a vertex in the space of the bind pose.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Factors {
    /// T · B⁻¹.
    Exact,
    /// T.
    NoInverseBind,
    /// T with the directions of a Collada file, without the file's inverse bind matrix.
    NoInverseBindOfFile,
    /// B⁻¹.
    InverseBindOnly,
    /// T · B.
    BindNotInverted,
    /// B⁻¹ · T.
    Swapped,
    /// The same with the matrices of a Collada file, the axes of which are converted last.
    SwappedInFile,
    /// The same where the axes are converted in T.
    SwappedWithFile,
    /// T · B⁻¹, whose axes and units stay those of a Collada file.
    ExactInFile,
    /// (T · B⁻¹)ᵀ, by which a row is multiplied on the left of T · B⁻¹.
    Transposed,
    /// Tᵀ · B⁻ᵀ.
    EachTransposed,
    /// Tᵀ · B⁻¹.
    CurrentTransposed,
    /// T · B₁⁻¹, where B₁ is that of the first joint of the vertex for all of them.
    InverseBindOfFirst,
    /// T · B⁻ᵀ.
    InverseBindTransposed,
    /// The same with the file's inverse bind matrix transposed.
    InverseBindOfFileTransposed,
    /// T · B⁻¹ with the file's inverse bind matrix of the joint whose number the weight has.
    InverseBindOfNumber,
    /// (T · B⁻¹)ᵀ, where the inverse of B comes from the file and so leads from its axes and units.
    TransposedInFile,
    /// T · Bᵀ.
    BindTransposed,
    /// T⁻¹ · B.
    InverseOfCurrent,
    /// B · T⁻¹.
    InverseOfCurrentFirst,
    /// B · T.
    BindNotInvertedFirst,
    /// Nothing: vertices stay as they are in the file.
    Nothing,
}

/// A matrix of a joint that moves vertices.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Factor {
    /// T, from the joint's frame to model space in the pose.
    Current,
    /// B, the same in the bind pose.
    Bind,
    /// B⁻¹, from model space to the joint's frame in the bind pose.
    InverseBind,
    /// B₁⁻¹, that of the first joint with a weight.
    InverseBindOfFirst,
    /// Tᵀ.
    CurrentTransposed,
    /// B⁻ᵀ.
    InverseBindTransposed,
    /// Bᵀ.
    BindTransposed,
    /// T⁻¹.
    InverseCurrent,
    /// A⁻¹, from the mesh at rest to where the skin of a Collada file has it, in the axes and units of the file.
    ToFile,
    /// A.
    FromFile,
    /// Aᵀ.
    FromFileTransposed,
    /// The directions that a Collada file gives the joint at rest.
    DirectionsInFile,
    /// The inverse bind matrix that a Collada file gives the joint.
    InverseBindOfFile,
    /// The same of the joint whose number the weight has, where that is taken for another joint's.
    InverseBindOfNumber,
    /// The inverse bind matrix that a Collada file gives the joint, transposed.
    InverseBindOfFileTransposed,
}

impl Factor {
    /// The joint whose matrix it is where the weight of the joint `numbered` is taken for one of `joint`.
    pub(super) fn joint(self, numbered: usize, joint: usize) -> usize {
        match self {
            Self::InverseBindOfNumber => numbered,
            _ => joint,
        }
    }
}

impl Factors {
    /// Whether they are those of a program that has the frames of a Collada file.
    pub(super) fn are_of_file(self) -> bool {
        self.in_order().contains(&Factor::ToFile)
    }

    /// The matrices in the order in which they come to a vertex, from the right of the product to its
    /// left.
    pub fn in_order(self) -> &'static [Factor] {
        match self {
            Self::Exact => &[Factor::InverseBind, Factor::Current],
            Self::InverseBindOfFirst => &[Factor::InverseBindOfFirst, Factor::Current],
            Self::NoInverseBind => &[Factor::Current],
            Self::NoInverseBindOfFile => {
                &[Factor::ToFile, Factor::DirectionsInFile, Factor::Current]
            }
            Self::InverseBindOnly => &[Factor::InverseBind],
            Self::BindNotInverted => &[Factor::Bind, Factor::Current],
            Self::Swapped => &[Factor::Current, Factor::InverseBind],
            Self::SwappedInFile => &[
                Factor::ToFile,
                Factor::DirectionsInFile,
                Factor::Current,
                Factor::ToFile,
                Factor::InverseBindOfFile,
                Factor::FromFile,
            ],
            Self::SwappedWithFile => &[
                Factor::ToFile,
                Factor::DirectionsInFile,
                Factor::Current,
                Factor::InverseBindOfFile,
            ],
            Self::ExactInFile => &[Factor::InverseBind, Factor::Current, Factor::ToFile],
            Self::Transposed => &[Factor::CurrentTransposed, Factor::InverseBindTransposed],
            Self::EachTransposed => &[Factor::InverseBindTransposed, Factor::CurrentTransposed],
            Self::CurrentTransposed => &[Factor::InverseBind, Factor::CurrentTransposed],
            Self::InverseBindTransposed => &[Factor::InverseBindTransposed, Factor::Current],
            Self::InverseBindOfFileTransposed => &[
                Factor::ToFile,
                Factor::InverseBindOfFileTransposed,
                Factor::DirectionsInFile,
                Factor::Current,
            ],
            Self::InverseBindOfNumber => &[
                Factor::ToFile,
                Factor::InverseBindOfNumber,
                Factor::DirectionsInFile,
                Factor::Current,
            ],
            Self::TransposedInFile => &[
                Factor::ToFile,
                Factor::CurrentTransposed,
                Factor::InverseBindTransposed,
                Factor::FromFileTransposed,
            ],
            Self::BindTransposed => &[Factor::BindTransposed, Factor::Current],
            Self::InverseOfCurrent => &[Factor::Bind, Factor::InverseCurrent],
            Self::InverseOfCurrentFirst => &[Factor::InverseCurrent, Factor::Bind],
            Self::BindNotInvertedFirst => &[Factor::Current, Factor::Bind],
            Self::Nothing => &[],
        }
    }
}

/// What is divided by the fourth coordinate, which a transposed matrix makes other than 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Divided {
    /// Nothing.
    Nothing,
    /// Where each joint moves a vertex.
    Each,
    /// Their weighted sum.
    Sum,
}

impl Divided {
    /// Where one joint moves a vertex.
    pub(super) fn each(self, moved: DVec4) -> DVec4 {
        match self {
            Self::Each => moved / moved.w,
            Self::Nothing | Self::Sum => moved,
        }
    }

    /// What the weighted sum is multiplied by.
    pub(super) fn factor(self, sum: DVec4) -> f64 {
        match self {
            Self::Sum => sum.w.recip(),
            Self::Nothing | Self::Each => 1.0,
        }
    }
}
