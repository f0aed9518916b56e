//! Where the results of other programs are that ours are compared with. They are not part of this
//! project: `EDITOR_REFERENCE_DATA` names the folder that holds `data`.

use std::path::PathBuf;

/// The file or folder `name` below `data`; `None`, told on standard error, where there is no
/// reference data.
///
/// # Panics
/// If it is missing although `EDITOR_REQUIRE_REFERENCE=1` says that it must be there.
pub fn reference(name: &str) -> Option<PathBuf> {
    let folder = std::env::var_os("EDITOR_REFERENCE_DATA");
    let path = folder.map(|folder| PathBuf::from(folder).join("data").join(name));
    if let Some(path) = path.filter(|path| path.exists()) {
        return Some(path);
    }
    let required = std::env::var_os("EDITOR_REQUIRE_REFERENCE").is_some_and(|value| value == "1");
    assert!(
        !required,
        "{name} is required but not in EDITOR_REFERENCE_DATA"
    );
    eprintln!("left out: {name}, for EDITOR_REFERENCE_DATA does not lead to it");
    None
}
