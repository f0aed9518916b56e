//! A diagnosis in steps, which an interface can draw between.

use crate::diagnose::figures::{Figure, turned};
use crate::diagnose::student::{RIGHT, Student};
use editor_core::diagnose::MeshJob;
use editor_core::geometry::SharedMesh;
use glam::Vec3;
use std::sync::Arc;

#[test]
fn a_diagnosis_in_steps_is_the_one_that_is_made_at_once() {
    let figure = Figure::builtin("dog", turned(11));
    let two_mistakes = Student {
        joint_of_column: |column| column,
        slider: |angles| Vec3::new(0.0, angles.y, angles.z),
        ..RIGHT
    };
    for (student, least) in [(RIGHT, 1), (two_mistakes, 30)] {
        let theirs = student.skin(&figure);
        let job = MeshJob {
            character: Arc::clone(&figure.character),
            pose: figure.pose(),
            theirs: SharedMesh::new(figure.mesh(&theirs)),
        };
        let mut steps = job.diagnose();
        let (mut count, mut part) = (0, 0.0);
        let found = loop {
            count += 1;
            let found = steps.step();
            assert!((part..=1.0).contains(&steps.part()), "it never goes back");
            part = steps.part();
            if let Some(found) = found {
                break found;
            }
        };
        assert_eq!(found.unwrap(), figure.diagnose(&theirs));
        assert!(count >= least, "{count} steps");
    }
}
