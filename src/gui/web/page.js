// The page: starts the program, gives it a turn a frame while it has something to do, keeps its files between visits,
// and passes files between it and the user's device.
'use strict';

const words = JSON.parse(document.getElementById('words').textContent);
const asked = new URLSearchParams(location.search);
const own_folder = document.currentScript.src.replace(/[^/]*$/, '');
const canvas = document.getElementById('canvas');
const says = document.getElementById('says');
const chooser = document.getElementById('chooser');

const language = [asked.get('language'), ...navigator.languages].map((tag) => tag?.slice(0, 2))
  .find((code) => code in words) ?? 'en';
document.documentElement.lang = language;

function say(id, why = '') {
  says.textContent = words[language][id] + (why ? '\n' + why : '');
  says.hidden = false;
}

let program;  // Emscripten's module, once it has its files
let running = false;

let failed = false;

function fail(why) {
  if (failed) return;
  failed = true;
  running = false;
  console.error(why);
  const memory = /memory/i.test(String(why?.message ?? why));
  say(memory ? 'out_of_memory' : 'failed', String(why?.message ?? why));
  if (program) keep();
}

// --- What is kept between visits: the files of /kept, in the browser's database --------------------------------------
//
// An autosave belongs to its tab, under a key of its own, until that tab is gone; the others belong to all tabs.

let tab = '';
const tabs = self.origin !== 'null' && typeof BroadcastChannel === 'function' ? new BroadcastChannel('raywalk') : null;
const is_own = (name) => name.startsWith('autosave');
const key_of = (name) => is_own(name) ? `own/${tab}/${name}` : `shared/${name}`;
let database = null;  // none: the browser keeps nothing
const kept = new Map();  // of /kept: name to stamp, as last read or written

const done = (request) => new Promise((resolve, reject) => {
  request.onsuccess = () => resolve(request.result);
  request.onerror = () => reject(request.error);
});

// Holds the lock of this name as long as the page lives; false when another page does not let it go.
function hold(name) {
  const patience = AbortSignal.timeout(1000); // a page that is loaded again waits for itself to be gone
  return new Promise((held) => navigator.locks.request(name, { signal: patience }, () => (held(true), new Promise(() => {})))
    .catch(() => held(false)));
}

// Names this tab, as before it was loaded again; but a tab that was made from another has that one's name.
async function name_tab() {
  tab = sessionStorage.getItem('raywalk') ?? '';
  if (tab && await hold('raywalk/' + tab)) return;
  tab = Array.from(crypto.getRandomValues(new Uint32Array(4)), (part) => part.toString(36)).join('');
  sessionStorage.setItem('raywalk', tab);
  await hold('raywalk/' + tab);
}

// The kept files, by name. Autosaves of tabs that are gone become this tab's.
async function recall() {
  const files = new Map();
  try {
    await name_tab();
    const living = new Set((await navigator.locks.query()).held.map((lock) => lock.name));
    living.delete('raywalk/' + tab);
    const opening = indexedDB.open('raywalk', 1);
    opening.onupgradeneeded = () => opening.result.createObjectStore('files');
    database = await done(opening);
    const store = database.transaction('files', 'readwrite').objectStore('files');
    const [keys, contents] = await Promise.all([done(store.getAllKeys()), done(store.getAll())]);
    let number = 0;
    keys.forEach((key, i) => {
      const [kind, owner, name] = key.split('/');
      if (kind === 'shared') return files.set(owner, contents[i]);
      if (living.has('raywalk/' + owner)) return;
      const own = number++ === 0 ? 'autosave.toml' : `autosave-${number}.toml`;
      files.set(own, contents[i]);
      store.delete(key);
      store.put(contents[i], key_of(own));
    });
  } catch (why) {
    console.warn('nothing is kept between visits:', why);
    database = null;
  }
  return files;
}

// Changes when a file does: its node is another, for files are written by rename.
function stamp_of(path) {
  const { ino, mtime, size } = program.FS.stat(path);
  return `${ino} ${+mtime} ${size}`;
}

const names_in = (folder) => program.FS.readdir(folder).filter((name) => !name.startsWith('.'));

