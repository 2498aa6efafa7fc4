// The page: it starts, walks, saves, survives a reload, takes and gives files, and rests when nothing moves.
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync, statSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { Visit, browser, is_firefox, only_in_chromium, open_for_tests, pictures, saving_into, server, site } from './browser.mjs';

const downloads = mkdtempSync(join(tmpdir(), 'raywalk-downloads-'));
open_for_tests(saving_into(downloads));
after(() => rmSync(downloads, { recursive: true }));

const image_done = (report) => report.image.finished;

for (const [name, size] of [['1280x720', {}], ['1280x720@2', { deviceScaleFactor: 2 }], ['360x640', { width: 360, height: 640 }],
  ['768x1024', { width: 768, height: 1024 }], ['1920x1080', { width: 1920, height: 1080 }]])
  test(`the page starts and STEP steps, at ${name}`, async () => {
    const visit = await Visit.begin(browser, server.address, size);
    const report = await visit.report();
    assert.deepEqual([report.window.width, report.window.height], [size.width ?? 1280, size.height ?? 720]);
    await visit.page.keyboard.press(' ');
    await visit.until((now) => now.position === 1);
    await visit.until(image_done, 'the image is finished');
    await visit.page.screenshot({ path: join(pictures, `${name}.png`) });
    assert.deepEqual(visit.complaints, []);
    await visit.page.close();
  });

test('the one file works from a disk, without a network', async () => {
  const page = pathToFileURL(join(site, 'raywalk.html')).href;
  const visit = await Visit.begin(browser, page);
  await visit.click('step');
  await visit.until((now) => now.position >= 1);  // a slow machine takes a click for holding the button down
  assert.deepEqual(visit.requests.filter((url) => !/^(file|blob|data):/.test(url)), []);
  assert.deepEqual(visit.complaints, []);
  await visit.page.close();
});

test('a page at rest draws nothing', async () => {
  const visit = await Visit.begin(browser, server.address);
  await visit.until(image_done, 'the image is finished');
  await visit.page.evaluate(() => {
    window.frames_asked = 0;
    const ask = window.requestAnimationFrame;
    window.requestAnimationFrame = (call) => (++window.frames_asked, ask(call));
  });
  await new Promise((again) => setTimeout(again, 8000)); // what is said for some seconds has gone by then
  await visit.page.evaluate(() => { window.frames_asked = 0; });
  await new Promise((again) => setTimeout(again, 2000));
  assert.equal(await visit.page.evaluate(() => window.frames_asked), 0);
  await visit.page.close();
});

test('a scene that is dropped is opened with what it names, and asks before it drops changes', async () => {
  const visit = await Visit.begin(browser, server.address);
  const scenes = join(process.env.RAYWALK_SOURCE_DIR, 'scenes');
  const drop = () => visit.page.evaluate((files) => {
    const dataTransfer = new DataTransfer;
    for (const [name, bytes] of files) dataTransfer.items.add(new File([new Uint8Array(bytes)], name));
    document.getElementById('canvas').dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
  }, ['ball.ply', 'mesh.toml'].map((name) => [name, [...readFileSync(join(scenes, name))]]));
  await drop();
  await visit.until((now) => now.path === '/files/mesh.toml' && now.question === '');
  await visit.add_sphere();
  await visit.until((now) => now.dirty);
  await drop();
  await visit.until((now) => now.question === 'unsaved');
  assert.deepEqual(visit.complaints, []);
  await visit.page.close();
});

test('what cannot be read any more when it is dropped is left out, and the page goes on', async () => {
  const visit = await Visit.begin(browser, server.address);
  const scene = readFileSync(join(process.env.RAYWALK_SOURCE_DIR, 'scenes/classic.toml'), 'utf8');
  const drop = (...names) => visit.page.evaluate((names, scene) => {
    const read = Blob.prototype.arrayBuffer;
    Blob.prototype.arrayBuffer = function () {
      return this.name?.startsWith('gone') ? Promise.reject(new DOMException('gone', 'NotReadableError')) : read.call(this);
    };
    const dataTransfer = new DataTransfer;
    for (const name of names) dataTransfer.items.add(new File([scene], name));
    document.getElementById('canvas').dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
  }, names, scene);
  await drop('gone.ply', 'here.toml');
  await visit.until((now) => now.path === '/files/here.toml');
  await drop('gone.toml');
  await visit.until((now) => now.notice.includes('gone.toml'));
  await visit.page.keyboard.press(' ');
  await visit.until((now) => now.path === '/files/here.toml' && now.position === 1);
  await visit.page.close();
});

