// The page's figures: how large it is, how soon it can be used, what a STEP costs, and what pictures cost against the
// native program in one thread. Times are the medians of several tries; seconds on the clock depend on what else runs,
// so they stand beside the machine's load.
import { spawnSync } from 'node:child_process';
import { readFileSync, readdirSync, rmSync } from 'node:fs';
import { cpus, loadavg, tmpdir } from 'node:os';
import { join } from 'node:path';
import { brotliCompressSync, gzipSync } from 'node:zlib';
import { act_in, build, open_browser, serve, site, work_of } from './browser.mjs';

const median = (numbers) => [...numbers].sort((a, b) => a - b)[Math.floor(numbers.length / 2)];
const print = (what, value, goal) => console.log(`${what.padEnd(58)} ${value.padStart(14)}   ${goal}`);
const megabytes = (bytes) => `${(bytes / 1e6).toFixed(2)} MB`;

print('raywalk.html, gzipped', megabytes(gzipSync(readFileSync(join(site, 'raywalk.html')), { level: 9 }).length), '2.00');
// What a visit fetches: not the one file, the example, nor the code in letters.
const parts = readdirSync(site, { recursive: true })
  .filter((name) => /\.(html|js|bin|css|svg|webmanifest)$/.test(name) && !/raywalk\.html|course\.html|code\.js/.test(name));
const sum_of = (size) => megabytes(parts.reduce((sum, name) => sum + size(readFileSync(join(site, name))).length, 0));
print('the site, by brotli', sum_of(brotliCompressSync), '1.50');
print('the site, packed by no host', sum_of((bytes) => bytes), '');

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

const load = () => console.log(`load of the machine: ${loadavg()[0].toFixed(1)} on ${cpus().length} processors`);
load();
for (const [slower, goal] of [[1, '2'], [4, '4']]) {
  const times = [];
  for (let i = 0; i < 7; ++i) {
    const page = await open_page(slower);
    times.push(await page.evaluate(ready));
    await page.close();
  }
  print(`first STEP possible${slower > 1 ? `, slowed ${slower} times` : ''}: shortest, median`,
    `${(Math.min(...times) / 1000).toFixed(2)} ${(median(times) / 1000).toFixed(2)} s`, goal);
}

async function each_in_turn(all, does) {
  for (const one of all) {
    await does(one);
    await new Promise((next) => setTimeout(next, 120));
  }
}
for (const [scene, rests] of [['classic', true], ['classic', false], ['cornell', false], ['distributed', false]]) {
  const page = await open_page(1, `?scene=${scene}`);
  if (rests) await new Promise((again) => setTimeout(again, 15000)); // its picture is made
  const { frames, longest } = await work_of(page, () => each_in_turn(Array(40).fill(), () => page.keyboard.press(' ')));
  print(`${scene}: a frame of STEP${rests ? '' : ', a picture being made'}: median, longest`,
    `${median(frames).toFixed(1)} ${longest.toFixed(1)} ms`, rests ? '16' : '50');
  await page.close();
}

// What is done beside the page or in slices between frames, the searches of a structure and the tries: what kept the page
// from answering longest meanwhile.
for (const [what, lines] of [
  ['sphereflake: structures searched', ['tab structure', ...Array(20).fill('step forward'), 'structure octree', 'structure kdtree', 'structure grid', 'structure none']],
  ['sphereflake: structures built', ['tab structure', 'structure-page build', 'structure bvh', 'structure octree', 'structure kdtree', 'structure grid']],
  ['cornell: tries of Cost', ['tab cost', 'cost-try ladder', ...Array(12).fill('step forward')]]]) {
  const page = await open_page(1, `?scene=${what.split(':')[0]}`);
  const { frames, longest } = await work_of(page, () => each_in_turn(lines, (line) => act_in(page, line)));
  print(`${what}: median frame, longest task`, `${median(frames).toFixed(1)} ${longest.toFixed(1)} ms`, '50');
  await page.close();
}

load();
// Seconds on the clock: a STEP until its pixels can be read, and the classic strip walked anew, to another depth.
const page = await open_page();
await new Promise((again) => setTimeout(again, 15000));
const [drawn, recorded, memory] = await page.evaluate(() => {
  const program = window.raywalk, gl = document.getElementById('canvas').getContext('webgl2'), drawn = [], recorded = [];
  const timed = (times, line, more = () => 0) => {
    const begun = performance.now();
    program.ccall('page_act', null, ['string'], [line]);
    more();
    times.push(performance.now() - begun);
  };
  for (let i = 0; i < 40; ++i)
    timed(drawn, 'step forward', () => {
      program._page_turn();
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
    });
  for (let i = 0; i < 10; ++i) timed(recorded, `depth ${1 + i % 2}`);
  return [drawn, recorded, program.HEAPU8.length + program.workers.memory()];
});
print('classic: STEP drawn by software: median', `${median(drawn).toFixed(1)} ms`, '50');
print('classic: the strip recorded anew: median', `${median(recorded).toFixed(1)} ms`, '30');
print('memory of page and workers', `${(memory / 2 ** 20).toFixed(0)} MiB`, '256');

// Processor time, which other programs on this machine do not change.
const metrics = await page.createCDPSession();
await metrics.send('Performance.enable');
const processor_time = async () => (await metrics.send('Performance.getMetrics')).metrics.find(({ name }) => name === 'ThreadTime').value;
for (const scene of ['whitted', 'classic']) {
  const file = join(tmpdir(), `raywalk-${process.pid}.pfm`), own = [], native = [];
  for (let i = 0; i < 5; ++i) {
    const before = await processor_time();
    await page.evaluate((file) => window.raywalk.ccall('page_render', 'string',
      ['string', 'string', 'number', 'number', 'string', 'string'], [file, '/own.pfm', 1323, 993, 'double', '']),
    `/raywalk/scenes/${scene}.toml`);
    own.push(await processor_time() - before);
    const { stderr } = spawnSync('bash', ['-c', 'TIMEFORMAT="%U %S"; time "$0" "$@"', join(build, 'release/raywalk'), 'render',
      `${process.env.RAYWALK_SOURCE_DIR}/scenes/${scene}.toml`, '-o', file, '--size', '1323x993', '--threads', '1', '--quiet'],
    { encoding: 'utf8' });
    native.push(stderr.trim().split(' ').reduce((sum, seconds) => sum + Number(seconds), 0));
  }
  rmSync(file);
  print(`${scene}, 1323 x 993: page, native, ratio`,
    `${median(own).toFixed(2)} ${median(native).toFixed(2)} ${(median(own) / median(native)).toFixed(2)}`, scene === 'whitted' ? '1.60' : '');
}
await page.close();
await browser.close();
server.end();
