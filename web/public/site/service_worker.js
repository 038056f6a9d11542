// Keeps the site's files in the browser, so that it opens without a network. `muster site` replaces the two words in capitals:
// the files, and a number that follows from their contents.
/* global self, caches, fetch, Headers, Request, Response, URL, FILES */

const kCache = 'muster-VERSION';
// With two cores the engine has one thread.
const kThreads = self.navigator.hardwareConcurrency > 2;
const kFiles = FILES.filter((path) => kThreads || !path.includes('-threads'));

/** What the browser has already is asked after, not loaded again. */
async function keep() {
  const cache = await caches.open(kCache);
  await cache.addAll(kFiles.map((path) => new Request(path, { cache: 'no-cache' })));
}

async function dropOthers() {
  for (const name of await caches.keys()) if (name.startsWith('muster-') && name !== kCache) await caches.delete(name);
  await self.clients.claim();
}

/** The same answer for an isolated page: such a page may share memory between threads. */
function isolated(answer) {
  // The browser follows redirections itself.
  if (answer.status === 0) return answer;
  const headers = new Headers(answer.headers);
  headers.set('Cross-Origin-Opener-Policy', 'same-origin');
  headers.set('Cross-Origin-Embedder-Policy', 'require-corp');
  return new Response(answer.body, { status: answer.status, statusText: answer.statusText, headers });
}

/** A kept file; whatever else comes from the network. */
async function answer(request) {
  const kept = await (await caches.open(kCache)).match(request, { ignoreSearch: true });
  return isolated(kept ?? (await fetch(request)));
}

self.addEventListener('install', (event) => event.waitUntil(keep().then(() => self.skipWaiting())));
self.addEventListener('activate', (event) => event.waitUntil(dropOthers()));
self.addEventListener('fetch', (event) => {
  if (event.request.method === 'GET' && new URL(event.request.url).origin === self.location.origin)
    event.respondWith(answer(event.request));
});
