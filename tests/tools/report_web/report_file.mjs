import { readFileSync } from 'node:fs';

/** The text of the report that the command line names, and the data within it. */
export function readReport() {
  const file = process.argv[2];
  const html = readFileSync(file, 'utf8');
  const found = html.match(/id="edvo-data">([^]*?)<\/script>/);
  if (!found) skip('the program was built without the interactive report');
  return { file, html, data: JSON.parse(found[1]) };
}

/** Ends the test: something that it needs is absent. In CI that is a failure. */
export function skip(why) {
  console.log(`skipped: ${why}`);
  process.exit(process.env.CI ? 1 : 77);
}
