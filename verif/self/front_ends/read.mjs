// SPDX-License-Identifier: Apache-2.0
// read.mjs YOSYS TOP FILE...: elaborates TOP by slang, which is built into YOSYS, the folder of @yowasp/yosys.
//
// Prints slang's log. Exit code 1 when it finds an error.
import fs from 'node:fs';
import path from 'node:path';

const [yosys, top, ...names] = process.argv.slice(2);
const { runYosys } = await import(path.resolve(yosys, 'gen/bundle.js'));
const files = Object.fromEntries(names.map((name) => [path.basename(name), fs.readFileSync(name, 'utf8')]));
// WebAssembly has one thread. How far loops are unrolled (4000 by itself) is a limit of this program alone.
const script = `read_slang --threads 1 --unroll-limit 100000 --top ${top} ${Object.keys(files).join(' ')}`;
const print = (bytes) => { if (bytes) process.stdout.write(bytes); };
try {
  await runYosys(['-p', script], files, { stdout: print, stderr: print });
} catch (error) {
  console.log(String(error));
  process.exitCode = 1;
}
