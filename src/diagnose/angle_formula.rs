//! What a formula changes of the angles of joints.

/// Joint whose angles a joint is given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AnglesOf {
    /// Itself.
    Itself,
    /// The one before it in the file, of all joints or of all but the first.
    Before(Shifted, AngleAtEnd),
    /// The one after it.
    After(Shifted, AngleAtEnd),
    /// Itself, but roots have none.
    ItselfButRoots,
    /// Itself, but only roots have any.
    RootsAlone,
    /// Its parent; roots have none.
    Parent,
}

/// Joints that have the angles of others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shifted {
    /// Every joint.
    All,
    /// All but the first, which has its own and is nobody's neighbor.
    ButFirst,
}

/// Angles of the joint that has no neighbor, at the end of the list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AngleAtEnd {
    /// None.
    None,
    /// Its own.
    Own,
    /// Those of the joint at the other end.
    OtherEnd,
}

impl AnglesOf {
    /// The joint of `count` whose angles that at the index `joint` is given; `None` if none's.
    pub(super) fn joint(self, joint: usize, parent: Option<usize>, count: usize) -> Option<usize> {
        let (shifted, at_end) = match self {
            Self::Itself => return Some(joint),
            Self::ItselfButRoots => return parent.map(|_| joint),
            Self::RootsAlone => return parent.is_none().then_some(joint),
            Self::Parent => return parent,
            Self::Before(shifted, at_end) | Self::After(shifted, at_end) => (shifted, at_end),
        };
        let first = match shifted {
            Shifted::All => 0,
            Shifted::ButFirst => 1,
        };
        if joint < first {
            return Some(joint);
        }
        let is_before = matches!(self, Self::Before(..));
        let ends = [first, count - 1];
        let [end, other_end] = if is_before { ends } else { [ends[1], ends[0]] };
        match at_end {
            _ if joint != end && is_before => Some(joint - 1),
            _ if joint != end => Some(joint + 1),
            AngleAtEnd::None => None,
            AngleAtEnd::Own => Some(joint),
            AngleAtEnd::OtherEnd => Some(other_end),
        }
    }
}

/// Angles with fewer digits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RoundedAngles {
    /// Angles are as they are.
    No,
    /// The nearest one with so many digits after the point in degrees.
    ToDegrees(i32),
    /// The next whole degree towards 0.
    TowardsZero,
    /// The nearest one with so many digits after the point in radians.
    ToRadians(i32),
}

impl RoundedAngles {
    /// What becomes of an angle, in radians.
    pub(super) fn angle(self, radians: f64) -> f64 {
        let to_digits = |number: f64, digits: i32| {
            let scale = 10_f64.powi(digits);
            (number * scale).round() / scale
        };
        match self {
            Self::No => radians,
            Self::ToDegrees(digits) => to_digits(radians.to_degrees(), digits).to_radians(),
            Self::TowardsZero => {
                let degrees = radians.to_degrees();
                // A whole number that lost a hair on its way through single precision is that number.
                let whole = (degrees.abs() + A_HAIR).floor();
                whole.copysign(degrees).to_radians()
            }
            Self::ToRadians(digits) => to_digits(radians, digits),
        }
    }
}

/// What whole degrees have lost at most that were converted to radians and back, in degrees.
const A_HAIR: f64 = 1e-4;

/// The numbers that are given to sine and cosine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AngleUnits {
    /// Radians.
    Radians,
    /// Degrees, which are not converted.
    Degrees,
    /// What comes of converting degrees to radians and the result once more.
    ConvertedTwice,
    /// What they lack to a right angle, in radians: sine and cosine are exchanged.
    Complements,
}

/// Axes that a joint turns about, at rest.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum About {
    /// Those of the character.
    Model,
    /// Those that a Collada file gives the joint.
    Bone,
    /// The same, where the pose's axes are brought into those of the file first.
    BoneFromFile,
    /// Those of a Collada file, along which roots are moved as well.
    File,
}
