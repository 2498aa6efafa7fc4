// How the page looks, read back from its pixels: at windows from a small telephone's to a wall of 3840 x 2160, in both
// themes, with and without a lesson; and a telephone that is turned while it walks.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { Visit, browser, is_firefox, open_for_tests, pictures, pixels_of, server } from './browser.mjs';

open_for_tests();

const theme_source = readFileSync(join(process.env.RAYWALK_SOURCE_DIR, 'src/view/drawing/theme.cpp'), 'utf8');
const colour_of = (theme, name) => new RegExp(`Palette ${theme}_palette\\{[^;]*?\\.${name} = \\{([^}]*)\\}`).exec(theme_source)[1].split(',').map(Number);

// A picture of the window and its items, in the screen's pixels.
class Look {
  static async of(visit, name) {
    const look = new Look;
    await visit.rests();
    const report = await visit.report();
    look.ratio = await visit.page.evaluate(() => devicePixelRatio);
    look.items = Object.fromEntries(Object.entries(report.items).map(([item, rect]) => [item, rect.map((each) => each * look.ratio)]));
    const png = Buffer.from(await visit.page.screenshot());
    writeFileSync(join(pictures, `look-${name}.png`), png);
    Object.assign(look, pixels_of(png));
    return look;
  }
  at(x, y) {
    const i = 4 * (Math.round(y) * this.width + Math.round(x));
    return [...this.data.subarray(i, i + 3)];
  }
  // The colours of a part and how often each is there, the most frequent first.
  colours([x, y, width, height]) {
    const found = new Map;
    for (let row = Math.ceil(y); row < Math.min(y + height, this.height); ++row)
      for (let column = Math.ceil(x); column < Math.min(x + width, this.width); ++column) {
        const colour = this.data.readUIntBE(4 * (row * this.width + column), 3);
        found.set(colour, (found.get(colour) ?? 0) + 1);
      }
    return [...found].sort(([, a], [, b]) => b - a);
  }
  most([...part]) {
    const [[colour]] = this.colours(part);
    return [colour >> 16, colour >> 8 & 255, colour & 255];
  }
  // Whether letters or lines touch a side of a button: then they are cut off there, or stand over it.
  cut(item) {
    const [x, y, width, height] = this.items[item], inset = 2 * this.ratio, cut = [];
    for (const [side, column] of [['left', x + inset], ['right', x + width - inset]])
      for (let row = y + height * 0.3; row < y + height * 0.7; ++row) {
        const own = this.at(column, row), before = this.at(column, y + height * 0.3);
        if (own.some((each, i) => Math.abs(each - before[i]) > 40)) {
          cut.push(`${item} at its ${side}`);
          break;
        }
      }
    return cut;
  }
}

const buttons = /^(step|play|clear|mode-\w+|tab-\w+|grain-\w+|lessons|language|menu-\w+|only-pixel|front-\w+|lesson-(list|back|next|reveal)|guess\/\d)$/;

function faults(look, { theme, panes }) {
  const wrong = [], close = (a, b) => a.every((each, i) => Math.abs(each - b[i]) <= 2);
  for (const [item, colour] of Object.entries(panes)) {
    const is = look.most(look.items[item]), should = colour_of(theme, colour);
    if (!close(is, should)) wrong.push(`${item} is ${is}, not ${should}`);
    const colours = look.colours(look.items[item]).length;
    if (colours < 20) wrong.push(`${item} has only ${colours} colours`);
  }
  const all = Object.entries(look.items).filter(([item, [, , width, height]]) => buttons.test(item) && width > 0 && height > 0);
  const in_lines = (item) => item.startsWith('guess/'); // these scroll
  for (const [item, [x, y, width, height]] of all) {
    if (x < -1 || y < -1 || x + width > look.width + 1 || (!in_lines(item) && y + height > look.height + 1))
      wrong.push(`${item} at ${[x, y, width, height]} is outside of ${look.width} x ${look.height}`);
    // A small one has the room of a large one around it (WCAG 2.5.8).
    if (Math.min(width, height) < 24 * look.ratio - 1) {
      const [middle_x, middle_y] = [x + width / 2, y + height / 2];
      for (const [other, [left, top, wide, high]] of all) {
        const away = Math.hypot(Math.max(left - middle_x, 0, middle_x - left - wide), Math.max(top - middle_y, 0, middle_y - top - high));
        if (other !== item && away < 12 * look.ratio) wrong.push(`${item} is small, and ${other} only ${away / look.ratio} from its middle`);
      }
    }
    const lines = look.items['lesson-lines'];
    const shown = !in_lines(item) || (y >= lines[1] && y + height <= lines[1] + lines[3]);
    if (shown) wrong.push(...look.cut(item));
    if (shown && look.colours([x, y, width, height]).length < 3) wrong.push(`nothing is written on ${item}`);
  }
  for (const [i, [one, a]] of all.entries())
    for (const [other, b] of all.slice(i + 1)) {
      if (in_lines(one) || in_lines(other)) continue;
      const wide = Math.min(a[0] + a[2], b[0] + b[2]) - Math.max(a[0], b[0]), high = Math.min(a[1] + a[3], b[1] + b[3]) - Math.max(a[1], b[1]);
      if (wide > 1.5 * look.ratio && high > 1.5 * look.ratio) wrong.push(`${one} and ${other} overlap by ${wide} x ${high}`);
    }
  return wrong;
}

