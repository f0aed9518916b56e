//! Files that the user gave to the page, kept in the browser so that work that is offered back after
//! a reload finds them. Nothing leaves the browser.

use idb::{Database, DatabaseEvent, Error, Factory, ObjectStoreParams, TransactionMode};
use js_sys::Uint8Array;
use std::collections::HashMap;
use std::path::{Path, PathBuf};
use wasm_bindgen::{JsCast, JsValue};

const DATABASE: &str = "editor";
const FILES: &str = "files";

async fn database() -> Result<Database, Error> {
    let mut request = Factory::new()?.open(DATABASE, Some(1))?;
    request.on_upgrade_needed(|event| {
        if let Ok(database) = event.database() {
            // A database without it fails when it is used, which is told then.
            let _ = database.create_object_store(FILES, ObjectStoreParams::new());
        }
    });
    request.await
}

/// All files that are kept, by name; none where the browser keeps nothing.
pub(super) async fn load() -> HashMap<PathBuf, Vec<u8>> {
    read_if(|_| true).await.unwrap_or_default()
}

/// Those of the files that are kept that are called as one of `names`, in whatever folder.
pub(super) async fn namesakes(names: &[PathBuf]) -> HashMap<PathBuf, Vec<u8>> {
    read_if(|path| {
        names
            .iter()
            .any(|name| name.file_name() == path.file_name())
    })
    .await
    .unwrap_or_default()
}

async fn read_if(wanted: impl Fn(&Path) -> bool) -> Result<HashMap<PathBuf, Vec<u8>>, Error> {
    let database = database().await?;
    let transaction = database.transaction(&[FILES], TransactionMode::ReadOnly)?;
    let store = transaction.object_store(FILES)?;
    let names = store.get_all_keys(None, None)?.await?;
    let mut files = HashMap::new();
    for name in names {
        let Some(path) = name
            .as_string()
            .map(PathBuf::from)
            .filter(|path| wanted(path))
        else {
            continue;
        };
        let content = store.get(key(&path))?.await?;
        if let Some(bytes) = content.and_then(|it| it.dyn_into::<Uint8Array>().ok()) {
            files.insert(path, bytes.to_vec());
        }
    }
    Ok(files)
}

/// Keeps `files`, by name, beside those that are kept already.
pub(super) async fn keep(files: &[(PathBuf, Vec<u8>)]) -> Result<(), Error> {
    let database = database().await?;
    let transaction = database.transaction(&[FILES], TransactionMode::ReadWrite)?;
    let store = transaction.object_store(FILES)?;
    for (path, bytes) in files {
        store.put(&Uint8Array::from(&bytes[..]), Some(&key(path)))?;
    }
    transaction.commit()?.await?;
    Ok(())
}

/// Lets go of all files.
pub(super) async fn forget() -> Result<(), Error> {
    let database = database().await?;
    let transaction = database.transaction(&[FILES], TransactionMode::ReadWrite)?;
    transaction.object_store(FILES)?.clear()?.await?;
    transaction.commit()?.await?;
    Ok(())
}

fn key(path: &Path) -> JsValue {
    JsValue::from_str(&path.to_string_lossy())
}
