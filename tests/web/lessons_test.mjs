// Every lesson from its start to its end, in every language and by every means: by mouse, by touch on a telephone, by keys
// alone, and by the accessibility tree alone, each in another language from lesson to lesson. Every question is answered, by
// the same means.
import assert from 'node:assert/strict';
import { readdirSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { setTimeout as pause } from 'node:timers/promises';
import { Visit, browser, is_firefox, open_for_tests, server, spoken, tab_to, use, word } from './browser.mjs';

open_for_tests();

const lessons = readdirSync(join(process.env.RAYWALK_SOURCE_DIR, 'lessons')).filter((name) => /^\d\d-/.test(name)).sort();
const languages = ['en', 'es', 'pt'];
const middle = ([x, y, width, height]) => [x + width / 2, y + height / 2];

// As who reads it knows: what is asked for, by the window in words.
const asked = (visit) => visit.page.evaluate(() => {
  const outline = window.raywalk.ccall('page_outline', 'string');
  return Object.entries({ choice: '"key":"choice-0"', number: '"key":"number"', arrow: '"key":"degrees"', line: '"key":"mark"' })
    .find(([, key]) => outline.includes(key))?.[0] ?? 'nothing';
});

// Moves what scrolls until an item stands within what it is in.
async function bring(visit, item, scroll) {
  for (let turns = 0; turns < 30; ++turns) {
    const { items } = await visit.until((now) => item in now.items, `there is ${item}`, 10000);
    const where = item.startsWith('line-') ? items.code : items['lesson-lines'];
    const [, top] = where, [, y, , height] = items[item], below = y + height - (top + where[3]), above = top - y;
    if (below <= 1 && above <= 1) return;
    await scroll(middle(where), below > 1 ? Math.min(below + 10, 120) : -Math.min(above + 10, 120));
    await pause(150);
  }
  throw new Error(`${item} does not come into sight`);
}

// With what points: how it presses a place, an item, and scrolls.
const pointed = ({ press, scroll, type }) => async (visit, { items, objects, eye, lesson: { revealed } }) => {
  const touched = async (item) => {
    await bring(visit, item, (...by) => scroll(visit, ...by));
    await press(visit, middle((await visit.report()).items[item]));
  };
  if (!('lesson-reveal' in items)) return press(visit, middle(items['lesson-next'] ?? items['front-lesson']));
  const what = await asked(visit);
  if (what === 'choice') await touched('guess/1');
  if (what === 'line') {
    if ('front-code' in items) await press(visit, middle(items['front-code'])); // a small window shows one of the two
    const is_line = (name) => /^line-\d+$/.test(name);
    const rows = await visit.until((now) => Object.keys(now.items).some(is_line), 'there is the code', 10000);
    await touched(Object.keys(rows.items).filter(is_line).at(-1));
    if ('front-code' in items) await press(visit, middle((await visit.report()).items['front-lesson']));
    await visit.until((now) => 'lesson-reveal' in now.items, 'the lesson is back', 10000);
  }
  if (what === 'arrow') {
    const inside = ([x, y]) => x > items.plan[0] + 30 && y > items.plan[1] + 30 && x < items.plan[0] + items.plan[2] - 30 && y < items.plan[1] + items.plan[3] - 30;
    await press(visit, Object.values(objects).map(({ window }) => window).find(inside) ?? eye.window);
  }
  if (what === 'number') {
    await touched('lesson-number');
    await pause(150);
    await type(visit, '21');
  }
  await visit.page.waitForFunction(() => !/"key":"answer"[^}]*"enabled":false/.test(window.raywalk.ccall('page_outline', 'string')),
    { timeout: 20000, polling: 50 });
  await press(visit, middle((await visit.report()).items['lesson-reveal']));
  assert.ok(!revealed);
};

