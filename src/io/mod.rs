//! Files: importers, exporters, scene files. Bytes in, values out; nothing here opens a file, a
//! dialog or a window.

mod angle;
mod animation;
mod archive;
mod attach;
pub mod builtin;
mod content_kind;
pub mod dae;
mod diagnostic;
mod encoding;
mod export;
mod export_character;
mod export_materials;
mod file_access;
mod file_importer;
pub mod image;
mod import_character;
mod import_shape;
mod joint_names;
mod json;
mod json_node;
mod json_text;
mod json_values;
mod loaded;
mod missed_files;
mod mtl;
pub mod namesakes;
mod numbers;
mod obj;
mod obj_counts;
mod obj_face_reader;
mod obj_faces;
mod obj_shape;
mod palette;
mod pictures;
mod pose_collection;
mod pose_data;
mod pose_file;
mod read_job;
mod recorder;
mod rubric_data;
mod scanner;
mod scene;
pub mod scene_link;
mod skel;
mod swp;
mod tests_file;

pub use animation::Animation;
pub use archive::{WithArchives, to_zip, unpacked};
pub use attach::read_attach;
pub use content_kind::extension_of;
pub use diagnostic::{Diagnostic, Imported, Position};
pub use encoding::{in_utf8, markup};
pub use export::{TooFarOut, export_obj};
pub use export_character::{CharacterFiles, NotExpressible, export_character, left_out_of_course};
pub use export_materials::{ObjWithMaterials, export_obj_with_materials};
pub use file_access::{Files, expect_extension, extension, is_archive, is_scene};
pub use file_importer::{
    IMPORTABLE, character_file, import_any, import_character, import_collada, import_curve,
    import_shape,
};
pub use import_character::{is_character, read_character};
pub use import_shape::read_shape_obj;
pub use joint_names::no_such_joint;
pub use loaded::Loaded;
pub use missed_files::missed_files;
pub use obj::{
    has_vertices_alone, read_character_obj, read_posed_obj, read_posed_vertices, take_faces_of,
};
pub use obj_face_reader::{has_vertices, without_v};
pub use pose_collection::pose_of_several;
pub use pose_data::{Entries, Key, PoseData};
pub use pose_file::PoseFile;
pub use read_job::{ReadFiles, ReadJob, Wanted};
pub use rubric_data::{
    OTHER_POSE, Points, RIGHT_BUT_FOR_DIGITS, RIGHT_BUT_FOR_FEW, RIGHT_BUT_FOR_JOINTS,
    RIGHT_BUT_FOR_LITTLE, RubricData, SectionData, Share,
};
pub use scene::{
    Missing, Package, Reimported, SceneError, SceneFile, files_of_source, needed_files, normal,
    package, read_scene, reimport, scene_text,
};
pub use skel::read_skel;
pub use swp::{read_swp, to_swp};
pub use tests_file::{CommandData, NamedFile, TestData, TestKind, TestsFile};
