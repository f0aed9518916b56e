//! Small pictures of what is off.

use super::canvas::{Canvas, Color};
use crate::character::Facing;
use crate::compare::{DRAWN_THRESHOLD, Pair};
use crate::diagnose::MeshMeasure;
use crate::geometry::{Mesh, Picture};
use crate::math::Aabb;
use crate::scene::Camera;
use glam::{Mat3, Vec2, Vec3};

/// Width and height of pictures of meshes in pixels, and the longer side of those of pictures.
const SIDE: u32 = 192;
/// Pixels that stay free at each side.
const MARGIN: f32 = 6.0;
/// As much of what is far off is shown, in sizes of the exact mesh from its center, and of a mesh that is so far off, or
/// so large, that most of it would not be in the picture.
const SHOWN: f32 = 1.0;
const MOST_SHOWN: f32 = 1e4;
/// The error at the end of the colors, by the size.
pub(super) const LARGEST_ERROR: f32 = 0.25;
/// Steps of color and of light: few, so that pictures stay small.
const STEPS: f32 = 12.0;

const PAPER: Color = [247, 247, 244];
/// The exact mesh behind a file.
pub(super) const GHOST: Color = [221, 223, 226];
const EXACT: Color = [150, 163, 179];
/// Where a file agrees.
pub(super) const AGREES: Color = [176, 183, 192];
/// Errors, the largest last: each is darker than the one before, so that they are told apart without
/// seeing colors.
pub(super) const ERRORS: [Color; 4] =
    [[250, 204, 106], [241, 138, 52], [208, 46, 34], [112, 8, 44]];
/// What only their silhouette has, and only the exact one.
pub(super) const ONLY_THEIRS: Color = [224, 112, 26];
pub(super) const ONLY_EXACT: Color = [52, 104, 190];

/// The exact mesh of a test, seen from its front and a little from its left and above.
#[derive(Debug)]
pub(super) struct MeshThumbnail<'a> {
    exact: &'a [Vec3],
    triangles: &'a [[u32; 3]],
    view_from_model: Mat3,
    bounds: Aabb,
}

impl<'a> MeshThumbnail<'a> {
    pub(super) fn new(exact: &'a [Vec3], triangles: &'a [[u32; 3]], facing: Facing) -> Self {
        let to_eye = facing.front() + 0.45 * facing.left() + 0.2 * Vec3::Y;
        let to_eye = to_eye.normalize_or(Vec3::Z);
        let right = Vec3::Y.cross(to_eye).normalize_or(Vec3::X);
        Self {
            exact,
            triangles,
            view_from_model: Mat3::from_cols(right, to_eye.cross(right), to_eye).transpose(),
            bounds: Aabb::from_points(exact.iter().copied()),
        }
    }

    /// The diagonal of the exact mesh's box.
    fn size(&self) -> f32 {
        match self.bounds.size().length() {
            size if size > 0.0 => size,
            _ => 1.0,
        }
    }

    /// The exact mesh alone.
    pub(super) fn of_exact(&self) -> Picture {
        let mut canvas = Canvas::new([SIDE; 2], PAPER);
        let frame = self.frame(&[], SHOWN);
        self.draw(&mut canvas, &frame, self.exact, self.triangles, |_, _| {
            EXACT
        });
        canvas.into_picture()
    }

    /// `theirs` before the exact mesh, in the colors of its errors as far as they have been measured; behind the exact
    /// one where that is a small part of the picture.
    pub(super) fn of_theirs(&self, theirs: &Mesh, measure: Option<&MeshMeasure>) -> Picture {
        let mut canvas = Canvas::new([SIDE; 2], PAPER);
        let is_elsewhere = self.is_mostly_elsewhere(&theirs.positions);
        let sizes = if is_elsewhere { MOST_SHOWN } else { SHOWN };
        let frame = self.frame(&theirs.positions, sizes);
        self.draw(&mut canvas, &frame, self.exact, self.triangles, |_, _| {
            GHOST
        });
        canvas.forget_depths();
        let tolerance = measure.map_or(0.0, |measure| measure.tolerance / measure.size);
        let errors: Vec<f32> = match measure {
            Some(measure) => {
                let by_size = |distance: &f64| (distance / measure.size) as f32;
                measure.distances.iter().map(by_size).collect()
            }
            None => vec![LARGEST_ERROR; theirs.positions.len()],
        };
        self.draw(
            &mut canvas,
            &frame,
            &theirs.positions,
            &theirs.triangles,
            |corners, weights| {
                let errors = Vec3::from_array(corners.map(|corner| errors[corner as usize]));
                match weights.dot(errors) {
                    error if f64::from(error) <= tolerance => AGREES,
                    error => error_color(error),
                }
            },
        );
        if is_elsewhere {
            canvas.forget_depths();
            self.draw(&mut canvas, &frame, self.exact, self.triangles, |_, _| {
                EXACT
            });
        }
        canvas.into_picture()
    }

