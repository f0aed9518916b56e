//! Runs that take minutes: `make test-long`.

use crate::program::submit::ANSWERS;
use crate::stories::{STRIP, Story};
use editor_core::editor::{Edit, View};
use editor_core::gpu::HeadlessContext;
use editor_core::math::{Euler, Transform};
use editor_core::scene::{IkSettings, Scene, ShapeId};
use editor_core::ui::{Action, Answer, Ask, GestureStep, HistoryMove, Primitive};
use editor_core::{disk, scene::NewShape};
use glam::Vec3;
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Command as Process, Stdio};
use std::time::Duration;

/// Numbers that look random and are the same in each run.
struct Dice(u64);

impl Dice {
    /// A number below `sides`.
    fn roll(&mut self, sides: usize) -> usize {
        // Knuth's MMIX; the upper bits are the better ones.
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005);
        self.0 = self.0.wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % sides
    }

    /// A number from -2 to 2.
    fn number(&mut self) -> f32 {
        self.roll(4001) as f32 / 1000.0 - 2.0
    }

    fn vector(&mut self) -> Vec3 {
        Vec3::new(self.number(), self.number(), self.number())
    }
}

/// Most shapes in a document: then some are deleted.
const MOST_SHAPES: usize = 12;

/// An edit of a shape of the document, or of none if there is none.
fn edit(story: &Story, dice: &mut Dice) -> Edit {
    let shapes = story.program.session().scene().shapes();
    let Some(shape) = shapes.get(dice.roll(shapes.len().max(1))) else {
        return insertion(dice);
    };
    let id = shape.id;
    if shapes.len() > MOST_SHAPES {
        return Edit::Delete(id);
    }
    match dice.roll(16) {
        0 => insertion(dice),
        1 => Edit::Delete(id),
        2 => Edit::SetTransform(
            id,
            Transform {
                position: dice.vector(),
                rotation: Euler::from_degrees(dice.vector() * 90.0),
                scale: Vec3::splat(1.0 + dice.number().abs()),
            },
        ),
        3 => Edit::SetVisible(id, dice.roll(2) == 0),
        4 => Edit::Rename(id, format!("Shape {}", dice.roll(100))),
        5 => Edit::MoveInList(id, dice.roll(MOST_SHAPES)),
        6 => Edit::KeepPose {
            shape: id,
            name: format!("Pose {}", dice.roll(5)),
        },
        7 => Edit::ForgetPose(id, dice.roll(3)),
        8 => Edit::SetIk(
            id,
            IkSettings {
                length: 1 + dice.roll(5),
                pins: [dice.roll(3)].into(),
                ..IkSettings::default()
            },
        ),
        9 => Edit::Reset(id),
        10 => Edit::SetControlPoint {
            shape: id,
            curve: 0,
            point: dice.roll(4),
            position: dice.vector(),
        },
        11 => Edit::SetUniformScaling(id, dice.roll(2) == 0),
        12 => Edit::ResetPose(id),
        13 => Edit::UnpinAll(id),
        _ => Edit::SetJointTransform {
            shape: id,
            joint: dice.roll(3),
            rotation: Euler::from_degrees(dice.vector() * 90.0),
        },
    }
}

fn insertion(dice: &mut Dice) -> Edit {
    let kinds = [
        Primitive::Cube,
        Primitive::Teapot,
        Primitive::BezierCurve,
        Primitive::Circle,
    ];
    let kind = kinds[dice.roll(kinds.len())].kind();
    Edit::Insert(vec![NewShape::new("New", kind)])
}

/// One thing that a user does.
fn deed(story: &mut Story, dice: &mut Dice) {
    let selected = |story: &Story| story.program.session().selected();
    let character = selected(story).unwrap_or(ShapeId(1));
    let actions = match dice.roll(24) {
        0 => vec![Action::History(HistoryMove::Undo)],
        1 => vec![Action::History(HistoryMove::Redo)],
        2 => {
            let steps = story.program.session().steps().len();
            vec![Action::History(HistoryMove::GoTo(dice.roll(steps + 1)))]
        }
        3 => {
            let end = [GestureStep::Commit, GestureStep::Cancel][dice.roll(2)];
            let edits = (0..dice.roll(4)).map(|_| Action::Edit(edit(story, dice)));
            let edits: Vec<Action> = edits.collect();
            let begin = Action::Gesture(GestureStep::Begin);
            let ends = [Action::Gesture(end)];
            std::iter::once(begin).chain(edits).chain(ends).collect()
        }
        4 => vec![Action::Ask(Ask::Save)],
        5 => vec![Action::Ask(Ask::SaveAs)],
        6 => vec![Action::Ask(Ask::Open)],
        7 => vec![Action::Ask(Ask::ImportCharacter)],
        8 => vec![Action::Ask(Ask::InsertBuiltin("robot"))],
        9 => vec![Action::Ask(Ask::ExportGeometry)],
        10 => vec![Action::Ask(Ask::CopyPose {
            shape: character,
            joints: Vec::new(),
        })],
        11 => vec![Action::Ask(Ask::PastePose(character))],
        12 if dice.roll(20) == 0 => vec![Action::Ask(Ask::New)],
        13 => {
            let shapes = story.program.session().scene().shapes();
            let shape = shapes.get(dice.roll(MOST_SHAPES)).map(|shape| shape.id);
            vec![Action::View(View::Select(shape))]
        }
        _ => vec![Action::Edit(edit(story, dice))],
    };
    let requests = story.host.requests.len();
    story.program.carry_out(actions, &mut story.host);
    if story.host.requests.len() > requests {
        let broken = dice.roll(6) == 0;
        let path = match story
            .host
            .requests
            .last()
            .expect("a request")
            .purpose
            .title()
        {
            "Export Geometry of All Shapes" => "out.obj",
            "Save As" => ["a.scene", "b.scene"][dice.roll(2)],
            "Open" if broken => "broken.scene",
            "Open" => ["a.scene", "b.scene"][dice.roll(2)],
            _ if broken => "broken.obj",
            _ => STRIP[0].0,
        };
        story.host.choose(path);
    }
    // Unsaved work is sometimes wanted, and sometimes not.
    let answers = [
        Answer::Save,
        Answer::Discard,
        Answer::Cancel,
        Answer::Overwrite,
    ];
    let answer = Action::Ask(Ask::Answer(answers[dice.roll(answers.len())]));
    story.program.carry_out(vec![answer], &mut story.host);
}