// Each answers or goes on, once.
const means = {
  mouse: pointed({
    async press({ page }, at) {
      await page.mouse.move(...at);
      await page.mouse.down();
      await pause(60);
      await page.mouse.up();
    },
    async scroll({ page }, at, by) {
      await page.mouse.move(...at);
      await page.mouse.wheel({ deltaY: 2 * by });
    },
    type: ({ page }, text) => page.keyboard.type(text),
  }),
  touch: pointed({
    press: (visit, at) => visit.tap(...at),
    async scroll(visit, [x, y], by) {
      await visit.touch('touchstart', [x, y]);
      for (let part = 1; part <= 4; ++part) await visit.touch('touchmove', [x, y - by * part / 4]);
      await visit.touch('touchend');
    },
    async type({ page }, text) {
      for (const letter of text) await page.keyboard.sendCharacter(letter);
    },
  }),
  async keys(visit, { items, position }, language) {
    const { keyboard } = visit.page;
    if (!('lesson-reveal' in items)) return keyboard.press('Enter');
    const what = await asked(visit);
    if (what === 'choice') await keyboard.press('1');
    if (what === 'number') await keyboard.type('21');
    if (what === 'line') {
      if (position === 0) await keyboard.press(' ');
      await visit.until((now) => now.position > 0);
      await keyboard.press('Enter');
    }
    if (what === 'arrow') {
      await visit.page.keyboard.down('Shift');
      for (let tabs = 0; tabs < 9 && await visit.page.evaluate(() => document.activeElement.id !== 'as-text'); ++tabs) await keyboard.press('Tab');
      await visit.page.keyboard.up('Shift');
      await keyboard.press('Enter');
      await tab_to(visit.page, word(language, 'outline.degrees'));
      await keyboard.type('30');
      await keyboard.press('Enter');
      await visit.until((now) => now.lesson.aimed);
      await tab_to(visit.page, word(language, 'page.as_drawing'), true);
      await keyboard.press('Enter');
      await tab_to(visit.page, 'canvas');
    }
    await keyboard.press('Enter');
  },
  async tree(visit, before, language) {
    const { page } = visit, say = (key) => word(language, key);
    const nodes = await spoken(page), named = (role, name) => nodes.find((node) => node.role === role && name.test(node.name))?.name;
    const literally = (text) => text.replace(/[.*+?^$()|[\]\\]/g, '\\$&').replace(/\{.*\}/, '.*');
    const button = (key) => named('button', new RegExp(`^${say(key)}$`));
    const on = button('lesson.next') ?? button('lesson.finish');
    if (on) return use(page, 'button', on);
    const choice = named('button', /^1 /), line = named('button', new RegExp(`^${literally(say('outline.mark'))}$`));
    const number = named('textbox', new RegExp(`^${literally(say('outline.your_number'))}$|^${literally(say('outline.your_number_in'))}$`));
    if (choice) await use(page, 'button', choice);
    else if (number) await use(page, 'textbox', number, '21');
    else if (line) await use(page, 'button', line);
    else await use(page, 'textbox', say('outline.degrees'), '30');
    await use(page, 'button', button('lesson.reveal'));
  },
};

async function through(visit, lesson, by, language) {
  await visit.page.evaluate((link) => { location.hash = link; }, `#v=1/lesson=${lesson}/at=1/lang=${language}`);
  await visit.until((now) => now.lesson?.open === lesson && now.lesson.step === 1 && now.language === language, `${lesson} opens`);
  for (let moves = 0; moves < 60; ++moves) {
    const before = await visit.until((now) => now.lesson.open !== lesson || 'lesson-reveal' in now.items || 'lesson-next' in now.items);
    const { step, revealed, judged } = before.lesson;
    if (before.lesson.open !== lesson) return judged;
    // A click may miss what a busy machine scrolls late: as a person would, it is done again.
    const goes_on = ({ lesson: now, items }) => now.open !== lesson || now.step !== step || (now.revealed !== revealed && 'lesson-next' in items);
    for (let tries = 1; ; ++tries) {
      const what = `${lesson} in ${language} goes on from step ${step}, ${revealed ? '' : 'not '}revealed, by ${by}`;
      try {
        await means[by](visit, await visit.report(), language);
        await visit.until(goes_on, what, 20000);
        break;
      } catch (why) {
        if (goes_on(await visit.report())) break;
        if (tries === 3) throw new Error(`${what}: ${why.message}`);
      }
    }
  }
  throw new Error(`${lesson} does not end by ${by}`);
}

const turn = is_firefox ? 1 : 0; // so that each lesson is tried in two languages by each means
Object.keys(means).forEach((by, i) => test(`every lesson by ${by}, in at most 256 MiB`, async () => {
  assert.ok(lessons.length >= 18);
  const size = by === 'touch' ? { width: 360, height: 640, hasTouch: true } : {};
  const visit = await Visit.begin(browser, server.address, size), { page } = visit;
  if (by === 'tree') await use(page, 'button', word('en', 'page.as_text'));
  let judged = 0;
  for (const [number, lesson] of lessons.entries()) {
    const begun = Date.now();
    judged = await through(visit, lesson, by, languages[(number + i + turn) % 3]);
    if (process.env.RAYWALK_TIMES) console.log(`${by} ${lesson} ${((Date.now() - begun) / 1000).toFixed(1)} s`);
  }
  assert.ok(judged >= 85, `${judged} questions were answered`);
  const memory = await page.evaluate(() => window.raywalk.HEAPU8.length + window.raywalk.workers.memory());
  assert.ok(memory <= 256 * 2 ** 20, `${memory / 2 ** 20} MiB`);
  assert.deepEqual(visit.complaints, []);
  await page.close();
}));

test('the page\'s own parts speak the language that is chosen in the drawing', async () => {
  const visit = await Visit.begin(browser, server.address);
  await visit.click('language');
  await visit.until((now) => now.language === 'es');
  await visit.rests();
  const [language, button] = await visit.page.evaluate(() => [document.documentElement.lang, document.getElementById('as-text').textContent]);
  await visit.page.close();
  assert.deepEqual([language, button], ['es', word('es', 'page.as_text')]);
});
