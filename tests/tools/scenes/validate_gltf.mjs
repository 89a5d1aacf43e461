// node validate_gltf.mjs FILE...  Prints what Khronos' validator finds; exit code 1 on an error or a
// warning. The validator is looked up from the current folder; without it, exit code 77 (1 in CI).
import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import path from 'node:path';

const require = createRequire(path.join(process.cwd(), 'package.json'));
const { validateBytes } = loadValidator();

function loadValidator() {
  try {
    return require('gltf-validator');
  } catch {
    console.log('skipped: gltf-validator is not installed');
    process.exit(process.env.CI ? 1 : 77);
  }
}

const kSeverities = ['error', 'warning', 'info', 'hint'];

async function validate(file) {
  const folder = path.dirname(path.resolve(file));
  const report = await validateBytes(new Uint8Array(await readFile(file)), {
    uri: path.basename(file),
    maxIssues: 50,
    externalResourceFunction: async (uri) =>
      new Uint8Array(await readFile(path.join(folder, decodeURIComponent(uri)))),
  });
  for (const { severity, code, message, pointer } of report.issues.messages) {
    console.log(`${file}: ${kSeverities[severity]}: ${code} ${pointer ?? ''}: ${message}`);
  }
  const { numErrors, numWarnings, numInfos, numHints } = report.issues;
  console.log(
    `${file}: ${numErrors} errors, ${numWarnings} warnings, ${numInfos} infos, ${numHints} hints; ` +
      `${report.info.totalTriangleCount} triangles in the meshes`,
  );
  return numErrors + numWarnings === 0;
}

const files = process.argv.slice(2);
if (files.length === 0) {
  console.error('usage: node validate_gltf.mjs FILE...');
  process.exit(2);
}
const valid = await Promise.all(files.map(validate));
process.exit(valid.every(Boolean) ? 0 : 1);
