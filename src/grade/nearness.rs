//! How much vertices count that are not right but near.

use crate::diagnose::MeshMeasure;

/// Distance from which on a vertex counts nothing, by the size: what is farther off is seen at once.
const FAR: f64 = 0.01;

/// What the vertices of a mesh count for on average, 0 to 1.
pub(super) fn nearness(measure: &MeshMeasure) -> f64 {
    let counts = measure.distances.iter();
    let counts = counts.map(|distance| count(distance / measure.size, measure));
    counts.sum::<f64>() / measure.distances.len().max(1) as f64
}

/// What a vertex counts for that is off by `error`, by the size: all within the tolerance, and from there on less for
/// each time that it is twice as far away.
fn count(error: f64, measure: &MeshMeasure) -> f64 {
    let tolerance = measure.tolerance / measure.size;
    if error <= tolerance {
        return 1.0;
    }
    if error.is_nan() || error >= FAR {
        return 0.0;
    }
    (FAR / error).ln() / (FAR / tolerance).ln()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_vertex_counts_the_more_the_nearer_it_is() {
        let measure = |distances: &[f64]| MeshMeasure {
            distances: distances.to_vec(),
            size: 2.0,
            tolerance: 2e-4,
            off: 0,
            worst: 0.0,
            worst_vertex: None,
            mean: 0.0,
            regions: Vec::new(),
        };
        let of = |error: f64| nearness(&measure(&[2.0 * error]));
        for (error, expected) in [
            (0.0, 1.0),
            (1e-4, 1.0),
            (3e-4, 0.761),
            (1e-3, 0.5),
            (5e-3, 0.151),
            (1e-2, 0.0),
            (f64::INFINITY, 0.0),
            (f64::NAN, 0.0),
        ] {
            assert!(
                (of(error) - expected).abs() < 1e-3,
                "{error}: {}",
                of(error)
            );
        }
        let errors = (0..300).map(|step| 1e-5 * 1.03_f64.powi(step));
        let counts: Vec<f64> = errors.map(of).collect();
        assert!(counts.is_sorted_by(|near, far| near >= far));
        assert_eq!(nearness(&measure(&[0.0, 1.0])), 0.5);
    }
}