// Writes what has changed in /kept.
function keep() {
  if (!database) return;
  const now = new Map(names_in('/kept').map((name) => [name, stamp_of('/kept/' + name)]));
  const changed = [...now].filter(([name, stamp]) => kept.get(name) !== stamp).map(([name]) => name);
  const gone = [...kept.keys()].filter((name) => !now.has(name));
  if (changed.length + gone.length === 0) return;
  const store = database.transaction('files', 'readwrite').objectStore('files');
  for (const name of changed) {
    const bytes = program.FS.readFile('/kept/' + name);
    store.put(bytes, key_of(name));
    if (!is_own(name)) tabs?.postMessage({ name, bytes });
    kept.set(name, now.get(name));
  }
  for (const name of gone) {
    store.delete(key_of(name));
    kept.delete(name);
  }
}

function put_kept(name, bytes) {
  program.FS.writeFile('/kept/' + name, bytes);
  kept.set(name, stamp_of('/kept/' + name));
}

if (tabs) tabs.onmessage = ({ data }) => running && put_kept(data.name, data.bytes);

// --- The user's files: /files --------------------------------------------------------------------------------------
//
// What is chosen or dropped is copied there; what the program writes there is downloaded.

const taken = new Map();  // of /files: path to stamp, as last chosen or downloaded

function all_files(folder = '/files') {
  return names_in(folder).flatMap((name) => {
    const path = `${folder}/${name}`;
    return program.FS.isDir(program.FS.stat(path).mode) ? all_files(path) : [path];
  });
}

async function take(files) {
  const paths = [];
  for (const { name, file } of files) {
    const parts = name.split('/').filter((part) => part && part !== '.' && part !== '..');
    const path = '/files/' + parts.join('/');
    program.FS.mkdirTree(path.slice(0, path.lastIndexOf('/')));
    program.FS.writeFile(path, new Uint8Array(await file.arrayBuffer()));
    taken.set(path, stamp_of(path));
    paths.push(path);
  }
  if (paths.length > 0) program.ccall('page_open', null, ['string'], [paths.join('\n')]);
  soon();
}

function download() {
  for (const path of all_files()) {
    const stamp = stamp_of(path);
    if (taken.get(path) === stamp) continue;
    taken.set(path, stamp);
    const link = document.createElement('a');
    link.href = URL.createObjectURL(new Blob([program.FS.readFile(path)]));
    link.download = path.slice(path.lastIndexOf('/') + 1);
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60000);
  }
}

// The files of what was dropped, folders with all that they hold.
async function dropped(entry, folder = '') {
  if (entry instanceof File) return [{ name: entry.name, file: entry }];
  if (entry.isFile) return [{ name: folder + entry.name, file: await new Promise((...calls) => entry.file(...calls)) }];
  const reader = entry.createReader(), within = [];
  for (let some; (some = await new Promise((...calls) => reader.readEntries(...calls))).length > 0;) within.push(...some);
  return (await Promise.all(within.map((each) => dropped(each, folder + entry.name + '/')))).flat();
}

chooser.addEventListener('change', () => {
  take([...chooser.files].map((file) => ({ name: file.name, file }))).catch(fail);
  chooser.value = '';
});
window.addEventListener('dragover', (event) => event.preventDefault());
window.addEventListener('drop', (event) => {
  event.preventDefault();
  const entries = [...event.dataTransfer.items].map((item) => item.webkitGetAsEntry() ?? item.getAsFile())
    .filter((entry) => entry);
  if (running) Promise.all(entries.map((entry) => dropped(entry))).then((files) => take(files.flat())).catch(fail);
});

// --- Turns: one a frame while there is something to do, none while there is not ----------------------------------------

let frame = 0, timer = 0, looked = 0;
const look_every = 250; // milliseconds between looks at the files, while there is work

function soon() {
  if (frame === 0 && running) frame = requestAnimationFrame(turn);
}

function turn() {
  frame = 0;
  clearTimeout(timer);
  try {
    const wait = program._page_turn();
    if (looked === 0) performance.mark('ready');
    if (wait === 0) soon();
    if (wait > 0) timer = setTimeout(soon, 1000 * wait);
    if (wait === 0 && performance.now() - looked < look_every) return;
    keep();
    download();
    looked = performance.now();
  } catch (why) {
    fail(why);
  }
}