    /// Center of the picture in the view, and pixels by length. As much of `theirs` is in it as lies within so many
    /// `sizes` of the exact mesh.
    fn frame(&self, theirs: &[Vec3], sizes: f32) -> (Vec2, f32) {
        let most = Vec3::splat(self.size() * sizes);
        let center = self.bounds.center();
        let near = theirs
            .iter()
            .map(|place| place.clamp(center - most, center + most));
        let seen = self.exact.iter().copied().chain(near);
        let bounds = Aabb::from_points(seen.map(|place| self.view_from_model * place));
        let side = bounds.size().truncate().max_element();
        let scale = (SIDE as f32 - 2.0 * MARGIN) / if side > 0.0 { side } else { 1.0 };
        (bounds.center().truncate(), scale)
    }

    /// Whether most vertices are farther away than what is shown of a mesh that is off in places.
    fn is_mostly_elsewhere(&self, theirs: &[Vec3]) -> bool {
        let center = self.bounds.center();
        let shown = self.size() * SHOWN;
        let is_far = |place: &&Vec3| (**place - center).abs().max_element() > shown;
        2 * theirs.iter().filter(is_far).count() > theirs.len()
    }

    fn draw(
        &self,
        canvas: &mut Canvas,
        &(center, scale): &(Vec2, f32),
        places: &[Vec3],
        triangles: &[[u32; 3]],
        color: impl Fn([u32; 3], Vec3) -> Color,
    ) {
        let middle = SIDE as f32 / 2.0;
        let seen: Vec<Vec3> = places
            .iter()
            .map(|&place| {
                let view = self.view_from_model * place;
                let from_center = (view.truncate() - center) * scale;
                Vec3::new(
                    middle + from_center.x,
                    middle - from_center.y,
                    view.z * scale,
                )
            })
            .collect();
        for &corners in triangles {
            let at = corners.map(|corner| seen[corner as usize]);
            let normal = (at[1] - at[0]).cross(at[2] - at[0]).normalize_or(Vec3::Z);
            // Light from the eye: how much a side is turned away, whichever it is.
            let light = 0.55 + 0.45 * (normal.z.abs() * STEPS).round() / STEPS;
            canvas.triangle(at, |weights| {
                color(corners, weights).map(|channel| (f32::from(channel) * light) as u8)
            });
        }
    }
}

/// Space around a silhouette, by its longer side.
const ROOM: f32 = 0.08;

/// The color of an error, by the size.
fn error_color(error: f32) -> Color {
    let share = (error / LARGEST_ERROR).clamp(0.0, 1.0).sqrt();
    let place = (share * STEPS).round() / STEPS * (ERRORS.len() - 1) as f32;
    let below = (place as usize).min(ERRORS.len() - 2);
    let [from, to] = [below, below + 1].map(|at| Vec3::from(ERRORS[at].map(f32::from)));
    from.lerp(to, place - below as f32)
        .to_array()
        .map(|channel| channel.round() as u8)
}

/// The silhouette in `theirs`, and where it differs from the exact one: a mesh with the vertices
/// `exact`, seen with `camera` in a picture of `size` pixels; of that the part with both. Without `theirs` the exact one
/// alone.
pub(super) fn of_silhouette(
    theirs: Option<&Picture>,
    size: [u32; 2],
    camera: &Camera,
    exact: &[Vec3],
    triangles: &[[u32; 3]],
) -> Picture {
    let whole = Vec2::new(size[0] as f32, size[1] as f32);
    let clip_from_world = camera.clip_from_world(whole.x / whole.y.max(1.0));
    let seen: Vec<Option<Vec3>> = exact
        .iter()
        .map(|&place| {
            let clip = clip_from_world * place.extend(1.0);
            let at = clip.truncate() / clip.w;
            let at_pixel = Vec2::new(at.x + 1.0, 1.0 - at.y) * whole / 2.0;
            (clip.w > 1e-6).then(|| at_pixel.extend(-at.z))
        })
        .collect();
    let is_drawn = theirs.map(drawn);
    let mut corners: Vec<Vec2> = seen.iter().flatten().map(|at| at.truncate()).collect();
    if let Some(is_drawn) = &is_drawn {
        for row in 0..size[1] as usize {
            let mut columns = (0..size[0] as usize).filter(|&column| is_drawn(column, row));
            let first = columns.next();
            let both = [first, columns.next_back().or(first)];
            corners.extend(
                both.iter()
                    .flatten()
                    .map(|&column| Vec2::new(column as f32, row as f32)),
            );
        }
    }
    let (from, shown) = part_with(&corners, whole);
    let scale = SIDE as f32 / shown.max_element();
    let [width, height] = shown
        .to_array()
        .map(|side| (side * scale).round().max(1.0) as u32);
    let mut canvas = Canvas::new([width, height], PAPER);
    let to_canvas = |at: Vec3| ((at.truncate() - from) * scale).extend(at.z);
    for corners in triangles {
        if let [Some(a), Some(b), Some(c)] = corners.map(|corner| seen[corner as usize]) {
            canvas.triangle([a, b, c].map(to_canvas), |_| EXACT);
        }
    }
    if let Some(is_drawn) = is_drawn {
        let pixel = |x: usize, y: usize| {
            let at = from + Vec2::new(x as f32 + 0.5, y as f32 + 0.5) / scale;
            let at = at.clamp(Vec2::ZERO, whole - 1.0);
            (at.x as usize, at.y as usize)
        };
        canvas.map(|x, y, color| {
            let (column, row) = pixel(x, y);
            match (is_drawn(column, row), color != PAPER) {
                (true, true) => AGREES,
                (true, false) => ONLY_THEIRS,
                (false, true) => ONLY_EXACT,
                (false, false) => PAPER,
            }
        });
    }
    canvas.into_picture()
}

