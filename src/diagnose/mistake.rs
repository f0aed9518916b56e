//! What a mistake is, and how one is found by its name.

use super::formula::Formula;
use super::found_otherwise::FOUND_OTHERWISE;
use super::mistakes::MISTAKES;
use super::of_whole_program::OF_WHOLE_PROGRAM;

/// A mistake that programs make in skinning a character.
#[derive(Debug)]
pub struct Mistake {
    /// Its name, which scripts may rely on.
    pub id: &'static str,
    /// What the program does, in a sentence without a full stop.
    pub meaning: &'static str,
    /// Section of the assignment.
    pub section: &'static str,
    /// What to look at in the code.
    pub look_at: &'static str,
    /// How the mistake is made, the most usual way first.
    pub readings: &'static [Reading],
}

/// One way to make a mistake.
#[derive(Debug)]
pub struct Reading {
    /// What is special about it; empty if there is nothing to add.
    pub how: &'static str,
    /// Makes the mistake.
    pub make: fn(&mut Formula),
    /// Whether programs hardly make it so: what gives the same is told before it.
    pub is_rare: bool,
}

pub(super) const SKELETON: &str = "3.2 Skeleton";
pub(super) const SLIDERS: &str = "3.4 Sliders";
pub(super) const MESH: &str = "4.1 Mesh";
pub(super) const SSD: &str = "4.2 SSD";

/// What to look at where some weights of a vertex are not used.
pub(super) const EVERY_JOINT_COUNTS: &str =
    "where weights are read or summed: every joint counts, however many there are";

/// What to look at where a mesh is moved, turned or scaled as a whole.
pub(super) const LOOK_AT_PLACE: &str = "what is done to vertices after skinning, or to the model when it is read: \
                                        units, axes, a matrix of the shape or of the camera that belongs only to drawing";

pub(super) const fn reading(how: &'static str, make: fn(&mut Formula)) -> Reading {
    Reading {
        how,
        make,
        is_rare: false,
    }
}

/// A way to make a mistake that programs hardly have.
pub(super) const fn rare_reading(how: &'static str, make: fn(&mut Formula)) -> Reading {
    Reading {
        is_rare: true,
        ..reading(how, make)
    }
}

/// Name of the mistake that leaves the mesh in the bind pose.
pub const POSE_NOT_APPLIED: &str = "pose-not-applied";
/// Name of the mistake that a mesh is moved, turned or scaled as a whole, which grading also counts of one that is right but
/// for that.
pub const MOVED_AS_A_WHOLE: &str = "moved-as-a-whole";
/// Name of the mistake that there is one vertex fewer than the model has.
pub const VERTEX_MISSING: &str = "vertex-missing";
/// Name of the mistake that there is one more.
pub const VERTEX_TOO_MANY: &str = "vertex-too-many";
/// Name of the mistake that triangles wind the other way.
pub const TRIANGLES_TURNED: &str = "triangles-turned";
/// Name of the mistake that triangles are missing, or others are in their place.
pub const TRIANGLES_DIFFER: &str = "triangles-differ";
/// Name of the mistake that a picture is upside down or mirrored.
pub const PICTURE_TURNED: &str = "picture-turned";
/// Name of the mistake of a mesh that is right but mirrored.
pub const MESH_MIRRORED: &str = "mesh-mirrored";

/// The mistake of vertices that are right but in an order of which no formula is known.
pub(super) static IN_ANY_ORDER: Reading = reading("in another order", |_| {});

impl Mistake {
    /// Every mistake that is known: those of [`MISTAKES`], those of a whole program, and those that are found otherwise.
    pub fn all() -> impl Iterator<Item = &'static Self> {
        let others = OF_WHOLE_PROGRAM.into_iter().chain(FOUND_OTHERWISE);
        MISTAKES.iter().chain(others)
    }

    /// The mistake with this name, if there is one.
    pub fn find(id: &str) -> Option<&'static Self> {
        Self::all().find(|mistake| mistake.id == id)
    }
}
