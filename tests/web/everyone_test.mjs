// The page for everybody: lesson 1 from its start to its end by the accessibility tree alone, by keys alone, and by
// touch; axe-core finds nothing; and a picture in the making does not make anybody wait.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { test } from 'node:test';
import { Visit, browser, is_firefox, open_browser, open_for_tests, pictures, server } from './browser.mjs';

open_for_tests();

const open_as_text = 'Show as text, for screen readers and keyboards';
const lesson_1 = (report) => report.lesson?.open === '01-ray-casting' ? report.lesson : { step: 0 };

// What assistive technology is told: every node with its role and name. Firefox's protocol does not offer its tree: there
// what the page's elements say.
async function spoken(page) {
  const nodes = [];
  if (is_firefox)
    return page.$$eval('#mirror :is(h1, h2, h3, p, span, button, label)', (all) => all.map((each) =>
      ({ role: /^H\d$/.test(each.tagName) ? 'heading' : each.tagName.toLowerCase(), name: each.textContent })));
  const gather = (node) => {
    nodes.push(node);
    (node.children ?? []).forEach(gather);
  };
  gather(await page.accessibility.snapshot({ interestingOnly: false }));
  return nodes;
}
const says = (nodes, part) => nodes.some(({ name }) => name?.includes(part));

// Presses what has this role and name, as a screen reader does: by its place in the tree, not on the screen.
async function use(page, role, name, typed) {
  const element = await page.waitForSelector(`aria/${name.replace(/ +/g, ' ')}[role="${role}"]`, { timeout: 60000 });
  if (typed === undefined) return element.evaluate((it) => it.click());
  await element.focus();
  await element.evaluate((it) => it.select()); // as Tab does
  await page.keyboard.type(typed);
  await page.keyboard.press('Enter');
}

test('lesson 1 by the accessibility tree alone', async () => {
  const visit = await Visit.begin(browser, server.address), { page } = visit;
  await use(page, 'button', open_as_text);
  await use(page, 'button', 'Lessons');
  await use(page, 'button', 'Ray casting, 0 / 5, go on with this one');
  const { position } = await visit.until((now) => lesson_1(now).step === 1);
  assert.ok(says(await spoken(page), 'Press STEP') || says(await spoken(page), 'STEP'));
  await use(page, 'button', 'STEP');
  await visit.until((now) => now.position > position);
  const nodes = await spoken(page);
  assert.ok(nodes.some(({ role, name }) => role === 'heading' && name === 'Pseudocode'));
  assert.ok(says(nodes, ', has just run'), 'the current line is said');
  assert.ok(says(nodes, (await visit.report()).sentence), 'the sentence is said');
  await use(page, 'button', 'Next');
  for (const step of [2, 3]) {
    await visit.until((now) => lesson_1(now).step === step);
    const choices = await page.$$eval('#mirror [data-key^="button choice-"]', (all) => all.map((each) => each.textContent));
    assert.ok(choices.length >= 3);
    await use(page, 'button', choices[0]);
    await use(page, 'button', 'Reveal');
    await visit.until((now) => lesson_1(now).revealed);
    await use(page, 'button', 'Next');
  }
  await visit.until((now) => lesson_1(now).step === 4);
  await use(page, 'textbox', 'Direction in degrees: 0 to the right, 90 up', '30');
  await visit.until((now) => lesson_1(now).aimed);
  await use(page, 'button', 'Reveal');
  await use(page, 'button', 'Next');
  await visit.until((now) => lesson_1(now).step === 5);
  await use(page, 'textbox', 'Your number', 'many');
  assert.ok(says(await spoken(page), 'This is not a number'));
  await page.evaluate(() => { document.activeElement.value = ''; });
  await use(page, 'textbox', 'Your number', '21');
  await use(page, 'button', 'Reveal');
  await visit.until((now) => lesson_1(now).revealed);
  await use(page, 'button', 'Finish');
  await visit.until((now) => now.lesson.open === '');
  await use(page, 'button', 'Ray casting, 5 / 5');
  assert.deepEqual(visit.complaints, []);
  await page.close();
});

