use super::CurvePoint;
use super::curve_evaluation;
use glam::Vec3;

/// Curve as a `.swp` file describes it: a chain of cubic pieces, or a circle.
///
/// Always valid: [`Curve::spline`] and [`Curve::circle`] check what they are given.
#[derive(Clone, Debug, PartialEq)]
#[doc(alias = "evalBezier")]
#[doc(alias = "evalBspline")]
pub struct Curve {
    form: CurveForm,
    steps: u32,
}

/// Form of a curve, with its parameters.
#[derive(Clone, Debug, PartialEq)]
pub enum CurveForm {
    /// Cubic pieces.
    Spline {
        /// Basis of the control points.
        basis: Basis,
        /// Whether it lies in the plane z = 0 (`bez2`, `bsp2`) or in space (`bez3`, `bsp3`). All
        /// control points of a flat one have z = 0.
        flat: bool,
        /// Control points in model space, in the order of the file.
        control_points: Vec<Vec3>,
    },
    /// About the origin in the plane z = 0, from +X counter-clockwise (`circ`).
    Circle {
        /// Radius, in model space; zero is allowed.
        radius: f32,
    },
}

/// Basis by which control points become cubic pieces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Basis {
    /// Bézier: 3k + 1 control points make k pieces, neighbors share a point.
    Bezier,
    /// Uniform B-spline: n control points make n − 3 pieces, neighbors share three points.
    BSpline,
}

/// The largest STEPS of a curve or a surface of revolution.
pub const MAX_STEPS: u32 = 10_000;
/// The largest number of evaluated points of one curve.
pub const MAX_CURVE_POINTS: usize = 1_000_000;
/// The largest coordinate or radius: beyond it sweeps could leave the range of `f32`.
pub const MAX_COORDINATE: f32 = 1e9;

/// Reason why numbers do not describe a curve.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum CurveError {
    /// Number of steps out of range.
    #[error("expected 1 to {MAX_STEPS} steps, found {0}")]
    Steps(u64),
    /// Number of control points that does not fit a Bézier curve.
    #[error("expected 3k + 1 control points (4, 7, 10, …) for a Bézier curve, found {0}")]
    BezierCount(usize),
    /// Number of control points that does not fit a B-spline.
    #[error("expected at least 4 control points for a B-spline, found {0}")]
    BSplineCount(usize),
    /// Too many points: pieces times steps.
    #[error("expected at most {MAX_CURVE_POINTS} points on a curve, found {0}")]
    TooManyPoints(usize),
    /// Number that is not finite, or too large to compute with.
    #[error("expected numbers within ±{MAX_COORDINATE:e}, found {0:e}")]
    Coordinate(f32),
}

impl Basis {
    /// Whether `count` control points make whole pieces.
    ///
    /// # Errors
    /// If they do not; the message names counts that would.
    pub fn check_count(self, count: usize) -> Result<(), CurveError> {
        match self {
            Self::Bezier if count < 4 || count % 3 != 1 => Err(CurveError::BezierCount(count)),
            Self::BSpline if count < 4 => Err(CurveError::BSplineCount(count)),
            _ => Ok(()),
        }
    }

    /// Number of pieces that `count` control points make.
    pub fn pieces(self, count: usize) -> usize {
        match self {
            Self::Bezier => count.saturating_sub(1) / 3,
            Self::BSpline => count.saturating_sub(3),
        }
    }
}

impl Curve {
    /// A Bézier curve or a B-spline with `steps` steps per piece. The z of a `flat` curve's control
    /// points is dropped.
    ///
    /// # Errors
    /// If the count does not fit the basis, a number is not finite or too large, or there would be
    /// too many points.
    pub fn spline(
        basis: Basis,
        flat: bool,
        steps: u32,
        mut control_points: Vec<Vec3>,
    ) -> Result<Self, CurveError> {
        check_steps(steps)?;
        basis.check_count(control_points.len())?;
        let points = basis
            .pieces(control_points.len())
            .saturating_mul(steps as usize + 1);
        if points > MAX_CURVE_POINTS {
            return Err(CurveError::TooManyPoints(points));
        }
        for point in &mut control_points {
            if flat {
                point.z = 0.0;
            }
            point.to_array().into_iter().try_for_each(check_number)?;
        }
        let form = CurveForm::Spline {
            basis,
            flat,
            control_points,
        };
        Ok(Self { form, steps })
    }

    /// A circle with `steps` steps in all.
    ///
    /// # Errors
    /// If the radius is not finite or too large, or there are no or too many steps.
    pub fn circle(steps: u32, radius: f32) -> Result<Self, CurveError> {
        check_steps(steps)?;
        check_number(radius)?;
        let form = CurveForm::Circle { radius };
        Ok(Self { form, steps })
    }

    /// Form of the curve.
    pub fn form(&self) -> &CurveForm {
        &self.form
    }

    /// Steps per piece; of a circle, in all.
    pub fn steps(&self) -> u32 {
        self.steps
    }

    /// The control points, in model space; a circle has none.
    pub fn control_points(&self) -> &[Vec3] {
        match &self.form {
            CurveForm::Spline { control_points, .. } => control_points,
            CurveForm::Circle { .. } => &[],
        }
    }

    /// Whether it lies in the plane z = 0, as a profile must.
    pub fn is_flat(&self) -> bool {
        self.control_points().iter().all(|point| point.z == 0.0)
    }

    /// Whether its control points cannot leave the plane z = 0 (`bez2`, `bsp2`).
    pub fn stays_flat(&self) -> bool {
        matches!(self.form, CurveForm::Spline { flat: true, .. })
    }

    /// Upper bound of the number of points that [`Curve::evaluate`] returns.
    pub fn max_points(&self) -> usize {
        let steps = self.steps as usize + 1;
        match &self.form {
            CurveForm::Spline {
                basis,
                control_points,
                ..
            } => basis.pieces(control_points.len()) * steps,
            CurveForm::Circle { .. } => steps,
        }
    }

    /// The same curve with another number of steps.
    ///
    /// # Errors
    /// If there are none or too many.
    pub fn with_steps(&self, steps: u32) -> Result<Self, CurveError> {
        match &self.form {
            CurveForm::Spline {
                basis,
                flat,
                control_points,
            } => Self::spline(*basis, *flat, steps, control_points.clone()),
            CurveForm::Circle { radius } => Self::circle(steps, *radius),
        }
    }

    /// Evaluates the curve: points from start to end with their frames, in model space.
    ///
    /// A point that two pieces share is stored once where the curve is smooth, and twice at a
    /// corner, once with either tangent. Frames are always finite and orthonormal: where a
    /// derivative vanishes (repeated control points, cusps) the tangent is the direction that the
    /// curve takes beside that point.
    pub fn evaluate(&self) -> Vec<CurvePoint> {
        match &self.form {
            CurveForm::Spline {
                basis,
                control_points,
                ..
            } => curve_evaluation::spline(*basis, control_points, self.steps),
            CurveForm::Circle { radius } => curve_evaluation::circle(*radius, self.steps),
        }
    }
}

fn check_steps(steps: u32) -> Result<(), CurveError> {
    if (1..=MAX_STEPS).contains(&steps) {
        Ok(())
    } else {
        Err(CurveError::Steps(steps.into()))
    }
}

fn check_number(number: f32) -> Result<(), CurveError> {
    // NaN fails every comparison.
    if number.abs() <= MAX_COORDINATE {
        Ok(())
    } else {
        Err(CurveError::Coordinate(number))
    }
}
