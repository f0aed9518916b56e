use glam::{DMat3, DVec3};

/// A symmetric system of linear equations, of whose matrix the lower half counts.
#[derive(Clone, Debug)]
pub(super) struct Equations {
    count: usize,
    matrix: Vec<f64>,
    right: Vec<f64>,
}

impl Equations {
    /// Equations of so many unknowns, all zero.
    pub(super) fn new(count: usize) -> Self {
        Self {
            count,
            matrix: vec![0.0; count * count],
            right: vec![0.0; count],
        }
    }

    /// Adds to the matrix, at a row and a column of the lower half.
    pub(super) fn add(&mut self, row: usize, column: usize, value: f64) {
        self.matrix[row * self.count + column] += value;
    }

    /// Adds to the right-hand side.
    pub(super) fn add_right(&mut self, row: usize, value: f64) {
        self.right[row] += value;
    }

    /// By how much the sum of squares that these are the normal equations of becomes less at most, if the three
    /// unknowns from `first` on alone are other than zero.
    pub(super) fn promise(&self, first: usize) -> f64 {
        let at = |row: usize, column: usize| {
            let (row, column) = (row.max(column), row.min(column));
            self.matrix[(first + row) * self.count + first + column]
        };
        let columns =
            [0, 1, 2].map(|column| DVec3::from_array([0, 1, 2].map(|row| at(row, column))));
        let own = DMat3::from_cols(columns[0], columns[1], columns[2]);
        let right = DVec3::from_slice(&self.right[first..first + 3]);
        // What no vertex tells promises nothing.
        let least = (at(0, 0) + at(1, 1) + at(2, 2)) * 1e-6 + f64::MIN_POSITIVE;
        let raised = own + DMat3::from_diagonal(DVec3::splat(least));
        let promise = right.dot(raised.inverse() * right);
        if promise.is_finite() { promise } else { 0.0 }
    }

    /// The solution with the diagonal raised by `damping` of itself and of its largest entry, which leaves
    /// alone what no equation tells; `None` if the numbers are not finite. By Cholesky's
    /// decomposition.
    pub(super) fn solve(mut self, damping: f64) -> Option<Vec<f64>> {
        let count = self.count;
        let diagonal = |matrix: &[f64], i: usize| matrix[i * count + i];
        let largest = (0..count)
            .map(|i| diagonal(&self.matrix, i))
            .fold(0.0, f64::max);
        for i in 0..count {
            let own = diagonal(&self.matrix, i);
            self.matrix[i * count + i] = own + damping * (own + largest * 1e-3);
        }
        for row in 0..count {
            for column in 0..=row {
                let (above, own) = self.matrix.split_at(row * count);
                let of_column = if column == row {
                    &own[..column]
                } else {
                    &above[column * count..column * count + column]
                };
                let products: f64 = own[..column]
                    .iter()
                    .zip(of_column)
                    .map(|(a, b)| a * b)
                    .sum();
                let rest = own[column] - products;
                self.matrix[row * count + column] = if column == row {
                    if rest <= 0.0 {
                        return None;
                    }
                    rest.sqrt()
                } else {
                    rest / above[column * count + column]
                };
            }
        }
        let mut found = self.right;
        for row in 0..count {
            let products: f64 = (0..row)
                .map(|column| self.matrix[row * count + column] * found[column])
                .sum();
            found[row] = (found[row] - products) / diagonal(&self.matrix, row);
        }
        for row in (0..count).rev() {
            let products: f64 = (row + 1..count)
                .map(|below| self.matrix[below * count + row] * found[below])
                .sum();
            found[row] = (found[row] - products) / diagonal(&self.matrix, row);
        }
        // Also what is not finite in the matrix ends up here.
        found.iter().all(|value| value.is_finite()).then_some(found)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equations_are_solved_and_what_none_of_them_tells_is_left_alone() {
        // Of 4 x + 2 y = 2 and 2 x + 3 y + z = 1, with z in one more, and a fourth unknown in none.
        let mut equations = Equations::new(4);
        let matrix = [
            (0, 0, 4.0),
            (1, 0, 2.0),
            (1, 1, 3.0),
            (2, 1, 1.0),
            (2, 2, 5.0),
        ];
        for (row, column, value) in matrix {
            equations.add(row, column, value);
        }
        for (row, value) in [2.0, 1.0, -3.0].into_iter().enumerate() {
            equations.add_right(row, value);
        }
        let found = equations.solve(1e-12).unwrap();
        let [x, y, z, free] = found[..] else {
            panic!("four unknowns")
        };
        for (left, right) in [
            (4.0 * x + 2.0 * y, 2.0),
            (2.0 * x + 3.0 * y + z, 1.0),
            (y + 5.0 * z, -3.0),
            (free, 0.0),
        ] {
            assert!((left - right).abs() < 1e-9, "{found:?}");
        }
    }

    #[test]
    fn numbers_that_are_not_finite_have_no_solution() {
        let mut equations = Equations::new(1);
        equations.add(0, 0, f64::NAN);
        assert_eq!(equations.solve(1e-6), None);
    }
}
