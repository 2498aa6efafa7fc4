// What a walk is exported to, Spot the bug, the microscope and Cost, as they are used in a browser; and a demo file.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, statSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { setTimeout as pause } from 'node:timers/promises';
import { pathToFileURL } from 'node:url';
import { Visit, browser, build, open_for_tests, pictures, pixels_of, saving_into, server, spoken, use } from './browser.mjs';

const downloads = mkdtempSync(join(tmpdir(), 'raywalk-exports-'));
open_for_tests(saving_into(downloads));
after(() => rmSync(downloads, { recursive: true }));

const source = process.env.RAYWALK_SOURCE_DIR;

// A file that was downloaded, once it is there: all of it, for Firefox begins with an empty one.
async function downloaded(name, is_whole = () => true) {
  for (let tries = 0; tries < 600; ++tries) {
    const path = join(downloads, name);
    if (statSync(path, { throwIfNoEntry: false })?.size > 0) {
      const bytes = readFileSync(path);
      if (is_whole(bytes)) return bytes;
    }
    await pause(100);
  }
  throw new Error(`${name} is never downloaded`);
}

// How many colours there are in a part of the window, of 4096: a blank one has few.
async function colours_in(visit, [x, y, width, height]) {
  const { data } = await visit.pixels({ x, y, width, height });
  const found = new Set;
  for (let i = 0; i < data.length; i += 4) found.add((data[i] >> 4) << 8 | (data[i + 1] >> 4) << 4 | data[i + 2] >> 4);
  return found.size;
}

async function export_by_mouse(visit, ending) {
  await visit.click('menu-file');
  await visit.click('menu/export');
  await visit.until((now) => now.prompt === 'export');
  await visit.click('export' + ending);
  for (let tries = 1; ; ++tries) { // a busy machine may miss a click; one more would meet what is behind the dialog
    if ((await visit.report()).prompt !== '') await visit.click('browser-accept');
    if (await visit.until((now) => now.prompt === '', `${ending} is exported`, 20000).catch((why) => { if (tries === 3) throw why; })) break;
  }
}

test('a walk is exported as numbers, words, drawing, picture, animation and page, each downloaded whole', async () => {
  const visit = await Visit.begin(browser, server.address, {}, '&language=en#v=1/scene=classic/step=40/mode=trace');
  await visit.saves_into(downloads);
  const { steps, window: { width, height } } = await visit.until((now) => now.position === 40);
  const native = (...more) => execFileSync(join(build, 'release/raywalk'), ['step', 'classic', ...more], { maxBuffer: 1 << 28 });

  await export_by_mouse(visit, '.txt');
  assert.equal((await downloaded('classic.txt')).toString(), native('--language', 'en').toString());
  await export_by_mouse(visit, '.json');
  const told = JSON.parse(await downloaded('classic.json', (bytes) => bytes.at(-2) === 0x7d || bytes.at(-1) === 0x7d));
  assert.deepEqual(told.steps, JSON.parse(native('--format', 'json')).steps);
  assert.equal(told.steps.length, steps);

  await export_by_mouse(visit, '.svg');
  const svg = (await downloaded('classic.svg', (bytes) => bytes.includes('</svg>'))).toString();
  for (const word of ['Solid Sphere', 'Polygon', 'EYE', 'SCREEN']) assert.ok(svg.includes(word), word);

  await export_by_mouse(visit, '.png');
  const png = await downloaded('classic.png', (bytes) => bytes.includes('IEND'));
  assert.deepEqual([png.readUInt32BE(16), png.readUInt32BE(20)], [width, height], 'the picture is as large as the window');
  const { data } = pixels_of(png), colours = new Set(Array.from({ length: data.length / 4 }, (_, i) => data.readUInt32BE(4 * i))).size;
  assert.ok(colours > 100, `it has ${colours} colours`);

  await export_by_mouse(visit, '.gif');
  const gif = await downloaded('classic.gif', (bytes) => bytes.at(-1) === 0x3b);
  assert.equal(gif.subarray(0, 6).toString(), 'GIF89a');
  assert.deepEqual([gif.readUInt16LE(6), gif.readUInt16LE(8)], [width, height]);
  assert.ok(gif.toString('latin1').split('\x21\xf9\x04').length > 3, 'it has a frame for each step');
  await visit.until((now) => now.position === 40, 'the walk is where it was');

  await export_by_mouse(visit, '.html');
  await downloaded('classic.html', (bytes) => bytes.includes('</html>'));
  const page = await visit.context.newPage(), wrong = [], asked = [];
  page.on('pageerror', (error) => wrong.push(String(error)));
  page.on('request', (request) => asked.push(request.url()));
  await page.goto(pathToFileURL(join(downloads, 'classic.html')).href);
  const before = await page.evaluate(() => document.body.innerText);
  await page.keyboard.press('ArrowRight');
  await page.waitForFunction((before) => document.body.innerText !== before, { timeout: 20000 }, before);
  await page.screenshot({ path: join(pictures, 'exported-page.png') });
  assert.deepEqual([wrong, asked.filter((url) => !/^(file|data|blob):/.test(url))], [[], []]);
  await page.close();
  assert.deepEqual(visit.complaints, []);
  await visit.page.close();
});

