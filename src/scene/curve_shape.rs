use super::{CurveItem, CurveSet};
use crate::revision::Revision;
use glam::Vec3;
use std::collections::HashSet;
use std::sync::Arc;

/// Curves and surfaces in the scene, with how they are displayed.
#[derive(Clone, Debug)]
pub struct CurveShape {
    curves: Arc<CurveSet>,
    frame_closing: bool,
    revision: Revision,
    /// Display options.
    pub display: CurveDisplay,
}

/// Display options of curves and surfaces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CurveDisplay {
    /// Whether control points and the polygon that joins them are drawn.
    pub control_points: bool,
    /// Display of the curves.
    pub curve: CurveVisibility,
    /// Display of the surfaces.
    pub surface: SurfaceVisibility,
}

impl Default for CurveDisplay {
    fn default() -> Self {
        Self {
            control_points: true,
            curve: CurveVisibility::On,
            surface: SurfaceVisibility::Shaded,
        }
    }
}

/// Display of curves: Curve Visibility in the panel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum CurveVisibility {
    /// Not drawn.
    Off,
    /// Drawn as lines.
    On,
    /// Drawn as lines with normal, tangent and binormal at each point.
    #[serde(rename = "frames")]
    OnWithFrames,
}

/// Display of surfaces: Surface Visibility in the panel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum SurfaceVisibility {
    /// Not drawn.
    Off,
    /// All edges of the triangles, and the normal of each vertex.
    #[serde(rename = "wireframe")]
    WireframeWithNormals,
    /// Lit.
    Shaded,
}

impl PartialEq for CurveShape {
    fn eq(&self, other: &Self) -> bool {
        // Most edits leave the curves alone, of which there may be many.
        (Arc::ptr_eq(&self.curves, &other.curves) || self.curves == other.curves)
            && self.frame_closing == other.frame_closing
            && self.display == other.display
    }
}

impl CurveShape {
    /// `curves` with default display options and frame closing.
    pub fn new(curves: CurveSet) -> Self {
        Self {
            curves: Arc::new(curves),
            frame_closing: true,
            revision: Revision::new(),
            display: CurveDisplay::default(),
        }
    }

    /// Curves and surfaces.
    pub fn curves(&self) -> &CurveSet {
        &self.curves
    }

    /// Whether the angle between the last and the first frame of a closed sweep is distributed
    /// along it (see [`crate::geometry::close_frames`]).
    pub fn frame_closing(&self) -> bool {
        self.frame_closing
    }

    /// Revision, which changes with the curves and the frame closing.
    pub fn revision(&self) -> Revision {
        self.revision
    }

    /// See [`super::Scene::memory`].
    pub(super) fn memory(&self, counted: &mut HashSet<usize>) -> usize {
        if !counted.insert(Arc::as_ptr(&self.curves).addr()) {
            return 0;
        }
        let points = |item: &CurveItem| item.curve().map_or(0, |c| c.control_points().len());
        let items = self.curves.items().iter();
        items
            .map(|item| size_of::<CurveItem>() + points(item) * size_of::<Vec3>())
            .sum()
    }

    /// Replaces the curves. Equal ones do not change the revision.
    pub fn set_curves(&mut self, curves: CurveSet) {
        if curves != *self.curves {
            self.curves = Arc::new(curves);
            self.revision = Revision::new();
        }
    }

    /// Turns frame closing on or off.
    pub fn set_frame_closing(&mut self, frame_closing: bool) {
        if frame_closing != self.frame_closing {
            self.frame_closing = frame_closing;
            self.revision = Revision::new();
        }
    }
}
