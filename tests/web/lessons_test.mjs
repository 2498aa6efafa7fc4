// Every lesson from its start to its end, in every language: by the text beside the drawing, by mouse, and by keys.
import assert from 'node:assert/strict';
import { readdirSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { Visit, is_firefox, open_browser, serve } from './browser.mjs';

let browser, server;
before(async () => {
  browser = await open_browser();
  server = await serve();
});
after(async () => {
  await browser?.close();
  server?.end();
});

const lessons = readdirSync(join(process.env.RAYWALK_SOURCE_DIR, 'lessons')).filter((name) => /^\d\d-/.test(name)).sort();

// Each answers or goes on, once.
const means = {
  async text(visit) {
    await visit.page.waitForFunction(() => ['choice-0', 'answer', 'next'].map((key) => document.querySelector(`#mirror [data-key="button ${key}"]`))
      .filter((button) => button && button.getAttribute('aria-disabled') !== 'true' && button.getAttribute('aria-pressed') !== 'true')
      .map((button) => button.click()).length > 0);
  },
  async mouse(visit, { items, lesson: { revealed } }) {
    const next = 'lesson-reveal' in items ? 'lesson-reveal' : 'lesson-next';
    if ('guess/1' in items && !revealed) {
      const bottom = ([, y, , height]) => y + height;
      await visit.page.mouse.move(items.lesson[0] + items.lesson[2] / 2, items.lesson[1] + items.lesson[3] / 2);
      for (let turns = 0; turns < 20 && bottom((await visit.report()).items['guess/1']) > items[next][1]; ++turns) {
        await visit.page.mouse.wheel({ deltaY: 200 });
        await new Promise((again) => setTimeout(again, 100));
      }
      await visit.click('guess/1');
    }
    await visit.click(next);
  },
  async keys(visit, { items }) {
    if ('guess/1' in items) await visit.page.keyboard.press('1');
    await visit.page.keyboard.press('Enter');
  },
};

async function through(visit, lesson, by) {
  await visit.page.evaluate((lesson) => { location.hash = `#v=1/lesson=${lesson}/at=1`; }, lesson);
  await visit.until((now) => now.lesson?.open === lesson && now.lesson.step === 1, `${lesson} opens`);
  for (let moves = 0; moves < 60; ++moves) {
    const before = await visit.report(), { step, revealed } = before.lesson;
    if (before.lesson.open !== lesson) return;
    // A click may miss what a busy machine scrolls late: as a person would, it is done again.
    const goes_on = ({ lesson: now }) => now.open !== lesson || now.step !== step || now.revealed !== revealed;
    for (let tries = 1; ; ++tries) {
      await means[by](visit, before);
      const what = `${lesson} goes on from step ${step}, ${revealed ? '' : 'not '}revealed, by ${by}`;
      const done = await visit.until(goes_on, what, 60000).catch((why) => {
        if (tries === 3) throw why;
      });
      if (done) break;
    }
  }
  throw new Error(`${lesson} does not end by ${by}`);
}

const turn = is_firefox ? 1 : 0; // so that each language is tried in two ways
['en', 'es', 'pt'].forEach((language, i) => {
  const by = Object.keys(means)[(i + turn) % 3];
  test(`every lesson in ${language} by ${by}, in at most 256 MiB`, async () => {
    assert.ok(lessons.length >= 13);
    const visit = await Visit.begin(browser, server.address, {}, `&language=${language}`), { page } = visit;
    if (by === 'text') await page.evaluate(() => document.getElementById('as-text').click());
    await visit.act('lesson-options unlocked'); // what is right is not asked for here
    for (const lesson of lessons) await through(visit, lesson, by);
    assert.equal((await visit.report()).language, language);
    const memory = await page.evaluate(() => window.raywalk.HEAPU8.length + window.raywalk.workers.memory());
    assert.ok(memory <= 256 * 2 ** 20, `${memory / 2 ** 20} MiB`);
    assert.deepEqual(visit.complaints, []);
    await page.close();
  });
});
