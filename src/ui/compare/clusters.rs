//! Pixels that lie together.

use std::collections::{BTreeMap, HashSet};

/// Row and column of a square cell of pixels.
type Cell = [u32; 2];

/// Groups of items at pixels `(x, y)` that are at least about `cell` pixels apart, from the top down.
pub(super) fn clusters<T>(
    items: impl IntoIterator<Item = T>,
    pixel: impl Fn(&T) -> (u32, u32),
    cell: u32,
) -> Vec<Vec<T>> {
    let mut cells = BTreeMap::<Cell, Vec<T>>::new();
    for item in items {
        let at = cell_of(pixel(&item), cell);
        cells.entry(at).or_default().push(item);
    }
    let mut clusters = Vec::new();
    while let Some((first, items)) = cells.pop_first() {
        let (mut cluster, mut next) = (items, vec![first]);
        while let Some(at) = next.pop() {
            for beside in around(at) {
                if let Some(items) = cells.remove(&beside) {
                    cluster.extend(items);
                    next.push(beside);
                }
            }
        }
        clusters.push(cluster);
    }
    clusters
}

/// Pixels along a cell of those that are `apart` by so many, …
const ALONG: u32 = 6;
/// … and how many of them a cell has where they fill an area: a line through it has fewer.
const FILLED: usize = (ALONG * ALONG / 3) as usize;
/// Share of the largest cluster below which another one is a stray: where a limb stands before a shape, this is in several
/// clusters of like size.
const STRAY: f64 = 0.25;

/// Those of the pixels that lie together in an area, and not along lines or in much smaller ones: a shape that moves takes
/// along its shadow, and the ground if it is the lowest one. All of them if nowhere so many lie together.
pub(super) fn without_strays(pixels: &[(u32, u32)], apart: u32) -> Vec<(u32, u32)> {
    let cell = ALONG * apart.max(1);
    let filled = filled(pixels.iter().copied(), cell);
    let clusters = clusters(filled, |([row, column], _)| (*column, *row), 1);
    let size = |cluster: &[(Cell, usize)]| cluster.iter().map(|(_, count)| count).sum::<usize>();
    let largest = clusters.iter().map(|cluster| size(cluster)).max();
    let Some(largest) = largest else {
        return pixels.to_vec();
    };
    let is_kept = |cluster: &Vec<(Cell, usize)>| size(cluster) as f64 >= STRAY * largest as f64;
    let kept = clusters.into_iter().filter(is_kept).flatten();
    let kept: HashSet<Cell> = kept.flat_map(|(at, _)| around(at)).collect();
    let is_kept = |pixel: &(u32, u32)| kept.contains(&cell_of(*pixel, cell));
    pixels.iter().copied().filter(is_kept).collect()
}

/// Those of the pixels that are so far `apart` which lie together in an area, or beside one, and not along lines.
pub(super) fn in_areas(pixels: impl Iterator<Item = [u32; 2]>, apart: u32) -> Vec<[u32; 2]> {
    let pixels: Vec<[u32; 2]> = pixels.collect();
    let cell = ALONG * apart.max(1);
    let kept: HashSet<Cell> = filled(pixels.iter().map(|&[x, y]| (x, y)), cell)
        .flat_map(|(at, _)| around(at))
        .collect();
    let is_kept = |&[x, y]: &[u32; 2]| kept.contains(&cell_of((x, y), cell));
    pixels.into_iter().filter(is_kept).collect()
}

/// Whether pixels that are so far `apart` lie together in an area somewhere, and not only along lines.
pub(super) fn fill_an_area(pixels: &[[u32; 2]], apart: u32) -> bool {
    let pixels = pixels.iter().map(|&[x, y]| (x, y));
    filled(pixels, ALONG * apart.max(1)).next().is_some()
}

/// The cells that pixels fill, with how many there are in each.
fn filled(
    pixels: impl Iterator<Item = (u32, u32)>,
    cell: u32,
) -> impl Iterator<Item = (Cell, usize)> {
    let mut counts = BTreeMap::<Cell, usize>::new();
    for pixel in pixels {
        *counts.entry(cell_of(pixel, cell)).or_default() += 1;
    }
    counts.into_iter().filter(|(_, count)| *count >= FILLED)
}

fn cell_of((x, y): (u32, u32), cell: u32) -> Cell {
    [y / cell, x / cell]
}

/// A cell and those beside it.
fn around([row, column]: Cell) -> impl Iterator<Item = Cell> {
    let rows = row.saturating_sub(1)..=row + 1;
    let columns = column.saturating_sub(1)..=column + 1;
    rows.flat_map(move |row| columns.clone().map(move |column| [row, column]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compare::Area;

    /// Every third pixel of an area.
    fn filled(area: &str) -> Vec<(u32, u32)> {
        let area: Area = area.parse().unwrap();
        let every_third = |from: u32, count: u32| (from..from + count).step_by(3);
        every_third(area.y, area.height)
            .flat_map(|y| every_third(area.x, area.width).map(move |x| (x, y)))
            .collect()
    }

    fn area_of(areas: &[&str]) -> String {
        let pixels = areas.iter().flat_map(|area| filled(area));
        let kept = without_strays(&pixels.collect::<Vec<_>>(), 3);
        Area::around(kept).unwrap().to_string()
    }

    #[test]
    fn a_line_and_a_small_area_are_strays() {
        let shape = "90,90,91,91";
        assert_eq!(area_of(&[shape]), shape);
        assert_eq!(area_of(&[shape, "300,0,1,400"]), shape);
        assert_eq!(area_of(&[shape, "300,300,40,40"]), shape);
    }

    #[test]
    fn an_area_of_like_size_is_none() {
        assert_eq!(area_of(&["90,90,91,91", "300,300,61,61"]), "90,90,271,271");
    }

    #[test]
    fn what_is_as_thin_as_a_line_is_kept_where_nothing_else_is() {
        assert_eq!(area_of(&["300,0,1,400"]), "300,0,1,400");
    }
}
