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

/** Runs the program to its end, with a page that is kept, and returns all that it tells. */
const told = (...words) => toldBy(...words, '--live-keep', '--quiet');

/** Runs the program until it says a second time where its page is, or has told all, and returns what it tells its page,
 * by the events' names. */
async function toldBy(...words) {
  const child = spawn(edvo, words, { stdio: ['ignore', 'ignore', 'pipe'] });
  const lines = readline.createInterface({ input: child.stderr });
  const url = await new Promise((resolve) => lines.once('line', (line) => resolve(line.match(/http:\S+/)[0])));
  const stream = await fetch(url.replace('/?', '/events?'));
  lines.on('line', () => child.kill('SIGINT')); // it says that the run is over
  const text = words[0] === 'view' ? await untilEnd(stream) : await stream.text();
  child.kill('SIGINT');
  const events = {};
  for (const [, name, data] of text.matchAll(/^event: (\w+)\ndata: (.*)\n\n/gm)) {
    (events[name] ??= []).push(JSON.parse(data));
  }
  return events;
}

/** The text of a stream that stays open, up to the event `end`. */
async function untilEnd(stream) {
  const decoder = new TextDecoder();
  let text = '';
  for await (const piece of stream.body) {
    text += decoder.decode(piece, { stream: true });
    if (/^event: end\ndata: .*\n\n/m.test(text)) break;
  }
  return text;
}

rmSync(work, { recursive: true, force: true });
mkdirSync(work, { recursive: true });
const sequence = path.join(work, 'sequence');
const rendered = await told(
  'render', path.join(assets, 'room/room.gltf'), '--out', sequence, '--size', '160x120', '--path', 'orbit',
  '--orbit.centre', '-0.95,0.5,0.3', '--orbit.radius', '1.2', '--orbit.height', '0.8', '--duration', '0.6',
);
const beside = (name) => path.join(work, name);
const tracked = await told('track', sequence, '--out', beside('e.txt'), '--frame-log', beside('e.csv'),
  '--time-log', beside('e_times.csv'), '--debug-images', '3');
const viewed = await toldBy('view', beside('e.txt'));

test('events are of the declared form; a key more and a key less are not', () => {
  assert.ok(rendered.path[0].poses.length > 10);
  assert.equal(tracked.frame.length, rendered.path[0].poses.length);
  const exact = ({ frame, status, points, times_ms, position_covariance }) => ({ frame, status, points, times_ms, position_covariance });
  assert.deepEqual(viewed.frame.map(exact), tracked.frame.map(exact));
  assert.equal(viewed.pictures.length, Math.ceil(viewed.frame.length / 3));
  const shortened = (value) => JSON.stringify(value, (_, v) => (typeof v === 'string' ? v.slice(0, 100) : v));
  const wrong = '// @ts-expect-error'; // the compiler complains unless the next line is wrong
  const lines = ["import type { LiveEvents } from './live_data';"];
  const declare = (name, event, value) =>
    lines.push(`export const ${name}: LiveEvents['${event}'] = ${shortened(value)};`);
  for (const [run, events] of Object.entries({ rendered, tracked, viewed })) {
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
