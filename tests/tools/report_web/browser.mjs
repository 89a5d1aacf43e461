// What the tests of pages share: Chromium by playwright-core, which is looked for in the folder that the test runs
// in, and a page that collects what is wrong with it. Without either the test is skipped with a message.
import { existsSync } from 'node:fs';
import { createRequire } from 'node:module';
import path from 'node:path';
import { skip } from './report_file.mjs';

const chromiumPath = ['/usr/bin/chromium', '/usr/bin/chromium-browser'].find(existsSync);
if (!chromiumPath) skip('Chromium is not installed');
if (!existsSync('node_modules/playwright-core')) skip("npm's packages are not installed");
const { chromium } = createRequire(path.join(process.cwd(), 'package.json'))('playwright-core');

export const launch = () =>
  chromium.launch({
    executablePath: chromiumPath,
    args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
  });

/**
 * Opens a URL. `complaints` gets what the page logs as an error, and each URL that it loads for which `isOwn` does
 * not hold.
 */
export async function openPage(browser, url, isOwn, { width = 1280, height = 900, colorScheme = 'light' } = {}) {
  const context = await browser.newContext({ viewport: { width, height }, colorScheme });
  const page = await context.newPage();
  const complaints = [];
  page.on('pageerror', (error) => complaints.push(String(error)));
  page.on('console', (message) => message.type() === 'error' && complaints.push(message.text()));
  page.on('request', (request) => isOwn(request.url()) || complaints.push(request.url()));
  await page.goto(url);
  return { page, complaints };
}
