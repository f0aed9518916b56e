// Starts the editor, and keeps the page for times without a network.
(async () => {
  const note = document.getElementById("note");
  let workers;
  try {
    if (location.protocol !== "file:") workers = navigator.serviceWorker;
  } catch {
    // Frames that may keep nothing have none.
  }
  try {
    // They come while the browser looks for what it has kept.
    const program = fetch("./editor_bg.wasm");
    const script = import("./editor.js");
    for (const coming of [program, script]) coming.catch(() => {});
    // A newer version that came during the last visit is used from now on.
    const waiting = (await workers?.getRegistration().catch(() => undefined))?.waiting;
    if (waiting) {
      const taken = new Promise((done) => workers.addEventListener("controllerchange", done, { once: true }));
      waiting.postMessage("take over");
      await taken;
      location.reload();
      return;
    }
    const { default: start } = await script;
    await start({ module_or_path: program });
  } catch (error) {
    if (!note.hidden) {
      note.textContent = location.protocol === "file:"
        ? "Browsers run the editor only from a web server: see README.md beside this page."
        : `The editor cannot be loaded: ${error.message ?? error}`;
    }
    throw error;
  }
  // What is kept comes after what the first picture needs.
  addEventListener("editor-shown", () => {
    const registered = workers?.register("./service-worker.js", { updateViaCache: "none" });
    registered?.catch((error) => console.warn(`The page is not kept for times without a network: ${error}`));
  }, { once: true });
})();
