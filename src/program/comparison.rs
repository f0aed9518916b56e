use super::Host;
use super::edges::Edges;
use super::files::file_name;
use super::job::{CompareWork, Compared, Half, Job, JobHandle, Outcome, Work};
use super::textured::Textured;
use crate::compare::{
    Area, CompareError, Measured, Pair, PictureJob, has_smooth_edges, side_by_side,
};
use crate::geometry::{GroundColors, Picture};
use crate::render::Backdrop;
use crate::revision::Revision;
use crate::scene::{Camera, Look, Skinning, ViewSettings};
use crate::ui::{self, CompareReport, CompareSettings, CompareView};
use egui::Context;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

/// How long the view must stand still before what takes longer is measured.
const STILL: Duration = Duration::from_millis(150);
/// Time between two looks at how far the slower half has come.
const LOOK: Duration = Duration::from_millis(100);
/// Time between two looks at whether the live view has been drawn: about a frame.
pub(super) const DRAWING: Duration = Duration::from_millis(16);

/// Share of a panel that is the same in other pictures with it, whatever its fields say: most of it has one color.
const SAME_PANEL: f64 = 0.5;

/// A comparison of the live view with a picture.
pub(super) struct Comparison {
    /// Look from before it.
    pub(super) look_before: Look,
    /// Look that it began with, and the backdrop of the reference.
    pub(super) looks: (Look, Backdrop),
    /// Camera from before it, where the one of the page began it that the reference is a screenshot of.
    pub(super) camera_before: Option<Camera>,
    /// Whether panels were cut off the reference, which is a screenshot of the Virtual Mannequin's page.
    pub(super) is_cut: bool,
    /// Whether it may show the Virtual Mannequin's page, or its view alone.
    pub(super) is_page: bool,
    /// File of the reference.
    path: PathBuf,
    name: String,
    reference: Textured,
    live: Option<Textured>,
    difference: Option<Textured>,
    /// State that `live` shows: it is drawn again only when this changes.
    drawn: Option<Drawn>,
    /// State that is being drawn.
    drawing: Option<Drawn>,
    settings: CompareSettings,
    edges: Edges,
    /// Whether the reference has smooth edges, if that is clear.
    is_reference_smooth: Option<bool>,
    report: CompareReport,
    measuring: Measuring,
}

/// State that a picture of the live view follows from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Drawn {
    pub document: Revision,
    pub view: ViewSettings,
    pub smooth_edges: bool,
    pub skinning: Option<Skinning>,
}

/// How far the measuring of the two pictures has come.
#[derive(Debug, Default)]
struct Measuring {
    /// The newest state of the pictures, and when it came.
    wanted: Option<(Revision, Duration)>,
    /// The job that has not finished yet.
    running: Option<Running>,
    measured: Option<Revision>,
    judged: Option<Revision>,
}

/// A job about a state of the pictures.
#[derive(Debug)]
struct Running {
    of: Revision,
    half: Half,
    job: JobHandle,
}

impl Comparison {
    /// A comparison with the picture `reference` from the file `path`, with the settings of the
    /// comparison before it.
    pub fn new(
        path: PathBuf,
        reference: Picture,
        mut settings: CompareSettings,
        look_before: Look,
    ) -> Self {
        let size = (reference.width, reference.height);
        for mask in &mut settings.masks {
            *mask = mask.inside(size);
        }
        Self {
            look_before,
            looks: (Look::Course, Backdrop::default()),
            camera_before: None,
            is_cut: false,
            is_page: false,
            name: file_name(&path),
            path,
            is_reference_smooth: has_smooth_edges(&reference),
            reference: Textured::new(reference),
            live: None,
            difference: None,
            drawn: None,
            drawing: None,
            edges: Edges::Unknown,
            settings: CompareSettings {
                smooth_edges: false,
                ..settings
            },
            report: CompareReport::default(),
            measuring: Measuring::default(),
        }
    }

    /// File that the reference was read from.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Look that the view goes back to when the comparison ends in `look`: the one before it, unless
    /// another was chosen meanwhile.
    pub fn look_after(&self, look: Look) -> Look {
        if look == self.looks.0 {
            self.look_before
        } else {
            look
        }
    }

    /// Camera that the view goes back to when the comparison ends with `camera`: the one before it, unless it
    /// was moved meanwhile.
    pub fn camera_after(&self, camera: Camera) -> Camera {
        let before = self.camera_before;
        let is_moved = camera != Camera::of_mannequin();
        before.filter(|_| !is_moved).unwrap_or(camera)
    }

    /// Loads the textures of pictures that are new.
    pub fn load_textures(&mut self, context: &Context) {
        self.reference.load(context, "reference");
        if let Some(live) = &mut self.live {
            live.load(context, "live view");
        }
        if let Some(difference) = &mut self.difference {
            difference.load(context, "differences");
        }
    }

