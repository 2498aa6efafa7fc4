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

const our_words = () => words[document.documentElement.lang] ?? words.en;

function say(id, why = '') {
  says.className = '';
  says.textContent = our_words()[id] + (why ? '\n' + why : '');
  says.hidden = false;
}

// Beside the drawing, for a while.
let remarked = 0;
function remark(id) {
  say(id);
  says.className = 'remark';
  clearTimeout(remarked);
  remarked = setTimeout(() => { says.hidden = !failed; }, 15000);
}

let program;  // Emscripten's module, once it has its files
let running = false;

let failed = false;

// Ends the program, and says what becomes of the work.
function end(id, why) {
  if (failed) return;
  failed = true;
  running = false;
  const left = program ? [our_words()[database ? 'kept' : 'not_kept']] : []; // nobody has made anything before
  say(id, [...left, why].join('\n'));
  if (program) keep();
}

function fail(why) {
  console.error(why);
  const said = String(why?.message ?? why);
  end(/memory/i.test(said) ? 'out_of_memory' : 'failed', said);
}

// The browser takes it from pages that nobody sees, and where the graphics card starts anew; and may give it back.
canvas.addEventListener('webglcontextlost', (event) => {
  if (!running) return end('drawing_lost', '');
  event.preventDefault();
  leave();
  running = false;
  say('drawing_lost', our_words()[database ? 'kept' : 'not_kept']);
});
canvas.addEventListener('webglcontextrestored', () => {
  if (failed) return;
  running = true;
  says.hidden = true;
  program._page_draw_again();
  soon();
});

// --- What is kept between visits: the files of /kept, in the browser's database --------------------------------------
//
// An autosave belongs to its tab, under a key of its own, until that tab is gone; the others belong to all tabs. A tab that
// lives holds a lock. Hosts without encryption have none: there it answers who asks, within `patience`.

let tab = '';
const patience = 1000;  // milliseconds
const others = new Set();  // tabs that have answered
const tabs = self.origin !== 'null' && typeof BroadcastChannel === 'function' ? new BroadcastChannel('raywalk') : null;
const is_own = (name) => name.startsWith('autosave');
const key_of = (name) => is_own(name) ? `own/${tab}/${name}` : `shared/${name}`;
let database = null;  // none: the browser keeps nothing
const kept = new Map();  // of /kept: name to stamp, as last read or written; '': otherwise

const done = (request) => new Promise((resolve, reject) => {
  request.onsuccess = () => resolve(request.result);
  request.onerror = () => reject(request.error);
});

// Holds the lock of this name as long as the page lives; false when another page does not let it go.
function hold(name) {
  if (!navigator.locks) return !others.has(name);
  const signal = AbortSignal.timeout(patience); // a page that is loaded again waits for itself to be gone
  return new Promise((held) => navigator.locks.request(name, { signal }, () => (held(true), new Promise(() => {})))
    .catch(() => held(false)));
}

// Names this tab, as before it was loaded again; but a tab that was made from another has that one's name.
async function name_tab() {
  tab = sessionStorage.getItem('raywalk') ?? '';
  if (!navigator.locks) {
    tabs?.postMessage({ asks: true });
    await new Promise((answered) => setTimeout(answered, patience));
  }
  if (tab && await hold('raywalk/' + tab)) return;
  tab = Array.from(crypto.getRandomValues(new Uint32Array(4)), (part) => part.toString(36)).join('');
  sessionStorage.setItem('raywalk', tab);
  await hold('raywalk/' + tab);
}

async function open_database() {
  const opening = indexedDB.open('raywalk', 1);
  opening.onupgradeneeded = () => opening.result.createObjectStore('files');
  const opened = database = await done(opening);
  opened.onclose = () => database === opened && lose('closed');
}

// The browser closes it where the user clears what it keeps, or where it needs the room.
function lose(why) {
  console.warn('the database was lost:', why);
  database = null;
  keep_again();
}

// Writes all once more, later: what it failed by may pass.
let again = 0;
function keep_again() {
  clearTimeout(again);
  again = setTimeout(async () => {
    if (!database) await open_database().catch(lose);
    for (const name of kept.keys()) kept.set(name, '');
    keep();
  }, 5000);
}

