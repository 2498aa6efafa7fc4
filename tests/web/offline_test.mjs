// The page without a network, and the step from one version to the next.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { cpSync, mkdtempSync, readFileSync, readdirSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { only_in_chromium, open_browser, site } from './browser.mjs';

let browser, server, address;
const own = mkdtempSync(join(tmpdir(), 'raywalk-site-'));
const serve = (port) => new Promise((resolve, reject) => {
  server = spawn('node', [join(process.env.RAYWALK_SOURCE_DIR, 'src/gui/web/serve.mjs'), own, ...port ? [port] : []]);
  server.stdout.on('data', (text) => resolve(/http:\S+/.exec(text)[0]));
  server.on('exit', reject);
});

before(async () => {
  cpSync(site, own, { recursive: true });
  browser = await open_browser();
  address = await serve();
});
after(async () => {
  await browser?.close();
  server?.kill();
  rmSync(own, { recursive: true });
});

const version_in = (folder) => readdirSync(folder).find((name) => /^[0-9a-f]{16}$/.test(name));
const started = (page) => page.waitForFunction(() => document.getElementById('says').hidden, { timeout: 120000 });
const version_of = (page) => page.evaluate(() => document.querySelector('script[src]').src.match(/[0-9a-f]{16}/)[0]);
const kept = (page) => page.waitForFunction(async () => (await navigator.serviceWorker.getRegistration())?.active, { timeout: 60000 });

// The next version on the host: the same program in a folder of another name.
function publish(version) {
  const old = version_in(own);
  renameSync(join(own, old), join(own, version));
  for (const name of ['index.html', 'kept.js'])
    writeFileSync(join(own, name), readFileSync(join(own, name), 'utf8').replaceAll(old, version));
}

test('after the first visit the page opens without a network', async () => {
  const page = await browser.newPage();
  await page.goto(address + '?language=en');
  await started(page);
  await kept(page);
  server.removeAllListeners('exit');
  server.kill();
  await page.goto(address + '?language=pt#v=1/scene=glass/step=2');
  await started(page);
  assert.equal(await page.evaluate(() => document.documentElement.lang), 'pt');
  await page.goto(address + 'index.html');
  await started(page);
  await page.close();
  assert.equal(await serve(new URL(address).port), address);
});

test('a new version takes the place of the old one whole, once no page of the old one is open', async () => {
  const context = await browser.createBrowserContext();
  const first = await context.newPage();
  await first.goto(address);
  await started(first);
  await kept(first);
  const old = await version_of(first);
  await first.reload(); // from here on the service worker answers
  await started(first);
  publish('0123456789abcdef');
  await first.evaluate(async () => (await navigator.serviceWorker.getRegistration()).update());
  await first.waitForFunction(async () => (await navigator.serviceWorker.getRegistration()).waiting, { timeout: 60000 });
  // While the old one is open, all pages are the old one, with all of its files.
  const second = await context.newPage();
  await second.goto(address);
  await started(second);
  assert.equal(await version_of(second), old);
  await first.close();
  await second.close();
  await new Promise((again) => setTimeout(again, 1000));
  const third = await context.newPage();
  await third.goto(address);
  await started(third);
  if (await version_of(third) === old) { // the browser may take a moment to see that nobody is left
    await third.goto('about:blank');
    await new Promise((again) => setTimeout(again, 2000));
    await third.goto(address);
    await started(third);
  }
  assert.equal(await version_of(third), '0123456789abcdef');
  const caches_left = await third.evaluate(() => caches.keys());
  assert.deepEqual(caches_left, [`raywalk ${address} 0123456789abcdef`]);
  await context.close();
});

test('an update that cannot be had whole leaves what is kept', async () => {
  const context = await browser.createBrowserContext(), page = await context.newPage();
  await page.goto(address);
  await started(page);
  await kept(page);
  const worker = readFileSync(join(own, 'kept.js'), 'utf8'), icon = readFileSync(join(own, 'icon.svg'));
  writeFileSync(join(own, 'kept.js'), worker + '\n');
  rmSync(join(own, 'icon.svg'));
  const state = await page.evaluate(async () => {
    const registration = await navigator.serviceWorker.getRegistration();
    await registration.update();
    const { installing } = registration;
    return new Promise((settled) => { installing.onstatechange = () => settled(installing.state); });
  });
  assert.equal(state, 'redundant');
  assert.equal((await page.evaluate(() => caches.keys())).length, 1);
  writeFileSync(join(own, 'kept.js'), worker);
  writeFileSync(join(own, 'icon.svg'), icon);
  await context.close();
});

test('the page can be installed', only_in_chromium, async () => {
  const page = await browser.newPage();
  await page.goto(address);
  const session = await page.createCDPSession();
  const { url, errors, data } = await session.send('Page.getAppManifest');
  assert.ok(url.endsWith('manifest.webmanifest'));
  assert.deepEqual(errors, []);
  assert.equal(JSON.parse(data).display, 'standalone');
  await page.close();
});
