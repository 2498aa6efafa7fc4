// The short set: the page starts and steps, a lesson's step, a link, and the bits of five scenes.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Visit, browser, open_for_tests, server } from './browser.mjs';
import { five_in } from './pictures.mjs';

five_in('double');

open_for_tests();

test('the page starts, and STEP steps', async () => {
  const visit = await Visit.begin(browser, server.address);
  await visit.page.keyboard.press(' ');
  await visit.until((now) => now.position === 1);
  const letters = await visit.letters_on('step');
  assert.ok(letters >= 3 && letters <= 12, `STEP can be read (${letters} parts)`);
  assert.deepEqual(visit.complaints, []);
  await visit.page.close();
});

test('a link opens a scene at its step, and Copy link makes the same', async () => {
  const link = '#v=1/scene=glass/step=12/mode=trace/tab=tree/lang=pt/theme=projector';
  const visit = await Visit.begin(browser, server.address, {}, link);
  const now = await visit.until((now) => now.position === 12);
  assert.deepEqual([now.tab, now.language, now.theme, now.mode], ['tree', 'pt', 'projector', 'trace']);
  await visit.copy_link();
  const { link: made } = await visit.until((now) => now.link !== '');
  assert.equal(made, server.address + link);
  assert.deepEqual(visit.complaints, []);
  await visit.page.close();
});

test('a step of a lesson is answered', async () => {
  const visit = await Visit.begin(browser, server.address, {}, '&language=en#v=1/lesson=01-ray-casting/at=2');
  await visit.until((now) => now.lesson?.open === '01-ray-casting' && now.lesson.step === 2);
  await visit.page.keyboard.press('1');
  await visit.page.keyboard.press('Enter');
  await visit.until((now) => now.lesson.revealed && now.lesson.judged === 1);
  assert.deepEqual(visit.complaints, []);
  await visit.page.close();
});
