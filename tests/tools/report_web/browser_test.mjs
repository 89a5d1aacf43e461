// node browser_test.mjs REPORT.html [PICTURES], in a folder with the packages of web/: opens the
// report in Chromium and uses it with mouse and keyboard. Screenshots go to the folder PICTURES.
import assert from 'node:assert/strict';
import { statSync } from 'node:fs';
import path from 'node:path';
import test, { after, beforeEach } from 'node:test';
import { launch, openPage } from './browser.mjs';
import { readReport } from './report_file.mjs';

const { file, data } = readReport();
const pictures = process.argv[3];
const names = data.scenarios.map(({ name }) => name);
const browser = await launch();
after(() => browser.close());

let page;
let complaints; // what the page logged as an error or loaded from elsewhere

async function open({ hash = '', ...view } = {}) {
  const isOwn = (url) => /^(file|data|blob):/.test(url);
  ({ page, complaints } = await openPage(browser, `file://${path.resolve(file)}${hash}`, isOwn, view));
  await page.waitForSelector('h2');
}

const link = (name, frame = 0) => `#${new URLSearchParams({ scenario: name, frame })}`;
const slider = () => page.getByRole('slider', { name: 'Frame' });
const frame = async () => Number(await slider().inputValue());

beforeEach(async () => {
  await page?.context().close();
  page = undefined;
});

test('the report of 300 frames alone fits into 3 MB', () => {
  assert.equal(data.scenarios[0].frames.timestamp.length, 300);
  const bytes = statSync(file).size - JSON.stringify(data.scenarios.slice(1)).length;
  assert.ok(bytes < 3e6, `${bytes} bytes`);
});

test('the verdict table comes first and the first failed scenario is shown', async () => {
  await open();
  const rows = page.locator('.verdicts tbody tr');
  assert.equal(await rows.count(), names.length);
  const verdicts = await rows.locator('.badge').allTextContents();
  assert.deepEqual(
    verdicts.map((text) => text.includes('PASS')),
    data.scenarios.map(({ passed }) => passed),
  );
  const shown = names[data.scenarios.findIndex(({ passed }) => !passed)];
  assert.ok((await page.locator('h2').textContent()).startsWith(shown));
  assert.deepEqual(complaints, []);
});

test('metrics that are neither measured nor bounded are left out', async () => {
  const isOwn = ({ value, holds }) => value !== null || holds !== null;
  const { name, metrics } = data.scenarios.find((scenario) => !scenario.metrics.every(isOwn));
  await open({ hash: link(name) });
  assert.equal(await page.locator('.metrics tbody tr').count(), metrics.filter(isOwn).length);
});

test('arrow keys scrub, the space bar plays, a click on a scenario shows it', async () => {
  await open();
  await page.getByRole('button', { name: names[0], exact: true }).click();
  assert.ok((await page.locator('h2').textContent()).startsWith(names[0]));
  await page.locator('h2').click();
  await page.keyboard.press('ArrowRight');
  assert.equal(await frame(), 1);
  await page.keyboard.press('Shift+ArrowRight');
  assert.equal(await frame(), 11);
  await page.keyboard.press('ArrowLeft');
  assert.equal(await frame(), 10);
  await slider().focus();
  await page.keyboard.press('ArrowRight');
  assert.equal(await frame(), 11, 'the slider moves by one, not by two');
  await page.locator('h2').click();
  await page.keyboard.press('Space');
  await page.getByRole('button', { name: 'Pause' }).waitFor();
  await page.waitForFunction(() => document.querySelector('input[type=range]').valueAsNumber > 13);
  await page.keyboard.press('Space');
  await page.getByRole('button', { name: 'Play' }).waitFor();
  assert.deepEqual(complaints, []);
});

test('a click on a plot or on the path shows that frame, with its pictures', async () => {
  await open({ hash: link(names[0], 7) });
  assert.equal(await frame(), 7, 'the link is followed');
  const box = await page.locator('.u-over').first().boundingBox();
  await page.locator('.u-over').first().click({ position: { x: box.width / 2, y: box.height / 2 } });
  assert.ok(Math.abs((await frame()) - 149.5) < 2);
  const { pictures: all } = data.scenarios[0];
  const nearest = all.reduce((a, b) => (Math.abs(b.frame - 150) < Math.abs(a.frame - 150) ? b : a));
  const source = await page.locator('figure img').first().getAttribute('src');
  assert.equal(source, `data:image/webp;base64,${nearest.colour}`);
  const drawn = page.locator('figure img').first();
  assert.equal(await drawn.evaluate((image) => image.decode().then(() => image.naturalWidth)), 160);

  const end = await page.locator('.truth-path').evaluate((truth) => {
    truth.scrollIntoView({ block: 'center', behavior: 'instant' });
    const at = truth.getPointAtLength(0).matrixTransform(truth.getScreenCTM());
    return { x: at.x, y: at.y };
  });
  await page.mouse.click(end.x, end.y);
  const { truth } = data.scenarios[0].frames;
  const [x, , z] = truth[await frame()];
  assert.ok(Math.hypot(x - truth[0][0], z - truth[0][2]) < 0.005, 'm, on the floor');
  assert.deepEqual(complaints, []);
});