    /// Goes on with other graphics: all textures are loaded anew when they are shown next, and what was
    /// being drawn is drawn again.
    pub fn replace_graphics(&mut self) {
        self.drawing = None;
        let shown = [&mut self.live, &mut self.difference];
        let shown = shown.into_iter().flatten();
        for textured in shown.chain([&mut self.reference]) {
            textured.texture = None;
        }
    }

    /// As the panels show it; `None` before its textures are loaded.
    pub fn view(&self) -> Option<CompareView<'_>> {
        let difference = self.difference.as_ref().and_then(Textured::shown);
        let running = self.measuring.running.as_ref();
        let judging = running.filter(|running| running.half == Half::Judge);
        Some(CompareView {
            name: &self.name,
            look: self.looks.0,
            is_cut: self.is_cut,
            are_edges_chosen: self.edges == Edges::Chosen,
            is_reference_smooth: self.is_reference_smooth,
            settings: &self.settings,
            reference: self.reference.shown()?,
            live: self.live.as_ref().and_then(Textured::shown),
            difference: difference.map(|difference| difference.texture),
            report: &self.report,
            judged_part: judging.map(|judging| judging.job.part()),
        })
    }

    /// Brightness of what is behind the shapes.
    pub fn backdrop(&self) -> Backdrop {
        self.looks.1
    }

    /// Choices in its panel.
    pub fn settings(&self) -> &CompareSettings {
        &self.settings
    }

    /// Choices that a comparison with the picture `next` goes on with: all but masks of panels that it has not.
    pub fn settings_for(&self, next: &Picture) -> CompareSettings {
        let reference = &*self.reference.picture;
        let (size, of_next) = (self.size(), (next.width, next.height));
        let mut settings = self.settings.clone();
        let mut panels = [&ui::course_panels(size)[..], &ui::mannequin_panels(size)].concat();
        panels.retain(|panel| settings.masks.contains(panel));
        let has_same = |panel: &Area| panel.share_alike(reference, next) > SAME_PANEL;
        if size != of_next || !panels.iter().any(has_same) {
            settings.masks.retain(|mask| !panels.contains(mask));
        }
        settings
    }

    /// Width and height in pixels of the reference, and so of the live view.
    pub fn size(&self) -> (u32, u32) {
        let reference = &self.reference.picture;
        (reference.width, reference.height)
    }

    /// Takes what was chosen in the panel; what depends on it is measured anew.
    pub fn set(&mut self, settings: CompareSettings, now: Duration) {
        let measured_by = |s: &CompareSettings| (s.threshold, s.masks.clone());
        if settings.smooth_edges != self.settings.smooth_edges {
            self.edges = Edges::Chosen;
        }
        let measures_change = measured_by(&settings) != measured_by(&self.settings);
        self.settings = settings;
        if measures_change {
            self.measure(now);
        }
    }

    /// Whether the live view has to be drawn again to show `wanted`.
    pub fn needs(&self, wanted: &Drawn) -> bool {
        self.drawn.as_ref() != Some(wanted)
    }

    /// Whether the live view is being drawn.
    pub fn is_drawing(&self) -> bool {
        self.drawing.is_some()
    }

    /// Takes note that the live view is being drawn as it is in this state.
    pub fn begin_drawing(&mut self, state: Drawn) {
        self.drawing = Some(state);
    }

    /// Takes the picture of the live view that was being drawn; whether it differs from the one before.
    pub fn take_live(&mut self, picture: Picture, now: Duration) -> bool {
        self.drawn = self.drawing.take();
        let before = self.live.as_ref();
        if before.is_some_and(|live| *live.picture == picture) {
            return false;
        }
        self.live = Some(Textured::new(picture));
        self.measure(now);
        true
    }

    /// What `editor compare -o` writes; `None` before the view has been drawn.
    pub fn picture(&self) -> Option<Result<Picture, CompareError>> {
        let live = self.live.as_ref()?;
        let (a, b) = (&*self.reference.picture, &*live.picture);
        let pair = Pair::new(a, b, &self.settings.masks);
        Some(pair.map(|pair| side_by_side(&[a, b, &pair.heat_map()])))
    }

    /// The pictures are to be measured as they are now. What is judged of their state before is given
    /// up; the quicker half comes to its end, so that something is to be seen while they change.
    fn measure(&mut self, now: Duration) {
        if self.live.is_some() {
            self.report.measuring = true;
            self.measuring.wanted = Some((Revision::new(), now));
            let running = &mut self.measuring.running;
            running.take_if(|running| running.half == Half::Judge);
        }
    }

    /// Starts the next job if there is one to start. Returns how long nothing needs to be started
    /// unless something changes.
    pub fn advance(&mut self, host: &mut dyn Host) -> Option<Duration> {
        let (wanted, since) = self.measuring.wanted?;
        if let Some(running) = &self.measuring.running {
            return (running.half == Half::Judge).then_some(LOOK);
        }
        if self.measuring.judged == Some(wanted) {
            return None;
        }
        let half = if self.measuring.measured == Some(wanted) {
            let still_for = host.now().saturating_sub(since);
            if still_for < STILL {
                return Some(STILL - still_for);
            }
            Half::Judge
        } else {
            Half::Measure
        };
        let live = Arc::clone(&self.live.as_ref()?.picture);
        let job = Job::new(Work::Compare(CompareWork {
            of: wanted,
            half,
            is_page: self.is_page,
            are_edges_alike: self
                .is_reference_smooth
                .is_none_or(|is_smooth| is_smooth == self.settings.smooth_edges),
            pictures: PictureJob {
                a: Arc::clone(&self.reference.picture),
                b: live,
                threshold: self.settings.threshold,
                ignore: self.settings.masks.clone(),
                ground: self.ground(),
            },
        }));
        self.measuring.running = Some(Running {
            of: wanted,
            half,
            job: job.handle(),
        });
        host.start_job(job);
        (half == Half::Judge).then_some(LOOK)
    }

    /// What the figures stand on in the live view, if its look has a ground.
    fn ground(&self) -> Option<GroundColors> {
        let drawn = self.drawn.as_ref()?;
        (drawn.view.look == Look::Studio).then(|| self.looks.1.ground())
    }

    /// Chooses the edges of the live view, of whose pixels so many differ as it is drawn now.
    fn choose_edges(&mut self, differing: u64) {
        let told = self.edges.tell(differing);
        self.is_reference_smooth = self.is_reference_smooth.or(told);
        if let Some(found) = self.edges.after(
            differing,
            self.settings.smooth_edges,
            self.is_reference_smooth,
        ) {
            (self.edges, self.settings.smooth_edges) = found;
        }
    }

    /// Takes in the result of a job. That of an earlier comparison is ignored.
    pub fn take_result(&mut self, result: Compared) {
        let running = &mut self.measuring.running;
        if running.take_if(|running| running.of == result.of).is_none() {
            return;
        }
        let is_newest = self.measuring.wanted.is_some_and(|(of, _)| of == result.of);
        match result.outcome {
            Ok(Outcome::Measured(Measured {
                differences,
                heat_map,
            })) => {
                self.measuring.measured = Some(result.of);
                if is_newest {
                    self.choose_edges(differences.differing_pixels);
                }
                self.difference = Some(Textured::new(heat_map));
                self.report.differences = Some(differences);
                self.report.problem = None;
            }
            Ok(Outcome::Judged {
                judgment,
                page_figure,
            }) => {
                self.report.page_figure = page_figure;
                self.measuring.judged = Some(result.of);
                self.report.judgment = Some(judgment);
                self.report.measuring = !is_newest;
            }
            Err(problem) => {
                self.measuring.judged = Some(result.of);
                self.report.problem = Some(problem);
                self.report.differences = None;
                self.report.judgment = None;
                self.report.measuring = !is_newest;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compare::Area;

    #[test]
    fn the_edges_that_leave_fewer_differences_are_kept_unless_the_user_has_chosen() {
        for (hard, smooth, kept) in [
            (0, None, false),
            (90, Some(91), false),
            (90, Some(89), true),
        ] {
            let picture = Picture {
                width: 1,
                height: 1,
                rgba: vec![0; 4],
            };
            let settings = CompareSettings::default();
            let mut comparison = Comparison::new("a.png".into(), picture, settings, Look::Course);
            comparison.choose_edges(hard);
            assert_eq!(comparison.settings.smooth_edges, smooth.is_some());
            comparison.choose_edges(smooth.unwrap_or(0));
            assert_eq!(comparison.settings.smooth_edges, kept);
            let chosen = CompareSettings {
                smooth_edges: !kept,
                ..CompareSettings::default()
            };
            comparison.set(chosen, Duration::ZERO);
            comparison.choose_edges(5);
            assert_eq!(comparison.settings.smooth_edges, !kept);
        }
    }

    #[test]
    fn what_is_left_out_goes_on_with_another_picture_as_far_as_it_is_inside() {
        let area = |x, y, width, height| Area {
            x,
            y,
            width,
            height,
        };
        let settings = CompareSettings {
            masks: vec![area(1, 0, 2, 1), area(3, 1, 50, 40), area(90, 90, 5, 5)],
            ..CompareSettings::default()
        };
        let picture = Picture {
            width: 5,
            height: 4,
            rgba: vec![0; 4 * 5 * 4],
        };
        let comparison = Comparison::new("a.png".into(), picture, settings, Look::Course);
        let inside = [area(1, 0, 2, 1), area(3, 1, 2, 3), area(4, 3, 1, 1)];
        assert_eq!(comparison.settings().masks, inside);
    }
}
