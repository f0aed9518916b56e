use egui::{Rect, Vec2, pos2, vec2};

/// Height of the line of text above a picture, in points.
pub(super) const CAPTION: f32 = 20.0;
/// Between two pictures, and around them where there is room, in points.
const GAP: f32 = 8.0;

/// A picture of `size` pixels in the middle of `area` (points), as large as fits. Where it can
/// be shown pixel by pixel or larger it is, in whole pixels of the screen.
fn fitted(area: Rect, size: Vec2, pixels_per_point: f32) -> Rect {
    let size = size.max(Vec2::splat(1.0));
    let room = area.size() * pixels_per_point;
    let scale = (room.x / size.x).min(room.y / size.y);
    let scale = if scale >= 1.0 {
        scale.floor()
    } else {
        scale.max(1.0 / size.max_elem())
    };
    let shown = size * (scale / pixels_per_point);
    let free = (area.size() - shown).max(Vec2::ZERO) * 0.5;
    let whole = |points: f32| (points * pixels_per_point).round() / pixels_per_point;
    let corner = area.min + free;
    Rect::from_min_size(pos2(whole(corner.x), whole(corner.y)), shown)
}

fn below_caption(area: Rect) -> Rect {
    let top = (area.top() + CAPTION).min(area.bottom());
    Rect::from_min_max(pos2(area.left(), top), area.max)
}

/// Where one picture with a caption above it is shown.
pub(super) fn one(area: Rect, size: Vec2, pixels_per_point: f32) -> Rect {
    fitted(below_caption(area), size, pixels_per_point)
}

/// Where two pictures of the same size are shown, each with a caption above it: side by side, or
/// one above the other where they can be clearly larger so.
pub(super) fn two(area: Rect, size: Vec2, pixels_per_point: f32) -> [Rect; 2] {
    let area = area.shrink(GAP.min(area.size().min_elem().max(0.0) * 0.1));
    let beside = halves(area, vec2(1.0, 0.0)).map(|half| one(half, size, pixels_per_point));
    let above = halves(area, vec2(0.0, 1.0)).map(|half| one(half, size, pixels_per_point));
    if above[0].width() > 1.25 * beside[0].width() {
        above
    } else {
        beside
    }
}

/// The parts of `area` that are left of each other (`along` = +x) or above (`along` = +y).
fn halves(area: Rect, along: Vec2) -> [Rect; 2] {
    let gap = along * GAP;
    let size = (area.size() - (area.size() + gap) * along * 0.5).max(Vec2::ZERO);
    let second = area.min + along * (size + gap);
    [area.min, second].map(|corner| Rect::from_min_size(corner, size))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn area(width: f32, height: f32) -> Rect {
        Rect::from_min_size(pos2(10.0, 30.0), vec2(width, height))
    }

    const COURSE: Vec2 = vec2(800.0, 600.0);

    #[test]
    fn a_picture_that_fits_is_shown_pixel_by_pixel_in_the_middle() {
        let rect = fitted(area(1000.0, 650.0), COURSE, 1.0);
        assert_eq!(rect.size(), COURSE);
        assert_eq!(rect.min, pos2(110.0, 55.0));
        assert_eq!(
            fitted(area(1700.0, 1200.0), COURSE, 1.0).size(),
            COURSE * 2.0
        );
    }

    #[test]
    fn on_a_fine_screen_a_pixel_of_the_picture_is_a_whole_number_of_its_pixels() {
        let rect = fitted(area(1000.0, 650.0), COURSE, 1.5);
        // A corner is kept, not a size: rounded to what a number of points can hold.
        let close = |a: Vec2, b: Vec2| (a - b).abs().max_elem() < 1e-3;
        assert!(close(rect.size() * 1.5, COURSE), "{rect}");
        let corner = rect.min.to_vec2() * 1.5;
        assert!(close(corner, corner.round()), "{rect}");
    }

    #[test]
    fn a_picture_that_does_not_fit_keeps_its_shape_inside_of_the_area() {
        for (width, height) in [(500.0, 700.0), (900.0, 200.0), (60.0, 20.0)] {
            let area = area(width, height);
            let rect = fitted(area, COURSE, 1.0);
            assert!(
                area.expand(1.0).contains_rect(rect),
                "{rect} is not in {area}"
            );
            assert!((rect.aspect_ratio() - 4.0 / 3.0).abs() < 1e-4, "{rect}");
        }
        assert!(fitted(area(0.0, 0.0), COURSE, 1.0).is_positive());
        assert!(fitted(area(10.0, 10.0), Vec2::ZERO, 1.0).is_positive());
    }

    #[test]
    fn two_pictures_stand_side_by_side_or_above_each_other_and_never_overlap() {
        let [a, b] = two(area(1000.0, 600.0), COURSE, 1.0);
        assert_eq!(a.size(), b.size());
        assert!(a.right() + GAP <= b.left() + 1.0 && a.top() == b.top());
        assert!(a.top() >= area(1000.0, 600.0).top() + CAPTION);
        let [a, b] = two(area(400.0, 900.0), COURSE, 1.0);
        assert_eq!(a.size(), b.size());
        assert!(a.bottom() + CAPTION <= b.top() && a.left() == b.left());
    }
}
