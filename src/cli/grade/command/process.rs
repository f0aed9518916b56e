//! A process and all that it starts, which are a group and end together.

use super::CommandFailure;
use crate::cli::grade::interruption::Interruption;
use crate::disk::in_words;
use crate::io::CommandData;
use signal_hook::consts;
use std::io::{ErrorKind, Read};
use std::os::unix::process::ExitStatusExt;
use std::path::Path;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};

/// Time between two looks at a process: short at first, since most end soon.
const FIRST_PAUSE: Duration = Duration::from_millis(1);
const LONGEST_PAUSE: Duration = Duration::from_millis(20);
/// Time that is waited for the rest of what a process that has ended printed.
const PATIENCE: Duration = Duration::from_secs(1);
/// As much of the end of the errors that a command prints is told, in bytes.
const TOLD: usize = 400;

/// Runs the program and arguments `words` in `folder` within the limits of `data`.
pub(super) fn run(
    data: &CommandData,
    words: &[String],
    folder: &Path,
    interruption: &Interruption,
) -> Result<(), CommandFailure> {
    let (name, arguments) = words
        .split_first()
        .map_or(("", words), |(name, rest)| (&**name, rest));
    // One that is named by a path is the submission's.
    let program = if name.contains('/') {
        folder.join(name)
    } else {
        name.into()
    };
    let mut command = Command::new(&program);
    command.args(arguments).current_dir(folder);
    command.stdin(Stdio::null()).stdout(Stdio::null());
    let started = interruption.start(command.stderr(Stdio::piped()));
    let mut child = started.map_err(|error| match error.kind() {
        ErrorKind::NotFound => CommandFailure::Missing(format!("there is no program {name}")),
        ErrorKind::PermissionDenied if program.is_file() => CommandFailure::Failed(format!(
            "{name} cannot be started: it is not executable (chmod +x)"
        )),
        _ => CommandFailure::Failed(format!("{name} cannot be started: {}", in_words(&error))),
    })?;
    let printed = read_on(child.stderr.take());
    let ended = wait(&mut child, data, interruption);
    interruption.end(&child);
    let status = match ended {
        Ok(status) => status,
        Err(failure) => {
            // It has been killed, so that it ends at once.
            let _ = child.wait();
            return Err(failure);
        }
    };
    if status.success() {
        return Ok(());
    }
    let printed = printed.recv_timeout(PATIENCE).unwrap_or_default();
    let how = match (status.code(), status.signal()) {
        (Some(code), _) => format!("the command ended with exit code {code}"),
        (None, Some(signal)) => format!("the command crashed with {}", signal_name(signal)),
        (None, None) => "the command ended abnormally".to_owned(),
    };
    Err(CommandFailure::Failed(match &*told(&printed) {
        "" => how,
        text => format!("{how}:\n{text}"),
    }))
}

/// The end of what a command printed as text; of one that is cut off without the line in which it begins, unless that is
/// most of it.
fn told(printed: &[u8]) -> String {
    let is_cut = printed.len() > TOLD;
    // A cut may go through a character.
    let is_first = |byte: &u8| byte & 0xc0 != 0x80;
    let first = printed.iter().position(is_first).unwrap_or(0);
    let text = String::from_utf8_lossy(&printed[first..]);
    let text = text.trim();
    match text.split_once('\n') {
        _ if !is_cut => text.to_owned(),
        Some((_, lines)) if lines.len() >= TOLD / 2 => format!("…\n{lines}"),
        _ => format!("…{text}"),
    }
}

