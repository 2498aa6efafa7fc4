// serve.mjs FOLDER [PORT]: serves a folder's files to browsers on this machine, as any static host would.
import { createReadStream, statSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join, normalize } from 'node:path';

const [folder, port] = process.argv.slice(2);
const kinds = { '.html': 'text/html; charset=utf-8', '.js': 'text/javascript', '.css': 'text/css',
  '.svg': 'image/svg+xml', '.webmanifest': 'application/manifest+json' };

const server = createServer((request, response) => {
  let file, found;
  try {
    const { pathname } = new URL(request.url, 'http://localhost');
    file = join(folder, normalize('/' + decodeURIComponent(pathname)), pathname.endsWith('/') ? 'index.html' : '');
    found = statSync(file, { throwIfNoEntry: false });
  } catch {
    found = null; // no address at all
  }
  if (!found?.isFile()) return response.writeHead(404).end('there is no such file here\n');
  response.writeHead(200, { 'Content-Type': kinds[extname(file)] ?? 'application/octet-stream', 'Content-Length': found.size });
  createReadStream(file).pipe(response);
});
server.on('error', (why) => {
  console.error(`raywalk: the page cannot be served: ${why.message}`);
  process.exit(1);
});
server.listen(Number(port ?? 0), '127.0.0.1', () =>
  console.log(`raywalk: the page is at http://127.0.0.1:${server.address().port}/ until Ctrl-C`));
