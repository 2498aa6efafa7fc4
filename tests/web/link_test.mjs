// Links in the page: an address opens a moment, loses no work, and is no way to harm it. What the page allows itself.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { Visit, browser, is_firefox, open_browser, open_for_tests, pictures, server, site } from './browser.mjs';

open_for_tests();

const go_to = (visit, hash) => visit.page.evaluate((to) => { location.hash = to; }, hash);

// Where Firefox is tested, the link is copied in Chromium.
test('a scene that was changed is opened by its link in another browser, at the same step', async () => {
  const first = is_firefox ? await open_browser({}, false) : browser;
  const visit = await Visit.begin(first, server.address);
  await visit.add_sphere();
  await visit.until((now) => now.dirty);
  await visit.page.keyboard.press('t');
  for (let i = 0; i < 5; ++i) await visit.page.keyboard.press(' ');
  const before = await visit.until((now) => now.position >= 5);
  await visit.copy_link();
  const { link } = await visit.until((now) => now.link !== '');
  assert.ok(link.length <= 2000, link);
  const other = await Visit.begin(browser, server.address, {}, '&language=en' + link.slice(link.indexOf('#')));
  const there = await other.until((now) => now.position === before.position);
  assert.deepEqual(Object.keys(there.objects), Object.keys(before.objects));
  assert.equal(there.dirty, false);
  assert.deepEqual([...visit.complaints, ...other.complaints], []);
  await visit.page.close();
  await other.page.close();
  if (first !== browser) await first.close();
});

test('a link over unsaved work asks, and a broken one says so and leaves all as it was', async () => {
  const visit = await Visit.begin(browser, server.address);
  await visit.add_sphere();
  const mine = await visit.until((now) => now.dirty);
  await go_to(visit, '#v=1/scene=glass/step=3');
  await visit.until((now) => now.question === 'unsaved');
  await visit.page.keyboard.press('Escape');
  await visit.until((now) => now.question === '' && now.dirty);
  for (const hash of ['#v=1/scene=nothing/', '#v=7/scene=glass', '#v=1/changes=AAAA', '#v=1/step=-5', '#v=1/' + 'x'.repeat(9000)]) {
    await go_to(visit, hash);
    let now = await visit.until((now) => now.notice !== '' || now.question !== '', hash);
    if (now.question) {
      await visit.page.keyboard.press('2'); // do not save
      now = await visit.until((now) => now.question === '' && now.notice !== '', hash);
    }
    assert.deepEqual(Object.keys(now.objects), Object.keys(mine.objects), hash);
    await visit.page.keyboard.press('Escape');
    await visit.until((now) => now.notice === '');
  }
  assert.deepEqual(visit.complaints, []);
  await visit.page.close();
});

test('the link is shown with a code for telephones', async () => {
  for (const [name, size] of [['code', {}], ['code@2', { deviceScaleFactor: 2 }]]) {
    const visit = await Visit.begin(browser, server.address, size, '&language=en#v=1/scene=whitted/step=7');
    await visit.act('show-link on');
    await visit.until((now) => now.link_shown && 'link-code' in now.items);
    await visit.page.screenshot({ path: join(pictures, `${name}.png`) });
    await visit.click('link-close');
    await visit.until((now) => !now.link_shown);
    await visit.page.close();
  }
});

test('the one file opens links too', async () => {
  const page = pathToFileURL(join(site, 'raywalk.html')).href;
  const visit = await Visit.begin(browser, page, {}, '&language=en#v=1/scene=mirrors/step=9');
  await visit.until((now) => now.position === 9 && now.path.endsWith('mirrors.toml'));
  assert.deepEqual(visit.complaints, []);
  await visit.page.close();
});