// Goes on by Tab until the focus is on what says this.
async function tab_to(page, name, key = 'Tab') {
  const seen = [];
  for (let i = 0; i < 400; ++i) {
    await page.keyboard.press(key);
    const now = await page.evaluate(() => {
      const at = document.activeElement;
      return at.labels?.[0]?.textContent ?? (at.tagName === 'CANVAS' ? 'canvas' : at.textContent);
    });
    if (now === name || now.startsWith(name)) return now;
    seen.push(now);
  }
  throw new Error(`Tab never comes to ${name}, only to ${[...new Set(seen)].join(' | ')}`);
}

test('lesson 1 by keys alone, and Tab leads out of everything', async () => {
  const visit = await Visit.begin(browser, server.address), { page } = visit;
  const { keyboard } = page;
  await keyboard.press(' ');
  await visit.until((now) => now.position === 1);
  await keyboard.press('m'); // where Tab once chose the next thing
  await visit.until((now) => now.mode === 'move');
  await keyboard.down('Shift');
  await tab_to(page, open_as_text);
  await keyboard.up('Shift');
  await keyboard.press('Enter');
  assert.equal(await page.evaluate(() => document.activeElement.tagName), 'H1');
  const press = async (name) => {
    await tab_to(page, name);
    await keyboard.press('Enter');
  };
  await press('Lessons');
  assert.equal(await page.evaluate(() => document.activeElement.textContent), 'Lessons', 'the focus is where they are listed');
  assert.equal(await page.evaluate(() => document.activeElement.tagName), 'H2');
  await press('Ray casting');
  await visit.until((now) => lesson_1(now).step === 1);
  await press('Next');
  for (const step of [2, 3]) {
    await visit.until((now) => lesson_1(now).step === step);
    await press('1  ');
    await press('Reveal');
    await visit.until((now) => lesson_1(now).revealed);
    await press('Next');
  }
  await visit.until((now) => lesson_1(now).step === 4);
  await tab_to(page, 'Direction in degrees');
  await keyboard.type('30');
  await press('Reveal');
  await press('Next');
  await visit.until((now) => lesson_1(now).step === 5);
  await tab_to(page, 'Your number');
  await keyboard.type('21');
  await press('Reveal');
  await press('Finish');
  await visit.until((now) => now.lesson.open === '');
  await keyboard.down('Shift');
  await tab_to(page, 'Hide the text');
  await keyboard.up('Shift');
  await keyboard.press('Enter');
  assert.equal(await page.evaluate(() => document.activeElement.id), 'as-text');
  await tab_to(page, 'canvas');
  assert.deepEqual(visit.complaints, []);
  await page.close();
});

// In the page: whether the lesson has a guess by now.
const can_reveal = () => !/"key":"answer"[^}]*"enabled":false/.test(window.raywalk.ccall('page_outline', 'string'));

const middle = ([x, y, width, height]) => [x + width / 2, y + height / 2];