/// Memory of this process, in KiB.
fn memory() -> usize {
    let status = std::fs::read_to_string("/proc/self/status").expect("Linux tells it");
    let line = status.lines().find(|line| line.starts_with("VmRSS:"));
    let number = line.and_then(|line| line.split_whitespace().nth(1)?.parse().ok());
    number.expect("a number of KiB")
}

/// Objects of OpenGL that exist: buffers, textures, framebuffers, renderbuffers and programs.
fn objects(headless: &HeadlessContext) -> usize {
    use glow::HasContext;
    use std::num::NonZeroU32;
    let count = |glow: &glow::Context| {
        let exists = |name: NonZeroU32| {
            // SAFETY: questions about a name change nothing, whatever it is.
            let found = unsafe {
                [
                    glow.is_buffer(glow::NativeBuffer(name)),
                    glow.is_texture(glow::NativeTexture(name)),
                    glow.is_framebuffer(glow::NativeFramebuffer(name)),
                    glow.is_renderbuffer(glow::NativeRenderbuffer(name)),
                    glow.is_program(glow::NativeProgram(name)),
                ]
            };
            found.into_iter().filter(|&found| found).count()
        };
        (1..20_000).filter_map(NonZeroU32::new).map(exists).sum()
    };
    headless.gl().with_glow(count).expect("a context")
}

#[test]
#[ignore = "takes minutes: make test-long"]
fn ten_thousand_commands_and_files_leave_no_memory_and_no_object_behind_and_are_undone() {
    let mut story = Story::start(&[]);
    let broken = b"v 0 0 0\nf 1 2 3\n".to_vec();
    story.host.files.insert("broken.obj".into(), broken);
    story
        .host
        .files
        .insert("broken.scene".into(), b"{".to_vec());
    let mut dice = Dice(1);
    let mut used = Vec::new();
    for count in 1..=10_000 {
        deed(&mut story, &mut dice);
        // Requests and messages are kept by the test's host alone.
        story.host.requests.clear();
        story.host.time += Duration::from_millis(40);
        if count % 20 == 0 {
            story.frame(Vec::new());
        }
        if count % 500 == 0 {
            used.push((memory(), objects(&story.headless)));
        }
    }
    eprintln!("KiB and objects of OpenGL after each 500: {used:?}");
    let most = |part: &[(usize, usize)]| {
        let memory = part.iter().map(|(memory, _)| *memory).max();
        let objects = part.iter().map(|(_, objects)| *objects).max();
        (memory.unwrap_or_default(), objects.unwrap_or_default())
    };
    let (first, second) = (most(&used[2..10]), most(&used[10..]));
    let grown = (
        second.0 as f64 / first.0 as f64,
        second.1 as f64 / first.1 as f64,
    );
    assert!(grown.0 < 1.1, "memory grew by {grown:?}");
    assert!(grown.1 < 1.5, "objects of OpenGL grew by {grown:?}");

    story
        .program
        .carry_out(vec![Action::Ask(Ask::New)], &mut story.host);
    let discard = Action::Ask(Ask::Answer(Answer::Discard));
    story.program.carry_out(vec![discard], &mut story.host);
    let first: Scene = story.program.session().scene().clone();
    for count in 0..150 {
        // The last document has shapes, whatever was deleted before.
        let edit = if count < 148 {
            edit(&story, &mut dice)
        } else {
            insertion(&mut dice)
        };
        story
            .program
            .carry_out(vec![Action::Edit(edit)], &mut story.host);
    }
    let last = story.program.session().scene().clone();
    assert!(last.shapes().len() > 1);
    let all = |back| vec![Action::History(back); 200];
    story
        .program
        .carry_out(all(HistoryMove::Undo), &mut story.host);
    assert_eq!(story.program.session().scene(), &first);
    story
        .program
        .carry_out(all(HistoryMove::Redo), &mut story.host);
    assert_eq!(story.program.session().scene(), &last);

    story
        .program
        .carry_out(vec![Action::Ask(Ask::New)], &mut story.host);
    let Story {
        graphics, headless, ..
    } = story;
    drop(graphics);
    assert_eq!(objects(&headless), 0, "objects of OpenGL are left");
}

