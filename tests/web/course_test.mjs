// The example of a course page, as a teacher would put it beside the site: its frame walks, its buttons lead, its lines tell.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { test } from 'node:test';
import { act_in, browser, open_for_tests, pictures, server } from './browser.mjs';

open_for_tests();

test('the example course page shows the walk in its frame, leads it by its buttons, and counts predictions', async () => {
  const page = await browser.newPage(), complaints = [];
  page.on('pageerror', (error) => complaints.push(String(error)));
  page.on('console', (said) => said.type() === 'error' && !said.location().url?.endsWith('/favicon.ico') && complaints.push(said.text()));
  await page.setViewport({ width: 1280, height: 900 });
  await page.goto(new URL('course.html', server.address).href);
  const shows = (id, text) => page.waitForFunction((id, text) => new RegExp(text).test(document.getElementById(id).textContent),
    { timeout: 60000, polling: 50 }, id, text);
  const press = (text) => page.evaluate((text) => [...document.querySelectorAll('button')].find((each) => each.textContent === text).click(), text);
  await shows('step', '^12 of ');
  const frame = await (await page.$('#raywalk')).contentFrame();
  await frame.waitForFunction(() => document.getElementById('says').hidden);

  // A student walks in the frame.
  await (await page.$('#raywalk')).click({ offset: { x: 300, y: 150 } });
  await page.keyboard.press(' ');
  await shows('step', '^13 of ');
  await press('To the start');
  await shows('step', '^0 of ');
  await press('The classic scene');
  await shows('step', '^40 of ');
  await page.screenshot({ path: join(pictures, 'course.png') });

  await press('A step of a lesson');
  const told = () => frame.evaluate(() => JSON.parse(window.raywalk.ccall('page_told', 'string')));
  for (let tries = 0; (await told()).moment.lesson !== '04-reflection' && tries < 200; ++tries) await new Promise((again) => setTimeout(again, 100));
  const { moment: { lesson, lesson_step, lesson_steps } } = await told();
  assert.deepEqual([lesson, lesson_step], ['04-reflection', 2]);
  await (await page.$('#raywalk')).focus();
  await frame.focus('#canvas');
  await page.keyboard.press('1');
  await page.keyboard.press('Enter');
  await shows('made', '^1$');
  await shows('right', (await told()).right === 1 ? '^1$' : '^0$');
  await page.screenshot({ path: join(pictures, 'course-lesson.png') });
  await act_in(frame, 'lesson-options unlocked');
  for (let step = lesson_step; step <= lesson_steps; ++step) {
    await act_in(frame, `lesson-step ${step}`);
    await new Promise((again) => setTimeout(again, 300));
  }
  await shows('end', '^Lesson 04-reflection is finished\\.$');
  assert.deepEqual(complaints, []);
  await page.close();
});

test('the example course page fits a telephone', async () => {
  const page = await browser.newPage();
  await page.setViewport({ width: 360, height: 640 });
  await page.goto(new URL('course.html', server.address).href);
  await page.waitForFunction(() => /^12 of/.test(document.getElementById('step').textContent), { timeout: 60000 });
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= 360), 'nothing is cut off');
  await page.screenshot({ path: join(pictures, 'course-360.png') });
  await page.close();
});