// The kept files, by name. Autosaves of tabs that are gone become this tab's.
async function recall() {
  const files = new Map();
  try {
    await name_tab();
    const living = navigator.locks ? new Set((await navigator.locks.query()).held.map((lock) => lock.name)) : others;
    const lives = (other) => other !== tab && living.has('raywalk/' + other);
    await open_database();
    const store = database.transaction('files', 'readwrite').objectStore('files');
    const [keys, contents] = await Promise.all([done(store.getAllKeys()), done(store.getAll())]);
    const found = new Map(keys.map((key, i) => [key, contents[i]]));
    const left = Object.keys(localStorage).filter((key) => key.startsWith(left_by)).map((key) => key.slice(left_by.length))
      .filter((owner) => !lives(owner));
    for (const owner of left) read_left(owner, (key, bytes) => found.set(key, bytes));
    store.transaction.oncomplete = () => left.forEach((owner) => localStorage.removeItem(left_by + owner));
    const adopted = [];
    for (const [key, bytes] of found) {
      const [kind, owner] = key.split('/');
      if (kind === 'shared') files.set(owner, bytes);
      if (kind === 'shared' || lives(owner)) continue;
      if (bytes) adopted.push(bytes);
      store.delete(key);
    }
    // The latest is the first by name, and written last: it is the one that the program offers.
    const written = (bytes) => /# written on: .*|$/.exec(new TextDecoder().decode(bytes.subarray(0, 9999)))[0];
    adopted.sort((a, b) => written(a).localeCompare(written(b))).forEach((bytes, i) => {
      const number = adopted.length - i, own = number === 1 ? 'autosave.toml' : `autosave-${number}.toml`;
      files.set(own, bytes);
      store.put(bytes, key_of(own));
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

// What a page writes to the database as it is left may be lost (WebKit), or come too late for the next one. So what of the
// tab's own is under way then is left beside it, where writing is done at once, as texts by name; null: gone.
const unsure = new Map();  // names, to the transactions that write them
const left_by = 'raywalk left by ';
function leave_unsure() {
  const texts = [...unsure.keys()].map((name) =>
    [name, names_in('/kept').includes(name) ? program.FS.readFile('/kept/' + name, { encoding: 'utf8' }) : null]);
  try {
    if (texts.length > 0) localStorage.setItem(left_by + tab, JSON.stringify(Object.fromEntries(texts)));
  } catch (why) {
    console.warn('too large to be left:', why);
  }
}

// Calls with key and bytes of all that a tab has left.
function read_left(owner, found) {
  for (const [name, text] of Object.entries(JSON.parse(localStorage.getItem(left_by + owner))))
    found(`own/${owner}/${name}`, text === null ? null : new TextEncoder().encode(text));
}

// Writes what has changed in /kept.
function keep() {
  if (!database) return;
  const now = new Map(names_in('/kept').map((name) => [name, stamp_of('/kept/' + name)]));
  const changed = [...now].filter(([name, stamp]) => kept.get(name) !== stamp).map(([name]) => name);
  const gone = [...kept.keys()].filter((name) => !now.has(name));
  if (changed.length + gone.length === 0) return;
  let writing;
  try {
    writing = database.transaction('files', 'readwrite');
  } catch (why) {
    return lose(why);
  }
  writing.onabort = () => {
    console.warn('not kept:', writing.error);
    for (const name of gone) kept.set(name, '');
    keep_again();
  };
  const store = writing.objectStore('files');
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
  writing.commit(); // WebKit never ends those of a page that was left meanwhile, and the next one would wait for it
  for (const name of [...changed, ...gone].filter(is_own)) unsure.set(name, writing);
  writing.oncomplete = () => {
    for (const [name, by] of unsure) if (by === writing) unsure.delete(name);
    if (unsure.size === 0) localStorage.removeItem(left_by + tab);
  };
}

function put_kept(name, bytes) {
  program.FS.writeFile('/kept/' + name, bytes);
  kept.set(name, stamp_of('/kept/' + name));
}

if (tabs) tabs.onmessage = ({ data: { asks, answers, name, bytes } }) => {
  if (asks && tab) tabs.postMessage({ answers: 'raywalk/' + tab });
  if (answers) others.add(answers);
  if (name && running) put_kept(name, bytes);
};

// --- The user's files: /files --------------------------------------------------------------------------------------
//
// What is chosen or dropped is copied there. A scene that the program writes there is written to the user's own file, where
// the browser can; all else is downloaded.

const taken = new Map();  // of /files: path to stamp, as last chosen or downloaded
let files_changed = 0;    // by the user

function all_files(folder = '/files') {
  return names_in(folder).flatMap((name) => {
    const path = `${folder}/${name}`;
    return program.FS.isDir(program.FS.stat(path).mode) ? all_files(path) : [path];
  });
}

// What cannot be read any more, since it was chosen or dropped, is not there: the program says so where it asks for it.
const unreadable = (why) => { console.warn(why); return null; };

function put_taken(path, content) {
  program.FS.writeFile(path, content);
  taken.set(path, stamp_of(path));
}

// Opens the first scene among these.
function open_of(paths) {
  ++files_changed;
  if (paths.length > 0) call('page_open', paths.join('\n'));
  soon();
}

// `own`: the user's file itself, where the browser tells.
async function take(files) {
  const paths = [];
  for (const { name, file, own } of files) {
    const parts = name.split('/').filter((part) => part && part !== '.' && part !== '..');
    const path = '/files/' + parts.join('/');
    if (own) own_files.set(path, own);
    else own_files.delete(path);
    const bytes = await file?.arrayBuffer().catch(unreadable);
    if (bytes) {
      program.FS.mkdirTree(path.slice(0, path.lastIndexOf('/')));
      put_taken(path, new Uint8Array(bytes));
    } else if (taken.delete(path)) {
      program.FS.unlink(path);
    }
    paths.push(path);
  }
  open_of(paths);
}

const own_files = new Map();  // the user's, by their paths in /files
const picks = typeof showSaveFilePicker === 'function' && self.origin !== 'null';
let being_written = Promise.resolve(), writes = 0;
const name_in = (path) => path.slice(path.lastIndexOf('/') + 1);

// Writes what has changed in /files.
function give() {
  for (const path of all_files()) {
    const stamp = stamp_of(path);
    if (taken.get(path) === stamp) continue;
    taken.set(path, stamp);
    if (!picks || !path.endsWith('.toml')) {
      download(path);
      continue;
    }
    ++writes;
    being_written = being_written.then(() => write(path)).catch((why) => not_written(path, why)).finally(() => --writes);
  }
}

function download(path) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([program.FS.readFile(path)]));
  link.download = name_in(path);
  link.click();
  if (self.origin === 'null' && window.parent !== window) remark('may_be_forbidden'); // nobody tells a sandbox
  else if (path.endsWith('.toml')) remark('downloaded');
  setTimeout(() => URL.revokeObjectURL(link.href), 60000);
}

// Into the user's file; asks once where that is, and whether it may.
async function write(path) {
  const bytes = program.FS.readFile(path), own = own_files.get(path) ?? await showSaveFilePicker({ suggestedName: name_in(path) });
  if (await own.requestPermission({ mode: 'readwrite' }) !== 'granted') throw new DOMException('', 'AbortError');
  const file = await own.createWritable();
  await file.write(bytes);
  await file.close();
  own_files.set(path, own);
}

// The browser asks nobody where this page is in another host's, or long after a key was pressed.
function not_written(path, why) {
  console.warn(path, why);
  const refused = ['AbortError', 'NotAllowedError'].includes(why.name);
  attempt(() => {
    if (why.name === 'SecurityError' || !program.ccall('page_not_saved', 'number', ['string', 'string'], [path, refused ? '' : why.message]))
      download(path);
    soon();
  });
}

async function choose_files() {
  if (!picks) return chooser.click();
  try {
    const all = await showOpenFilePicker({ multiple: true });
    await take(await Promise.all(all.map(async (own) => ({ name: own.name, file: await own.getFile().catch(unreadable), own }))));
  } catch (why) {
    if (why.name === 'SecurityError') chooser.click();
    else if (why.name !== 'AbortError') fail(why);
  }
}

// The files of what was dropped, folders with all that they hold.
async function dropped(entry, own, folder = '') {
  if (entry instanceof File) return [{ name: entry.name, file: entry, own: await own }];
  const asked = (what) => new Promise(what).catch(unreadable);
  if (entry.isFile) return [{ name: folder + entry.name, file: await asked((...calls) => entry.file(...calls)), own: await own }];
  const reader = entry.createReader(), within = [];
  for (let some; (some = await asked((...calls) => reader.readEntries(...calls)))?.length > 0;) within.push(...some);
  return (await Promise.all(within.map((each) => dropped(each, null, folder + entry.name + '/')))).flat();
}

chooser.addEventListener('change', () => {
  take([...chooser.files].map((file) => ({ name: file.name, file }))).catch(fail);
  chooser.value = '';
});
window.addEventListener('dragover', (event) => event.preventDefault());
window.addEventListener('drop', (event) => {
  event.preventDefault();
  const entries = [...event.dataTransfer.items].map((item) =>
    [item.webkitGetAsEntry() ?? item.getAsFile(), item.getAsFileSystemHandle?.().catch(unreadable)]).filter(([entry]) => entry);
  if (running) Promise.all(entries.map(([entry, own]) => dropped(entry, own))).then((files) => take(files.flat())).catch(fail);
});

// --- Turns: one a frame while there is something to do, none while there is not ----------------------------------------

let frame = 0, timer = 0, looked = 0;
const look_every = 250; // milliseconds between looks at the files, while there is work

function soon() {
  if (frame === 0 && running) frame = requestAnimationFrame(turn);
}

function turn() {
  cancelAnimationFrame(frame); // a turn out of its turn takes the place of the next
  frame = 0;
  clearTimeout(timer);
  try {
    const wait = program._page_turn();
    if (looked === 0) performance.mark('ready');
    mirror.refresh();
    embedding?.look(told());
    if (wait === 0) soon();
    if (wait > 0) timer = setTimeout(soon, 1000 * wait);
    if (wait === 0 && performance.now() - looked < look_every) return;
    keep();
    give();
    looked = performance.now();
  } catch (why) {
    fail(why);
  }
}

for (const type of ['pointermove', 'pointerdown', 'pointerup', 'pointerleave', 'wheel', 'keydown', 'keypress', 'keyup',
  'paste', 'resize', 'focus', 'blur', 'touchstart', 'touchmove', 'touchend', 'fullscreenchange'])
  window.addEventListener(type, soon, true);

// Hidden, it may never have a turn again.
function leave() {
  if (!running) return;
  program._page_autosave();
  keep();
  leave_unsure();
}
window.addEventListener('pagehide', leave);
window.addEventListener('beforeunload', (event) => running && (writes > 0 || (!database && told().unsaved)) &&
  event.preventDefault());
document.addEventListener('visibilitychange', () => document.hidden && leave());

// What GLFW's JavaScript leaves out: a drag goes on outside of the page.
canvas.addEventListener('pointerdown', (event) => {
  canvas.classList.remove('by-keys');
  if (event.pointerType !== 'touch') canvas.setPointerCapture(event.pointerId);
});

// --- For everyone: touch, the window in words, and motion --------------------------------------------------------------

const call = (name, ...texts) => program.ccall(name, 'string', texts.map(() => 'string'), texts);
const told = () => JSON.parse(call('page_told'));

// The page's first button, and all but the drawing that it shows.
const header = document.createElement('header'), main = document.createElement('main');
header.innerHTML = '<h1 class="unseen"></h1><button type="button" id="as-text"></button>';
canvas.before(header, main);
main.append(canvas, Object.assign(document.createElement('div'), { id: 'mirror', hidden: true }));
const as_text = document.getElementById('as-text'), text_place = document.getElementById('mirror');
text_place.innerHTML = '<h1 tabindex="-1"></h1><button type="button" class="leave"></button><div class="outline"></div>' +
  '<p role="status" class="unseen"></p>';
// Drawn at once: letters that wait for a frame are lost if a finger leaves the field before it.
const keyboard = new Keyboard(canvas, { settle: () => running && turn() });
new Touch(canvas, {
  first: () => running && call('page_act', 'touch on'),
  holds: (x, y) => running && program._page_holds(x, y),
  scroll: (x, y, by) => running && program._page_scroll(x, y, by),
  wheel: (by) => running && program._page_wheel(by),
  // The program sees a press in one frame and what it has done in the next ones.
  settle: () => {
    if (!running) return;
    for (let i = 0; i < 4; ++i) turn();
    keyboard.show(program._page_types() && { mode: program._page_types_number() ? 'decimal' : 'text',
      x: program._page_typed_x(), y: program._page_typed_y() });
  },
});

const mirror = new Mirror(text_place, {
  ask: () => call('page_outline'),
  act: (does, typed) => {
    const wrong = call('page_do', does, typed);
    turn();
    return wrong;
  },
  shown: () => {
    canvas.classList.toggle('beside', mirror.open);
    header.querySelector('h1').hidden = mirror.open;
    (mirror.open ? text_place.querySelector('h1') : as_text).focus();
    soon();
  },
});
as_text.addEventListener('click', () => running && mirror.show(true));
text_place.querySelector('.leave').addEventListener('click', () => mirror.show(false));

// What the page itself says, in the language of the program.
function name_parts(now) {
  document.documentElement.lang = now;
  const said = our_words();
  Mirror.say(as_text, said.as_text);
  for (const title of document.querySelectorAll('h1')) Mirror.say(title, document.title);
  Mirror.say(text_place.querySelector('.leave'), said.as_drawing);
  for (const element of [canvas, keyboard.field]) Mirror.set(element, 'aria-label', said.drawing);
}
canvas.setAttribute('role', 'application');

const less_motion = matchMedia('(prefers-reduced-motion: reduce)');
less_motion.addEventListener('change', () => running && less_motion.matches && call('page_act', 'tweens off'));

// Whether keys belong to the page: in its own elements, and while the text is open everywhere but in the drawing, for who
// reads there may have clicked beside all of them.
const of_text = (target) => target !== canvas &&
  (mirror.open || (target instanceof Element && (header.contains(target) || main.contains(target))));

// What is left for the drawing, in CSS pixels.
function canvas_size() {
  const beside = mirror.open && innerWidth >= 900 ? text_place.offsetWidth : 0;
  return [Math.max(1, innerWidth - beside), Math.max(1, innerHeight)];
}

// --- Keys: the program's own work, and no others are taken from the browser ------------------------------------------

const key_names = { ' ': 'Space', '=': '+', 'ArrowLeft': 'Left', 'ArrowRight': 'Right', 'ArrowUp': 'Up',
  'ArrowDown': 'Down', 'PageUp': 'Page Up', 'PageDown': 'Page Down' };
// What every browser does by these is worth more here: the address, tabs, reloading, the size of all that is shown.
const browsers_own = new Set([...'LNRTW+-0'].map((key) => 'Ctrl+' + key).concat('F11', 'F12'));

// Before GLFW's, which so never sees what is left to the browser.
window.addEventListener('keydown', (event) => {
  if (!running || event.getModifierState('AltGraph')) return;
  // The keys of the page's own buttons and fields, and the one that leads from the drawing to them.
  if (of_text(event.target)) {
    if (event.target === keyboard.field && event.key === 'Enter') keyboard.key(13, 'Enter');
    return event.stopImmediatePropagation();
  }
  if (event.key === 'Tab' && !program._page_types()) return event.stopImmediatePropagation();
  const key = key_names[event.key] ?? (event.key.length === 1 ? event.key.toUpperCase() : event.key);
  const ctrl = event.ctrlKey || event.metaKey;
  if (browsers_own.has((ctrl ? 'Ctrl+' : '') + key)) return event.stopImmediatePropagation();
  const written = (ctrl ? 'Ctrl+' : '') + (event.altKey ? 'Alt+' : '') + (event.shiftKey ? 'Shift+' : '') + key;
  if ((ctrl || event.altKey || /^F\d/.test(key)) && program.ccall('page_uses_key', 'number', ['string'], [written]))
    event.preventDefault();
}, true);

for (const type of ['keypress', 'keyup'])
  window.addEventListener(type, (event) => {
    if (of_text(event.target)) event.stopImmediatePropagation();
    else if (type === 'keyup' && event.key === 'Tab') canvas.classList.add('by-keys');
  }, true);

// Hosts without encryption, and frames, have no clipboard by that name.
function copy(text) {
  const by_hand = () => {
    const focused = document.activeElement;
    const field = document.createElement('textarea');
    field.value = text;
    document.body.append(field);
    field.select();
    document.execCommand('copy');
    field.remove();
    focused.focus();
  };
  if (navigator.clipboard) navigator.clipboard.writeText(text).catch(by_hand);
  else by_hand();
}

// The browser tells what is pasted only here, before the frame in which the program asks for it.
window.addEventListener('paste', (event) => {
  if (running) program.pasted = event.clipboardData.getData('text/plain');
});

// --- Links, and the page around this one --------------------------------------------------------------------------------

const own_link = () => location.hash.startsWith('#v=') ? location.hash : '';

function attempt(work) {
  try {
    return running ? work() : '';
  } catch (why) {
    return fail(why);
  }
}

function act(line) {
  attempt(() => {
    call('page_act', line);
    soon();
  });
}

let sent = 0; // scenes: each is a file of its own, for the one that is open may be kept

// A link that is typed or pasted over the address of this page.
window.addEventListener('hashchange', () => own_link() && act('open-link ' + own_link()));

const embedding = asked.has('embed') ? new Embedding(asked.get('embed'), {
  load_link: (link) => act('open-link ' + link.slice(link.indexOf('#')).replace(/[\n\r]/g, '')),
  load_scene: (text) => attempt(() => {
    const why = call('page_refuses', text);
    if (why) return why;
    const path = `/files/embedded-${++sent}.toml`;
    put_taken(path, text);
    return open_of([path]);
  }),
  go: (step) => act('jump ' + step),
  asks: () => attempt(() => told().waits),
}) : null;

// --- Start -----------------------------------------------------------------------------------------------------------

// A module of one function that makes a vector: what does not know SIMD refuses it. pack.mjs says what the program does
// without.
const needs_simd = 'WITHOUT' !== 'no-simd';
const with_simd = new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0,
  253, 15, 253, 98, 11]);