// At a desk from the list of lessons; on a telephone, upright, from a link that a teacher has sent.
const phone = { width: 360, height: 640, hasTouch: true };
for (const [name, size, more] of [['at a desk', { hasTouch: true }], ['on a telephone, from its link', phone, '&language=en#v=1/lesson=01-ray-casting/at=1']])
  test(`lesson 1 by touch, ${name}`, async () => {
    const visit = await Visit.begin(browser, server.address, size, more), { page } = visit;
    // A student scrolls until what is to be touched stands above the buttons.
    const tap = async (item) => {
      let { items } = await visit.until((now) => item in now.items, `there is ${item}`);
      const below = () => /^guess|^lesson-number/.test(item) && items[item][1] + items[item][3] > (items['lesson-reveal'] ?? items['lesson-next'])[1];
      for (let drags = 0; drags < 20 && below(); ++drags) {
        const [x, y] = middle(items.lesson);
        await visit.touch('touchstart', [x, y]);
        for (let moved = 15; moved <= 60; moved += 15) await visit.touch('touchmove', [x, y - moved]);
        await visit.touch('touchend');
        await new Promise((again) => setTimeout(again, 200));
        ({ items } = await visit.report());
      }
      await visit.tap(...middle(items[item]));
    };
    // The answer stands high in the room that there is, above its reason and, where both have room, below the guess.
    const verdict_is_on_top = async () => {
      const { items } = await visit.until((now) => now.items['lesson-verdict']?.[1] - now.items.lesson[1] < (more ? 150 : 400));
      assert.ok(items['lesson-verdict'][1] >= items['lesson-lines'][1] - 1);
    };
    const look = (step) => page.screenshot({ path: join(pictures, `touch-${size.width ?? 1280}-lesson-1-${step}.png`) });
    if (!more) {
      await tap('lessons');
      await tap('lesson/01-ray-casting');
    }
    await visit.until((now) => lesson_1(now).step === 1);
    await look(1);
    await tap('lesson-next');
    for (const step of [2, 3]) {
      await visit.until((now) => lesson_1(now).step === step);
      await tap('guess/2');
      await look(step);
      await tap('lesson-reveal');
      await visit.until((now) => lesson_1(now).revealed);
      await verdict_is_on_top();
      await look(`${step}-revealed`);
      await tap('lesson-next');
    }
    const report = await visit.until((now) => lesson_1(now).step === 4);
    await visit.tap(...report.objects['Solid Sphere'].window);
    await visit.until((now) => lesson_1(now).aimed);
    await look(4);
    await tap('lesson-reveal');
    await tap('lesson-next');
    await visit.until((now) => lesson_1(now).step === 5);
    await tap('lesson-number');
    assert.equal(await page.evaluate(() => document.activeElement.id), 'keyboard');
    // The page's field is of its kind, and stands where it does, for the browser keeps what is typed into in sight.
    const field = await page.$eval('#keyboard', (each) => ({ mode: each.inputMode, top: each.getBoundingClientRect().top }));
    const { items: { 'lesson-number': [, top, , height] } } = await visit.report();
    assert.equal(field.mode, 'decimal');
    assert.ok(field.top >= top - 1 && field.top < top + height, `${field.top} is beside ${top}`);
    await visit.rests(); // a student thinks first: nothing but the letters has the field drawn
    await page.keyboard.sendCharacter('2');
    await page.keyboard.sendCharacter('1');
    assert.ok(await page.evaluate(can_reveal), 'letters are in the field as soon as they are typed');
    await look(5);
    await tap('lesson-reveal');
    await visit.until((now) => lesson_1(now).revealed);
    await look('5-revealed');
    await tap('lesson-next');
    await visit.until((now) => now.lesson.open === '');
    await look('end');
    assert.deepEqual(visit.complaints, []);
    await page.close();
  });

test('a finger that misses a small button by little presses it', async () => {
  // On a telephone none is small.
  const visit = await Visit.begin(browser, server.address, { hasTouch: true }, '&language=en#v=1/scene=glass/mode=move'), { page } = visit;
  const { items: { 'mode-trace': [x, y, width] } } = await visit.until((now) => now.mode === 'move');
  await visit.tap(x + width / 2, y - 2);
  await visit.until((now) => now.mode === 'trace');
  await page.close();
});

test('on a telephone what fixes the bug of a lesson stands below the answer, which the question has made room for', async () => {
  const visit = await Visit.begin(browser, server.address, phone, '&language=en#v=1/lesson=14-radiosity/at=7');
  await visit.until((now) => now.lesson?.step === 7 && now.notice === '', 'no notice hides what is asked about');
  await visit.act('mark-line 67');
  await visit.act('reveal');
  const { items } = await visit.until((now) => now.lesson.revealed && 'bug-mend' in now.items);
  assert.ok(items['bug-mend'][1] > items['lesson-verdict'][1]);
  await visit.page.close();
});

