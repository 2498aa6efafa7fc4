// A browser without a window on the page, and the page's own report of what it shows. Chromium, or Firefox where
// RAYWALK_BROWSER says so; Firefox draws with WebGL only on a display (run.sh gives it one that nobody sees).
import { spawn } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
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

// The site as any static host gives it: its address and how to end it.
export function serve() {
  const server = spawn('node', [join(process.env.RAYWALK_SOURCE_DIR, 'src/gui/web/serve.mjs'), site]);
  return new Promise((resolve, reject) => {
    server.stdout.on('data', (text) => resolve({ address: /http:\S+/.exec(text)[0], end: () => server.kill() }));
    server.on('exit', reject);
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
