// Every picture has the native program's bits: in Node, where a picture needs no page, and in a browser.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Visit, open_browser, serve } from './browser.mjs';
import { all_pictures, five_in, named, native_hash, node_hash } from './pictures.mjs';

const in_node = process.env.RAYWALK_BROWSER !== 'firefox'; // once is enough
if (in_node) ['double', 'float'].forEach(five_in);

test('every scene by every integrator in both precisions has the native bits, in Node and in the browser', async () => {
  const browser = await open_browser(), server = await serve();
  try {
    const { page } = await Visit.begin(browser, server.address);
    const differ = [];
    for (const picture of all_pictures) {
      const native = native_hash(picture), { scene, integrator, precision, size } = picture;
      const own = await page.evaluate(async (...asked) => {
        const program = window.raywalk;
        const wrong = program.ccall('page_render', 'string', ['string', 'string', 'number', 'number', 'string', 'string'], asked);
        if (wrong) return wrong;
        const bytes = await crypto.subtle.digest('SHA-256', program.FS.readFile('/own.pfm'));
        return Array.from(new Uint8Array(bytes), (byte) => byte.toString(16).padStart(2, '0')).join('');
      }, `/raywalk/scenes/${scene}.toml`, '/own.pfm', ...size, precision, integrator);
      if (own !== native) differ.push(`${named(picture)} in the browser: ${own}`);
      if (in_node && await node_hash(picture) !== native) differ.push(`${named(picture)} in Node`);
    }
    assert.deepEqual(differ, []);
  } finally {
    await browser.close();
    server.end();
  }
});