test('two fingers zoom and pan the plan, and one that rests tells and presses nothing', async () => {
  const visit = await Visit.begin(browser, server.address, { hasTouch: true }), { page } = visit;
  const touch = (type, ...points) => visit.touch(type, ...points);
  const apart = ({ objects: all }) => Math.hypot(...[0, 1].map((i) => all['Solid Sphere'].window[i] - all.Polygon.window[i]));
  const before = await visit.report(), [x, y] = before.objects['Solid Sphere'].window;
  await touch('touchstart', [x - 40, y], [x + 40, y]);
  await touch('touchmove', [x - 80, y], [x + 80, y]);
  await touch('touchend');
  const zoomed = await visit.until((now) => Math.abs(apart(now) - 2 * apart(before)) < 3, 'it is twice as large');
  assert.ok(Math.abs(zoomed.objects['Solid Sphere'].window[0] - x) < 3, 'what is between the fingers stays there');
  await touch('touchstart', [x - 40, y], [x + 40, y]);
  await touch('touchmove', [x - 10, y + 20], [x + 70, y + 20]);
  await touch('touchend');
  await visit.until((now) => Math.abs(now.objects['Solid Sphere'].window[0] - x - 30) < 3 &&
    Math.abs(now.objects['Solid Sphere'].window[1] - y - 20) < 3, 'it has moved with the fingers');

  const step = middle((await visit.report()).items.clear);
  await page.keyboard.press(' ');
  await visit.until((now) => now.position === 1);
  await touch('touchstart', step);
  await new Promise((again) => setTimeout(again, 900));
  await page.screenshot({ path: join(pictures, 'long-press.png') });
  await touch('touchend');
  await new Promise((again) => setTimeout(again, 200));
  assert.equal((await visit.report()).position, 1);
  await visit.tap(...step);
  await visit.until((now) => now.position === 0);
  assert.deepEqual(visit.complaints, []);
  await page.close();
});

test('a finger scrolls what scrolls, and presses nothing by that', async () => {
  const visit = await Visit.begin(browser, server.address, phone, '&language=en#v=1/lesson=01-ray-casting/at=2');
  const before = await visit.until((now) => 'guess/1' in now.items), [x, y] = middle(before.items.lesson);
  await visit.touch('touchstart', [x, y]);
  for (let moved = 10; moved <= 50; moved += 10) await visit.touch('touchmove', [x, y - moved]);
  await visit.touch('touchend');
  const after = await visit.until((now) => Math.abs(before.items['guess/1'][1] - now.items['guess/1'][1] - 50) < 2, 'it moves with the finger');
  assert.deepEqual([after.position, after.lesson.step], [before.position, before.lesson.step]);
  await visit.tap(...middle(after.items['guess/1']));
  await visit.tap(...middle(after.items['lesson-reveal']));
  await visit.until((now) => now.lesson.revealed);
  await visit.page.close();
});

