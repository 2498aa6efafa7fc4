// pack.mjs BUILD SITE: makes the static site of what the compiler made in BUILD, and raywalk.html, which holds all of it
// in one file.
import { createHash } from 'node:crypto';
import { copyFileSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';

const [build, site] = process.argv.slice(2);
const here = dirname(fileURLToPath(import.meta.url));
const texts = join(here, '../../text');
const read = (folder, name) => readFileSync(join(folder, name), 'utf8');

// What is said before the program is there: the table [page] of each language.
function page_words(toml) {
  const table = toml.match(/^\[page\]\n((?:(?!\[).*\n?)*)/m)?.[1] ?? '';
  return Object.fromEntries([...table.matchAll(/^(\w+) = (".*")$/gm)].map(([, id, text]) => [id, JSON.parse(text)]));
}
const words = Object.fromEntries(readdirSync(texts).filter((name) => name.endsWith('.toml'))
  .map((name) => [name.slice(0, -5), page_words(read(texts, name))]));

const program = read(build, 'raywalk.js'), script = read(here, 'page.js'), style = read(here, 'page.css');
const hash = (text) => `'sha256-${createHash('sha256').update(text).digest('base64')}'`;

// No request leaves the page. WebAssembly has to be allowed by name.
function page(scripts, styles, more, rest) {
  const policy = `default-src 'none'; script-src ${scripts} 'wasm-unsafe-eval'; style-src ${styles}; img-src blob: data:${more}`;
  const head = `<meta http-equiv="Content-Security-Policy" content="${policy}">`;
  const said = `<script type="application/json" id="words">${JSON.stringify(words).replaceAll('<', '\\u003c')}</script>`;
  return read(here, 'page.html').replace(/<!--[^]*?-->/, () => head).replace('</html>', () => `${said}\n${rest}\n</html>`);
}
const inline = (text) => {
  if (text.includes('</script')) throw new Error('this script cannot stand in a page');
  return `<script>${text}</script>`;
};

rmSync(site, { recursive: true, force: true });
mkdirSync(site, { recursive: true });
for (const [folder, name] of [[build, 'raywalk.js'], [build, 'raywalk.wasm'], [here, 'page.js'], [here, 'page.css']])
  copyFileSync(join(folder, name), join(site, name));
writeFileSync(join(site, 'index.html'), page("'self'", "'self'", "; connect-src 'self'",
  '<link rel="stylesheet" href="page.css">\n<script src="raywalk.js"></script>\n<script src="page.js"></script>'));

const code = gzipSync(readFileSync(join(build, 'raywalk.wasm')), { level: 9 }).toString('base64');
writeFileSync(join(site, 'raywalk.html'), page(`${hash(program)} ${hash(script)}`, hash(style), '',
  `<style>${style}</style>\n<script type="text/plain" id="code">${code}</script>\n${inline(program)}\n${inline(script)}`));
