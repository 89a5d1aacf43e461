// node bundle.mjs OUTPUT.cpp: bundles src/main.ts and embeds script and style as C++ strings.
import { build } from 'esbuild';
import { writeFile } from 'node:fs/promises';

const result = await build({
  entryPoints: ['src/main.ts'],
  bundle: true,
  charset: 'ascii',
  format: 'iife',
  legalComments: 'none',
  minify: true,
  outdir: 'out',
  target: ['chrome100', 'firefox100', 'safari15.4'],
  write: false,
});

/** Raw string literals of a length that every compiler takes; adjacent ones are one string. */
function literal(text) {
  const pieces = text.match(/[^]{1,8000}/g) ?? [''];
  if (text.includes(')~~"')) throw new Error('the bundle holds the end of a raw string literal');
  return pieces.map((piece) => `R"~~(${piece})~~"`).join('\n');
}

function output(extension) {
  return result.outputFiles.find((file) => file.path.endsWith(extension)).text.trim();
}

await writeFile(
  process.argv[2],
  `#include "tools/report/report_bundle.h"

tools::ReportBundle tools::report_bundle() {
  return {.script = ${literal(output('.js'))},
.style = ${literal(output('.css'))},
.missing = ""};
}
`,
);