test('axe-core finds no fault, as a drawing and as text', async () => {
  const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
  const visit = await Visit.begin(browser, server.address), { page } = visit;
  const faults = async () => {
    await page.evaluate(axe);
    const { violations } = await page.evaluate(() => window.axe.run(document, { runOnly: ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa', 'best-practice'] }));
    return violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html).slice(0, 3).join(' ')}`);
  };
  assert.deepEqual(await faults(), []);
  await use(page, 'button', open_as_text);
  assert.deepEqual(await faults(), []);
  await use(page, 'button', 'Lessons');
  await use(page, 'button', 'Ray casting, 0 / 5, go on with this one');
  await visit.until((now) => lesson_1(now).step === 1);
  await page.evaluate(() => { for (const each of document.querySelectorAll('#mirror details')) each.open = true; });
  assert.deepEqual(await faults(), []);
  await page.screenshot({ path: join(pictures, 'as-text.png') });
  // The drawing has the rest of the window, and its own proportions.
  const shown = await page.$eval('#canvas', (canvas) => [canvas.getBoundingClientRect().right, canvas.clientWidth * devicePixelRatio / canvas.width]);
  assert.deepEqual(shown, [await page.$eval('#mirror', (text) => text.getBoundingClientRect().left), 1]);
  // A key that is pressed beside all buttons is not the program's.
  const { mode } = await visit.until(() => true);
  await page.click('#mirror h1');
  await page.keyboard.press('m');
  await new Promise((drawn) => setTimeout(drawn, 500));
  assert.equal((await visit.until(() => true)).mode, mode);
  await page.setViewport({ width: 360, height: 640 });
  assert.deepEqual(await faults(), []);
  assert.ok(await page.evaluate(() => document.getElementById('mirror').scrollWidth <= 360), 'nothing is cut off');
  await page.close();
});

test('the text costs nothing before it is asked for, and speaks the language of the window', async () => {
  const visit = await Visit.begin(browser, server.address), { page } = visit;
  await page.evaluate(() => {
    const { raywalk } = window, { ccall } = raywalk;
    window.outlines = 0;
    raywalk.ccall = (name, ...rest) => (window.outlines += name === 'page_outline', ccall(name, ...rest));
  });
  await page.keyboard.press(' ');
  await visit.until((now) => now.position === 1);
  assert.equal(await page.evaluate(() => window.outlines), 0);
  await use(page, 'button', open_as_text);
  await page.evaluate(() => { for (const each of document.querySelectorAll('#mirror details')) each.open = true; });
  await use(page, 'button', 'Español');
  await page.waitForFunction(() => document.documentElement.lang === 'es');
  assert.ok(await page.evaluate(() => window.outlines) > 0);
  assert.ok(says(await spoken(page), 'Seudocódigo'));
  await page.close();
});

test('as text, a dialog takes the name that it offers, and a field shows what the program has', async () => {
  const visit = await Visit.begin(browser, server.address), { page } = visit;
  await use(page, 'button', open_as_text);
  await use(page, 'textbox', 'Go to step', '99999');
  const { position } = await visit.until((now) => now.position > 0);
  assert.equal(await page.evaluate(() => document.activeElement.value), String(position));
  await visit.act('ask-save-as');
  await use(page, 'button', 'Save');
  await visit.until((now) => now.prompt === '' && now.path === '/files/classic.toml');
  await visit.act('ask-open');
  await page.evaluate(() => { document.getElementById('chooser').click = () => { window.chooses = true; }; });
  await use(page, 'button', 'From this device…');
  await visit.until((now) => now.prompt === '');
  assert.ok(await page.evaluate(() => window.chooses));
  assert.deepEqual(visit.complaints, []);
  await page.close();
});

test('as text, the buttons of dialogs that are drawn lead to what can be chosen there', async () => {
  const visit = await Visit.begin(browser, server.address), { page } = visit;
  await use(page, 'button', open_as_text);
  for (const [command, heading] of [['breakpoints', 'Where to stop'], ['image-settings', 'The 3-D image']]) {
    await page.$eval(`#mirror [data-key="button command-${command}"]`, (button) => button.click());
    assert.equal(await page.evaluate(() => document.activeElement.textContent), heading);
    assert.ok(await page.evaluate(() => document.activeElement.closest('details').open));
  }
  await use(page, 'textbox', 'Samples per pixel', '4');
  assert.equal(await page.evaluate(() => document.activeElement.value), '4');
  await use(page, 'button', 'Heat map: time');
  await visit.until((now) => now.image.finished);
  assert.equal(await page.$eval('#mirror [data-key="button heat-4"]', (button) => button.ariaPressed), 'true');
  assert.deepEqual(visit.complaints, []);
  await page.close();
});

test('as text, properties are changed, and Cost says what it has found', async () => {
  const visit = await Visit.begin(browser, server.address), { page } = visit;
  await use(page, 'button', open_as_text);
  await visit.act('mode move');
  const select = '#mirror [data-key="entry object-0"] [data-key="button select"]';
  await page.waitForSelector(select);
  const name = (await page.$eval(select, (button) => (button.click(), button.textContent))).replace('Properties of ', '');
  await page.waitForFunction((heading) => document.activeElement.textContent === heading, {}, name);
  await use(page, 'textbox', 'Radius', '0,5');
  assert.equal(await page.evaluate(() => document.activeElement.value), '0.5');
  await use(page, 'textbox', 'Diffuse (kd)', '0.25 0.5 1');
  assert.equal(await page.evaluate(() => document.activeElement.value), '0.25 0.5 1');
  await use(page, 'textbox', 'Radius', '-1');
  await page.waitForFunction(() => /radius: expected a number above 0/.test(document.querySelector('#mirror').textContent));
  await visit.act('tab cost');
  await page.$eval('#mirror [data-key="button command-cost-knobs"]', (button) => button.click());
  assert.equal(await page.evaluate(() => document.activeElement.closest('details').open), true);
  await visit.act('cost-try');
  await page.waitForFunction(() => /rays/.test(document.querySelector('#mirror [data-key="entry try-0"]')?.textContent), { timeout: 60000 });
  await visit.act('cost-page effects');
  await page.waitForFunction(() => /of the time/.test(document.querySelector('#mirror [data-key="text effect-1"]')?.textContent), { timeout: 60000 });
  assert.deepEqual(visit.complaints, []);
  await page.close();
});

test('as text, a link that cannot be made says why', async () => {
  const visit = await Visit.begin(browser, server.address), { page } = visit;
  await page.evaluate(() => {
    const spheres = Array.from({ length: 1100 }, (_, i) => `[[object]]\nname = "O${i}"\ntype = "sphere"\ncentre = [${i}, 0, 0]\nradius = 0.1\n`);
    const dataTransfer = new DataTransfer;
    dataTransfer.items.add(new File(['[camera]\neye = [-5, 0, 0]\nlook_at = [0, 0, 0]\nfov = 40\n', ...spheres], 'many.toml'));
    document.getElementById('canvas').dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
  });
  await visit.until((now) => now.path === '/files/many.toml');
  await use(page, 'button', open_as_text);
  await page.evaluate(() => { for (const each of document.querySelectorAll('#mirror details')) each.open = true; });
  await use(page, 'button', 'Copy link');
  await visit.until((now) => now.link_shown);
  assert.equal(await page.evaluate(() => document.activeElement.textContent), 'Link to this scene and step');
  assert.ok(says(await spoken(page), 'This scene is too large for a link'));
  await use(page, 'button', 'Close');
  await visit.until((now) => !now.link_shown);
  await page.close();
});

test('who wants less motion gets less', async () => {
  const calm = is_firefox ? await open_browser({ 'ui.prefersReducedMotion': 1 }) : browser;
  const visit = await Visit.begin(calm, server.address);
  if (!is_firefox) await visit.page.emulateMediaFeatures([{ name: 'prefers-reduced-motion', value: 'reduce' }]);
  await visit.page.reload();
  await visit.page.waitForFunction(() => document.getElementById('says').hidden && window.raywalk);
  await visit.settled();
  await visit.page.evaluate(() => document.getElementById('as-text').click());
  const tween = await visit.page.waitForSelector('#mirror [data-key="button command-tweens"]');
  assert.equal(await tween.evaluate((it) => it.getAttribute('aria-pressed')), 'false');
  await visit.page.close();
  if (is_firefox) await calm.close();
});