test('a touch presses where it is', async () => {
  const visit = await Visit.begin(browser, server.address, { hasTouch: true });
  const [x, y, width, height] = (await visit.report()).items.step;
  await visit.tap(x + width / 2, y + height / 2);
  await visit.until((now) => now.position >= 1);  // a slow machine takes a click for holding the button down
  await visit.page.close();
});

test('keys of the program are its own, and the browser keeps those that it needs', async () => {
  const visit = await Visit.begin(browser, server.address);
  const taken = (key, more = {}) => visit.page.evaluate((key, more) => {
    const event = new KeyboardEvent('keydown', { key, keyCode: key.length === 1 ? key.toUpperCase().charCodeAt(0) : 0, cancelable: true, bubbles: true, ...more });
    window.dispatchEvent(event);
    return event.defaultPrevented;
  }, key, more);
  for (const key of ['F1', 'F2', 'F3', 'F10']) assert.ok(await taken(key), key);
  for (const key of ['s', 'o', 'p', 'e']) assert.ok(await taken(key, { ctrlKey: true }), `Ctrl+${key}`);
  for (const key of ['F11', 'F12']) assert.ok(!await taken(key), key);
  for (const key of ['l', 't', 'w', 'r', 'c', 'v']) assert.ok(!await taken(key, { ctrlKey: true }), `Ctrl+${key}`);
  await visit.page.close();
});

test('lessons, help and other languages are there', async () => {
  const visit = await Visit.begin(browser, server.address, {}, '&language=es');
  await visit.page.keyboard.press('F2');
  await visit.until((now) => 'lesson' in now);
  await visit.page.screenshot({ path: join(pictures, 'lessons.png') });
  await visit.page.keyboard.press('F1');
  await visit.until((now) => now.mode === 'help');
  await visit.page.screenshot({ path: join(pictures, 'help.png') });
  assert.equal((await visit.report()).language, 'es');
  assert.deepEqual(visit.complaints, []);
  await visit.page.close();
});

test('the page fills a window that changes', async () => {
  const visit = await Visit.begin(browser, server.address);
  await visit.page.setViewport({ width: 900, height: 640, deviceScaleFactor: 2 });
  await visit.until((now) => now.window.width === 900 && now.window.height === 640);
  const canvas = await visit.page.evaluate(() => [document.getElementById('canvas').width, document.getElementById('canvas').height]);
  assert.deepEqual(canvas, [1800, 1280]);
  await visit.page.close();
});

test('an edit survives a reload, and belongs to its tab while that lives', async () => {
  const visit = await Visit.begin(browser, server.address);
  await visit.add_sphere();
  await visit.until((now) => now.dirty);
  await visit.page.waitForFunction(() => window.raywalk.FS.analyzePath('/kept/autosave.toml').exists, { timeout: 60000 });
  const other = await Visit.begin(browser, server.address, {}, '', visit);
  assert.equal((await other.report()).question, '');
  await other.page.close();
  await visit.page.reload();
  await visit.page.waitForFunction(() => document.getElementById('says').hidden);
  await visit.until((now) => now.question === 'recover');
  await visit.page.keyboard.press('Enter');
  await visit.until((now) => now.question === '' && now.dirty);
  await visit.page.close();
});

test('what is not saved yet is kept when the page is hidden, and again after the browser has closed its database', async () => {
  const visit = await Visit.begin(browser, server.address), { page } = visit;
  // Waits until a file whose key begins so has so many parts between such marks.
  const kept = (key, mark, parts) => page.waitForFunction(async (begin, mark, parts) => {
    const done = (request) => new Promise((resolve) => { request.onsuccess = () => resolve(request.result); });
    const store = (await done(indexedDB.open('raywalk', 1))).transaction('files').objectStore('files');
    const [keys, contents] = await Promise.all([done(store.getAllKeys()), done(store.getAll())]);
    const file = contents[keys.findIndex((key) => key.startsWith(begin))];
    return file && new TextDecoder().decode(file).split(mark).length === parts;
  }, { timeout: 60000, polling: 200 }, key, mark, parts);
  const parts = readFileSync(join(process.env.RAYWALK_SOURCE_DIR, 'scenes/classic.toml'), 'utf8').split('[[object]]').length;
  await visit.add_sphere();
  await visit.until((now) => now.dirty && now.undo === 1);
  await kept('own/', '[[object]]', parts + 1);
  await visit.add_sphere();
  await visit.until((now) => now.undo === 2);
  // Before the next autosave is due; and a page that is hidden has no frames.
  await page.evaluate(() => {
    window.requestAnimationFrame = () => 0;
    Object.defineProperty(document, 'hidden', { value: true });
    document.dispatchEvent(new Event('visibilitychange'));
  });
  await kept('own/', '[[object]]', parts + 2);
  await page.evaluate(() => {
    const own = IDBDatabase.prototype.transaction;
    IDBDatabase.prototype.transaction = () => {
      IDBDatabase.prototype.transaction = own;
      throw new DOMException('closed', 'InvalidStateError');
    };
    window.raywalk.FS.writeFile('/kept/later', 'a|b');
    document.dispatchEvent(new Event('visibilitychange'));
  });
  await kept('shared/later', '|', 2);
  assert.ok(await page.evaluate(() => document.getElementById('says').hidden), 'the page goes on');
  await page.close();
});

