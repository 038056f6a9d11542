// Compiles each header by itself, with the flags of a source file near it: a header includes all that it uses.
// Usage: lonely_headers.mjs BUILD LIST: a build with compile_commands.json, and a file that names headers, one a line.
import { spawn } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { cpus } from 'node:os';
import { dirname, relative, resolve } from 'node:path';

const [build, list] = process.argv.slice(2);
const headers = readFileSync(list, 'utf8').split('\n').filter(Boolean);
const entries = JSON.parse(readFileSync(resolve(build, 'compile_commands.json'), 'utf8'))
  .map(({ directory, command, file }) => ({ directory, command, file: relative('.', file) }));

/** Of an installed header those of a module that sees all of its kind; else those of the nearest folder with a source file. */
function flagsOf(header) {
  const isC = header === 'include/muster/muster.h';
  const own = isC ? 'bindings/c/c_io' : header.startsWith('include/') ? 'apps/muster' : dirname(header);
  for (let folder = own; folder !== '.'; folder = dirname(folder)) {
    const near = entries.find(({ file }) => dirname(file) === folder) ?? entries.find(({ file }) => file.startsWith(`${folder}/`));
    if (near) return near;
  }
  return entries[0];
}

/** The compiler's words up to its outputs, without ccache in front of it and without precompiled headers. */
function compile(header) {
  const { directory, command } = flagsOf(header);
  const all = command.split(/\s+/).map((word) => word.replaceAll('\\"', '"'));
  const words = all.slice(all.findIndex((word) => /\/ccache$/.test(word)) + 1, all.indexOf('-o'));
  const flags = words.filter((word, i) => !/cmake_pch/.test(word) && !(word === '-include' && /cmake_pch/.test(words[i + 1])) && word !== '-Winvalid-pch');
  return new Promise((done) => {
    const child = spawn(flags[0], [...flags.slice(1), '-fsyntax-only', '-O0', '-include', resolve(header), '-x', 'c++', '/dev/null'], { cwd: directory });
    let text = '';
    child.stderr.on('data', (chunk) => (text += chunk));
    child.on('exit', (code) => done({ header, code, text }));
  });
}

let failed = 0;
const queue = [...headers];
await Promise.all(cpus().map(async () => {
  for (let header = queue.shift(); header; header = queue.shift()) {
    const { code, text } = await compile(header);
    if (code === 0) continue;
    failed += 1;
    console.log(`${header}:\n${text.split('\n').slice(0, 6).join('\n')}`);
  }
}));
process.exit(failed === 0 ? 0 : 1);
