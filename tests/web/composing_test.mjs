// Letters that are composed before they are typed, as the keyboards of telephones do with every word, and those of many
// languages: they come into a field of the program's once, as they are at last.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { setTimeout as pause } from 'node:timers/promises';
import { Visit, browser, only_in_chromium, open_for_tests, server } from './browser.mjs';

open_for_tests();

const tablet = { width: 768, height: 1024, hasTouch: true };

// Begins to type into a field by a finger.
async function into(visit, item) {
  const { items: { [item]: [x, y, width, height] } } = await visit.until((now) => item in now.items, `there is ${item}`);
  await visit.rests();
  await visit.tap(x + width / 2, y + height / 2);
  await visit.page.waitForFunction(() => document.activeElement.id === 'keyboard');
}

// What stands there in turn while it is composed, and what it becomes: nothing if it is given up.
async function compose(visit, parts, becomes) {
  for (const text of parts) {
    await visit.session.send('Input.imeSetComposition', { text, selectionStart: text.length, selectionEnd: text.length });
    await pause(120);
  }
  if (becomes) await visit.session.send('Input.insertText', { text: becomes });
  else await visit.session.send('Input.imeSetComposition', { text: '', selectionStart: 0, selectionEnd: 0 });
  await pause(200);
}

// Of a field in the window in words.
const value_of = (visit, key) => visit.page.evaluate((key) => {
  const find = (items) => items.map((item) => item.key === key ? item : find(item.items ?? [])).find((found) => found);
  return find(JSON.parse(window.raywalk.ccall('page_outline', 'string')))?.value;
}, key);

test('a number that is composed answers a question once, and what is given up leaves nothing', only_in_chromium, async () => {
  const visit = await Visit.begin(browser, server.address, tablet, '&language=en#v=1/lesson=01-ray-casting/at=5');
  await visit.until((now) => now.lesson?.step === 5);
  await into(visit, 'lesson-number');
  await compose(visit, ['2', '21'], '21');
  assert.equal(await value_of(visit, 'number'), '21');
  await compose(visit, ['3', '35'], '');
  assert.equal(await value_of(visit, 'number'), '21');
  await compose(visit, ['0', '03', '0'], '0');
  assert.equal(await value_of(visit, 'number'), '210');
  await visit.page.keyboard.press('Backspace');
  await pause(200);
  assert.equal(await value_of(visit, 'number'), '21');
  assert.deepEqual(visit.complaints, []);
  await visit.page.close();
});

test('a file\'s name with a composed accent is that name', only_in_chromium, async () => {
  const visit = await Visit.begin(browser, server.address, tablet);
  await visit.act('ask-save-as');
  await into(visit, 'browser-path');
  await visit.page.keyboard.press('End');
  for (let i = 0; i < 'classic.toml'.length; ++i) await visit.page.keyboard.press('Backspace');
  await compose(visit, ['t', 'te', 'tel', 'tel´', 'telé'], 'telé');
  await compose(visit, ['s', 'sc'], 'scopio.toml');
  await visit.click('browser-accept');
  const { path } = await visit.until((now) => now.prompt === '');
  assert.equal(path, '/files/teléscopio.toml');
  assert.deepEqual(visit.complaints, []);
  await visit.page.close();
});
