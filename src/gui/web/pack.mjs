// pack.mjs BUILD SITE [no-simd]: makes the static site of what the compiler made in BUILD, and raywalk.html, which holds all of it
// in one file.
//
// What belongs together stands in a folder of the site that is named after all of its bytes, so that a page never mixes
// two versions: not while a new one is copied to the host, and not in a browser that keeps some of the old.
import { spawnSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { copyFileSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { pruned } from './prune.mjs';
import { streamed } from './streams.mjs';

const [build, site, without] = process.argv.slice(2);
const here = dirname(fileURLToPath(import.meta.url));
const texts = join(here, '../../text');
const tool = createRequire(join(build, '../emscripten/root/usr/share/emscripten/tools/'));
const acorn = tool('acorn'), terser = tool('../third_party/terser/terser.js');
// A script without what is said to its readers, and with short names for what only it sees.
const shortened = (text, toplevel = false) => {
  const script = terser.AST_Node.from_mozilla_ast(acorn.parse(text, { ecmaVersion: 2022 }));
  script.figure_out_scope({ toplevel });
  script.mangle_names({ toplevel });
  return script.print_to_string({ shorthand: true });
};
const read = (folder, name) => {
  const text = readFileSync(join(folder, name), 'utf8');
  return name.endsWith('.js') ? shortened(text) : text;
};

function by_ppmd(bytes) {
  const tool = new WebAssembly.Instance(new WebAssembly.Module(readFileSync(join(build, 'text_packer.wasm')))).exports;
  tool._initialize();
  if (bytes.length > tool.pack_most()) throw new Error('the page has more texts than text_packer.cpp takes');
  new Uint8Array(tool.memory.buffer).set(bytes, tool.pack_room());
  const size = tool.pack(bytes.length);
  return Buffer.from(tool.memory.buffer, tool.pack_packed(), size);
}

// The compiler may come to use an instruction that one of the two does not know.
function unpacks(unpacker) {
  const tool = new WebAssembly.Instance(new WebAssembly.Module(unpacker)).exports, most = tool.unpack_most();
  tool._initialize();
  let size = 0;
  for (let from = 0; from < packed.length && size >= 0; from += most) {
    const part = packed.subarray(from, from + most);
    new Uint8Array(tool.memory.buffer).set(part, tool.unpack_room());
    size = tool.unpack(part.length);
  }
  if (!tool.unpack_whole() || code.compare(new Uint8Array(tool.memory.buffer, tool.unpack_code(), size)) !== 0)
    throw new Error('the page does not unpack its code as it was');
}

// What the page runs, in this order, behind the program. The service worker needs the first as well; page.js of the site
// is joined from several, which pack better as one.
const scripts = ['unpack.js', 'page.js'];
const joined = ['embed.js', 'offline.js', 'workers.js', 'mirror.js', 'touch.js', 'page.js'];

// What is said before the program is there: the table [page] of each language.
function page_words(toml) {
  const table = toml.match(/^\[page\]\n((?:(?!\[).*\n?)*)/m)?.[1] ?? '';
  const in_a_line = (lines) => `"${lines.replaceAll('\\\n', '')}"`;  // a \ at the end of a line joins the next to it
  return Object.fromEntries([...table.matchAll(/^(\w+) = (?:"""\n([^]*?)"""|(".*"))$/gm)]
    .map(([, id, lines, line]) => [id, JSON.parse(line ?? in_a_line(lines))]));
}
const words = Object.fromEntries(readdirSync(texts).filter((name) => name.endsWith('.toml'))
  .map((name) => [name.slice(0, -5), page_words(read(texts, name))]));

// No request leaves the page, and nothing runs in it but these scripts. WebAssembly has to be allowed by name.
function page(more_policy, head, rest) {
  const policy = ["default-src 'none'", "base-uri 'none'", "form-action 'none'", ...more_policy].join('; ');
  const said = `<script type="application/json" id="words">${JSON.stringify(words).replaceAll('<', '\\u003c')}</script>`;
  return read(here, 'page.html')
    .replace(/<!--[^]*?-->/, () => [`<meta http-equiv="Content-Security-Policy" content="${policy}">`, ...head].join('\n'))
    .replace('</html>', () => `${[said, ...rest].join('\n')}\n</html>`);
}

const sha256 = (...parts) => parts.reduce((hash, part) => hash.update(part), createHash('sha256'));
// The program's code, packed for the way: sorted by what it is made of, and by LZMA, which sees all of it, where what hosts
// and browsers know looks 32 KiB back; unpack.js brings along what unpacks it. Its file, a .lzma, says how large it was. Behind
// it come its texts, by PPMd, which takes an eighth less for them. It is named .bin, for a kind that every host knows.
const code = readFileSync(join(build, 'raywalk.wasm')), { parts: sorted_code, texts: of_code } = streamed(code);
const packed_texts = by_ppmd(of_code);
const sorted = Buffer.concat([Buffer.from(Uint32Array.of(code.length, packed_texts.length).buffer), sorted_code]);
const xz = spawnSync('xz', ['-c', '--format=lzma', '--lzma1=preset=9e,lc=2,pb=0,dict=16MiB'], { input: sorted, maxBuffer: 1 << 28 });
if (xz.status !== 0) throw new Error(`xz could not pack the page: ${xz.error ?? xz.stderr}`);
xz.stdout.writeBigUInt64LE(BigInt(sorted.length), 5);
const packed = Buffer.concat([xz.stdout, packed_texts]);
unpacks(readFileSync(join(build, 'unpack.wasm')));
const letters = packed.toString('base64');
const unpacker = readFileSync(join(build, 'unpack.wasm'), 'hex'); // which brotli and gzip pack better than base64
const source = (name) => readFileSync(join(here, name), 'utf8').replace(/^'use strict';$/m, '').replace("'WITHOUT'", () => `'${without}'`);
const whole_page = () => shortened(["'use strict';", ...joined.map(source)].join('\n'), true);
// What the page, its workers and tests ask for of Emscripten's script.
const asked = new Set([...joined, 'worker.js'].flatMap((name) => source(name).match(/\w+/g)).concat('analyzePath'));
const program = () => shortened(pruned(readFileSync(join(build, 'raywalk.js'), 'utf8'), acorn, asked));
const script = (name) => name === 'raywalk.js' ? program() : name === 'page.js' ? whole_page() :
  read(here, name).replace('"UNPACKER"', () => JSON.stringify(unpacker));

rmSync(site, { recursive: true, force: true });

// --- The site --------------------------------------------------------------------------------------------------------

const parts = new Map([['raywalk.bin', packed], ['page.css', read(here, 'page.css')],
  ...['raywalk.js', 'worker.js', ...scripts].map((name) => [name, script(name)])]);
const index = page(
  ["script-src 'self' 'wasm-unsafe-eval'", "style-src 'self'", "img-src 'self' blob: data:", "connect-src 'self'",
    "worker-src 'self'", "manifest-src 'self'"],
  ['<link rel="icon" href="icon.svg">', '<link rel="manifest" href="manifest.webmanifest">',
    '<link rel="stylesheet" href="VERSION/page.css">'],
  ['raywalk.js', ...scripts].map((name) => `<script src="VERSION/${name}"></script>`));
const for_all = ['icon.svg', 'manifest.webmanifest'];
const kept = ['./', ...for_all, ...[...parts.keys()].filter((name) => name !== 'raywalk.bin').map((name) => `VERSION/${name}`)];
// What names the version, which is of these bytes too.
const naming = new Map([['index.html', index], ['kept.js', read(here, 'kept.js').replace('[]', () => JSON.stringify(kept))]]);
const version = sha256(...parts.values(), ...naming.values(), ...for_all.map((name) => read(here, name))).digest('hex').slice(0, 16);
const own = join(site, version);
mkdirSync(own, { recursive: true });
for (const [name, content] of parts) writeFileSync(join(own, name), content);
for (const [name, content] of naming) writeFileSync(join(site, name), content.replaceAll('VERSION', version));
// For where a page may run scripts but fetch nothing: a frame without an origin, or a folder of a disk.
writeFileSync(join(own, 'code.js'), `self.raywalk_code = '${letters}';\n`);
for (const name of [...for_all, 'course.html']) copyFileSync(join(here, name), join(site, name));

// --- The one file ------------------------------------------------------------------------------------------------------

const inline = ['raywalk.js', ...scripts].map(script);
const style = read(here, 'page.css'), worker = script('worker.js');
for (const text of [...inline, worker])
  if (text.includes('</script')) throw new Error('this script cannot stand in a page');
const hashes = inline.map((text) => `'sha256-${sha256(text).digest('base64')}'`);
writeFileSync(join(site, 'raywalk.html'), page(
  [`script-src ${hashes.join(' ')} 'wasm-unsafe-eval'`, `style-src 'sha256-${sha256(style).digest('base64')}'`,
    'img-src blob: data:', 'worker-src blob:'],
  ['<link rel="icon" href="data:,">', `<style>${style}</style>`],
  [`<script type="text/plain" id="code">${letters}</script>`, `<script type="text/plain" id="worker">${worker}</script>`,
    ...inline.map((text, i) => `<script${i === 0 ? ' id="program"' : ''}>${text}</script>`)]));