for (const type of ['pointermove', 'pointerdown', 'pointerup', 'pointerleave', 'wheel', 'keydown', 'keypress', 'keyup',
  'paste', 'resize', 'focus', 'blur', 'touchstart', 'touchmove', 'touchend', 'fullscreenchange'])
  window.addEventListener(type, soon, true);

window.addEventListener('pagehide', () => running && keep());

// What GLFW's JavaScript leaves out: a drag goes on outside of the page, and a touch is somewhere before it presses.
canvas.addEventListener('pointerdown', (event) => canvas.setPointerCapture(event.pointerId));
window.addEventListener('touchstart', ({ touches: [first], target }) => {
  if (target === canvas) canvas.dispatchEvent(new MouseEvent('mousemove', { clientX: first.clientX, clientY: first.clientY }));
}, true);

// --- Keys: the program's own work, and no others are taken from the browser ------------------------------------------

const key_names = { ' ': 'Space', '=': '+', 'ArrowLeft': 'Left', 'ArrowRight': 'Right', 'ArrowUp': 'Up',
  'ArrowDown': 'Down', 'PageUp': 'Page Up', 'PageDown': 'Page Down' };
// What every browser does by these is worth more here: the address, tabs, reloading, the size of all that is shown.
const browsers_own = new Set([...'LNRTW+-0'].map((key) => 'Ctrl+' + key).concat('F11', 'F12'));

// Before GLFW's, which so never sees what is left to the browser.
window.addEventListener('keydown', (event) => {
  if (!running || event.getModifierState('AltGraph')) return;
  const key = key_names[event.key] ?? (event.key.length === 1 ? event.key.toUpperCase() : event.key);
  const ctrl = event.ctrlKey || event.metaKey;
  if (browsers_own.has((ctrl ? 'Ctrl+' : '') + key)) return event.stopImmediatePropagation();
  const written = (ctrl ? 'Ctrl+' : '') + (event.altKey ? 'Alt+' : '') + (event.shiftKey ? 'Shift+' : '') + key;
  if ((ctrl || event.altKey || /^F\d/.test(key)) && program.ccall('page_uses_key', 'number', ['string'], [written]))
    event.preventDefault();
}, true);

// The browser tells what is pasted only here, before the frame in which the program asks for it.
window.addEventListener('paste', (event) => {
  if (running) program.pasted = event.clipboardData.getData('text/plain');
});

// --- Start -----------------------------------------------------------------------------------------------------------

// A module of one function that makes a vector: what does not know SIMD refuses it.
const with_simd = new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0,
  253, 15, 253, 98, 11]);

// The code in letters, packed: in this file, or where nothing may be fetched from a script beside this one.
async function own_code() {
  if (!document.getElementById('code') && self.origin === 'null')
    await new Promise((loaded, refused) => document.head.append(Object.assign(document.createElement('script'),
      { src: own_folder + 'code.js', onload: loaded, onerror: () => refused(new Error('code.js is missing')) })));
  const letters = document.getElementById('code')?.textContent ?? self.raywalk_code;
  if (!letters) return undefined;
  const packed = Uint8Array.from(atob(letters), (letter) => letter.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

async function start() {
  say('loading');
  if (!document.createElement('canvas').getContext('webgl2')) return say('no_webgl');
  if (!WebAssembly.validate(with_simd)) return say('no_simd');
  const [files, wasmBinary] = await Promise.all([recall(), own_code()]);
  const options = ['scene', 'language', 'report'].flatMap((name) => asked.has(name) ? [name, asked.get(name)] : []);
  const module = await Raywalk({
    canvas,
    wasmBinary,
    arguments: options,
    fail,
    chooseFiles: () => chooser.click(),
    onAbort: fail,
    preRun: [(module) => {
      program = module;
      for (const folder of ['/kept', '/files']) module.FS.mkdir(folder);
      for (const [name, bytes] of files) put_kept(name, bytes);
    }],
  });
  window.raywalk = module;  // for tests
  if (failed) return;
  running = true;
  says.hidden = true;
  canvas.focus();
  soon();
}

start().catch(fail);
