// The service worker: keeps one version of the page in the browser, whole, so that it opens without a network. pack.mjs
// fills in which version, and its files.
'use strict';

const version = 'VERSION';
const files = [];
const own = `raywalk ${version}`;
importScripts(version + '/unpack.js');

// All of them or none: a page that was changed on its host meanwhile is not this version. The program is kept unpacked, for
// its browser to compile without a detour.
async function keep() {
  const cache = await caches.open(own);
  try {
    await cache.addAll(files.map((file) => new Request(file, { cache: 'reload' })));
    const page = await (await cache.match('./')).text();
    if (!page.includes(version)) throw new Error('the host has another version by now');
    const packed = await fetch(version + '/raywalk.bin', { cache: 'reload' });
    if (!packed.ok) throw new Error('the program is missing');
    await cache.put(version + '/raywalk.wasm', await unpacked(packed.body));
  } catch (why) {
    await caches.delete(own);
    throw why;
  }
}

async function forget_others() {
  const names = await caches.keys();
  await Promise.all(names.filter((name) => name.startsWith('raywalk ') && name !== own).map((name) => caches.delete(name)));
}

async function answer(request) {
  const cache = await caches.open(own);
  // Options of the address are the page's own business.
  return await cache.match(request, { ignoreSearch: true }) ?? fetch(request);
}

// It takes over only once no page of an older version is open: the browser waits for that, and nobody skips it.
self.addEventListener('install', (event) => event.waitUntil(keep()));
self.addEventListener('activate', (event) => event.waitUntil(forget_others()));
self.addEventListener('fetch', (event) => {
  if (event.request.method === 'GET' && new URL(event.request.url).origin === location.origin)
    event.respondWith(answer(event.request));
});