// The program, compiled: for this page and for its workers. Its code is fetched packed; it stands in letters in this file,
// or where nothing may be fetched in a script beside this one.
async function compiled() {
  if (!document.getElementById('code') && self.origin === 'null')
    await new Promise((loaded, refused) => document.head.append(Object.assign(document.createElement('script'),
      { src: own_folder + 'code.js', onload: loaded, onerror: () => refused(new Error('code.js is missing')) })));
  const letters = document.getElementById('code')?.textContent ?? self.raywalk_code;
  if (!letters && navigator.serviceWorker?.controller) {
    const kept = await fetch(own_folder + 'raywalk.wasm'); // of the service worker, which has unpacked it
    if (kept.ok) return WebAssembly.compileStreaming(kept);
  }
  const packed = letters ? new Response(bytes_of(letters)) : await fetch(own_folder + 'raywalk.bin');
  if (!packed.ok) throw new Error(`raywalk.bin: ${packed.status} ${packed.statusText}`);
  let wrong = null;
  const code = await unpacked(packed.body, (why) => { wrong = why; });
  return WebAssembly.compileStreaming(code).catch((why) => { throw wrong ?? why; });
}

async function start() {
  say('loading');
  if (!document.createElement('canvas').getContext('webgl2')) return say('no_webgl');
  if (needs_simd && !WebAssembly.validate(with_simd)) return say('no_simd');
  const [files, code] = await Promise.all([recall(), compiled()]);
  const options = ['scene', 'language'].flatMap((name) => asked.has(name) ? [name, asked.get(name)] : []);
  // Beside the folders, not in them: what stands there is kept, or downloaded.
  const report = asked.get('report');
  if (/^\/\w+\.json$/.test(report)) options.push('report', report);
  if (own_link()) options.push('link', own_link());
  if (embedding) options.push('embed', 'yes');
  if (location.protocol !== 'file:') options.push('page', location.origin + location.pathname);
  const module = await Raywalk({
    canvas,
    canvas_size,
    workers: new PageWorkers(code, own_folder + 'worker.js', {
      answered: soon,
      files: () => all_files().map((path) => [path, program.FS.readFile(path)]),
      changed: () => files_changed,
    }),
    instantiateWasm: (imports, done) => {
      WebAssembly.instantiate(code, imports).then((instance) => done(instance, code)).catch(fail);
      return {};
    },
    arguments: options,
    fail,
    copy,
    speaks: name_parts,
    stands_at: (link) => {
      try {
        if (!embedding) history.replaceState(history.state, '', link || location.pathname + location.search);
      } catch {} // of a file some browsers refuse it
    },
    chooseFiles: choose_files,
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
  if (less_motion.matches) call('page_act', 'tweens off');
  // What is pressed by fingers alone is as high as they need from the start, not only after the first touch.
  if (matchMedia('(pointer: coarse)').matches) call('page_act', 'touch on');
  canvas.focus();
  soon();
}

start().catch(fail);
