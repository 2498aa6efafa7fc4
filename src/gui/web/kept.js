// The service worker: keeps one version of the page in the browser, whole, so that it opens without a network. pack.mjs
// fills in which version, and its files.
'use strict';

const version = 'VERSION';
const files = [];
// Caches are of the whole origin, which may hold this page in several places.
const place = `raywalk ${registration.scope} `;
const own = place + version;
importScripts(version + '/unpack.js');

// All of them or none: a page that was changed on its host meanwhile is not this version. The program is kept unpacked, for
// its browser to compile without a detour.
async function keep() {
  const is_new = !await caches.has(own);
  const cache = await caches.open(own);
  try {
    await cache.addAll(files.map((file) => new Request(file, { cache: 'reload' })));
    const page = await (await cache.match('./')).text();
    if (!page.includes(version)) throw new Error('the host has another version by now');
    const packed = await fetch(version + '/raywalk.bin', { cache: 'reload' });
    if (!packed.ok) throw new Error('the program is missing');
    await cache.put(version + '/raywalk.wasm', await unpacked(packed.body));
  } catch (why) {
    if (is_new) await caches.delete(own);
    throw why;
  }
}

// Earlier versions named theirs without a place: those that hold this page are its own.
async function is_of_this_page(name) {
  return name.startsWith(place) ||
    (/^raywalk [0-9a-f]{16}$/.test(name) && await (await caches.open(name)).match(registration.scope) !== undefined);
}

async function forget_others() {
  const forget = async (name) => name !== own && await is_of_this_page(name) && caches.delete(name);
  await Promise.all((await caches.keys()).map(forget));
}

// Options of the address are the page's own business, and so is whether its file is named.
async function answer(request) {
  const cache = await caches.open(own), address = request.url.replace(/[?#].*/, '').replace(/\/index\.html$/, '/');
  return await cache.match(address) ?? fetch(request);
}

// It takes over only once no page of an older version is open: the browser waits for that, and nobody skips it.
self.addEventListener('install', (event) => event.waitUntil(keep()));
self.addEventListener('activate', (event) => event.waitUntil(forget_others()));
self.addEventListener('fetch', (event) => {
  if (event.request.method === 'GET' && new URL(event.request.url).origin === location.origin)
    event.respondWith(answer(event.request));
});