test('nothing runs in the page but its own scripts, and no request leaves it', async () => {
  for (const page of [server.address, pathToFileURL(join(site, 'raywalk.html')).href]) {
    const visit = await Visit.begin(browser, page);
    const policy = await visit.page.evaluate(() => document.querySelector('meta[http-equiv]').content);
    assert.ok(!policy.includes('unsafe-inline') && !/'unsafe-eval'/.test(policy), policy);
    const broken = await visit.page.evaluate(async () => {
      const broken = [];
      addEventListener('securitypolicyviolation', (event) => broken.push(event.effectiveDirective));
      const script = document.createElement('script');
      script.textContent = 'window.harmed = true';
      document.body.append(script);
      // Later, for what a debugger evaluates may evaluate.
      await new Promise((done) => setTimeout(() => {
        try { (0, eval)('window.harmed = true'); } catch { /* as it should be */ }
        done();
      }));
      try { await fetch('https://example.org/'); } catch { /* as it should be */ }
      const image = new Image;
      image.src = 'https://example.org/x.png';
      await new Promise((again) => setTimeout(again, 500));
      return { harmed: !!window.harmed, broken };
    });
    assert.equal(broken.harmed, false);
    for (const directive of ['script-src-elem', 'connect-src', 'img-src']) assert.ok(broken.broken.includes(directive), directive);
    await visit.page.close();
  }
});

test('the licences of what is in the page stand in its help', async () => {
  const visit = await Visit.begin(browser, server.address);
  const text = await visit.page.evaluate(() => window.raywalk.FS.readFile('/raywalk/licences.txt', { encoding: 'utf8' }));
  for (const name of ['Raywalk', 'Dear ImGui', 'FreeType', 'Inter', 'JetBrains Mono', 'libqrencode', 'zlib', 'libpng', 'musl'])
    assert.ok(text.includes(`== ${name} ==\n`), name);
  await visit.page.keyboard.press('F1');
  await visit.until((now) => now.mode === 'help');
  await visit.page.keyboard.press('End');
  await visit.until((now) => 'licence/FreeType' in now.items);
  await visit.page.screenshot({ path: join(pictures, 'licences.png') });
  await visit.page.close();
});

test('without memory for a file the page says so, and lives on', async () => {
  const visit = await Visit.begin(browser, server.address);
  await visit.add_sphere();
  await visit.until((now) => now.dirty);
  await visit.page.waitForFunction(() => window.raywalk.FS.analyzePath('/kept/autosave.toml').exists, { timeout: 60000 });
  const said = await visit.page.evaluate(async () => {
    WebAssembly.Memory.prototype.grow = () => { throw new RangeError('no more memory'); };
    const rows = 'v 0 0 0\nv 1 0 0\nv 0 1 0\n'.repeat(400000) + 'f 1 2 3\n'.repeat(400000);
    const dataTransfer = new DataTransfer;
    dataTransfer.items.add(new File([rows], 'large.obj'));
    document.getElementById('canvas').dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
    const last = Date.now() + 30000;
    while (Date.now() < last) {
      await new Promise((again) => setTimeout(again, 100));
      const report = JSON.parse(window.raywalk.FS.readFile('/report.json', { encoding: 'utf8' }));
      if (report.question) window.raywalk.ccall('page_act', null, ['string'], ['answer discard']);
      if (/memory/.test(report.notice)) return report.notice;
      if (!document.getElementById('says').hidden) return document.getElementById('says').textContent;
    }
    return '';
  });
  assert.match(said, /memory/);
  await visit.page.reload();
  await visit.page.waitForFunction(() => document.getElementById('says').hidden);
  await visit.until((now) => now.question === 'recover', 'what was made is there again');
  await visit.page.close();
});

test('a page that is loaded again inside of a lesson goes on at its step, and counts what was right before', async () => {
  const visit = await Visit.begin(browser, server.address), hash = () => visit.page.evaluate(() => location.hash);
  await go_to(visit, '#v=1/lesson=01-ray-casting/at=2');
  await visit.until((now) => now.lesson?.open === '01-ray-casting' && now.lesson.step === 2);
  await visit.page.keyboard.press('3');
  await visit.page.keyboard.press('Enter');
  await visit.until((now) => now.lesson.revealed && now.lesson.judged === 1);
  await visit.page.keyboard.press('Enter');
  await visit.until((now) => now.lesson.step === 3);
  assert.equal(await hash(), '#v=1/lesson=01-ray-casting/at=3');
  await visit.page.reload();
  await visit.until((now) => now.lesson?.open === '01-ray-casting' && now.lesson.step === 3 && now.lesson.judged === 1);
  const { items } = await visit.report(), [x, y, width, height] = items['lesson-close'];
  await visit.page.mouse.click(x + width / 2, y + height / 2);
  await visit.until((now) => !now.lesson?.open);
  assert.equal(await hash(), '');
  assert.deepEqual(visit.complaints, []);
  await visit.page.close();
});
