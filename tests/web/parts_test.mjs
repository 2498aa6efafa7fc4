// Scripts of the page each by itself, without a browser: what they do where one would need chance, or another site.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { createContext, runInContext } from 'node:vm';

const run = (name, globals, what = '') => {
  const source = readFileSync(join(process.env.RAYWALK_SOURCE_DIR, 'src/gui/web', name), 'utf8');
  return runInContext(`${source};${what}`, createContext({ URL, Promise, console, ...globals }));
};
const settled = () => new Promise((again) => setImmediate(again));

test('a page around this one is told of errors of what it has sent, and of no other', async () => {
  const told = [], went = [], parent = { postMessage: (message) => told.push(message) };
  let question = false, hear;
  const window = { parent, addEventListener: (_, call) => { hear = call; } };
  const page = run('embed.js', { window, sent: {
    load_link: () => {},
    load_scene: (text) => text === 'bad' ? 'this is no scene' : undefined,
    go: (step) => went.push(step),
    asks: () => question,
  } }, 'new Embedding(null, sent)');
  const moment = { step: 0, lesson: '', lesson_step: 0, lesson_steps: 0 };
  const look = (error = '') => page.look({ moment, judged: 0, right: 0, made: 0, done: {}, asks: question, error });
  const say = (message) => hear({ source: parent, origin: 'https://course.example', data: { raywalk: 1, ...message } });
  const refused = () => told.splice(0).filter((each) => each.event === 'refused').map((each) => each.why);

  look('its link cannot be opened'); // the one in its address
  assert.deepEqual(refused(), ['its link cannot be opened']);
  look();
  look('/files/thesis.toml: line 3 is wrong');
  assert.deepEqual(refused(), []);
  say({ do: 'load', scene: 'bad' });
  look();
  look('/files/thesis.toml: line 4 is wrong');
  assert.deepEqual(refused(), ['this is no scene']);

  say({ do: 'load', link: '#v=1/scene=glass' });
  look('there is no such lesson');
  assert.deepEqual(refused(), ['there is no such lesson']);
  look();
  look('/files/thesis.toml: line 5 is wrong');
  assert.deepEqual(refused(), []);

  say({ do: 'load', scene: 'good' });
  question = true; // the student has changed the scene, and decides later
  look();
  look();
  // Meanwhile the program hears of nothing else, and the page around is told so.
  const load = { do: 'load' };
  for (const message of [{ ...load, scene: 'good' }, { ...load, link: '#v=1/scene=glass' }, { do: 'go', step: 3 }]) {
    say(message);
    assert.match(refused().join(), /question/, JSON.stringify(message));
  }
  say({ do: 'tell' });
  assert.deepEqual(refused(), []);
  question = false;
  look('it cannot be opened');
  assert.deepEqual(refused(), ['it cannot be opened']);

  for (const step of [0, 1e9]) say({ do: 'go', step });
  assert.deepEqual([went, refused()], [[0, 1e9], []]);
  say({ do: 'go', step: 1e9 + 1 });
  assert.match(refused().join(), /whole number/);
});

test('only the page around this one is heard, from its origin where one is named', () => {
  const parent = { postMessage() {} }, went = [];
  let hear;
  const window = { parent, addEventListener: (_, call) => { hear = call; } };
  for (const named of [null, 'https://course.example/']) {
    const page = run('embed.js', { window, named, does: { go: (step) => went.push(step), asks: () => false } }, 'new Embedding(named, does)');
    page.look({ moment: { step: 0 }, judged: 0, right: 0, made: 0, done: {}, asks: false, error: '' });
    for (const [step, source, origin] of [[1, parent, 'https://course.example'], [2, parent, 'https://other.example'], [3, {}, 'https://course.example'],
      [4, window, 'https://course.example']])
      hear({ source, origin, data: { raywalk: 1, do: 'go', step } });
    assert.deepEqual(went.splice(0), named ? [1] : [1, 2]);
  }
});

class Store {
  #caches = new Map();
  keys() { return Promise.resolve([...this.#caches.keys()]); }
  delete(name) { return Promise.resolve(this.#caches.delete(name)); }
  open(name) {
    if (!this.#caches.has(name)) this.#caches.set(name, new Set);
    const urls = this.#caches.get(name);
    return Promise.resolve({ urls, match: (url) => Promise.resolve(urls.has(url) ? { url } : undefined) });
  }
}

test('a version that is kept forgets the others of its own place, and none of another place on the same host', async () => {
  const caches = new Store, listeners = {};
  const scope = 'https://school.example/raywalk/', beside = 'https://school.example/raywalk/old/';
  (await caches.open('raywalk 0000000000000001')).urls.add(scope);
  (await caches.open('raywalk 0000000000000002')).urls.add(beside);
  for (const name of [`raywalk ${scope} 0000000000000003`, `raywalk ${beside} 0000000000000004`, `raywalk ${scope} VERSION`, 'raywalk notes', 'course'])
    await caches.open(name);
  const self = { addEventListener: (type, call) => { listeners[type] = call; } };
  run('kept.js', { caches, self, registration: { scope }, importScripts: () => {} });
  await new Promise((done) => listeners.activate({ waitUntil: (work) => work.then(done) }));
  assert.deepEqual(await caches.keys(),
    ['raywalk 0000000000000002', `raywalk ${beside} 0000000000000004`, `raywalk ${scope} VERSION`, 'raywalk notes', 'course']);
});

test('a message that makes a worker grow its memory arrives', async () => {
  const program = {
    HEAPU8: new Uint8Array(4),
    _worker_room(size) {
      this.HEAPU8 = structuredClone(this.HEAPU8.buffer, { transfer: [this.HEAPU8.buffer] }) && new Uint8Array(4 + size);
      return 4;
    },
    _worker_work: () => 0,
  };
  run('worker.js', { program_there: program, Raywalk: () => {}, message: { bytes: new Uint8Array([1, 2, 3]), files: [] } },
    'work(program_there, message)');
  assert.deepEqual([...program.HEAPU8.slice(4)], [1, 2, 3]);
});
