// SPDX-License-Identifier: Apache-2.0
// bundle.mjs: `node bundle.mjs OUT`: the templates, OUT/*.html, with style, script and libraries in them.
//
// A template has three places: <!--style-->, <!--script--> and, left for the program, <!--data-->. The libraries lie in
// OUT/node_modules; what of them is not called is left out.
import {createRequire} from 'node:module';
import fs from 'node:fs';
import path from 'node:path';
import {fileURLToPath} from 'node:url';

const room = path.dirname(fileURLToPath(import.meta.url)), out = path.resolve(process.argv[2]);
const esbuild = createRequire(path.join(out, 'package.json'))('esbuild');

async function script(entry) {
  const built = await esbuild.build({
    entryPoints: [path.join(room, entry)],
    bundle: true,
    minify: true,
    write: false,
    format: 'iife',
    target: 'chrome110',
    charset: 'utf8',
    legalComments: 'inline',
    nodePaths: [path.join(out, 'node_modules')],
    logLevel: 'warning',
  });
  return built.outputFiles[0].text.replaceAll('</script', '<\\/script');
}

async function template(name, entry, styles) {
  const read = (file) => fs.readFileSync(path.join(room, file), 'utf8');
  const html = read(name), style = styles.map(read).join(''), code = await script(entry);
  const whole = html.replace('<!--style-->', () => `<style>\n${style}</style>`)
                    .replace('<!--script-->', () => `<script>\n${code}</script>`);
  const file = path.join(out, path.basename(name));
  fs.writeFileSync(file + '.new', whole);
  fs.renameSync(file + '.new', file);
}

await template('page.html', 'page.mjs', ['page.css', 'frame/frame.css']);
