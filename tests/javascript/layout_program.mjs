// Writes a C99 program from a description of the C API, which compiles for WebAssembly only where its compiler places all fields of
// structs as the binding does. Usage: layout_program.mjs DESCRIPTION
import { readFileSync } from 'node:fs';
import { Types } from '../../schema/javascript/wasm_layout.mjs';

function layoutProgram(api) {
  const types = new Types(api);
  const lines = ['#include <muster/muster.h>', '#include <stddef.h>', ''];
  let checks = 0;
  const check = (condition) => lines.push(`typedef char check_${checks++}[(${condition}) ? 1 : -1];`);
  for (const { name, fields } of api.structs) {
    const { size, align, offsets } = types.place(name);
    check(`sizeof(${name}) == ${size}`);
    check(`_Alignof(${name}) == ${align}`);
    fields.forEach((field, k) => check(`offsetof(${name}, ${field.name}) == ${offsets[k]}`));
  }
  lines.push(`/* ${checks} checks */`, '');
  return lines.join('\n');
}

process.stdout.write(layoutProgram(JSON.parse(readFileSync(process.argv[2], 'utf8'))));
