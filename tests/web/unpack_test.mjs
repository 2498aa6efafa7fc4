// The program's code on its way: what is packed is what was made, and what arrives damaged or finds no memory is said in
// a sentence.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { build, open_browser, pictures, serve, site } from './browser.mjs';

let browser;
const own = mkdtempSync(join(tmpdir(), 'raywalk-unpack-'));
before(async () => { browser = await open_browser(); });
after(async () => {
  await browser?.close();
  rmSync(own, { recursive: true });
});

const module = new WebAssembly.Module(readFileSync(join(build, 'web/unpack.wasm')));
const version = readdirSync(site).find((name) => /^[0-9a-f]{16}$/.test(name));
const packed = readFileSync(join(site, version, 'raywalk.bin'));

// What becomes of these bytes, given so many at once; null if they are refused.
function unpacked(bytes, at_once = 1 << 16) {
  const tool = new WebAssembly.Instance(module).exports;
  tool._initialize();
  let size = 0;
  for (let from = 0; from < bytes.length && size >= 0; from += at_once) {
    const part = bytes.subarray(from, from + at_once);
    new Uint8Array(tool.memory.buffer).set(part, tool.unpack_room());
    size = tool.unpack(part.length);
  }
  return size >= 0 && tool.unpack_whole() ? Buffer.from(tool.memory.buffer, tool.unpack_code(), size) : null;
}
// How many of the last bytes are texts: that stands in the second word of what LZMA unpacks, which is before the code.
const texts_size = (() => {
  const tool = new WebAssembly.Instance(module).exports;
  tool._initialize();
  new Uint8Array(tool.memory.buffer).set(packed.subarray(0, tool.unpack_most()), tool.unpack_room());
  tool.unpack(tool.unpack_most());
  return new DataView(tool.memory.buffer).getUint32(tool.unpack_code() - Number(packed.readBigUInt64LE(5)) + 4, true);
})();
const code = readFileSync(join(build, 'web/raywalk.wasm'));

test('what is unpacked is what was packed, however it arrives', () => {
  for (const at_once of [1 << 16, 4099, 7]) assert.equal(Buffer.compare(unpacked(packed, at_once), code), 0);
});

test('no wrong bit, no missing end and nothing behind it goes unnoticed', () => {
  const size = packed.length, texts = size - texts_size;
  assert.ok(texts_size > 100000 && texts > size / 2, `${texts_size} bytes of texts`);
  // Bytes 1 to 4 say how far back the packer looked.
  const places = [0, 5, 6, 7, 8, 12, 13, 14, 18, size - 1, size - 2, size - 5, ...Array(40).fill().map((_, i) => 19 + Math.floor((size - 30) * i / 40)),
    ...Array(7).fill().map((_, i) => texts - 2 + i), ...Array(30).fill().map((_, i) => texts + Math.floor(texts_size * i / 30))];
  for (const [i, place] of places.entries()) {
    const wrong = Buffer.from(packed);
    wrong[place] ^= 1 << i % 8;
    const got = unpacked(wrong);
    assert.ok(got === null, `bit ${i % 8} of byte ${place}`);
  }
  for (const end of [0, 5, 13, 1000, texts - 1, texts, texts + 1, texts + 5, size - 50000, size - 1]) assert.equal(unpacked(packed.subarray(0, end)), null, `${end} bytes`);
  assert.equal(unpacked(Buffer.concat([packed, Buffer.from([0])])), null);
  const without = (from, to) => Buffer.concat([packed.subarray(0, from), packed.subarray(to)]);
  for (const from of [texts, texts + 1000, size - 2]) assert.equal(unpacked(without(from, from + 1)), null, `without byte ${from}`);
});

