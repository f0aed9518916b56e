//! Scenes in links: the text of a scene, compressed, in letters that addresses may have.

use base64::Engine as _;
use base64::engine::general_purpose::URL_SAFE_NO_PAD;
use flate2::Compression;
use flate2::read::DeflateDecoder;
use flate2::write::DeflateEncoder;
use std::io::{Read as _, Write as _};

/// Most letters of a scene in a link: programs for mail and chats cut longer ones.
pub const MOST_LETTERS: usize = 8000;

/// Most bytes of a text that comes out of a link.
const MOST_TEXT: u64 = 4 << 20;

/// The text of a scene as it stands in a link; `None` if that would be longer than [`MOST_LETTERS`].
pub fn to_link(text: &str) -> Option<String> {
    let mut encoder = DeflateEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(text.as_bytes()).ok()?;
    let letters = URL_SAFE_NO_PAD.encode(encoder.finish().ok()?);
    (letters.len() <= MOST_LETTERS).then_some(letters)
}

/// The text of the scene in a link.
///
/// # Errors
/// If the link is not one that [`to_link`] made, or only a part of it, in words.
pub fn from_link(letters: &str) -> Result<String, String> {
    let broken = "it is not whole, or not a link to a scene";
    let packed = URL_SAFE_NO_PAD.decode(letters).map_err(|_| broken)?;
    let mut text = String::new();
    let mut decoder = DeflateDecoder::new(&*packed).take(MOST_TEXT);
    decoder.read_to_string(&mut text).map_err(|_| broken)?;
    if text.len() as u64 == MOST_TEXT {
        return Err("its scene is too large".to_owned());
    }
    Ok(text)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn a_scene_comes_out_of_its_link_as_it_was(text in ".{0,400}") {
            let letters = to_link(&text).unwrap();
            prop_assert!(letters.bytes().all(|b| b.is_ascii_alphanumeric() || b"-_".contains(&b)));
            prop_assert_eq!(from_link(&letters).unwrap(), text);
        }

        #[test]
        fn a_link_that_was_cut_off_is_refused(text in ".{40,400}", part in 0.05..0.95) {
            let letters = to_link(&text).unwrap();
            let cut = (letters.len() as f64 * part) as usize;
            prop_assert!(from_link(&letters[..cut]).is_err());
        }
    }

    #[test]
    fn a_scene_that_is_too_large_for_a_link_gets_none() {
        let numbers = (0..4000_u64).map(|n| n.wrapping_mul(0x9E37_79B9_7F4A_7C15).to_string());
        assert_eq!(to_link(&numbers.collect::<String>()), None);
    }

    #[test]
    fn a_small_link_does_not_become_a_huge_text() {
        let mut encoder = DeflateEncoder::new(Vec::new(), Compression::best());
        encoder.write_all(&vec![b' '; 5 << 20]).unwrap();
        let letters = URL_SAFE_NO_PAD.encode(encoder.finish().unwrap());
        assert_eq!(from_link(&letters).unwrap_err(), "its scene is too large");
    }
}
