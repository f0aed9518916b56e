use super::CurveSet;
use crate::revision::Revision;
use std::sync::Arc;

/// Curves and surfaces in the scene: what was imported or drawn, and how it is shown.
#[derive(Clone, Debug)]
pub struct CurveShape {
    curves: Arc<CurveSet>,
    frame_closing: bool,
    revision: Revision,
    /// How it is drawn.
    pub display: CurveDisplay,
}

/// How curves and surfaces are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CurveDisplay {
    /// Whether control points and the polygon that joins them are drawn.
    pub control_points: bool,
    /// The curves.
    pub curve: CurveVisibility,
    /// The surfaces.
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

/// What the panel calls Curve Visibility.
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

/// What the panel calls Surface Visibility.
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
        self.curves == other.curves
            && self.frame_closing == other.frame_closing
            && self.display == other.display
    }
}

impl CurveShape {
    /// `curves` as they are first shown, closed sweeps closing.
    pub fn new(curves: CurveSet) -> Self {
        Self {
            curves: Arc::new(curves),
            frame_closing: true,
            revision: Revision::new(),
            display: CurveDisplay::default(),
        }
    }

    /// The curves and surfaces.
    pub fn curves(&self) -> &CurveSet {
        &self.curves
    }

    /// Whether the angle by which frames miss their start on a closed sweep is spread along it
    /// (see [`crate::geometry::close_frames`]).
    pub fn frame_closing(&self) -> bool {
        self.frame_closing
    }

    /// Changes with every change of the curves or the frame closing.
    pub fn revision(&self) -> Revision {
        self.revision
    }

    /// Replaces the curves; the same ones change nothing.
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
