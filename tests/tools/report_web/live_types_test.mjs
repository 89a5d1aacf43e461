// node live_types_test.mjs EDVO ASSETS WORK, in a folder with web/ and its packages: what a run tells its
// page is of the declared form, src/live_data.ts, no key more and no key less.
import assert from 'node:assert/strict';
import { spawn, spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, rmSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import readline from 'node:readline';
import test from 'node:test';
import { skip } from './report_file.mjs';

const compiler = 'node_modules/typescript/bin/tsc';
if (!existsSync(compiler)) skip("npm's packages are not installed");
const [edvo, assets, work] = process.argv.slice(2);

/** Runs the program to its end and returns all that it tells its page, by the events' names. */
async function told(...words) {
  const child = spawn(edvo, [...words, '--live-keep', '--quiet'], { stdio: ['ignore', 'ignore', 'pipe'] });
  const lines = readline.createInterface({ input: child.stderr });
  const url = await new Promise((resolve) => lines.once('line', (line) => resolve(line.match(/http:\S+/)[0])));
  const stream = await fetch(url.replace('/?', '/events?'));
  lines.on('line', () => child.kill('SIGINT')); // it says that the run is over
  const text = await stream.text();
  const events = {};
  for (const [, name, data] of text.matchAll(/^event: (\w+)\ndata: (.*)\n\n/gm)) {
    (events[name] ??= []).push(JSON.parse(data));
  }
  return events;
}

rmSync(work, { recursive: true, force: true });
mkdirSync(work, { recursive: true });
const sequence = path.join(work, 'sequence');
const rendered = await told(
  'render', path.join(assets, 'room/room.gltf'), '--out', sequence, '--size', '160x120', '--path', 'orbit',
  '--orbit.centre', '-0.95,0.5,0.3', '--orbit.radius', '1.2', '--orbit.height', '0.8', '--duration', '0.6',
);
const tracked = await told('track', sequence, '--out', path.join(work, 'e.txt'));

test('events are of the declared form; a key more and a key less are not', () => {
  assert.ok(rendered.path[0].poses.length > 10);
  assert.equal(tracked.frame.length, rendered.path[0].poses.length);
  const shortened = (value) => JSON.stringify(value, (_, v) => (typeof v === 'string' ? v.slice(0, 100) : v));
  const wrong = '// @ts-expect-error'; // the compiler complains unless the next line is wrong
  const lines = ["import type { LiveEvents } from './live_data';"];
  const declare = (name, event, value) =>
    lines.push(`export const ${name}: LiveEvents['${event}'] = ${shortened(value)};`);
  for (const [run, events] of Object.entries({ rendered, tracked })) {
    for (const [event, all] of Object.entries(events)) declare(`${run}_${event}`, event, all.at(-1));
  }
  const { cost, ...less } = tracked.frame[1];
  lines.push(wrong);
  declare('frameLess', 'frame', less);
  lines.push(wrong);
  declare('frameMore', 'frame', { ...tracked.frame[1], surprise: 1 });
  writeFileSync('src/live_example.ts', `${lines.join('\n')}\n`);
  const result = spawnSync(process.execPath, [compiler, '-p', '.'], { encoding: 'utf8' });
  rmSync('src/live_example.ts');
  assert.equal(result.stdout, '');
});
