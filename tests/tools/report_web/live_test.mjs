// node live_test.mjs EDVO ASSETS WORK [PICTURES], in a folder with the packages of web/: renders a short
// sequence, tracks it with --live and uses the page in Chromium. Screenshots go to the folder PICTURES.
import assert from 'node:assert/strict';
import { spawn, spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import readline from 'node:readline';
import test, { after, afterEach, before } from 'node:test';
import { launch, openPage } from './browser.mjs';

const [edvo, assets, work, pictures] = process.argv.slice(2);
const kFrames = 25;
const sequence = path.join(work, 'sequence');
const scenario = path.join(work, 'scenarios/small.toml');
const kScenario = `why = "it is broken"
[scene]
gltf = "room/room.gltf"
[camera]
width = 160
height = 120
[path]
kind = "orbit"
rate = 30.0
duration = 0.3
orbit.centre = [-0.95, 0.5, 0.3]
orbit.radius = 1.2
orbit.height = 0.8
[render]
samples = 1
[expect]
tracked_fraction = { min = 1.0 }
`;
let browser;
let page;
let run; // the program that is watched
let complaints; // what the page logged as an error or loaded from elsewhere

before(async () => {
  rmSync(work, { recursive: true, force: true });
  mkdirSync(work, { recursive: true });
  const rendered = spawnSync(edvo, [
    'render', path.join(assets, 'room/room.gltf'), '--out', sequence, '--size', '320x240', '--path', 'orbit',
    '--orbit.centre', '-0.95,0.5,0.3', '--orbit.radius', '1.2', '--orbit.height', '0.8', '--duration', '0.8',
    '--rate', '30', '--samples', '1', '--quiet',
  ], { encoding: 'utf8' });
  assert.equal(rendered.status, 0, rendered.stderr);
  symlinkSync(path.resolve(assets), path.join(work, 'assets'));
  mkdirSync(path.join(work, 'scenarios'));
  writeFileSync(scenario, kScenario);
  browser = await launch();
});
after(() => browser?.close());
afterEach(async () => {
  await page?.context().close();
  page = undefined;
  run?.child.kill('SIGKILL');
  run = undefined;
});

/** Starts the program and waits until it says where its page is. */
async function start(...words) {
  const child = spawn(edvo, words, { stdio: ['ignore', 'pipe', 'pipe'] });
  const ended = new Promise((resolve) => child.on('exit', (code, signal) => resolve(code ?? signal)));
  const lines = readline.createInterface({ input: child.stderr });
  const url = await new Promise((resolve, reject) => {
    let said = '';
    lines.on('line', (line) => {
      said += `${line}\n`;
      const found = line.match(/http:\S+/);
      if (found) resolve(found[0]);
    });
    ended.then((code) => reject(new Error(`ended with ${code}: ${said}`)));
  });
  return { child, url, ended };
}

async function open(url, view) {
  const isOwn = (other) => other.startsWith(new URL(url).origin) || /^(data|blob):/.test(other);
  ({ page, complaints } = await openPage(browser, url, isOwn, view));
}

/** Lets some frames pass, as a viewer's script would. */
async function steps(count) {
  const url = new URL(run.url);
  await badge('paused').waitFor();
  for (let i = 0; i < count; ++i) await fetch(`${url.origin}/step${url.search}`, { method: 'POST' });
}

const slider = () => page.getByRole('slider', { name: 'Frame' });
const frame = async () => Number(await slider().inputValue());
const badge = (text) => page.locator('.page-head .badge', { hasText: text });
const estimate = (name) => path.join(work, name);
const track = (name, ...words) => start('track', sequence, '--out', estimate(name), '--quiet', '--force', ...words);

test('the page shows every frame, its pictures, path and times, and stays until Ctrl-C', async () => {
  run = await track('kept.txt', '--live', '--live-keep');
  await open(run.url);
  await badge('done').waitFor();
  assert.equal(await slider().getAttribute('max'), String(kFrames - 1));
  assert.match(await page.locator('.live-message').textContent(), /25 of 25 frames tracked/);
  assert.match(await page.locator('.stage-times').textContent(), /pyramid.*edges.*alignment.*total/);
  assert.equal(await page.locator('.chart').count(), 2);
  assert.match(await page.locator('.trajectories h3').textContent(), /ellipsoids: 3 \u03C3/);
  await page.keyboard.press('ArrowLeft');
  assert.equal(await frame(), kFrames - 2);
  assert.deepEqual(complaints, []);
  run.child.kill('SIGINT');
  assert.equal(await run.ended, 0, 'the code of the run, which was over');
});

test('a track that is done is shown with its pictures and times, and can be scrubbed', async () => {
  const done = spawnSync(edvo, ['track', sequence, '--out', estimate('done.txt'), '--quiet', '--force',
    '--frame-log', estimate('done.csv'), '--time-log', estimate('done_times.csv'), '--debug-images', '6']);
  assert.equal(done.status, 0);
  run = await start('view', estimate('done.txt'));
  await open(run.url);
  await badge('done').waitFor();
  assert.equal(await slider().getAttribute('max'), String(kFrames - 1));
  assert.match(await page.locator('.stage-times').textContent(), /pyramid.*edges.*alignment.*total/);
  await page.waitForSelector('.live figure img[src]');
  await page.keyboard.press('ArrowLeft');
  assert.equal(await frame(), kFrames - 2);
  assert.match(await page.locator('.pictures .which').textContent(), /frame 24/);
  assert.deepEqual(complaints, []);
  run.child.kill('SIGINT');
  assert.equal(await run.ended, 130);
});

test('a viewer pauses, steps and lets go on, and the trajectory is the same', async () => {
  spawnSync(edvo, ['track', sequence, '--out', estimate('alone.txt'), '--quiet', '--force']);
  run = await track('paused.txt', '--live-paused');
  await open(run.url);
  await badge('paused').waitFor();
  await page.getByRole('button', { name: 'Step' }).click();
  await page.waitForSelector('.live figure img[src]');
  const before = Number(await slider().getAttribute('max'));
  await page.getByRole('button', { name: 'Step' }).click();
  await page.waitForFunction((n) => Number(document.querySelector('input[type=range]').max) === n, before + 1);
  await page.waitForFunction((n) => document.querySelector('.pictures .which').textContent === `frame ${n}`, before + 1);
  await page.locator('h1').click();
  await page.keyboard.press('Space');
  await badge('done').waitFor();
  assert.equal(await run.ended, 0);
  assert.equal(await frame(), kFrames - 1, 'the page follows the run, and stays when it has ended');
  assert.equal(readFileSync(estimate('paused.txt'), 'utf8'), readFileSync(estimate('alone.txt'), 'utf8'));
});

test('a run that loses its viewer goes on', async () => {
  run = await track('left.txt', '--live-paused');
  await open(run.url);
  await badge('paused').waitFor();
  await page.context().close();
  page = undefined;
  assert.equal(await run.ended, 0);
});

test('Ctrl-C ends a run that is paused, as one that is not', async () => {
  run = await track('ended.txt', '--live-paused');
  run.child.kill('SIGINT');
  assert.equal(await run.ended, 130);
  assert.ok(!existsSync(estimate('ended.txt')));
});

test('a monocular run shows the inverse depths of its map', async () => {
  run = await track('mono.txt', '--mode', 'mono', '--bootstrap', 'rgbd', '--live-paused', '--live-keep');
  await open(run.url);
  await steps(6);
  await page.getByText('Inverse depth, estimated').waitFor();
  await page.locator('.stage-times', { hasText: 'mapping' }).waitFor();
  assert.deepEqual(complaints, []);
});

test('a rendering shows its path beforehand and the frames as they are done', async () => {
  run = await start('render', path.join(assets, 'room/room.gltf'), '--out', path.join(work, 'rendered'), '--size', '160x120',
    '--path', 'orbit', '--orbit.centre', '-0.95,0.5,0.3', '--orbit.radius', '1.2', '--duration', '0.6', '--threads', '1',
    '--quiet', '--live-paused', '--live-keep');
  await open(run.url);
  await steps(3);
  await page.getByText('Colour').waitFor();
  await page.waitForSelector('.live figure img[src]');
  assert.equal(await slider().getAttribute('max'), String(18));
  assert.equal(await page.locator('.chart').count(), 0);
  if (pictures) await page.screenshot({ path: path.join(pictures, 'live_render.png') });
  await page.getByRole('button', { name: 'Go on' }).click();
  await badge('done').waitFor();
  assert.match(await page.locator('.live-message').textContent(), /19 frames/);
  assert.deepEqual(complaints, []);
});

test('a run shows its tracking beside the truth, and its report can be viewed', async () => {
  const out = path.join(work, 'run');
  run = await start('run', scenario, '--out', out, '--quiet', '--live-keep');
  await open(run.url);
  await badge('done').waitFor();
  assert.match(await page.locator('.live-message').textContent(), /all bounds hold/);
  assert.match(await page.locator('.facts').textContent(), /Position error/);
  assert.deepEqual(complaints, []);
  run.child.kill('SIGINT');
  assert.equal(await run.ended, 0);
  await page.context().close();
  run = await start('view', out);
  await open(run.url);
  await page.waitForSelector('h2');
  assert.match(await page.locator('h2').textContent(), /small/);
  assert.deepEqual(complaints, []);
  run.child.kill('SIGINT');
  assert.equal(await run.ended, 130);
});

test('a test shows the verdict of each scenario', async () => {
  run = await start('test', scenario, '--seeds', '2', '--cache', path.join(work, 'cache'), '--quiet', '--live-keep');
  await open(run.url);
  await badge('done').waitFor();
  const trials = await page.locator('.trials p').allTextContents();
  assert.equal(trials.length, 2);
  for (const trial of trials) assert.match(trial, /passed small.*ATE [\d.]+ mm, 100 % tracked/);
  assert.match(await page.locator('.live-message').textContent(), /1 of 1 scenarios passed/);
  assert.deepEqual(complaints, []);
  run.child.kill('SIGINT');
  assert.equal(await run.ended, 0);
});

for (const [device, width, height] of [['desktop', 1280, 900], ['phone', 390, 844]]) {
  for (const colorScheme of ['light', 'dark']) {
    test(`nothing is wider than a ${device}'s window, ${colorScheme}`, async () => {
      run = await track(`${device}.txt`, '--live-paused');
      await open(run.url, { width, height, colorScheme });
      await steps(12);
      await page.waitForSelector('.live figure img[src]');
      await page.waitForSelector('.chart');
      await page.waitForTimeout(500);
      const [needed, offered] = await page.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
      assert.ok(needed <= offered, `${needed} px in ${offered} px`);
      if (pictures) await page.screenshot({ path: path.join(pictures, `live_${device}_${colorScheme}.png`), fullPage: true });
      assert.deepEqual(complaints, []);
    });
  }
}