test('on a host without encryption work belongs to its tab while that lives, and then to the next one', async () => {
  const visit = await Visit.begin(browser, server.address), { page } = visit;
  const begin = async (page, go) => {
    await page.evaluateOnNewDocument(() => Object.defineProperty(navigator, 'locks', { value: undefined }));
    await go();
    await page.waitForFunction(() => window.raywalk && document.getElementById('says').hidden, { timeout: 120000 });
    return page;
  };
  const another = async () => {
    const page = await visit.context.newPage();
    return begin(page, () => page.goto(`${server.address}?language=en`));
  };
  const has_work = (page) => page.evaluate(() => window.raywalk.FS.readdir('/kept').includes('autosave.toml'));
  await begin(page, () => page.reload());
  await visit.add_sphere();
  await visit.until((now) => now.dirty && now.undo === 1);
  await begin(page, () => page.reload());
  assert.ok(await has_work(page));
  const other = await another();
  assert.ok(!await has_work(other));
  await other.close();
  await page.close();
  const next = await another();
  assert.ok(await has_work(next));
  await next.close();
});

test('a drawing that the browser drops and gives back is as it was', async () => {
  const visit = await Visit.begin(browser, server.address), { page } = visit;
  await visit.until(image_done, 'the image is finished');
  await visit.rests();
  const before = await page.screenshot({ encoding: 'base64' });
  await page.evaluate(() => {
    const canvas = document.getElementById('canvas'), losing = canvas.getContext('webgl2').getExtension('WEBGL_lose_context');
    canvas.addEventListener('webglcontextlost', () => setTimeout(() => losing.restoreContext(), 500));
    canvas.addEventListener('webglcontextrestored', () => { window.restored = true; });
    losing.loseContext();
  });
  await page.waitForFunction(() => window.restored && document.getElementById('says').hidden);
  await visit.rests();
  assert.ok(await page.screenshot({ encoding: 'base64' }) === before, 'the picture of the page is the same'); // not both, in letters
  await visit.act('ask-open'); // whose pictures are read again
  await visit.until((now) => now.prompt === 'open');
  await page.keyboard.press('Escape');
  await visit.until((now) => now.prompt === '');
  await page.keyboard.press(' ');
  await visit.until((now) => now.position === 1);
  assert.deepEqual(visit.complaints, []);
  await page.close();
});

