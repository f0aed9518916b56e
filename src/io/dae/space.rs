//! From the file's axes and unit to ours: +Y up, meters.

use super::document::{Dae, child};
use super::numbers::text;
use super::quoted;
use glam::{DMat3, DMat4, DVec3};

/// Which way the file's axes point, and how long its unit is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FileSpace {
    /// The axis that points up.
    pub up: UpAxis,
    /// Meters a unit; positions are scaled by it.
    pub meters: f64,
}

/// The axis that points up in a Collada file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum UpAxis {
    /// `(x, y, z)` is `(−y, x, z)` with +Y up.
    X,
    /// As here.
    #[default]
    Y,
    /// `(x, y, z)` is `(x, z, −y)` with +Y up, as Blender writes.
    Z,
}

impl FileSpace {
    /// What `<asset>` says; +Y up and meters where it says nothing.
    pub(super) fn read(dae: &Dae) -> Self {
        let asset = child(dae.root, "asset");
        let up = asset.and_then(|asset| child(asset, "up_axis"));
        let up = up.map_or(UpAxis::Y, |node| match text(node) {
            "X_UP" => UpAxis::X,
            "Y_UP" => UpAxis::Y,
            "Z_UP" => UpAxis::Z,
            other => {
                let found = quoted(other);
                dae.warn(
                    node,
                    format!("expected X_UP, Y_UP or Z_UP, found {found}: taken as Y_UP"),
                );
                UpAxis::Y
            }
        });
        let unit = asset.and_then(|asset| child(asset, "unit"));
        let meters = unit.and_then(|node| {
            let value = node.attribute("meter")?;
            let meters = value.trim().parse::<f64>().ok();
            let sensible = meters.filter(|meters| (1e-9..=1e9).contains(meters));
            if sensible.is_none() {
                let found = quoted(value);
                dae.warn(
                    node,
                    format!("expected the meters of a unit, found {found}: taken as 1"),
                );
            }
            sensible
        });
        Self {
            up,
            meters: meters.unwrap_or(1.0),
        }
    }

    /// The matrix that brings the file's positions into ours.
    pub fn ours_from_file(&self) -> DMat4 {
        let axes = match self.up {
            UpAxis::X => DMat3::from_cols(DVec3::Y, DVec3::NEG_X, DVec3::Z),
            UpAxis::Y => DMat3::IDENTITY,
            UpAxis::Z => DMat3::from_cols(DVec3::X, DVec3::NEG_Z, DVec3::Y),
        };
        DMat4::from_mat3(axes * self.meters)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_turn_as_collada_says() {
        let point = DVec3::new(1.0, 2.0, 3.0);
        let ours = |up, meters| {
            FileSpace { up, meters }
                .ours_from_file()
                .transform_point3(point)
        };
        assert_eq!(ours(UpAxis::Z, 1.0), DVec3::new(1.0, 3.0, -2.0));
        assert_eq!(ours(UpAxis::X, 1.0), DVec3::new(-2.0, 1.0, 3.0));
        assert_eq!(ours(UpAxis::Y, 0.5), point * 0.5);
    }
}
