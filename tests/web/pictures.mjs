// The pictures of the native program, and of the page's program in Node.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { mkdtempSync, readFileSync, readdirSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';

const build = process.env.RAYWALK_BUILD, scenes = join(process.env.RAYWALK_SOURCE_DIR, 'scenes');
const folder = mkdtempSync(join(tmpdir(), 'raywalk-'));
process.on('exit', () => rmSync(folder, { recursive: true }));

export const five = ['classic', 'whitted', 'distributed', 'cornell', 'mesh'];
const all_scenes = readdirSync(scenes).filter((name) => name.endsWith('.toml')).map((name) => name.slice(0, -5));

// Every shipped scene, by every integrator that takes any scene, and by the others where they are at home, in both
// precisions.
const at_home = { photons: ['caustic', 'classic', 'cornell'], radiosity: ['radiosity'], beams: ['beams'], cones: ['cones'] };
export const all_pictures = [
  ...all_scenes.flatMap((scene) => ['cast', 'whitted', 'distributed', 'path'].map((integrator) => ({ scene, integrator }))),
  ...Object.entries(at_home).flatMap(([integrator, scenes]) => scenes.map((scene) => ({ scene, integrator }))),
].flatMap((picture) => ['float', 'double'].map((precision) => ({ ...picture, precision, size: [37, 28] })));
export const named = ({ scene, integrator, precision }) => [scene, integrator, precision].filter((word) => word).join(' ');

export const hash_of = (bytes) => createHash('sha256').update(bytes).digest('hex');

export function native_hash({ scene, integrator, precision, size }) {
  const file = join(folder, 'native.pfm');
  execFileSync(join(build, 'release/raywalk'), ['render', join(scenes, `${scene}.toml`), '-o', file, '--size', size.join('x'),
    '--precision', precision, ...integrator ? ['--integrator', integrator] : [], '--quiet']);
  return hash_of(readFileSync(file));
}

let node_program;
export async function node_hash({ scene, integrator, precision, size }) {
  node_program ??= await createRequire(import.meta.url)(join(build, 'web/raywalk.js'))({ noInitialRun: true });
  const wrong = node_program.ccall('page_render', 'string', ['string', 'string', 'number', 'number', 'string', 'string'],
    [`/raywalk/scenes/${scene}.toml`, '/own.pfm', ...size, precision, integrator ?? '']);
  assert.equal(wrong, '');
  return hash_of(node_program.FS.readFile('/own.pfm'));
}

export function five_in(precision) {
  for (const scene of five) {
    const picture = { scene, precision, size: [121, 91] };
    test(`${named(picture)} has the native program's bits`, async () => assert.equal(await node_hash(picture), native_hash(picture)));
  }
}