test('a drawing that the browser drops is said to be gone, and the work is kept', async () => {
  const visit = await Visit.begin(browser, server.address, {}, '&language=en'), { page } = visit;
  await visit.add_sphere();
  await visit.until((now) => now.dirty && now.undo === 1);
  await page.evaluate(() => document.getElementById('canvas').getContext('webgl2').getExtension('WEBGL_lose_context').loseContext());
  await page.waitForFunction(() => /drawing's memory.*\n.*is kept/.test(document.getElementById('says').textContent));
  await page.reload();
  await page.waitForFunction(() => window.raywalk && document.getElementById('says').hidden, { timeout: 120000 });
  assert.ok(await page.evaluate(() => window.raywalk.FS.readdir('/kept').includes('autosave.toml')));
  await page.close();
});

test('the presenter\'s notes have a tab of their own, which keeps the ends of their lines', only_in_chromium, async () => {
  const visit = await Visit.begin(browser, server.address, {}, '&language=en#v=1/lesson=01-ray-casting/at=2');
  const [notes] = await Promise.all([new Promise((opened) => visit.page.once('popup', opened)), visit.act('notes-window on')]);
  await notes.waitForFunction(() => document.body.textContent && getComputedStyle(document.body).whiteSpace === 'pre-line');
  assert.deepEqual(visit.complaints, []);
  await visit.page.close();
});

test('work on a scene with a file of the user\'s is recovered once that is there again', async () => {
  const visit = await Visit.begin(browser, server.address), { page } = visit;
  const scenes = join(process.env.RAYWALK_SOURCE_DIR, 'scenes');
  await (await page.$('#chooser')).uploadFile(join(scenes, 'mesh.toml'), join(scenes, 'ball.ply'));
  await visit.until((now) => now.path === '/files/mesh.toml');
  await visit.add_sphere();
  await visit.until((now) => now.dirty);
  await page.waitForFunction(() => window.raywalk.FS.analyzePath('/kept/autosave.toml').exists, { timeout: 60000 });
  await page.reload();
  await page.waitForFunction(() => document.getElementById('says').hidden);
  await visit.until((now) => now.question === 'recover');
  await page.keyboard.press('Enter');
  await visit.until((now) => now.question === 'recover' && 'question-device' in now.items);
  await (await page.$('#chooser')).uploadFile(join(scenes, 'ball.ply'));
  await page.waitForFunction(() => window.raywalk.FS.analyzePath('/files/ball.ply').exists);
  await page.keyboard.press('Enter');
  await visit.until((now) => now.question === '' && now.dirty && now.path === '/files/mesh.toml');
  assert.deepEqual(visit.complaints, []);
  await page.close();
});

test('of two tabs that are gone both edits are kept, and the later one is offered', async () => {
  const visit = await Visit.begin(browser, server.address, {}, '&language=en');
  const own = await visit.page.evaluate(() => sessionStorage.getItem('raywalk'));
  // As tabs left them: one under a key before this tab's own by order, one under it.
  await visit.page.evaluate(async (keys) => {
    const opening = indexedDB.open('raywalk', 1);
    const done = (request) => new Promise((resolve) => { request.onsuccess = () => resolve(request.result); });
    const store = (await done(opening)).transaction('files', 'readwrite').objectStore('files');
    const text = (minute) => `# autosave of: /files/${minute}.toml\n# written on: 2026-11-21 at 14:0${minute}\n` +
      `title = "At ${minute}"\n[camera]\neye = [-5, 0, 0]\nlook_at = [0, 0, 0]\nfov = 40\n`;
    await Promise.all(keys.map((key, minute) => done(store.put(new TextEncoder().encode(text(minute)), key))));
  }, ['own/!/autosave.toml', `own/${own}/autosave.toml`, 'own/~/autosave.toml', 'own/!/autosave-2.toml']);
  await visit.page.reload();
  await visit.page.waitForFunction(() => document.getElementById('says').hidden);
  await visit.until((now) => now.question === 'recover');
  const kept = await visit.page.evaluate(async (own) => {
    const done = (request) => new Promise((resolve) => { request.onsuccess = () => resolve(request.result); });
    const store = (await done(indexedDB.open('raywalk', 1))).transaction('files').objectStore('files');
    const [keys, contents] = await Promise.all([done(store.getAllKeys()), done(store.getAll())]);
    const files = keys.map((key, i) => [key.replace(own, 'ME'), /"(.*)"/.exec(new TextDecoder().decode(contents[i]))?.[1]]);
    return Object.fromEntries(files.filter(([key]) => key.startsWith('own/')));
  }, own);
  assert.deepEqual(kept, { 'own/ME/autosave.toml': 'At 3', 'own/ME/autosave-2.toml': 'At 2',
    'own/ME/autosave-3.toml': 'At 1', 'own/ME/autosave-4.toml': 'At 0' });
  await visit.page.keyboard.press('Enter');
  await visit.until((now) => now.question === '' && now.dirty);
  const told = await visit.page.evaluate(() => JSON.parse(window.raywalk.ccall('page_told', 'string')));
  assert.equal(told.moment.scene, 'At 3');
  await visit.page.close();
});

test('an address makes the page report into a file of its own, and into no other', async () => {
  for (const path of ['/kept/settings.json', '/files/report.json', '/report.txt', '/../kept/x.json', 'report.json']) {
    const page = await browser.newPage();
    await page.goto(`${server.address}?report=${encodeURIComponent(path)}`);
    await page.waitForFunction(() => document.getElementById('says').hidden && window.raywalk, { timeout: 120000 });
    await page.keyboard.press(' ');
    await new Promise((again) => setTimeout(again, 500));
    const wrote = await page.evaluate((path) => {
      const { FS } = window.raywalk;
      const text = FS.analyzePath(path).exists ? FS.readFile(path, { encoding: 'utf8' }) : '';
      return text.includes('"position"');
    }, path);
    assert.ok(!wrote, path);
    await page.close();
  }
});

test('a file that is chosen is opened, and one that is saved is downloaded', async () => {
  const visit = await Visit.begin(browser, server.address);
  if (!is_firefox) {
    const session = await browser.target().createCDPSession();
    await session.send('Browser.setDownloadBehavior',
      { behavior: 'allow', downloadPath: downloads, browserContextId: visit.context.id });
  }
  const chooser = await visit.page.$('#chooser');
  const scenes = join(process.env.RAYWALK_SOURCE_DIR, 'scenes');
  await chooser.uploadFile(join(scenes, 'mesh.toml'), join(scenes, 'ball.ply'));
  await visit.until((now) => now.path === '/files/mesh.toml');
  await visit.page.keyboard.down('Control');
  await visit.page.keyboard.press('s');
  await visit.page.keyboard.up('Control');
  // Firefox begins with an empty file of this name.
  const saved = join(downloads, 'mesh.toml');
  for (let tries = 0; tries < 100 && !(statSync(saved, { throwIfNoEntry: false })?.size > 0); ++tries)
    await new Promise((again) => setTimeout(again, 100));
  assert.equal(readFileSync(saved, 'utf8'), readFileSync(join(scenes, 'mesh.toml'), 'utf8'));
  await visit.page.close();
});

test('a scene is saved into the file that it was opened from, or for which the browser was told a place once', only_in_chromium, async () => {
  const visit = await Visit.begin(browser, server.address), { page } = visit;
  const scene = readFileSync(join(process.env.RAYWALK_SOURCE_DIR, 'scenes/classic.toml'), 'utf8');
  // The browser's private files stand in for the user's.
  await page.evaluateOnNewDocument((scene) => {
    const file = async (name) => (await navigator.storage.getDirectory()).getFileHandle(name, { create: true });
    const { prototype } = FileSystemFileHandle;
    Object.assign(window, { file, downloads: 0, asked: 0, answer: null });
    HTMLAnchorElement.prototype.click = () => { ++window.downloads; };
    window.showSaveFilePicker = ({ suggestedName }) => {
      ++window.asked;
      return window.answer ? Promise.reject(new DOMException('no', window.answer)) : file(suggestedName);
    };
    window.showOpenFilePicker = async () => {
      const own = await file('mine.toml'), writing = await own.createWritable();
      await writing.write(scene);
      await writing.close();
      return [own];
    };
    prototype.requestPermission = async () => window.answer ? 'denied' : 'granted';
  }, scene);
  await page.reload();
  await page.waitForFunction(() => window.raywalk && document.getElementById('says').hidden, { timeout: 120000 });
  // While it is being written it cannot be read.
  const objects_in = (name) => page.evaluate(async (name) =>
    (await (await window.file(name)).getFile().then((file) => file.text()).catch(() => '')).split('[[object]]').length, name);
  const with_objects = async (name, count) => {
    for (let tries = 0; await objects_in(name) !== count; ++tries) {
      assert.ok(tries < 200, `${name} has ${count} parts`);
      await new Promise((again) => setTimeout(again, 50));
    }
  };
  const answer = (how) => page.evaluate((how) => { window.answer = how; }, how);
  const objects = scene.split('[[object]]').length;

  await answer('AbortError'); // of who closes the dialog
  await visit.act('save-as /files/new.toml');
  await visit.until((now) => now.dirty && now.notice.includes('new.toml is not saved'));
  await answer(null);
  await visit.act('save');
  await with_objects('new.toml', objects);
  await visit.add_sphere();
  await visit.until((now) => now.dirty);
  await visit.act('save');
  await with_objects('new.toml', objects + 1);
  await visit.until((now) => !now.dirty);
  assert.equal(await page.evaluate(() => window.asked), 2);

  await page.evaluate(() => window.raywalk.chooseFiles());
  await visit.until((now) => now.path === '/files/mine.toml');
  await answer('NotAllowedError');
  await visit.add_sphere();
  await visit.until((now) => now.dirty);
  await visit.act('save');
  await visit.until((now) => now.dirty && now.notice.includes('mine.toml is not saved'));
  await with_objects('mine.toml', objects);
  await answer(null);
  await visit.act('save');
  await with_objects('mine.toml', objects + 1);
  assert.deepEqual(await page.evaluate(() => [window.asked, window.downloads]), [2, 0]);

  await answer('SecurityError'); // of a frame of another host's
  await visit.act('save-as /files/third.toml');
  await page.waitForFunction(() => window.downloads === 1);
  await visit.until((now) => !now.dirty && now.path === '/files/third.toml');
  assert.deepEqual(visit.complaints, []);
  await page.close();
});
