// order.mjs WASM OPTIMISER [no-simd]: puts functions beside each other that are alike, and drops their names. Half of the code is one
// template or another, compiled for float and double, for this effect and that. What packs the file sees all of it, but says
// in fewer bits what was there a moment ago: a seventieth less than in the order in which they were linked.
//
// Names are what OPTIMISER, wasm-opt, can sort by: here each becomes its place in the wanted order.
import { execFileSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';

const [file, optimiser, without] = process.argv.slice(2);
const bytes = readFileSync(file);

let at = 8;
function number() {
  let value = 0;
  for (let shift = 0; ; shift += 7) {
    if (at >= bytes.length) throw new Error(`${file} ends within a number`);
    const byte = bytes[at++];
    value += (byte & 127) * 2 ** shift;
    if (byte < 128) return value;
  }
}
function written(value) {
  const made = [];
  for (; value > 127; value = Math.floor(value / 128)) made.push((value % 128) | 128);
  return Buffer.from([...made, value]);
}
const text = () => {
  const size = number();
  return bytes.toString('utf8', at, at += size);
};

const names = new Map, kept = [bytes.subarray(0, 8)];
while (at < bytes.length) {
  const from = at, kind = bytes[at++], size = number(), end = at + size;
  if (kind === 0 && text() === 'name') {
    while (at < end) {
      const part = bytes[at++], part_end = number() + at;
      if (part === 1) for (let left = number(); left > 0; --left) names.set(number(), text());
      at = part_end;
    }
  } else {
    kept.push(bytes.subarray(from, end));
  }
  at = end;
}

// Without what stands in angle brackets.
function without_arguments(name) {
  let depth = 0, bare = '';
  for (const letter of name) {
    if (letter === '<') ++depth;
    else if (letter === '>') --depth;
    else if (depth <= 0) bare += letter;
  }
  return bare.replace(/\b(float|double)\b/g, 'T');
}
const order = [...names].map(([index, name]) => ({ index, name, alike: without_arguments(name) }))
  .sort((a, b) => (a.alike < b.alike ? -1 : a.alike > b.alike ? 1 : a.name < b.name ? -1 : a.name > b.name ? 1 : 0));
const places = new Map(order.map(({ index }, place) => [index, Buffer.from(String(place).padStart(6, '0'))]));
const section = (kind, ...parts) => {
  const content = Buffer.concat(parts);
  return Buffer.concat([Buffer.from([kind]), written(content.length), content]);
};
const string = (letters) => Buffer.concat([written(letters.length), letters]);
const entries = [...places].sort(([a], [b]) => a - b).map(([index, place]) => Buffer.concat([written(index), string(place)]));
writeFileSync(file, Buffer.concat([...kept, section(0, string(Buffer.from('name')), section(1, written(places.size), ...entries))]));
// An instruction of a feature that is not among these is an error.
const features = ['exception-handling', ...without ? [] : ['simd'], 'bulk-memory', 'sign-ext', 'mutable-globals', 'nontrapping-float-to-int',
  'multivalue', 'reference-types'].map((name) => '--enable-' + name);
// What the compiler's own run of it has made smaller, two more make smaller still. Nothing lies below the first 1024 bytes.
execFileSync(optimiser, [file, ...features, '--reorder-functions-by-name', '--low-memory-unused', '-Oz',
  '--generate-global-effects', '-Oz', '--strip-debug', '--strip-producers', '-o', file]);
