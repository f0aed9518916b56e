//! Mistakes of a whole program with the angles of joints, and in how often they count.

use super::formula::{
    AngleAtEnd, AngleUnits, AnglesOf, Formula, Rotations, RoundedAngles, Shifted,
};
use super::mistake::{Mistake, SLIDERS, SSD, reading};

/// Mistakes that are told only where nothing simpler gives the same: an angle that is used twice, or alone.
pub(super) static TOLD_LAST: [&Mistake; 2] = [&ONLY_ONE_AXIS, &ANGLE_REPEATED];

/// The ways to use angles about other axes: those that are used about X, Y and Z, 0 for that about X.
macro_rules! axes {
    ($($how:literal = $axes:expr),+) => {
        &[$(reading($how, |formula| formula.joint.axes = $axes)),+]
    };
}

/// A mistake with the digits of angles.
pub(super) static ANGLES_ROUNDED: Mistake = Mistake {
    id: "angles-rounded",
    meaning: "angles are rounded",
    section: SLIDERS,
    look_at: "where angles come from: sliders and files keep all their digits, while numbers that are read off a panel have \
              fewer than the pose, of which a pose file has all",
    readings: &[
        reading("to one digit after the point of degrees", |formula| {
            formula.joint.rounded = RoundedAngles::ToDegrees(1);
        }),
        reading("to whole degrees", |formula| {
            formula.joint.rounded = RoundedAngles::ToDegrees(0);
        }),
        reading("towards 0 to whole degrees", |formula| {
            formula.joint.rounded = RoundedAngles::TowardsZero;
        }),
        reading("to two digits after the point of radians", |formula| {
            formula.joint.rounded = RoundedAngles::ToRadians(2);
        }),
    ],
};

/// A mistake with the angles about the axes.
pub(super) static ANGLES_EXCHANGED: Mistake = Mistake {
    id: "angles-exchanged",
    meaning: "angles are used about other axes than their own",
    section: SLIDERS,
    look_at: "where angles come to setJointTransform: which slider or number is about which axis",
    readings: axes!(
        "those about x and y are exchanged" = [1, 0, 2],
        "those about y and z are exchanged" = [0, 2, 1],
        "those about x and z are exchanged" = [2, 1, 0],
        "that about x about y, y about z, z about x" = [2, 0, 1],
        "that about x about z, y about x, z about y" = [1, 2, 0]
    ),
};

/// A mistake with one angle. Where a pose has few angles others give the same, so it is tried after them.
pub(super) static ANGLE_REPEATED: Mistake = Mistake {
    id: "angle-repeated",
    meaning: "one angle is used about several axes, in the place of others",
    section: SLIDERS,
    look_at: "setJointTransform and where angles come to it: each of the three rotations has an angle of its own",
    readings: axes!(
        "that about x about x and y" = [0, 0, 2],
        "that about x about x and z" = [0, 1, 0],
        "that about y about x and y" = [1, 1, 2],
        "that about y about y and z" = [0, 1, 1],
        "that about z about x and z" = [2, 1, 2],
        "that about z about y and z" = [0, 2, 2],
        "that about x about all three" = [0; 3],
        "that about y about all three" = [1; 3],
        "that about z about all three" = [2; 3]
    ),
};

/// A way to give joints the angles of others.
macro_rules! shifted {
    ($how:literal, $to:ident, $shifted:ident, $at_end:ident) => {
        reading($how, |formula| {
            formula.joint.angles_of = AnglesOf::$to(Shifted::$shifted, AngleAtEnd::$at_end);
        })
    };
}

/// A mistake with the angles of the joints.
pub(super) static ANGLES_SHIFTED: Mistake = Mistake {
    id: "angles-shifted",
    meaning: "joints have the angles of their neighbors in the file",
    section: SLIDERS,
    look_at: "where angles come to setJointTransform: angles i are of joint i, the root being joint 0",
    readings: &[
        shifted!("of the joint before them", Before, All, None),
        shifted!(
            "of the joint before them, the first one its own",
            Before,
            All,
            Own
        ),
        shifted!(
            "of the joint before them, the first one those of the last",
            Before,
            All,
            OtherEnd
        ),
        shifted!(
            "of the joint before them, but the first one its own, and the one after it none",
            Before,
            ButFirst,
            None
        ),
        shifted!("of the joint after them", After, All, None),
        shifted!(
            "of the joint after them, the last one its own",
            After,
            All,
            Own
        ),
        shifted!(
            "of the joint after them, the last one those of the first",
            After,
            All,
            OtherEnd
        ),
        shifted!(
            "of the joint after them, but the first one its own",
            After,
            ButFirst,
            None
        ),
        shifted!(
            "of the joint after them, but the first one and the last one their own",
            After,
            ButFirst,
            Own
        ),
    ],
};

