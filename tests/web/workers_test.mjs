// The 3-D picture is made beside the page: nobody waits for it, an edit ends it, and its bits do not depend on who made it.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { Visit, browser, only_in_chromium, open_for_tests, server, site, work_of } from './browser.mjs';

open_for_tests();

const workers = (visit) => visit.page.evaluate(() => window.raywalk.workers.count());
async function steps(visit, count) {
  for (let i = 0; i < count; ++i) {
    await visit.page.keyboard.press(' ');
    await new Promise((next) => setTimeout(next, 120));
  }
}
const finished = (report) => report.image.finished;

// A page whose browser has no workers, or ends them.
async function visit_without(script, address, more) {
  const context = await browser.createBrowserContext();
  const page = await context.newPage();
  await page.evaluateOnNewDocument(script);
  await page.goto(`${address}?report=/report.json${more}`);
  await page.waitForFunction(() => document.getElementById('says').hidden && window.raywalk, { timeout: 60000 });
  return Object.assign(new Visit, { page, context });
}

test('a STEP is answered within 50 ms of processor time while a picture is made', only_in_chromium, async () => {
  const visit = await Visit.begin(browser, server.address, {}, '&language=en&scene=cornell');
  assert.ok(await workers(visit) > 0);
  let meanwhile;
  const { longest } = await work_of(visit.page, async () => {
    await steps(visit, 20);
    meanwhile = await visit.until((now) => now.position >= 20);
  });
  assert.ok(!meanwhile.image.finished, 'the picture is still being made');
  assert.ok(meanwhile.image.done > 0);
  assert.ok(longest <= 50, `${longest} ms`);
  await visit.page.close();
});

test('a STEP is answered within 50 ms while thousands of shapes are put into structures, and while these are searched', only_in_chromium, async () => {
  const visit = await Visit.begin(browser, server.address, {}, '&language=en&scene=sphereflake');
  assert.ok(await workers(visit) > 0);
  const { longest } = await work_of(visit.page, async () => {
    await visit.act('tab structure');
    const { structure } = await visit.until((now) => now.structure);
    assert.equal(structure.steps, 0, 'they are still being built');
    await steps(visit, 6);
    await visit.until((now) => now.position >= 6 && now.structure.steps > 0, 'they are searched');
    await steps(visit, 10);
  });
  assert.ok(longest <= 50, `${longest} ms`);
  await visit.page.close();
});

test('the picture has the same bits by workers, without them, and when they are lost', async () => {
  for (const scene of ['classic', 'distributed']) {
    const more = `&language=en&scene=${scene}`;
    const by_workers = await Visit.begin(browser, server.address, {}, more);
    const { image: { hash } } = await by_workers.until(finished, 'the picture is finished');
    assert.ok(await workers(by_workers) > 0);
    await by_workers.page.close();
    const refused = await visit_without(() => { delete window.Worker; }, server.address, more);
    assert.equal((await refused.until(finished)).image.hash, hash);
    assert.equal(await workers(refused), 0);
    await refused.page.close();
    const lost = await visit_without(() => 0, server.address, more);
    await lost.until((now) => now.image.done > 0);
    await lost.page.evaluate(() => window.raywalk.workers.lose('a test'));
    assert.equal((await lost.until(finished)).image.hash, hash);
    await lost.page.close();
  }
});

test('an edit ends the picture under way', async () => {
  const visit = await Visit.begin(browser, server.address, {}, '&language=en&scene=cornell');
  await visit.until((now) => now.image.done > 0.02 && !now.image.finished);
  await visit.add_sphere();
  await visit.until((now) => now.image.done < 0.02, 'it begins anew');
  await visit.until((now) => now.image.done > 0.02, 'and goes on');
  await visit.page.close();
});

test('the one file has its workers in itself', async () => {
  const visit = await Visit.begin(browser, pathToFileURL(join(site, 'raywalk.html')).href);
  await visit.until(finished, 'the picture is finished');
  assert.ok(await workers(visit) > 0);
  assert.deepEqual(visit.complaints, []);
  await visit.page.close();
});

test('a scene of the user\'s, with its mesh, is traced by workers too', async () => {
  const visit = await Visit.begin(browser, server.address);
  const scenes = join(process.env.RAYWALK_SOURCE_DIR, 'scenes');
  const chooser = await visit.page.$('#chooser');
  await chooser.uploadFile(join(scenes, 'mesh.toml'), join(scenes, 'ball.ply'));
  await visit.until((now) => now.path === '/files/mesh.toml');
  const { image: { hash } } = await visit.until((now) => now.image.done < 1) && await visit.until(finished);
  assert.ok(await workers(visit) > 0);
  const refused = await visit_without(() => { delete window.Worker; }, server.address, '&scene=mesh');
  assert.equal((await refused.until(finished)).image.hash, hash);
  await visit.page.close();
  await refused.page.close();
});
