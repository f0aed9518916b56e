// Keeps all files of one version of the page, so that it works without a network.
const OF_THIS_PAGE = `editor-${registration.scope}-`;
const KEPT = OF_THIS_PAGE + __VERSION__;
const KEPT_FILES = __FILES__;
const ADDRESSES = new Set(KEPT_FILES.map((name) => new URL(name, registration.scope).href));

addEventListener("install", (event) => {
  event.waitUntil((async () => {
    const cache = await caches.open(KEPT);
    await cache.addAll(KEPT_FILES.map((name) => new Request(name, { cache: "no-cache" })));
    // The first version is there from now on; later ones wait for the next start of the page.
  })());
});

addEventListener("message", (event) => {
  if (event.data === "take over") skipWaiting();
});

addEventListener("activate", (event) => {
  event.waitUntil((async () => {
    // Other pages of the same site may keep something, too, and be editors.
    const names = await caches.keys();
    const older = names.filter((name) => name.startsWith(OF_THIS_PAGE) && name !== KEPT);
    await Promise.all(older.map((name) => caches.delete(name)));
    await clients.claim();
  })());
});

addEventListener("fetch", (event) => {
  const { request } = event;
  const url = new URL(request.url);
  url.search = url.hash = "";
  if (url.href === registration.scope) url.pathname += "index.html";
  // Files that lie beside the page but are not part of it come from the network.
  if (request.method !== "GET" || !ADDRESSES.has(url.href)) return;
  event.respondWith((async () => {
    const cache = await caches.open(KEPT);
    return await cache.match(url.href) ?? fetch(request);
  })());
});
