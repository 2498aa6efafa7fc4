// The page's figures: how large it is, how soon it can be used, what a STEP costs, and what pictures cost against the
// native program in one thread. Times are the medians of several tries.
import { spawnSync } from 'node:child_process';
import { readFileSync, readdirSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { brotliCompressSync, gzipSync } from 'node:zlib';
import { build, open_browser, serve, site } from './browser.mjs';

const median = (numbers) => [...numbers].sort((a, b) => a - b)[Math.floor(numbers.length / 2)];
const print = (what, value, goal) => console.log(`${what.padEnd(58)} ${value.padStart(14)}   ${goal}`);
const megabytes = (bytes) => `${(bytes / 1e6).toFixed(2)} MB`;

print('raywalk.html, gzipped', megabytes(gzipSync(readFileSync(join(site, 'raywalk.html')), { level: 9 }).length), '2.00');
// What a visit fetches: not the one file, the example, nor the code in letters.
const parts = readdirSync(site, { recursive: true })
  .filter((name) => /\.(html|js|wasm|css|svg|webmanifest)$/.test(name) && !/raywalk\.html|course\.html|code\.js/.test(name));
print('the site, by brotli', megabytes(parts.reduce((sum, name) => sum + brotliCompressSync(readFileSync(join(site, name))).length, 0)), '1.50');

const browser = await open_browser(), server = await serve();
const ready = () => performance.getEntriesByName('ready')[0]?.startTime;
const open_page = async (slower = 1, more = '') => {
  const page = await browser.newPage();
  await page.setViewport({ width: 1280, height: 720 });
  await page.emulateCPUThrottling(slower);
  await page.goto(server.address + more);
  await page.waitForFunction(ready, { polling: 10, timeout: 60000 });
  return page;
};

for (const [slower, goal] of [[1, '2'], [4, '4']]) {
  const times = [];
  for (let i = 0; i < 5; ++i) {
    const page = await open_page(slower);
    times.push(await page.evaluate(ready));
    await page.close();
  }
  print(`first STEP possible${slower > 1 ? `, slowed ${slower} times` : ''}`, `${(median(times) / 1000).toFixed(2)} s`, goal);
}

// Steps so many times; what each frame meanwhile took of the processor, in milliseconds, which other programs do not
// change. What the graphics card draws, or what stands in for it, is not among it.
async function frames_of_steps(page, count) {
  const path = join(tmpdir(), `raywalk-${process.pid}.json`);
  await page.tracing.start({ path, categories: ['devtools.timeline'] });
  for (let i = 0; i < count; ++i) {
    await page.keyboard.press('Space');
    await new Promise((next) => setTimeout(next, 120));
  }
  await page.tracing.stop();
  const { traceEvents } = JSON.parse(readFileSync(path, 'utf8'));
  rmSync(path);
  return traceEvents.filter(({ name, tdur }) => name === 'FireAnimationFrame' && tdur !== undefined).map(({ tdur }) => tdur / 1000);
}
for (const [scene, rests] of [['classic', true], ['classic', false], ['cornell', false], ['distributed', false]]) {
  const page = await open_page(1, `?scene=${scene}`);
  if (rests) await new Promise((again) => setTimeout(again, 15000)); // its picture is made
  const frames = await frames_of_steps(page, 40);
  print(`${scene}: a frame of STEP${rests ? '' : ', a picture being made'}: median, longest`,
    `${median(frames).toFixed(1)} ${Math.max(...frames).toFixed(1)} ms`, rests ? '16' : '50');
  await page.close();
}
await browser.close();
server.end();

// Processor time, which other programs on this machine do not change.
const program = await createRequire(import.meta.url)(join(build, 'web/raywalk.js'))({ noInitialRun: true });
for (const scene of ['whitted', 'classic']) {
  const file = join(tmpdir(), `raywalk-${process.pid}.pfm`), own = [], native = [];
  for (let i = 0; i < 5; ++i) {
    const before = process.cpuUsage();
    program.ccall('page_render', 'string', ['string', 'string', 'number', 'number', 'number'],
      [`/raywalk/scenes/${scene}.toml`, '/own.pfm', 1323, 993, 0]);
    const { user, system } = process.cpuUsage(before);
    own.push((user + system) / 1e6);
    const { stderr } = spawnSync('bash', ['-c', 'TIMEFORMAT="%U %S"; time "$0" "$@"', join(build, 'release/raywalk'), 'render',
      `${process.env.RAYWALK_SOURCE_DIR}/scenes/${scene}.toml`, '-o', file, '--size', '1323x993', '--threads', '1', '--quiet'],
    { encoding: 'utf8' });
    native.push(stderr.trim().split(' ').reduce((sum, seconds) => sum + Number(seconds), 0));
  }
  rmSync(file);
  print(`${scene}, 1323 x 993: page, native, ratio`,
    `${median(own).toFixed(2)} ${median(native).toFixed(2)} ${(median(own) / median(native)).toFixed(2)}`, scene === 'whitted' ? '1.60' : '');
}
