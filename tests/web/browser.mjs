// A browser without a window on the page, and the page's own report of what it shows. Chromium, or Firefox where
// RAYWALK_BROWSER says so; Firefox draws with WebGL only on a display (run.sh gives it one that nobody sees).
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before } from 'node:test';
import { inflateSync } from 'node:zlib';
import puppeteer from 'puppeteer-core';

export const build = process.env.RAYWALK_BUILD;
export const site = join(build, 'web/site');
export const pictures = join(build, 'web-tests/pictures');
mkdirSync(pictures, { recursive: true });

export const is_firefox = process.env.RAYWALK_BROWSER === 'firefox';
// For what Firefox's protocol does not offer.
export const only_in_chromium = { skip: is_firefox && 'in Chromium alone' };

export const open_browser = (preferences = {}, firefox = is_firefox) => puppeteer.launch(firefox ? {
  browser: 'firefox',
  protocol: 'webDriverBiDi',
  executablePath: '/usr/bin/firefox-esr',
  headless: false,
  extraPrefsFirefox: { 'webgl.force-enabled': true, 'dom.w3c_touch_events.enabled': 1, ...preferences },
} : {
  browser: 'chrome',
  executablePath: ['/usr/bin/chromium', '/usr/bin/chromium-browser'].find(existsSync),
  args: ['--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update',
    '--disable-sync', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
});

// What makes open_browser's Firefox save into a folder without a question; Chromium is told by a visit (saves_into).
export const saving_into = (folder) => ({ 'browser.download.dir': folder, 'browser.download.folderList': 2,
  'browser.download.useDownloadDir': true, 'browser.download.alwaysOpenPanel': false,
  'browser.helperApps.neverAsk.saveToDisk': 'application/octet-stream,text/html,text/plain,application/json,image/png,image/gif,image/svg+xml' });

// The site as any static host gives it: its address and how to end it.
export function serve() {
  const server = spawn('node', [join(process.env.RAYWALK_SOURCE_DIR, 'src/gui/web/serve.mjs'), site]);
  return new Promise((resolve, reject) => {
    server.stdout.on('data', (text) => resolve({ address: /http:\S+/.exec(text)[0], end: () => server.kill() }));
    server.on('exit', reject);
  });
}

// A browser and a site, for all tests of a file.
export let browser, server;
export function open_for_tests(preferences) {
  before(async () => {
    browser = await open_browser(preferences);
    server = await serve();
  });
  after(async () => {
    await browser?.close();
    server?.end();
  });
}

// What a page's own thread did while `act` ran: how long each frame took, and the longest of all that kept it from
// answering. Milliseconds of the processor, which other programs do not change. What the graphics card draws, or what
// stands in for it, is not among it. In Chromium alone.
export async function work_of(page, act) {
  const path = join(tmpdir(), `raywalk-${process.pid}.json`);
  await page.tracing.start({ path, categories: ['devtools.timeline'] });
  await act();
  await page.tracing.stop();
  const { traceEvents } = JSON.parse(readFileSync(path, 'utf8'));
  rmSync(path);
  const { pid, tid } = traceEvents.find(({ name }) => name === 'FireAnimationFrame');
  const taken = (...names) => traceEvents.filter((event) => event.pid === pid && event.tid === tid && names.includes(event.name) &&
    event.tdur !== undefined).map(({ tdur }) => tdur / 1000);
  const frames = taken('FireAnimationFrame');
  return { frames, longest: Math.max(...taken('FireAnimationFrame', 'FunctionCall', 'EventDispatch', 'TimerFire')) };
}

// What the program says in a language, by its key in src/text: word('es', 'lesson.reveal'). Names in braces are any.
export function word(language, key) {
  const [, section, name] = /^(.*)\.(.*)$/.exec(key);
  const text = readFileSync(join(process.env.RAYWALK_SOURCE_DIR, `src/text/${language}.toml`), 'utf8');
  const within = text.split(`\n[${section}]\n`)[1].split(/\n\[/)[0];
  return new RegExp(`^${name} = "(.*)"$`, 'm').exec(within)[1];
}

// What assistive technology is told: every node with its role and name. Firefox's protocol does not offer its tree: there
// what the page's elements say.
export async function spoken(page) {
  const nodes = [];
  if (is_firefox)
    return page.$$eval('#mirror :is(h1, h2, h3, p, span, button, label)', (all) => all.map((each) => ({ name: each.textContent,
      role: { H: 'heading', L: 'textbox' }[each.tagName[0]] ?? each.tagName.toLowerCase() })));
  const gather = (node) => {
    nodes.push(node);
    (node.children ?? []).forEach(gather);
  };
  gather(await page.accessibility.snapshot({ interestingOnly: false }));
  return nodes;
}

// Presses what has this role and name, or types into it, as a screen reader does: by its place in the tree, not on the screen.
export async function use(page, role, name, typed) {
  const quoted = name.replace(/ +/g, ' ').replaceAll('"', '\\"');
  const element = await page.waitForSelector(`aria/${quoted}[role="${role}"]`, { timeout: 60000 });
  if (typed === undefined) return element.evaluate((it) => it.click());
  await element.focus();
  await page.keyboard.type(typed);
  await page.keyboard.press('Enter');
}

// Goes on by Tab, with Shift back, until the focus is on what says this.
export async function tab_to(page, name, back = false) {
  const seen = [];
  if (back) await page.keyboard.down('Shift');
  try {
    for (let i = 0; i < 400; ++i) {
      await page.keyboard.press('Tab');
      const now = await page.evaluate(() => {
        const at = document.activeElement;
        return at.labels?.[0]?.textContent ?? (at.tagName === 'CANVAS' ? 'canvas' : at.textContent);
      });
      if (now.startsWith(name)) return now;
      seen.push(now);
    }
  } finally {
    if (back) await page.keyboard.up('Shift');
  }
  throw new Error(`Tab never comes to ${name}, only to ${[...new Set(seen)].join(' | ')}`);
}

// The width and height of a PNG of a browser's, and the colours of its pixels, four bytes each.
export function pixels_of(png) {
  const width = png.readUInt32BE(16), height = png.readUInt32BE(20), channels = { 2: 3, 6: 4 }[png[25]], parts = [];
  assert.ok(channels && png[24] === 8 && png[28] === 0, 'a picture of bytes, not interlaced');
  for (let at = 8; at < png.length;) {
    const length = png.readUInt32BE(at);
    if (png.toString('latin1', at + 4, at + 8) === 'IDAT') parts.push(png.subarray(at + 8, at + 8 + length));
    at += length + 12;
  }
  const packed = inflateSync(Buffer.concat(parts)), row = width * channels, data = Buffer.alloc(width * height * 4, 255);
  let above = new Uint8Array(row);
  for (let y = 0; y < height; ++y) {
    const filter = packed[y * (row + 1)], now = packed.subarray(y * (row + 1) + 1, (y + 1) * (row + 1));
    for (let i = 0; i < row; ++i) {
      const left = i < channels ? 0 : now[i - channels], up = above[i], corner = i < channels ? 0 : above[i - channels];
      if (filter === 1) now[i] += left;
      else if (filter === 2) now[i] += up;
      else if (filter === 3) now[i] += (left + up) >> 1;
      else if (filter === 4) {
        const p = Math.abs(up - corner), q = Math.abs(left - corner), r = Math.abs(left + up - 2 * corner);
        now[i] += p <= q && p <= r ? left : q <= r ? up : corner;
      }
    }
    for (let x = 0; x < width; ++x) now.copy(data, 4 * (y * width + x), x * channels, (x + 1) * channels);
    above = now;
  }
  return { width, height, data };
}

// Does an action, as a demo file has it, in a task of the page's own.
export const act_in = (page, line) => page.evaluate((line) => setTimeout(() => {
  window.raywalk.ccall('page_act', null, ['string'], [line]);
  window.dispatchEvent(new Event('focus'));
}), line);

// A page of the program, 1280 x 720 unless `size` says otherwise.
export class Visit {
  // In a browser of nobody's before, unless it is in that of an earlier visit.
  static async begin(browser, address, size = {}, more = '', earlier = null) {
    const visit = new Visit;
    visit.context = earlier?.context ?? await browser.createBrowserContext();
    visit.page = await visit.context.newPage();
    visit.complaints = [];
    visit.page.on('console', (said) => said.type() === 'error' && visit.complaints.push(said.text()));
    visit.page.on('pageerror', (error) => visit.complaints.push(String(error)));
    visit.requests = [];
    visit.page.on('request', (request) => visit.requests.push(request.url()));
    // Nobody answers a dialog of the browser's own: what is saved is downloaded, unless a test stands in for it.
    await visit.page.evaluateOnNewDocument(() => { for (const name of ['showOpenFilePicker', 'showSaveFilePicker']) delete window[name]; });
    await visit.page.setViewport({ width: 1280, height: 720, ...size });
    visit.begun = Date.now();
    await visit.page.goto(`${address}?report=/report.json${more || '&language=en'}`); // `more` may end in a link
    await visit.page.waitForFunction(() => document.getElementById('says').hidden, { timeout: 120000 });
    await visit.settled();
    return visit;
  }
  // What tests of the desktop's window read too (gui/report.h).
  report() {
    return this.page.evaluate(() => {
      try {
        return JSON.parse(window.raywalk.FS.readFile('/report.json', { encoding: 'utf8' }));
      } catch {
        return null;
      }
    });
  }
  // Waits until what is reported is as `is` wants it.
  async until(is, what = String(is), most = 180000) { // milliseconds: a machine may be busy
    const last = Date.now() + most;
    for (;;) {
      const report = await this.report();
      if (report && is(report)) return report;
      if (Date.now() > last) throw new Error(`never: ${what}`);
      await new Promise((again) => setTimeout(again, 20));
    }
  }
  // Does an action, as a demo file has it.
  act(line) {
    return act_in(this.page, line);
  }
  // Changes the scene.
  async add_sphere() {
    await this.page.keyboard.press('m');
    await this.until((now) => now.mode === 'move');
    await this.page.keyboard.down('Shift');
    await this.page.keyboard.press('1');
    await this.page.keyboard.up('Shift');
  }
  // Where this visit's downloads go, in Chromium: Firefox is begun with `saving_into`.
  async saves_into(folder) {
    if (is_firefox) return;
    const session = await this.page.browser().target().createCDPSession();
    await session.send('Browser.setDownloadBehavior',
      { behavior: 'allow', downloadPath: folder, browserContextId: this.context.id });
  }
  copy_link() {
    return this.act('copy-link');
  }
  settled() {
    return this.until(() => true);
  }
  // Waits until no frame has been drawn for half a second.
  async rests() {
    let frames = -1, since = 0;
    await this.until((now) => {
      if (now.window.frames !== frames) [frames, since] = [now.window.frames, Date.now()];
      return Date.now() - since > 500;
    }, 'it rests');
  }
  // Touches with these fingers, each its [x, y]: touchstart, touchmove or touchend. A browser's own way where it has one.
  async touch(type, ...points) {
    if (!is_firefox) {
      this.session ??= await this.page.createCDPSession();
      return this.session.send('Input.dispatchTouchEvent',
        { type: type.replace(/^touch./, (start) => start.slice(0, -1) + start.at(-1).toUpperCase()),
          touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
    }
    return this.page.evaluate((type, points) => {
      const target = document.getElementById('canvas');
      const touches = points.map(([clientX, clientY], identifier) => new window.Touch({ identifier, target, clientX, clientY }));
      target.dispatchEvent(new TouchEvent(type, { touches, targetTouches: touches, changedTouches: touches, bubbles: true, cancelable: true }));
    }, type, points);
  }
  async tap(x, y) {
    // At once: a finger that rests is something else, and a busy browser passes two requests on slowly.
    this.session ??= is_firefox ? null : await this.page.createCDPSession();
    await Promise.all([this.touch('touchstart', [x, y]), this.touch('touchend')]);
  }
  // What the window shows there, in CSS pixels, or all of it.
  async pixels(clip) {
    return pixels_of(Buffer.from(await this.page.screenshot(clip ? { clip } : {})));
  }
  // How many parts stand apart from left to right in what is written on an item: about as many as its word has letters.
  async letters_on(item) {
    const { items: { [item]: [x, y, width, height] } } = await this.until((now) => item in now.items, `there is an item ${item}`);
    const picture = await this.page.screenshot({ clip: { x: x + 2, y: y + 2, width: width - 4, height: height - 4 }, encoding: 'base64' });
    const blank = await this.context.newPage(); // where no policy forbids to open it
    const apart = await blank.evaluate(async (source) => {
      const image = new Image;
      image.src = source;
      await image.decode();
      const canvas = new OffscreenCanvas(image.width, image.height), context = canvas.getContext('2d');
      context.drawImage(image, 0, 0);
      const { data } = context.getImageData(0, 0, image.width, image.height);
      const unlike = (a, b) => Math.abs(data[a] - data[b]) + Math.abs(data[a + 1] - data[b + 1]) + Math.abs(data[a + 2] - data[b + 2]) > 90;
      const is_written = (column) => Array.from({ length: image.height }, (_, row) => 4 * (row * image.width + column))
        .some((pixel) => unlike(pixel, 4 * image.width * (image.height >> 1)));
      return Array.from({ length: image.width }, (_, column) => is_written(column)).filter((is, i, all) => is && !all[i - 1]).length;
    }, `data:image/png;base64,${picture}`);
    await blank.close();
    return apart;
  }
  async click(item) {
    const report = await this.until((now) => item in now.items, `there is an item ${item}`);
    const [x, y, width, height] = report.items[item];
    await this.page.mouse.move(x + width / 2, y + height / 2);
    await this.page.mouse.down();
    await new Promise((again) => setTimeout(again, 60));
    await this.page.mouse.up();
  }
}
