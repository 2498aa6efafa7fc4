// The page in somebody else's page, in a sandbox without an origin, and with one; what the two tell each other.
import assert from 'node:assert/strict';
import { createServer } from 'node:http';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { browser, open_for_tests, pictures, server } from './browser.mjs';

let course;
open_for_tests();
before(async () => {
  // A course page of another origin.
  course = createServer((request, response) => {
    const { searchParams } = new URL(request.url, 'http://localhost');
    response.writeHead(200, { 'Content-Type': 'text/html' }).end(`<!doctype html><title>Course</title>
      <iframe id="frame" style="width: 1000px; height: 600px" src="${server.address}?${searchParams.get('query')}"
        ${searchParams.has('sandbox') ? `sandbox="${searchParams.get('sandbox')}"` : ''}></iframe>
      <script>
        window.heard = [];
        addEventListener('message', ({ source, data }) => source === frame.contentWindow && heard.push(data));
        window.tell = (message) => frame.contentWindow.postMessage(message, '*');
      </script>`);
  });
  await new Promise((listening) => course.listen(0, '127.0.0.1', listening));
});
after(() => course?.close());

class Course {
  static async begin(query, sandbox) {
    const visit = new Course;
    visit.page = await browser.newPage();
    visit.complaints = [];
    visit.page.on('pageerror', (error) => visit.complaints.push(String(error)));
    await visit.page.setViewport({ width: 1040, height: 640 });
    const asked = new URLSearchParams({ query, ...(sandbox === undefined ? {} : { sandbox }) });
    await visit.page.goto(`http://127.0.0.1:${course.address().port}/?${asked}`);
    return visit;
  }
  hears(event, is = () => true) {
    return this.page.waitForFunction((event, is) => window.heard.findLast((each) => each.event === event && eval(is)(each)),
      { timeout: 120000, polling: 50 }, event, `(${is})`).then((found) => found.jsonValue());
  }
  tell(message) {
    return this.page.evaluate((message) => window.tell(message), message);
  }
}

for (const [name, sandbox] of [['in a sandbox without an origin', 'allow-scripts'], ['in a plain frame', undefined]])
  test(`${name} the page walks by messages, and tells of it`, async () => {
    const visit = await Course.begin('embed&language=en#v=1/scene=glass/step=12', sandbox);
    const ready = await visit.hears('ready');
    assert.equal(ready.step, 12);
    await visit.tell({ raywalk: 1, do: 'go', step: 3 });
    await visit.hears('moved', (each) => each.step === 3);
    await visit.tell({ raywalk: 1, do: 'load', link: '#v=1/scene=classic/step=5' });
    await visit.hears('moved', (each) => each.step === 5);
    await visit.tell({ raywalk: 1, do: 'load', scene: 'title = "Sent"\n[camera]\neye = [-5, 0, 0]\nlook_at = [0, 0, 0]\nfov = 40\n' });
    await visit.hears('moved', (each) => each.scene === 'Sent');
    await visit.page.screenshot({ path: join(pictures, `embedded-${sandbox ?? 'plain'}.png`) });
    assert.deepEqual(visit.complaints, []);
    await visit.page.close();
  });

test('a scene that is sent leaves the open one\'s file as it is, and nothing more is taken during a question', async () => {
  const visit = await Course.begin('embed&language=en#v=1/scene=glass/step=12', 'allow-scripts');
  await visit.hears('ready');
  const frame = await (await visit.page.$('#frame')).contentFrame();
  const scene = (title) => `title = "${title}"\n[camera]\neye = [-5, 0, 0]\nlook_at = [0, 0, 0]\nfov = 40\n`;
  await visit.tell({ raywalk: 1, do: 'load', scene: scene('First') });
  await visit.hears('moved', (each) => each.scene === 'First');
  const act = (line) => frame.evaluate((line) => window.raywalk.ccall('page_act', null, ['string'], [line]), line);
  await act('add solid-sphere');
  await visit.tell({ raywalk: 1, do: 'load', scene: scene('Second') });
  await visit.tell({ raywalk: 1, do: 'load', scene: scene('Third') });
  assert.match((await visit.hears('refused')).why, /question/);
  const files = await frame.evaluate(() => ['/files/embedded-1.toml', '/files/embedded-2.toml']
    .map((path) => window.raywalk.FS.readFile(path, { encoding: 'utf8' })));
  assert.deepEqual(files, [scene('First'), scene('Second')]);
  await act('answer discard');
  await visit.tell({ raywalk: 1, do: 'tell' });
  await visit.hears('moved', (each) => each.scene === 'Second');
  await visit.page.close();
});