test('a lesson\'s script for its presenter is downloaded', async () => {
  const visit = await Visit.begin(browser, server.address, {}, '&language=pt#v=1/lesson=04-reflection/at=1');
  await visit.saves_into(downloads);
  await visit.until((now) => now.lesson?.step === 1);
  await visit.click('lesson-presenter');
  await visit.click('lesson-script');
  await visit.until((now) => now.prompt === 'export');
  await visit.click('browser-accept');
  await visit.until((now) => now.prompt === '');
  const script = (await downloaded('04-reflection.script.html', (bytes) => bytes.includes('</html>'))).toString();
  assert.ok(script.includes('lang="pt"'));
  assert.deepEqual(visit.complaints, []);
  await visit.page.close();
});

test('a demo file plays in the page as in the window, and every line of it is understood', async () => {
  const visit = await Visit.begin(browser, server.address);
  const lines = readFileSync(join(source, 'tests/gui/demos/spot_the_bug.demo'), 'utf8').split('\n').filter((line) => line && !line.startsWith('#'));
  assert.ok(lines.length > 8);
  const wrong = await visit.page.evaluate((lines) => lines.map((line) => window.raywalk.ccall('page_do', 'string', ['string', 'string'], [line, ''])), lines);
  assert.deepEqual(wrong, lines.map(() => ''));
  await visit.page.evaluate(() => window.dispatchEvent(new Event('focus')));
  const { bug } = await visit.until((now) => now.bug?.known);
  assert.deepEqual(bug, { mended: false, known: true, hunted: true });
  assert.notEqual(await visit.page.evaluate(() => window.raywalk.ccall('page_do', 'string', ['string', 'string'], ['no such action', ''])), '');
  assert.deepEqual(visit.complaints, []);
  await visit.page.close();
});

test('Spot the bug by mouse: a wrong line, the right one, mended and not, and back to one\'s own scene', async () => {
  const visit = await Visit.begin(browser, server.address);
  const { path, objects } = await visit.until(() => true);
  await visit.page.keyboard.down('Shift');
  await visit.page.keyboard.press('F2');
  await visit.page.keyboard.up('Shift');
  await visit.click('bug/2');
  const hunted = await visit.until((now) => now.bug?.hunted && 'banner' in now.items && 'bug-mark' in now.items);
  assert.ok(hunted.items.banner[1] + hunted.items.banner[3] <= hunted.items.plan[1], 'the strip takes nothing away from the plan');
  const { image: { hash: broken } } = await visit.until((now) => now.image.finished);
  await visit.click('line-6');
  await visit.click('bug-mark');
  await visit.rests();
  assert.ok(!(await visit.report()).bug.known, 'another line is not at fault');
  await visit.click('line-9');
  await visit.click('bug-mark');
  await visit.until((now) => now.bug.known && 'bug-mend' in now.items);
  await visit.page.screenshot({ path: join(pictures, 'bug-found.png') });
  await visit.click('bug-mend');
  const mended = await visit.until((now) => now.bug.mended && now.image.finished && now.image.hash !== broken, 'mended, the picture is another');
  assert.notEqual(mended.image.hash, broken);
  await visit.click('bug-mend');
  await visit.until((now) => !now.bug.mended && now.image.finished && now.image.hash === broken, 'with its bug the picture is as it was');
  await visit.click('bugs-list');
  await visit.until((now) => !now.bug && 'bug/2' in now.items);
  await visit.click('bugs-close');
  const own = await visit.until((now) => !('bugs' in now.items));
  assert.deepEqual([own.path, Object.keys(own.objects), own.dirty], [path, Object.keys(objects), false]);
  assert.deepEqual(visit.complaints, []);
  await visit.page.close();
});

