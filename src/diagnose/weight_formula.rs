//! Which weights of a vertex count in the formula of skinning, and how much.

/// Which weights of a vertex count, and how much.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WeightFormula {
    /// Which row of the file a vertex has.
    pub rows: Rows,
    /// Whether the weights are rounded first.
    pub rounded: Rounded,
    /// Whether the weights are divided by their sum then.
    pub is_normalized: bool,
    /// Whether the root is given what they lack to sum to 1.
    pub is_completed: bool,
    /// Which of them are kept.
    pub kept: Kept,
    /// How those that are kept are changed.
    pub rescaled: Rescaled,
    /// Which joint each belongs to.
    pub columns: Columns,
    /// Factor of each in the end.
    pub factor: f64,
}

/// Numbers with fewer digits for weights.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rounded {
    /// Weights are as they are.
    No,
    /// The next whole number below.
    Down,
    /// The nearest one with so many digits after the point.
    ToDigits(i32, Halves),
}

/// Which way a number goes that is in the middle between two with fewer digits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Halves {
    /// Up, as far as single precision tells: `round(10 * w) / 10`.
    Up,
    /// To the even digit, as far as single precision tells: `rint(10 * w) / 10`.
    ToEven,
    /// To where it is nearer in fact, as `printf` writes it.
    AsTheyAre,
}

impl Halves {
    pub(super) const ALL: [Self; 3] = [Self::Up, Self::ToEven, Self::AsTheyAre];
}

impl Rounded {
    pub(super) fn weight(self, weight: f64) -> f64 {
        match self {
            Self::No => weight,
            Self::Down => weight.floor(),
            Self::ToDigits(digits, halves) => {
                let (scale, single) = (10_f64.powi(digits), weight as f32 * 10_f32.powi(digits));
                let rounded = match halves {
                    Halves::Up => f64::from(single.round()),
                    Halves::ToEven => f64::from(single.round_ties_even()),
                    Halves::AsTheyAre => (weight * scale).round_ties_even(),
                };
                rounded / scale
            }
        }
    }
}

/// How weights that are kept make up for those that are not.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rescaled {
    /// Not at all.
    No,
    /// They are divided by their sum.
    ToOne,
    /// They are divided by their sum where some were left out.
    ToOneWhereCut,
    /// They sum to what all did.
    ToSumOfAll,
    /// Each is 1, whatever it was.
    ToOnes,
    /// Each is the same, and they sum to 1, whatever they were.
    ToMean,
    /// They are divided by how many they are.
    ByCount,
}

/// Which row of weights a vertex is given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rows {
    /// Its own.
    Exact,
    /// The one of the vertex before it; the first vertex has none, or for a diagnosis its own or the last one.
    Before,
    /// The one of the vertex after it; the last vertex has none, or for a diagnosis its own or the first one.
    After,
}

/// Which joint a column of weights is taken for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Columns {
    /// Its own: column c is joint c + 1.
    Exact,
    /// The one before, for column 0 the root.
    Before,
    /// The one before, without column 0.
    BeforeWithoutFirst,
    /// The one after, which the last column lacks.
    After,
    /// The one after, for the last column the last joint.
    AfterToLast,
    /// The one after, for the last column the first joint.
    AfterToFirst,
    /// Its own for the last joint, and none for all others.
    LastAlone,
    /// None for the last joint, and its own for all others.
    WithoutLast,
    /// Its own, but for that of one joint, which counts for none.
    Without(usize),
    /// Its own, but for two joints, each of which has the other's.
    Exchanged(usize, usize),
}

/// Which weights of a vertex are kept.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kept {
    /// All.
    All,
    /// So many of the largest; of equals those that come first, though a diagnosis takes any.
    Largest(usize),
    /// So many of those that are not zero, in the order of the joints.
    First(usize),
    /// The last of those that are not zero, in the order of the joints.
    Last,
    /// Those of at least this, in single precision.
    From(f64),
}