test('what a lesson asks and how it ends is told', async () => {
  const visit = await Course.begin('embed&language=en#v=1/lesson=01-ray-casting/at=1', 'allow-scripts');
  const ready = await visit.hears('ready');
  assert.deepEqual([ready.lesson, ready.lesson_step], ['01-ray-casting', 1]);
  const frame = (await visit.page.$('#frame')).contentFrame();
  const act = async (line) => (await frame).evaluate((line) => {
    window.raywalk.ccall('page_act', null, ['string'], [line]);
    window.dispatchEvent(new Event('focus')); // a page at rest has no turn, and tells of nothing
  }, line);
  await act('lesson-options unlocked');
  for (let step = 1; step <= ready.lesson_steps; ++step) {
    await act('guess-choice 0');
    await act('guess-number 1');
    await act('reveal');
    await act(`lesson-step ${step}`);
  }
  await visit.hears('finished', (each) => each.lesson === '01-ray-casting');
  await visit.hears('predicted', (each) => typeof each.right === 'boolean');
  await visit.page.close();
});

test('messages that are none are refused with a sentence, and those of others are not heard', async () => {
  const visit = await Course.begin('embed&language=en#v=1/scene=glass/step=12', 'allow-scripts');
  await visit.hears('ready');
  for (const message of [{ raywalk: 2, do: 'go', step: 1 }, { raywalk: 1 }, { raywalk: 1, do: 'go', step: -1 }, { raywalk: 1, do: 'go', step: '7' },
    { raywalk: 1, do: 'go', step: 1e9 + 1 }, { raywalk: 1, do: 'go', step: 2 ** 31 },
    { raywalk: 1, do: 'load' }, { raywalk: 1, do: 'load', link: 'javascript:alert(1)' }, { raywalk: 1, do: 'load', link: { a: 1 } },
    { raywalk: 1, do: 'load', scene: 'x'.repeat(1 << 21) }]) {
    await visit.page.evaluate(() => { window.heard = []; });
    await visit.tell(message);
    assert.ok((await visit.hears('refused')).why.length > 10, JSON.stringify(message));
  }
  for (const bad of [{ link: '#v=1/scene=../../x' }, { scene: 'this is no scene' },
    { scene: '[camera]\neye = [0, 0, 0]\nlook_at = [1, 0, 0]\nfov = 40\n[[object]]\nname = "A"\ntype = "mesh"\nfile = "/kept/settings.json"\n' }]) {
    await visit.page.evaluate(() => { window.heard = []; });
    await visit.tell({ raywalk: 1, do: 'load', ...bad });
    assert.ok((await visit.hears('refused')).why.length > 10, JSON.stringify(bad));
  }
  await visit.page.evaluate(() => { window.heard = []; });
  for (const message of [null, 7, 'raywalk', {}, { do: 'go', step: 1 }]) await visit.tell(message);
  await visit.tell({ raywalk: 1, do: 'tell' });
  assert.equal((await visit.hears('moved')).step, 12);
  assert.deepEqual(visit.complaints, []);
  await visit.page.close();
});

test('a frame that was given an origin hears no other, and one without ?embed hears nobody', async () => {
  for (const query of ['embed=https://course.example&language=en', 'embed=nonsense&language=en', 'language=en']) {
    const visit = await Course.begin(query + '#v=1/scene=glass/step=12', 'allow-scripts');
    const frame = await (await visit.page.$('#frame')).contentFrame();
    await frame.waitForFunction(() => document.getElementById('says')?.hidden, { timeout: 120000 });
    await visit.tell({ raywalk: 1, do: 'go', step: 3 });
    await new Promise((again) => setTimeout(again, 1000));
    assert.deepEqual(await visit.page.evaluate(() => window.heard), []);
    assert.equal(await frame.evaluate(() => JSON.parse(window.raywalk.ccall('page_told', 'string')).moment.step), 12);
    await visit.page.close();
  }
});

test('in a sandbox, who saves a scene is told that this may be forbidden', async () => {
  const visit = await Course.begin('embed&language=en', 'allow-scripts');
  await visit.hears('ready');
  const frame = await (await visit.page.$('#frame')).contentFrame();
  await frame.evaluate(() => {
    window.raywalk.ccall('page_act', null, ['string'], ['save-as /files/x.toml']);
    window.dispatchEvent(new Event('focus'));
  });
  await frame.waitForFunction(() => {
    const { hidden, textContent } = document.getElementById('says');
    return !hidden && textContent.includes('may forbid downloads');
  }, { timeout: 60000 });
  await visit.page.close();
});