test('Spot the bug by the accessibility tree alone', async () => {
  const visit = await Visit.begin(browser, server.address), { page } = visit;
  await use(page, 'button', 'Show as text, for screen readers and keyboards');
  await use(page, 'button', 'Spot the bug');
  await use(page, 'button', 'Bug 2');
  await visit.until((now) => now.bug?.hunted);
  const press = async (name) => {
    for (let tries = 0; tries < 100; ++tries) {
      const found = (await spoken(page)).find((node) => node.role === 'button' && node.name.startsWith(name));
      if (found) return use(page, 'button', found.name);
      await pause(100);
    }
    throw new Error(`no button is called ${name}`);
  };
  await press('Mark “Form reflect ray”');
  await press('Is it this line?');
  await visit.until((now) => now.bug.known);
  assert.ok((await spoken(page)).some(({ name }) => name?.startsWith('✓')), 'the verdict is told');
  await press('All bugs');
  await visit.until((now) => !now.bug);
  assert.deepEqual(visit.complaints, []);
  await page.close();
});

test('the microscope comes to single numbers, and naive ones are seen in the picture and taken back', async () => {
  const visit = await Visit.begin(browser, server.address, {}, '&language=en#v=1/scene=classic/mode=trace');
  await visit.click('line-6'); // Form shadow ray: something was hit
  await visit.until((now) => now.position > 4);
  await visit.page.keyboard.press('y');
  const at_first = await visit.until((now) => now.tab === 'microscope' && 'microscope' in now.items && 'microscope/row-0' in now.items);
  assert.ok(at_first.items.microscope[2] > 0.3 * 1280);
  const shown = async () => (await visit.rests(), (await visit.pixels(Object.fromEntries(['x', 'y', 'width', 'height']
    .map((name, i) => [name, Math.round(at_first.items.microscope[i])])))).data);
  const whole = await shown();
  await visit.page.mouse.move(at_first.items.microscope[0] + 200, at_first.items.microscope[1] + 200);
  await visit.page.mouse.wheel({ deltaY: -400 });
  const nearer = await visit.until((now) => now.magnified > 0);
  await visit.click('to-numbers');
  await visit.until((now) => now.magnified === 1);
  assert.ok(nearer.magnified < 1);
  const numbers = await shown();
  assert.ok(whole.some((byte, i) => Math.abs(byte - numbers[i]) > 60), 'it shows something else');
  assert.ok(await colours_in(visit, (await visit.report()).items.microscope) > 8);
  await visit.page.screenshot({ path: join(pictures, 'microscope.png') });
  await visit.click('precision-float');
  await visit.click('numerics-naive');
  await visit.until((now) => now.naive && now.undo === 1);
  await visit.page.keyboard.down('Control');
  await visit.page.keyboard.press('z');
  await visit.page.keyboard.up('Control');
  await visit.until((now) => !now.naive);
  await visit.click('to-scene');
  await visit.until((now) => now.magnified === 0);
  assert.deepEqual(visit.complaints, []);
  await visit.page.close();
});

test('Cost tries settings while the walk goes on, compares two pictures, and tells what each effect adds', async () => {
  const visit = await Visit.begin(browser, server.address);
  await visit.page.keyboard.press('F3');
  await visit.until((now) => now.tab === 'cost');
  await visit.click('cost-try');
  await visit.until((now) => now.cost.tried === 1 && now.cost.done === 1);
  await visit.click('cost-ladder');
  await visit.until((now) => now.cost.tried >= 4);
  await visit.page.keyboard.press('t');
  await visit.page.keyboard.press(' ');
  await visit.until((now) => now.mode === 'trace' && now.position >= 1);
  const { cost: { tried } } = await visit.report();
  await visit.until((now) => now.cost.done === tried && now.cost.reference_samples >= 64 && 'cost-mark-0' in now.items, 'all are tried');
  await visit.click('cost-mark-0');
  const chosen = await visit.until((now) => now.cost.chosen === 0 && 'cost-picture' in now.items && 'cost-plot' in now.items);
  await visit.rests();
  for (const part of ['cost-plot', 'cost-picture'])
    assert.ok(await colours_in(visit, chosen.items[part]) >= (part === 'cost-plot' ? 4 : 10), `${part} is drawn`);
  await visit.page.screenshot({ path: join(pictures, 'cost.png') });
  await visit.page.keyboard.press('F6');
  await visit.until((now) => now.cost.difference);
  await visit.click('cost-page');
  const effects = await visit.until((now) => now.cost.page === 'effects' && now.cost.surveyed === 1 && 'cost-effects' in now.items);
  await visit.rests();
  assert.ok(await colours_in(visit, effects.items['cost-effects']) >= 4, 'the effects\' bars are drawn');
  await visit.page.screenshot({ path: join(pictures, 'cost-effects.png') });
  assert.deepEqual(visit.complaints, []);
  await visit.page.close();
});