const sizes = {
  '360x640': { width: 360, height: 640 },
  '393x851@3': { width: 393, height: 851, deviceScaleFactor: 3 },
  '768x1024': { width: 768, height: 1024 },
  '1280x720@2': { width: 1280, height: 720, deviceScaleFactor: 2 },
  '1920x1080': { width: 1920, height: 1080 },
  '3840x2160': { width: 3840, height: 2160 },
};
for (const [size, window] of Object.entries(sizes)) {
  // Firefox's own window is not larger than its display.
  test(`at ${size} nothing is blank, cut off, covered or outside, in any theme`, { skip: is_firefox && window.width > 2000 && 'larger than the display' }, async () => {
    const is_huge = window.width > 2000; // and takes software that draws it minutes
    for (const theme of is_huge ? ['projector'] : ['dark', 'projector']) {
      const link = `&language=en#v=1/scene=classic/step=60/mode=trace/theme=${theme}`;
      const visit = await Visit.begin(browser, server.address, window, link);
      const { items } = await visit.until((now) => now.position === 60 && now.theme === theme && now.image.finished);
      const canvas = await visit.page.$eval('#canvas', ({ width, height }) => [width, height]);
      const ratio = window.deviceScaleFactor ?? 1;
      assert.deepEqual(canvas, [window.width * ratio, window.height * ratio]);
      const panes = { plan: 'plan', ...'code' in items && items.code[2] > 0 ? { code: 'panel' } : {} };
      const look = await Look.of(visit, `${size}-${theme}`);
      assert.deepEqual([look.width, look.height], canvas);
      assert.deepEqual(faults(look, { theme, panes }), [], theme);
      // Rays of the walk are in the plan.
      const primary = theme === 'dark' ? 'dark_primary' : 'light_primary';
      const [r, g, b] = new RegExp(`${primary}\\{\\{([^}]*)\\}`).exec(theme_source)[1].split(',').map(Number);
      assert.ok(look.colours(look.items.plan).some(([colour, often]) => colour === (r << 16 | g << 8 | b) && often > 30), 'a primary ray is drawn');
      assert.deepEqual(visit.complaints, []);
      await visit.page.close();
      if (is_huge) continue;

      const lesson = await Visit.begin(browser, server.address, window, `&language=pt#v=1/lesson=04-reflection/at=2/theme=${theme}`);
      await lesson.until((now) => now.lesson?.step === 2 && now.theme === theme && 'guess/1' in now.items);
      const asks = await Look.of(lesson, `${size}-${theme}-lesson`);
      assert.deepEqual(faults(asks, { theme, panes: { plan: 'plan', lesson: 'panel' } }), [], `${theme}, in a lesson`);
      await lesson.page.close();
    }
  });
}

test('a telephone that is turned while it walks shows the same step laid out anew, and walks on', async () => {
  const upright = { width: 360, height: 640, hasTouch: true, isMobile: !is_firefox }, across = { ...upright, width: 640, height: 360, isLandscape: !is_firefox };
  const visit = await Visit.begin(browser, server.address, upright, '&language=en#v=1/scene=classic/step=60/mode=trace');
  const { page } = visit;
  const first = await visit.until((now) => now.position === 60);
  await page.setViewport(across);
  const turned = await visit.until((now) => now.window.width === 640 && now.window.height === 360);
  const look = await Look.of(visit, '640x360-turned');
  assert.deepEqual(faults(look, { theme: 'dark', panes: { plan: 'plan' } }), []);
  const after = await visit.report();
  if (!is_firefox) assert.ok(after.items.step[3] >= 39.5, 'a button suits a finger before the first touch');
  assert.deepEqual([after.position, after.steps, after.path, after.mode], [60, first.steps, first.path, first.mode]);
  assert.notDeepEqual(turned.items.plan, first.items.plan);
  for (const [name, { window: [x, y] }] of Object.entries(after.objects)) {
    const [left, top, width, height] = after.items.plan;
    assert.ok(x > left && x < left + width && y > top && y < top + height, `${name} is in the plan`);
  }
  await visit.tap(...[0, 1].map((i) => after.items.step[i] + after.items.step[2 + i] / 2));
  await visit.until((now) => now.position === 61);
  await page.setViewport(upright);
  const back = await visit.until((now) => now.window.width === 360 && now.items.plan[3] === first.items.plan[3]);
  assert.equal(back.position, 61);
  // While it plays, too.
  await visit.act('play-pause');
  await visit.until((now) => now.playing && now.position > 62);
  await page.setViewport(across);
  const playing = await visit.until((now) => now.window.width === 640);
  await visit.until((now) => now.playing && now.position > playing.position);
  assert.deepEqual(visit.complaints, []);
  await page.close();
});
