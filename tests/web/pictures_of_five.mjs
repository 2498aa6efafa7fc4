// The page's program gives the same bits as the native one: under Node, where pictures need no page.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';

const build = process.env.RAYWALK_BUILD;
const Raywalk = createRequire(import.meta.url)(join(build, 'web/raywalk.js'));
const program = await Raywalk({ noInitialRun: true });
const folder = mkdtempSync(join(tmpdir(), 'raywalk-'));
process.on('exit', () => rmSync(folder, { recursive: true }));

export const five = ['classic', 'whitted', 'distributed', 'cornell', 'mesh'];

export function same_bits(scene, precision) {
  test(`${scene} in ${precision} has the native program's bits`, () => {
    const wrong = program.ccall('page_render', 'string', ['string', 'string', 'number', 'number', 'number'],
      [`/raywalk/scenes/${scene}.toml`, '/own.pfm', 121, 91, precision === 'float' ? 1 : 0]);
    assert.equal(wrong, '');
    const native = join(folder, 'native.pfm');
    execFileSync(join(build, 'release/raywalk'), ['render', `${process.env.RAYWALK_SOURCE_DIR}/scenes/${scene}.toml`,
      '-o', native, '--size', '121x91', '--precision', precision, '--quiet']);
    const ours = program.FS.readFile('/own.pfm'), theirs = readFileSync(native);
    assert.equal(ours.length, theirs.length);
    const differ = ours.reduce((count, byte, i) => count + (byte !== theirs[i] ? 1 : 0), 0);
    assert.equal(differ, 0, `${differ} of ${ours.length} bytes differ`);
  });
}

for (const scene of five) same_bits(scene, 'double');
