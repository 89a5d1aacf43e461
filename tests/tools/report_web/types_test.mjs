// node types_test.mjs REPORT.html, in a folder with web/ and its packages: what the program wrote is
// of the declared form, src/data.ts, no key more and no key less, and the sources have no type error.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, writeFileSync } from 'node:fs';
import test from 'node:test';
import { readReport, skip } from './report_file.mjs';

const compiler = 'node_modules/typescript/bin/tsc';
if (!existsSync(compiler)) skip("npm's packages are not installed");
const { data } = readReport();

/** A constant of the declared type; long texts do not matter to it. */
function declaration(name, value) {
  const text = JSON.stringify(value, (_, v) => (typeof v === 'string' ? v.slice(0, 100) : v));
  return `export const ${name}: ReportData = ${text};`;
}

test('the data is of the declared form; a key more, a key less, another version are not', () => {
  const { stride, ...less } = data.scenarios.at(-1);
  const more = { ...data.scenarios.at(-1), surprise: 1 };
  const wrong = '// @ts-expect-error'; // the compiler complains unless the next line is wrong
  const lines = [
    "import type { ReportData } from './data';",
    declaration('example', data),
    wrong,
    declaration('keyMore', { ...data, scenarios: [more] }),
    wrong,
    declaration('keyLess', { ...data, scenarios: [less] }),
    wrong,
    declaration('nextVersion', { ...data, version: data.version + 1, scenarios: [] }),
  ];
  writeFileSync('src/example.ts', `${lines.join('\n')}\n`);
  const result = spawnSync(process.execPath, [compiler, '-p', '.'], { encoding: 'utf8' });
  assert.equal(result.stdout, '');
});
