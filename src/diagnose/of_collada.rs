//! Mistakes of a whole program with what only Collada files have: the skin's own matrix, the axes and units of the file, and
//! the directions of its bones.

use super::formula::{About, Factors, JointOrder, JointsBy, Shaped};
use super::mistake::{MESH, Mistake, SLIDERS, SSD, reading};

/// A mistake with the matrix that a Collada file's skin has for its mesh.
pub(super) static BIND_SHAPE_MISSING: Mistake = Mistake {
    id: "bind-shape-missing",
    meaning: "vertices are not placed by the skin's own matrix first",
    section: SSD,
    look_at: "where the skin of a Collada file is read: its bind_shape_matrix comes first to each vertex, before the \
              inverse of B",
    readings: &[reading("", |formula| formula.shaped = Shaped::Not)],
};

/// A mistake with the axes and units of a Collada file.
pub(super) static AXES_NOT_CONVERTED: Mistake = Mistake {
    id: "axes-not-converted",
    meaning: "the axes and units of the Collada file stay as they are, so that the mesh lies and angles are about the \
              file's axes",
    section: MESH,
    look_at: "where the Collada file is read: up_axis and unit of its asset hold for vertices and bones alike, and angles are \
              about axes of which Y points up",
    readings: &[reading("", |formula| {
        formula.joint.about = About::File;
        formula.factors = Factors::ExactInFile;
    })],
};

/// A mistake with the joints that weights belong to in a Collada file.
pub(super) static SKIN_LIST_IGNORED: Mistake = Mistake {
    id: "skin-list-ignored",
    meaning: "the numbers of joints in <v> are taken for places in a list of all bones instead of the skin's own list",
    section: SSD,
    look_at: "where the skin is read: numbers in <v> count in the skin's own list of joints (JOINT of its <joints>), whose \
              names lead to the bones",
    readings: &[
        reading("", |formula| formula.joint_order = BY_SKIN_LIST),
        reading(
            "while inverse bind matrices are those of the skin's own list",
            |formula| {
                formula.joint_order = BY_SKIN_LIST;
                formula.factors = Factors::InverseBindOfNumber;
            },
        ),
    ],
};

const BY_SKIN_LIST: JointOrder = JointOrder {
    by: JointsBy::SkinList,
    has_angles: false,
};

/// A mistake with the directions of the bones in a Collada file.
pub(super) static ANGLES_ABOUT_BONES: Mistake = Mistake {
    id: "angles-about-bones",
    meaning: "angles are about the bone's own axes in the Collada file instead of the character's",
    section: SLIDERS,
    look_at: "where a bone's rotation is multiplied on its matrix of the file: that leads from the bone's axes, into which \
              the axis has to be brought first",
    readings: &[
        reading("", |formula| formula.joint.about = About::Bone),
        reading(
            "after they are brought into the axes of the file",
            |formula| {
                formula.joint.about = About::BoneFromFile;
            },
        ),
    ],
};
