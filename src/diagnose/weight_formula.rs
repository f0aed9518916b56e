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
    /// Whether each takes the place of those before it, in the order of the joints, so that the last alone counts.
    pub is_overwritten: bool,
    /// Which joint each belongs to.
    pub columns: Columns,
    /// Whether weights whose columns are taken for no joint are left out before all that, and not of what is kept. Only two
    /// mistakes together tell that apart.
    pub unused_first: bool,
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
    /// The same of the file's number in double precision, as Python's `round` does.
    AsDoubles,
}

impl Halves {
    pub(super) const ALL: [Self; 4] = [Self::Up, Self::ToEven, Self::AsTheyAre, Self::AsDoubles];
}

/// The double precision of the number that was read in single precision, by its shortest decimal.
fn as_double(weight: f64) -> f64 {
    (weight as f32).to_string().parse().unwrap_or(weight)
}

/// The whole number next to `number` times `scale`, by what that is before it is rounded.
fn nearest_to_product(number: f64, scale: f64) -> f64 {
    let product = number * scale;
    let lost = number.mul_add(scale, -product);
    let is_half = (product - product.floor()).total_cmp(&0.5).is_eq();
    match is_half {
        true if lost < 0.0 => product.floor(),
        true if lost > 0.0 => product.ceil(),
        _ => product.round_ties_even(),
    }
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
                    Halves::AsDoubles => nearest_to_product(as_double(weight), scale),
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
    /// They are divided by the sum of those whose columns are taken for a joint.
    ToOneOfUsed,
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
    /// The one before it in the list that numbers count in, which is the skin's own in a Collada file.
    Before(AtEnd),
    /// The one after it in that list.
    After(AtEnd),
    /// Its own for the joint that has the first column, and none for all others.
    FirstAlone,
    /// Its own for the last joint, and none for all others.
    LastAlone,
    /// None for the last joint, and its own for all others.
    WithoutLast,
    /// Its own, but for that of one joint, which counts for none.
    Without(usize),
    /// Its own, but for two joints, each of which has the other's.
    Exchanged(usize, usize),
}

impl WeightFormula {
    /// The same weights, of which those that no joint takes are left out first; `None` if that is no other formula.
    pub(super) fn with_unused_first(self) -> Option<Self> {
        let leaves_out = !matches!(
            self.columns,
            Columns::Exact | Columns::Exchanged(..) | Columns::Without(_)
        );
        // Where a row ends at its first zero, columns are counted before.
        let chooses = match self.kept {
            Kept::BeforeZero => false,
            Kept::All => {
                self.rescaled != Rescaled::No
                    || self.is_normalized
                    || self.is_completed
                    || self.is_overwritten
            }
            Kept::Largest(_) | Kept::First(_) | Kept::From(_) => true,
        };
        (leaves_out && chooses).then_some(Self {
            unused_first: true,
            ..self
        })
    }
}

/// What comes of the column at the end of a list beyond which there is none.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AtEnd {
    /// What is next to it in the list of all joints, such as the root before those that have columns; none if it has a column,
    /// too.
    OfAll,
    /// Nothing.
    Lost,
    /// The same joint.
    Same,
    /// The joint at the other end, which may be the root, though that has no column in an .attach file.
    OtherEnd,
    /// The joint that has the column at the other end.
    OtherColumn,
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
    /// Those in the columns before the first one that is zero.
    BeforeZero,
    /// Those of at least this, in single precision.
    From(f64),
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn halves_go_where_languages_have_them_go() {
        let rounded = |weight: f32, halves| Rounded::ToDigits(1, halves).weight(f64::from(weight));
        // 0.15 is a little more in single precision, and a little less in double precision; 0.25 is itself in both.
        for (halves, expected) in [
            (Halves::Up, [0.2, 0.3, 0.4]),
            (Halves::ToEven, [0.2, 0.2, 0.4]),
            (Halves::AsTheyAre, [0.2, 0.2, 0.3]),
            (Halves::AsDoubles, [0.1, 0.2, 0.3]),
        ] {
            let found = [0.15, 0.25, 0.35].map(|weight| rounded(weight, halves));
            assert_eq!(found, expected, "{halves:?}");
        }
    }
}