test('sizes that cannot be are refused', () => {
  const most = 0xffffffff;
  const made = (words, texts = Buffer.alloc(0)) => {
    const sorted = Buffer.concat([Buffer.from(Uint32Array.from(words).buffer), Buffer.from('code')]);
    const { stdout } = spawnSync('xz', ['-c', '--format=lzma', '--lzma1=lc=2,pb=0'], { input: sorted });
    stdout.writeBigUInt64LE(BigInt(sorted.length), 5);
    return unpacked(Buffer.concat([stdout, texts]));
  };
  // The size of all, that of its packed texts, and a part: bytes as they are, and those of texts.
  assert.equal(made([4, 0, 0, 4, 0]).toString(), 'code');
  for (const words of [[3, 0, 0, 4, 0], [5, 0, 0, 4, 0], [most, 0, 0, 4, 0], [4, most, 0, 4, 0], [4, 1, 0, 4, 0], [4, 0, 0, most, 0],
    [4, 0, 0, 4, 1], [4, 0, 0, 4, most], [5, 0, 0, 4, 1], [4, 0, 0, 3, 1], [4, 0, 1, 4, 0]])
    assert.equal(made(words), null, words.join(' '));
  assert.equal(made([4, 5, 0, 4, 0], Buffer.alloc(5)), null, 'texts that no part asks for');
});

// The one file, changed: what it says.
async function said(change, prepare = () => 0) {
  const file = join(own, 'raywalk.html'), page = await browser.newPage();
  writeFileSync(file, change(readFileSync(join(site, 'raywalk.html'), 'utf8')));
  await prepare(page);
  await page.goto(pathToFileURL(file) + '?language=en');
  await page.waitForFunction(() => /stopped|memory/.test(document.getElementById('says')?.textContent), { timeout: 120000 });
  const text = await page.evaluate(() => document.getElementById('says').textContent);
  await page.screenshot({ path: join(pictures, 'damaged.png') });
  await page.close();
  return text;
}
const letters_at = (html) => html.indexOf('id="code">') + 'id="code">'.length;

test('a damaged page says so, and one that lacks its end', async () => {
  const text = await said((html) => html.slice(0, letters_at(html) + 1000000) + '////' + html.slice(letters_at(html) + 1000004));
  assert.match(text, /^Raywalk stopped .*\nthe page has arrived damaged$/);
  assert.match(await said((html) => html.slice(0, letters_at(html) + 1000000) + html.slice(html.indexOf('</script>', letters_at(html)))),
    /^Raywalk stopped .*\nthe page has not arrived whole$/);
});

test('a page without memory says so', async () => {
  const without = (page) => page.evaluateOnNewDocument(() => {
    const make = WebAssembly.instantiate;
    WebAssembly.instantiate = async (...all) => {
      const { instance } = await make(...all);
      return { instance: { exports: { ...instance.exports, unpack: () => -2 } } };
    };
  });
  assert.match(await said((html) => html, without), /^There is not enough memory/);
});

test('the program is kept unpacked', async () => {
  const server = await serve(), page = await browser.newPage();
  await page.goto(server.address);
  await page.waitForFunction(async () => (await navigator.serviceWorker.getRegistration())?.active, { timeout: 120000 });
  const kept = await page.evaluate(async (version) => {
    const answer = await caches.match(`${version}/raywalk.wasm`);
    const hash = await crypto.subtle.digest('SHA-256', await answer.arrayBuffer());
    return [answer.headers.get('content-type'), Array.from(new Uint8Array(hash), (byte) => byte.toString(16).padStart(2, '0')).join('')];
  }, version);
  assert.deepEqual(kept, ['application/wasm', createHash('sha256').update(code).digest('hex')]);
  await page.reload(); // from here on the service worker answers
  await page.waitForFunction(() => document.getElementById('says').hidden && window.raywalk, { timeout: 120000 });
  const asked = await page.evaluate(() => performance.getEntriesByType('resource').map(({ name }) => name.replace(/.*[/]/, '')));
  assert.ok(asked.includes('raywalk.wasm') && !asked.includes('raywalk.bin'), asked.join(' '));
  await page.close();
  server.end();
});
