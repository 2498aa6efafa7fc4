// A short set in WebKit, as Safari has it: WebKitGTK's small browser under its WebDriver (Debian's webkit2gtk-driver).
// The page starts and walks by mouse and keys, opens a link, answers a lesson, keeps its work, and speaks as text.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { existsSync, readdirSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:net';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { setTimeout as pause } from 'node:timers/promises';
import { pictures, pixels_of, serve } from './browser.mjs';

const libraries = '/usr/lib/x86_64-linux-gnu';
const browser = existsSync(libraries) && readdirSync(libraries).filter((name) => name.startsWith('webkit2gtk-')).sort()
  .map((name) => join(libraries, name, 'MiniBrowser')).findLast(existsSync);
const driver_file = ['/usr/bin/WebKitWebDriver'].find(existsSync);
const with_webkit = { skip: !(browser && driver_file) && 'WebKitGTK\'s driver is not installed' };

const free_port = () => new Promise((found) => {
  const server = createServer().listen(0, '127.0.0.1', () => {
    const { port } = server.address();
    server.close(() => found(port));
  });
});

let server, driver, port, session;
async function ask(method, path, body) {
  const answer = await fetch(`http://127.0.0.1:${port}${path}`, { method, ...body && { body: JSON.stringify(body) } });
  const { value } = await answer.json();
  if (value?.error) throw new Error(`${path}: ${value.error}: ${value.message}`);
  return value;
}
const act = (method, path, body) => ask(method, `/session/${session}${path}`, body);
const evaluate = (script, ...args) => act('POST', '/execute/sync', { script, args });

before(async () => {
  if (with_webkit.skip) return;
  server = await serve();
  port = await free_port();
  driver = spawn(driver_file, [`--port=${port}`], { stdio: 'ignore' });
  for (let tries = 0; tries < 100; ++tries) {
    if (await ask('GET', '/status').then(() => true, () => false)) break;
    await pause(100);
  }
  ({ sessionId: session } = await ask('POST', '/session', { capabilities: { alwaysMatch: { 'webkitgtk:browserOptions': { binary: browser, args: ['--automation'] } } } }));
  await act('POST', '/window/rect', { width: 1280, height: 800 });
});
after(async () => {
  if (session) await act('DELETE', '').catch(() => {});
  driver?.kill();
  server?.end();
});

async function until(is, what = String(is)) {
  for (const last = Date.now() + 60000; Date.now() < last; await pause(50)) {
    const text = await evaluate(`try { return window.raywalk.FS.readFile('/report.json', { encoding: 'utf8' }); } catch { return ''; }`);
    const report = text && JSON.parse(text);
    if (report && is(report)) return report;
  }
  throw new Error(`never: ${what}`);
}
async function open(more) {
  await act('POST', '/url', { url: 'about:blank' }); // a link alone would not load it anew
  await act('POST', '/url', { url: `${server.address}?report=/report.json&language=en${more}` });
  for (const last = Date.now() + 60000; !await evaluate('return document.getElementById("says").hidden && !!window.raywalk'); await pause(200))
    if (Date.now() > last) throw new Error(await evaluate('return document.getElementById("says").textContent'));
  await until(() => true);
}
const keys = (...pressed) => act('POST', '/actions', { actions: [{ type: 'key', id: 'keys', actions: pressed.flatMap((value) =>
  [{ type: 'keyDown', value }, { type: 'pause', duration: 60 }, { type: 'keyUp', value }]) }] });
const mouse = (...actions) => act('POST', '/actions', { actions: [{ type: 'pointer', id: 'mouse', parameters: { pointerType: 'mouse' }, actions }] });
async function click(item) {
  const { items: { [item]: [x, y, width, height] } } = await until((now) => item in now.items, `there is ${item}`);
  await mouse({ type: 'pointerMove', x: Math.round(x + width / 2), y: Math.round(y + height / 2) }, { type: 'pointerDown', button: 0 },
    { type: 'pause', duration: 60 }, { type: 'pointerUp', button: 0 });
}

test('in WebKit the page starts, walks by keys and by mouse, and is drawn', with_webkit, async () => {
  await open('');
  await evaluate('document.getElementById("canvas").focus()');
  await keys(' ');
  await until((now) => now.position === 1);
  await click('step');
  const { window: { width, height } } = await until((now) => now.position >= 2 && now.image.finished);
  const png = Buffer.from(await act('GET', '/screenshot'), 'base64');
  writeFileSync(join(pictures, 'webkit.png'), png);
  const { data, ...size } = pixels_of(png);
  assert.deepEqual(size, { width, height });
  const colours = new Set;
  for (let i = 0; i < data.length; i += 4) colours.add(data.readUInt32BE(i));
  assert.ok(colours.size > 500, `${colours.size} colours`);
});

test('in WebKit an object is dragged, and the work is there after the page is loaded again', with_webkit, async () => {
  await open('');
  const { objects: { 'Solid Sphere': { window: [x, y], plan } } } = await until((now) => now.mode === 'move');
  await mouse({ type: 'pointerMove', x: Math.round(x), y: Math.round(y) }, { type: 'pointerDown', button: 0 },
    ...[20, 40, 60].map((by) => ({ type: 'pointerMove', duration: 80, x: Math.round(x) + by, y: Math.round(y) + by / 2 })), { type: 'pause', duration: 100 }, { type: 'pointerUp', button: 0 });
  const moved = await until((now) => now.dirty && now.undo === 1);
  assert.ok(moved.objects['Solid Sphere'].plan[0] > plan[0]);
  for (const last = Date.now() + 60000; !await evaluate(`return window.raywalk.FS.analyzePath('/kept/autosave.toml').exists`); await pause(200))
    assert.ok(Date.now() < last, 'it is kept');
  await pause(1000);
  await open('');
  await until((now) => now.question === 'recover');
  await evaluate('document.getElementById("canvas").focus()');
  await keys('\uE007');
  const back = await until((now) => now.question === '' && now.dirty);
  assert.deepEqual(back.objects['Solid Sphere'].plan, moved.objects['Solid Sphere'].plan);
});

test('in WebKit a link opens a step of a lesson, and its question is answered by keys and as text', with_webkit, async () => {
  await open('#v=1/lesson=01-ray-casting/at=2');
  if ((await until(() => true)).question) await evaluate(`window.raywalk.ccall('page_act', null, ['string'], ['answer discard'])`); // of the test before
  await evaluate('window.dispatchEvent(new Event("focus"))');
  await until((now) => now.lesson?.step === 2 && now.question === '');
  await evaluate('document.getElementById("canvas").focus()');
  await keys('1', '\uE007');
  await until((now) => now.lesson.revealed && now.lesson.judged === 1);
  await evaluate('document.getElementById("as-text").click()');
  const press = async (name) => {
    for (const last = Date.now() + 20000; Date.now() < last; await pause(100))
      if (await evaluate(`const found = [...document.querySelectorAll('#mirror button')].find((each) => each.textContent.startsWith(arguments[0]));
        found?.click(); return !!found;`, name)) return;
    throw new Error(`no button ${name}`);
  };
  await press('Next');
  await until((now) => now.lesson.step === 3);
  await press('1  ');
  await press('Reveal');
  await until((now) => now.lesson.revealed && now.lesson.judged === 2);
});