/// A mistake at roots alone.
pub(super) static ROOT_ANGLES_MISSING: Mistake = Mistake {
    id: "root-angles-missing",
    meaning: "the root is not turned",
    section: SLIDERS,
    look_at: "setJointTransform and the loop over the joints that calls it: the root, joint 0, has sliders as well",
    readings: &[
        reading("", |formula| {
            formula.joint.angles_of = AnglesOf::ItselfButRoots;
        }),
        reading(
            "nor moved by the offset that the pose has for it",
            |formula| {
                formula.joint.angles_of = AnglesOf::ItselfButRoots;
                formula.joint.roots_are_moved = false;
            },
        ),
    ],
};

/// A mistake at all other joints.
pub(super) static ONLY_ROOT_TURNED: Mistake = Mistake {
    id: "only-root-turned",
    meaning: "only the root is turned: the joints below it follow it, but have no angles of their own",
    section: SLIDERS,
    look_at: "setJointTransform and the loop over the joints that calls it: every joint has its own angles; and the \
              recursion, which multiplies on each joint's own transform as it is in the pose",
    readings: &[reading("", |formula| {
        formula.joint.angles_of = AnglesOf::RootsAlone;
    })],
};

/// A mistake with the rotations about the axes, as of `R = Rx; R = Ry; R = Rz`, of which the last is left.
pub(super) static ONLY_ONE_AXIS: Mistake = Mistake {
    id: "only-one-axis",
    meaning: "the angle about one axis alone is used",
    section: SLIDERS,
    look_at: "setJointTransform: the three rotations are multiplied, and none overwrites those before it",
    readings: &[
        reading("that about z", |formula| turn_about_alone(2, formula)),
        reading("that about y", |formula| turn_about_alone(1, formula)),
        reading("that about x", |formula| turn_about_alone(0, formula)),
    ],
};

fn turn_about_alone(axis: usize, formula: &mut Formula) {
    let others = formula.joint.angles.iter_mut().enumerate();
    for (_, factor) in others.filter(|(other, _)| *other != axis) {
        *factor *= 0.0;
    }
}

/// A mistake in the matrices of the rotations.
pub(super) static SINE_COSINE_EXCHANGED: Mistake = Mistake {
    id: "sine-cosine-exchanged",
    meaning: "sine and cosine are exchanged, so that joints are turned by what their angles lack to 90°, those at rest as well",
    section: SLIDERS,
    look_at: "the matrices of the rotations in setJointTransform: cosines are on the diagonal, 1 where the angle is 0",
    readings: &[
        reading("", |formula| {
            formula.joint.units = [AngleUnits::Complements; 3];
        }),
        reading("about x alone", |formula| {
            formula.joint.units[0] = AngleUnits::Complements;
        }),
        reading("about y alone", |formula| {
            formula.joint.units[1] = AngleUnits::Complements;
        }),
        reading("about z alone", |formula| {
            formula.joint.units[2] = AngleUnits::Complements;
        }),
    ],
};

/// A mistake in how often rotations are made.
pub(super) static ROTATION_REPEATED: Mistake = Mistake {
    id: "rotation-repeated",
    meaning: "the rotation of each joint is multiplied on more than once",
    section: SLIDERS,
    look_at: "setJointTransform: it sets the joint's transform anew (=) instead of multiplying it on (*=), however often \
              it runs",
    readings: &[
        reading("twice", |formula| formula.joint.times = 2),
        reading("three times", |formula| formula.joint.times = 3),
    ],
};

/// A mistake in the numbers of quaternions.
pub(super) static QUATERNION_ORDER: Mistake = Mistake {
    id: "quaternion-order",
    meaning: "the four numbers of a quaternion are taken in another order",
    section: SLIDERS,
    look_at: "wherever a quaternion is made, kept or read: whether w is its first number or its last",
    readings: &[
        reading("a joint's own, x, y, z, w as w, x, y, z", |formula| {
            formula.joint.rotations = Rotations::ScalarTakenFirst;
        }),
        reading("a joint's own, w, x, y, z as x, y, z, w", |formula| {
            formula.joint.rotations = Rotations::ScalarTakenLast;
        }),
        reading("that of T, x, y, z, w as w, x, y, z", |formula| {
            formula.current_rotations = Rotations::ScalarTakenFirst;
        }),
        reading("that of T, w, x, y, z as x, y, z, w", |formula| {
            formula.current_rotations = Rotations::ScalarTakenLast;
        }),
    ],
};

/// A mistake in how T turns vertices.
pub(super) static CURRENT_ROTATION_TRANSPOSED: Mistake = Mistake {
    id: "current-rotation-transposed",
    meaning: "T turns the other way, while joints are where they should be",
    section: SSD,
    look_at: "where T or its quaternion comes to vertices: the signs of the quaternion, and rows and columns of the rotation",
    readings: &[reading("", |formula| {
        formula.current_rotations = Rotations::Transposed;
    })],
};