/// The part of a picture of the size `whole` that has these places, with some room: its corner and its size.
fn part_with(places: &[Vec2], whole: Vec2) -> (Vec2, Vec2) {
    let inside = places.iter().map(|place| place.clamp(Vec2::ZERO, whole));
    let (low, high) = inside.fold((whole, Vec2::ZERO), |(low, high), at| {
        (low.min(at), high.max(at))
    });
    if low.cmpge(high).any() {
        return (Vec2::ZERO, whole.max(Vec2::ONE));
    }
    let room = ROOM * (high - low).max_element();
    let (low, high) = ((low - room).max(Vec2::ZERO), (high + room).min(whole));
    (low, (high - low).max(Vec2::ONE))
}

/// Whether a pixel, by column and row, differs from the background.
fn drawn(picture: &Picture) -> impl Fn(usize, usize) -> bool {
    let pair = Pair::new(picture, picture, &[]).ok();
    let background = pair.and_then(|pair| pair.backgrounds()[0]);
    move |column, row| {
        let at = 4 * (row * picture.width as usize + column);
        let pixel = &picture.rgba[at..at + 3];
        background.is_some_and(|background| {
            let differences = pixel.iter().zip(background).map(|(a, b)| a.abs_diff(b));
            differences.max() > Some(DRAWN_THRESHOLD)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mesh_that_is_far_too_large_or_far_away_is_seen_whole_beside_the_exact_one() {
        let exact = [Vec3::ZERO, Vec3::X, Vec3::new(1.0, 1.0, 0.0), Vec3::Y];
        let triangles = vec![[0, 1, 2], [0, 2, 3]];
        let thumbnail = MeshThumbnail::new(&exact, &triangles, Facing::default());
        let pixels = |to: fn(Vec3) -> Vec3| {
            let theirs = Mesh::new(exact.map(to).to_vec(), triangles.clone());
            let picture = thumbnail.of_theirs(&theirs, None);
            let (pixels, _) = picture.rgba.as_chunks::<4>();
            let is_red = |pixel: &&[u8; 4]| u32::from(pixel[0]) > 2 * u32::from(pixel[1]);
            let drawn = pixels.iter().filter(|pixel: &&[u8; 4]| pixel[..3] != PAPER);
            let (red, gray): (Vec<&[u8; 4]>, Vec<_>) = drawn.partition(is_red);
            (red.len(), gray.len())
        };
        let (red, gray) = pixels(|at| 10.0 * at);
        assert!(gray > 100 && red / gray > 80, "{red} and {gray}");
        let (red, gray) = pixels(|at| at + Vec3::new(9.0, 0.0, 0.0));
        assert!(
            gray > 100 && gray.abs_diff(red) < gray / 5,
            "{red} and {gray}"
        );
        // What is near covers the exact one.
        let (red, gray) = pixels(|at| 1.2 * at - 0.1);
        assert!(red > 10_000 && gray == 0, "{red} and {gray}");
    }

    #[test]
    fn colors_of_errors_get_darker_all_the_way() {
        let light = |error: f32| -> u32 {
            let [r, g, b] = error_color(error).map(u32::from);
            2 * r + 7 * g + b
        };
        let lights: Vec<u32> = (0..=30).map(|step| light(step as f32 * 0.01)).collect();
        assert!(lights.is_sorted_by(|a, b| a >= b), "{lights:?}");
        assert!(lights[0] > 2 * lights[30]);
    }
}