fn wait(
    child: &mut Child,
    data: &CommandData,
    interruption: &Interruption,
) -> Result<ExitStatus, CommandFailure> {
    let (started, mut pause) = (Instant::now(), FIRST_PAUSE);
    loop {
        match child.try_wait() {
            Ok(Some(status)) => return Ok(status),
            Ok(None) => {}
            Err(error) => return Err(CommandFailure::Failed(in_words(&error))),
        }
        if interruption.is_asked() {
            return Err(CommandFailure::Interrupted);
        }
        if started.elapsed().as_secs_f64() > f64::from(data.seconds) {
            let text = format!("the command did not end within {} s", data.seconds);
            return Err(CommandFailure::Failed(text));
        }
        if memory_of_group(child.id()) > f64::from(data.memory) {
            let text = format!("the command took more than {} MiB of memory", data.memory);
            return Err(CommandFailure::Failed(text));
        }
        std::thread::sleep(pause);
        pause = (pause * 2).min(LONGEST_PAUSE);
    }
}

/// Reads what a process prints for as long as it does, so that it never waits for a reader, and gives
/// the end, where most programs say what is wrong.
fn read_on(mut pipe: Option<impl Read + Send + 'static>) -> Receiver<Vec<u8>> {
    let (send, receive) = channel();
    // What left the group keeps the pipe open: the thread waits for it, and nobody for the thread.
    std::thread::spawn(move || {
        let mut last = Vec::new();
        let mut piece = [0; 4096];
        // What cannot be read is not told.
        while let Some(pipe) = &mut pipe {
            match pipe.read(&mut piece) {
                Ok(count @ 1..) => last.extend_from_slice(&piece[..count]),
                Err(error) if error.kind() == ErrorKind::Interrupted => {}
                _ => break,
            }
            // One byte more tells that it is cut off.
            last.drain(..last.len().saturating_sub(TOLD + 1));
        }
        // Nobody may be waiting for it any more.
        let _ = send.send(last);
    });
    receive
}

fn signal_name(signal: i32) -> String {
    let name = match signal {
        consts::SIGABRT => "SIGABRT",
        consts::SIGBUS => "SIGBUS",
        consts::SIGFPE => "SIGFPE",
        consts::SIGILL => "SIGILL",
        consts::SIGKILL => "SIGKILL",
        consts::SIGSEGV => "SIGSEGV",
        _ => return format!("signal {signal}"),
    };
    name.to_owned()
}

/// Memory that the processes of a group have, in MiB.
#[cfg(target_os = "linux")]
fn memory_of_group(group: u32) -> f64 {
    let group = group.to_string();
    let processes = std::fs::read_dir("/proc").into_iter().flatten().flatten();
    let sizes = processes.filter_map(|process| {
        let path = process.path();
        path.file_name()?.to_str()?.parse::<u32>().ok()?;
        let stat = std::fs::read_to_string(path.join("stat")).ok()?;
        // Behind the name, which may hold anything: state, parent, group.
        let (_, fields) = stat.rsplit_once(')')?;
        if fields.split_whitespace().nth(2)? != group {
            return None;
        }
        let status = std::fs::read_to_string(path.join("status")).ok()?;
        let line = status.lines().find(|line| line.starts_with("VmRSS:"))?;
        line.split_whitespace().nth(1)?.parse::<f64>().ok()
    });
    sizes.sum::<f64>() / 1024.0
}

/// Not known on this system.
#[cfg(not(target_os = "linux"))]
fn memory_of_group(_: u32) -> f64 {
    0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_a_long_text_the_end_is_told_from_the_beginning_of_a_line_on() {
        assert_eq!(told(b"  what is wrong\n"), "what is wrong");
        let whole = "a".repeat(TOLD);
        assert_eq!(told(whole.as_bytes()), whole);
        let line = format!("b{}", "b".repeat(TOLD / 2));
        let lines = format!("{}\n{line}", "a".repeat(TOLD / 2));
        assert_eq!(told(lines.as_bytes()), format!("…\n{line}"));
        // One long line, and a short one after it.
        let long = format!("{}\nnote", "a".repeat(TOLD));
        assert_eq!(told(long.as_bytes()), format!("…{long}"));
    }

    #[test]
    fn a_character_that_is_cut_through_is_left_out() {
        let text = "é".repeat(TOLD);
        assert_eq!(
            told(&text.as_bytes()[1..]),
            format!("…{}", "é".repeat(TOLD - 1))
        );
    }
}
