//! `editor completions` and `editor man`.

use super::{editor_in, folder};
use std::process::Command;

/// Names of the commands that the help lists.
fn commands() -> Vec<String> {
    let help = editor_in(folder().path(), &["--help"]).out;
    let list = help.split("Commands:\n").nth(1).unwrap();
    let lines = list.lines().take_while(|line| !line.is_empty());
    // What is further to the right goes on with the line before.
    let names = lines.filter(|line| !line.starts_with("   "));
    names
        .map(|line| line.split_whitespace().next().unwrap().to_owned())
        .collect()
}

#[test]
fn completions_of_every_shell_know_every_command_and_a_shell_that_is_not_known_is_wrong_usage() {
    let (folder, commands) = (folder(), commands());
    assert!(commands.len() > 7, "{commands:?}");
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let ran = editor_in(folder.path(), &["completions", shell]);
        assert_eq!((ran.code, &*ran.err), (Some(0), ""), "{shell}");
        for command in &commands {
            assert!(ran.out.contains(&**command), "{shell}: {command}");
        }
    }
    let ran = editor_in(folder.path(), &["completions", "tcsh"]);
    assert_eq!((ran.code, &*ran.out), (Some(2), ""));
}

#[cfg(target_os = "linux")]
#[test]
fn bash_completes_the_beginning_of_a_command() {
    let folder = folder();
    let script = editor_in(folder.path(), &["completions", "bash"]).out;
    let script = script
        + "COMP_WORDS=(editor subm); COMP_CWORD=1; _editor editor subm editor; echo ${COMPREPLY[@]}";
    let shell = Command::new("bash").args(["-c", &script]).output().unwrap();
    assert_eq!(String::from_utf8_lossy(&shell.stdout), "submit\n");
}

#[test]
fn a_page_of_man_describes_every_option_that_the_help_does() {
    let folder = folder();
    for command in commands() {
        if command == "help" {
            continue;
        }
        let help = editor_in(folder.path(), &[&command, "--help"]).out;
        let ran = editor_in(folder.path(), &["man", &command]);
        assert_eq!((ran.code, &*ran.err), (Some(0), ""), "{command}");
        assert!(ran.out.contains(&format!(".TH editor-{command} 1")));
        // A hyphen has a backslash before it in such pages.
        let page = ran.out.replace("\\-", "-");
        let options = help.lines().filter_map(|line| {
            let line = line.trim_start();
            let is_option = line.starts_with('-') && !line.starts_with("- ");
            is_option.then(|| line.split_whitespace().find(|word| word.starts_with("--")))?
        });
        let options: Vec<&str> = options.collect();
        assert!(options.contains(&"--help"), "{help}");
        for option in options {
            assert!(page.contains(option), "{command} {option}");
        }
    }
    let page = editor_in(folder.path(), &["man", "diagnose"]).out;
    let page = page
        .replace("\\-", "-")
        .replace("\\fR", "")
        .replace("\\fB", "");
    let synopsis = "editor diagnose [OPTIONS] --character <MODEL> --pose <POSE.json> <THEIRS>";
    let sections = page
        .split(".SH ")
        .map(|section| section.split_once('\n').unwrap_or_default());
    let sections: Vec<(&str, &str)> = sections.collect();
    let text = |name: &str| {
        let section = sections.iter().find(|(title, _)| *title == name);
        section.unwrap_or_else(|| panic!("no {name} in {page}")).1
    };
    assert!(text("SYNOPSIS").contains(synopsis), "{}", text("SYNOPSIS"));
    assert!(
        text("EXAMPLES")
            .trim_start()
            .starts_with("editor diagnose mine.obj"),
        "{page}"
    );
    let page = editor_in(folder.path(), &["man"]).out.replace("\\-", "-");
    for command in commands() {
        assert!(page.contains(&format!("editor-{command}(1)")), "{command}");
    }
    let ran = editor_in(folder.path(), &["man", "frobnicate"]);
    assert_eq!((ran.code, &*ran.out), (Some(2), ""));
}