test('the scene is drawn in 3D and turned by keys', async () => {
  await open({ hash: link(names[0], 20) });
  const canvas = page.locator('.scene canvas');
  const look = async () => {
    await page.waitForTimeout(300);
    return (await canvas.screenshot()).toString('base64');
  };
  const withScene = await look();
  await canvas.focus();
  await page.keyboard.press('ArrowLeft');
  assert.equal(await frame(), 20, 'the view turns, time stays');
  assert.notEqual(await look(), withScene);
  await page.getByRole('button', { name: 'reset view' }).click();
  await page.getByRole('checkbox', { name: 'scene' }).uncheck();
  assert.ok((await look()).length < 0.7 * withScene.length, 'points take more bytes than none');
  await page.getByText('through camera').click();
  assert.deepEqual(complaints, []);
});

test('lost frames are named and can be jumped to', async () => {
  await open({ hash: link(names[1]) });
  await page.getByRole('button', { name: 'Next frame at which tracking is lost' }).click();
  assert.equal(await frame(), data.scenarios[1].frames.status.indexOf('lost'));
  assert.match(await page.locator('.readout .status').textContent(), /lost: /);
});

test('the path is shown as it is scored, and says so', async () => {
  await open({ hash: link(names[0]) });
  assert.ok(await page.getByRole('radio', { name: 'as scored: aligned by SE(3)' }).isChecked());
  assert.match(await page.locator('.top-view').textContent(), /world from above: [xyz] \u2192 [xyz] [\u2191\u2193]/);
  const path = () => page.locator('.estimate-path').getAttribute('d');
  const scored = await path();
  await page.getByText('as tracked: not aligned').click();
  assert.notEqual(await path(), scored);
});

test('uncertain frames are counted with their reason, and what moves is drawn over time', async () => {
  await open({ hash: link(names[0], 110) });
  const notes = await page.locator('.note').allTextContents();
  assert.ok(notes.includes('3 of 300 frames are uncertain: two motions 3.'));
  assert.match(await page.locator('.readout .status').textContent(), /uncertain: two motions/);
  assert.match(await page.locator('.facts').textContent(), /uncertain becausetwo motions/);
  await page.locator('.chart select').first().selectOption({ label: 'Moving by itself, % of the view' });
  assert.equal(await page.locator('.chart .now').first().textContent(), '25.0 % of the view');
});

test('monocular depth lies beside the truth, and times are marked as diagnostic', async () => {
  await open({ hash: link('monocular', 3) });
  const titles = await page.locator('figcaption b').allTextContents();
  assert.ok(titles.includes('Inverse depth, estimated') && titles.includes('Inverse depth, true'));
  assert.match(await page.locator('.diagnostic').textContent(), /differ from run to run/);
  await page.locator('.chart select').first().selectOption({ label: 'Alignment (time), ms' });
  assert.equal(await page.locator('.chart .now').first().textContent(), '8.00 ms');
});

test("another tracker's trajectory and a scenario without result are shown as far as they go", async () => {
  await open({ hash: link('another tracker', 2) });
  assert.equal(await frame(), 2);
  assert.equal(await page.locator('figure').count(), 0);
  await page.getByRole('button', { name: 'crashed' }).click();
  assert.match(await page.getByRole('alert').textContent(), /signal 11/);
  assert.deepEqual(complaints, []);
});

test('the theme follows the system until it is switched', async () => {
  await open({ colorScheme: 'dark' });
  const theme = () => page.evaluate(() => document.documentElement.dataset.theme);
  assert.equal(await theme(), 'dark');
  await page.getByRole('button', { name: /Switch to the light theme/ }).click();
  assert.equal(await theme(), 'light');
});

test('options can be filtered', async () => {
  await open({ hash: link(names[0]) });
  await page.locator('.options summary').click();
  const rows = page.locator('.options tbody tr');
  assert.equal(await rows.count(), 1, 'only what differs');
  await page.getByRole('checkbox', { name: /only what differs/ }).uncheck();
  assert.equal(await rows.count(), 2);
  await page.getByRole('searchbox').fill('pyramid');
  assert.equal(await rows.count(), 1);
});

test('everything is reached by the tab key and shows that it has the focus', async () => {
  await open({ hash: link(names[0]) });
  const reached = new Set();
  for (let i = 0; i < 45; ++i) {
    await page.keyboard.press('Tab');
    const focus = await page.evaluate(() => {
      const element = document.activeElement;
      const shown = element.matches('.choice input') ? element.nextElementSibling : element;
      const { outlineStyle, outlineWidth } = getComputedStyle(shown);
      const name = element.getAttribute('aria-label') ?? element.textContent.trim();
      return { tag: element.tagName, name, visible: outlineStyle !== 'none' && outlineWidth !== '0px' };
    });
    if (focus.tag === 'BODY') break;
    assert.ok(focus.visible, `${focus.tag} ${focus.name}`);
    reached.add(focus.tag);
  }
  for (const tag of ['BUTTON', 'CANVAS', 'SELECT', 'INPUT', 'SUMMARY']) assert.ok(reached.has(tag), tag);
});

for (const [device, width, height] of [['desktop', 1280, 900], ['phone', 390, 844]]) {
  for (const colorScheme of ['light', 'dark']) {
    test(`nothing is wider than a ${device}'s window, ${colorScheme}`, async () => {
      await open({ width, height, colorScheme, hash: link(names[0], 60) });
      await page.waitForTimeout(500);
      const [needed, offered] = await page.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
      assert.ok(needed <= offered, `${needed} px in ${offered} px`);
      if (pictures) await page.screenshot({ path: path.join(pictures, `${device}_${colorScheme}.png`) });
      assert.deepEqual(complaints, []);
    });
  }
}
