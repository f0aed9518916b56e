//! What kind of file has some bytes, for those that come without a name.

use super::image::is_picture;

/// The extension of a file with `bytes`, of all that the program reads: `png` for any picture, which says itself of
/// which format it is, and `obj` for what is nothing else.
pub fn extension_of(bytes: &[u8]) -> &'static str {
    if is_picture(bytes) {
        return "png";
    }
    if bytes.starts_with(b"PK\x03\x04") {
        return "zip";
    }
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let text = bytes.trim_ascii_start();
    let has = |word: &[u8]| text.windows(word.len()).any(|part| part == word);
    let first_word = text.split(u8::is_ascii_whitespace).next();
    match text.first() {
        // Poses have neither.
        Some(b'{') if has(b"\"shapes\"") || has(b"\"editor-scene\"") => "scene",
        Some(b'{') => "json",
        Some(b'<') => "dae",
        _ if matches!(
            first_word,
            Some(b"bez2" | b"bez3" | b"bsp2" | b"bsp3" | b"circ")
        ) =>
        {
            "swp"
        }
        _ => "obj",
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::io::builtin::{BuiltinKind, catalogue, resolve};
    use crate::io::{Files, builtin::WithBuiltin};
    use std::collections::HashMap;

    #[test]
    fn whatever_is_built_in_is_known_by_its_bytes() {
        let files = WithBuiltin(HashMap::new());
        let all = catalogue();
        assert!(all.iter().any(|it| it.kind == BuiltinKind::Character));
        for builtin in all {
            let path = format!("builtin:{}", builtin.name);
            let path = resolve(path.as_ref()).unwrap();
            let found = extension_of(&files.read(&path).unwrap());
            assert_eq!(path.extension().unwrap(), found, "{}", path.display());
        }
    }

    #[test]
    fn what_begins_with_space_or_a_mark_or_is_no_file_of_ours_is_known_too() {
        for (bytes, expected) in [
            (&b"\xef\xbb\xbf\n {\"joints\": {}}"[..], "json"),
            (b"\xff\xd8\xff\xe0", "png"),
            (b"GIF89a", "png"),
            (b"PK\x03\x04", "zip"),
            (b"# made by hand\nv 0 0 0\n", "obj"),
            (b"", "obj"),
        ] {
            assert_eq!(extension_of(bytes), expected, "{bytes:?}");
        }
    }
}
