// SPDX-License-Identifier: Apache-2.0
// bundle.mjs: `node bundle.mjs OUT`: the templates, OUT/*.html, with style, script and libraries in them, and
// OUT/svg.mjs, which draws charts without a page.
//
// All are page.html, which has three places: <!--style-->, <!--script--> and, left for the program, <!--data-->. The
// libraries lie in OUT/node_modules; what of them is not called is left out.
import {createRequire} from 'node:module';
import fs from 'node:fs';
import path from 'node:path';
import {fileURLToPath} from 'node:url';
import zlib from 'node:zlib';

const room = path.dirname(fileURLToPath(import.meta.url)), out = path.resolve(process.argv[2]);
const esbuild = createRequire(path.join(out, 'package.json'))('esbuild');

async function script(entry, form = {format: 'iife', target: 'chrome110'}) {
  const built = await esbuild.build({
    entryPoints: [path.join(room, entry)],
    bundle: true,
    minify: true,
    write: false,
    ...form,
    charset: 'utf8',
    legalComments: 'inline',
    nodePaths: [path.join(out, 'node_modules')],
    logLevel: 'warning',
  });
  return built.outputFiles[0].text;
}

function write(name, text) {
  const file = path.join(out, name);
  fs.writeFileSync(file + '.new', text);
  fs.renameSync(file + '.new', file);
}

// A large program lies in the page deflated, a third of its bytes, and these lines start it.
function packed(code) {
  const start = `(async () => {
    const letters = atob(document.getElementById('program').textContent);
    const coded = Uint8Array.from(letters, (c) => c.charCodeAt(0));
    const code = new Blob([coded]).stream().pipeThrough(new DecompressionStream('deflate'));
    const script = document.createElement('script');
    script.src = URL.createObjectURL(new Blob([await new Response(code).blob()], {type: 'text/javascript'}));
    document.body.append(script);
  })();`;
  const program = zlib.deflateSync(code, {level: 9}).toString('base64');
  return `<script type="text/plain" id="program">${program}</script>\n<script>\n${start}\n</script>`;
}

async function template(name, entry, ...styles) {
  const read = (file) => fs.readFileSync(path.join(room, file), 'utf8');
  const html = read('page.html'), style = ['page.css', ...styles].map(read).join('\n');
  const code = (await script(entry)).replaceAll('</script', '<\\/script');
  write(name, html.replace('<!--style-->', () => `<style>\n${style}</style>`)
                    .replace('<!--script-->', () => code.length > 2e6 ? packed(code) : `<script>\n${code}</script>`));
}

await template('page.html', 'page.mjs', 'frame/frame.css');
await template('viewer.html', 'viewer/viewer.mjs', 'viewer/viewer.css');
write('svg.mjs', await script('svg.mjs', {format: 'esm', platform: 'node', target: 'node18'}));