/// Where the child of the next test writes.
const TARGET: &str = "EDITOR_TEST_SAVES_TO";

/// Text of a saved document, number `version`, long enough to take a moment.
fn version(version: usize) -> Vec<u8> {
    format!("{version:06}\n").repeat(20_000).into_bytes()
}

/// Whether a file is one version, all of it.
fn is_whole(path: &Path) -> bool {
    let bytes = std::fs::read(path).expect("there is a file");
    let first: usize = std::str::from_utf8(&bytes[..6]).unwrap().parse().unwrap();
    bytes == version(first)
}

#[test]
#[ignore = "is the child of another test"]
fn child_that_saves_without_an_end() {
    let Ok(target) = std::env::var(TARGET) else {
        return;
    };
    let target = PathBuf::from(target);
    for number in 0.. {
        let files = [(target.clone(), version(number))];
        disk::write_all_keeping(&files, &|_, _| false).expect("a saved file");
        if number == 0 {
            println!("saving");
        }
    }
}

#[test]
#[ignore = "takes minutes: make test-long"]
fn killed_a_thousand_times_while_saving_the_file_is_the_old_one_or_the_new_one() {
    let folder = tempfile::tempdir().expect("a folder");
    let target = folder.path().join("work.scene");
    let mut dice = Dice(7);
    for round in 0..1000 {
        let mut child = Process::new(std::env::current_exe().expect("this program"))
            .args(["--exact", "--ignored", "--nocapture"])
            .arg("long::child_that_saves_without_an_end")
            .env(TARGET, &target)
            .stdout(Stdio::piped())
            .spawn()
            .expect("the child starts");
        let stdout = child.stdout.take().expect("its output");
        let mut lines = BufReader::new(stdout).lines();
        lines.find(|line| line.as_ref().is_ok_and(|line| line.contains("saving")));
        std::thread::sleep(Duration::from_micros(dice.roll(20_000) as u64));
        child.kill().expect("it was killed");
        child.wait().expect("it ended");
        assert!(is_whole(&target), "round {round}");
        let beside = folder.path().join("work.scene~");
        assert!(!beside.exists() || is_whole(&beside), "round {round}");
    }
    // What the killed ones left behind goes with the next save.
    disk::write_whole(&target, b"done").expect("a saved file");
    let left = std::fs::read_dir(folder.path()).expect("a list").count();
    assert!(left <= 2, "{left} files are left");
}

/// Where what is handed in is built, apart from our own, and kept from run to run.
const BUILT_THERE: &str = concat!(env!("CARGO_TARGET_TMPDIR"), "/handed-in");

#[test]
#[ignore = "takes minutes: make test-long"]
fn what_is_handed_in_builds_elsewhere_without_a_network_and_draws_the_same_picture() {
    let folder = tempfile::tempdir().expect("a folder");
    let place = |name: &str| folder.path().join(name);
    std::fs::write(place("answers.md"), ANSWERS).expect("a file");
    let run = |program: &Path, folder: &Path, line: &str| {
        let done = Process::new(program)
            .args(line.split(' '))
            .current_dir(folder)
            .env("CARGO_TARGET_DIR", BUILT_THERE)
            .status();
        assert!(done.expect("it starts").success(), "{line}");
    };
    let project = env!("CARGO_MANIFEST_DIR");
    let line = format!(
        "submit --project {project} --scene builtin:showcase --answers answers.md -o in.tar.gz"
    );
    let editor = Path::new(env!("CARGO_BIN_EXE_editor"));
    run(editor, folder.path(), &line);
    run(Path::new("tar"), folder.path(), "xzf in.tar.gz");
    let unpacked = place("in");
    run(
        Path::new(env!("CARGO")),
        &unpacked,
        "build --locked --offline",
    );
    let built = format!("{BUILT_THERE}/debug/editor{}", std::env::consts::EXE_SUFFIX);
    let handed_in = unpacked
        .join("editor")
        .with_extension(std::env::consts::EXE_EXTENSION);
    let line = "render data/showcase.zip --size 1280x960 --samples 4 -o drawn.png";
    for program in [handed_in.as_path(), Path::new(&built)] {
        run(program, &unpacked, line);
        let picture = |name: &str| std::fs::read(unpacked.join(name)).expect("a picture");
        assert!(
            picture("drawn.png") == picture("picture.png"),
            "{program:?}"
        );
        std::fs::remove_file(unpacked.join("drawn.png")).expect("it was there");
    }
}
