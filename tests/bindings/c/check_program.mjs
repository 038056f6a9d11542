// Writes a C99 program from docs/api/muster_api.json alone, which compiles only where the headers say the same: every function is
// assigned to a pointer of the described type, every struct is compared with one made from the description, every value with its
// number.
import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const root = join(dirname(fileURLToPath(import.meta.url)), '../../..');
const api = JSON.parse(readFileSync(process.argv[2] ?? join(root, 'docs/api/muster_api.json'), 'utf8'));

const typesOf = (parameters) => parameters.map(({ type }) => type).join(', ') || 'void';
const declare = ({ name, type, length, returns, parameters }) =>
  type === 'function' ? `${returns} (*${name})(${typesOf(parameters)})` : `${type} ${name}${length ? `[${length}]` : ''}`;

let checks = 0;
const lines = ['#include <muster/muster.h>', '#include <stddef.h>', ''];
/** A condition that the compiler checks. */
function check(condition) {
  lines.push(`typedef char check_${checks}[(${condition}) ? 1 : -1];`);
  checks += 1;
}

for (const { name, type, values } of api.integers) {
  lines.push(`static const ${type}* const is_${name} = (const ${name}*)0;`);
  for (const value of values ?? []) check(`${value.name} == ${value.value}`);
}
for (const { name, kind, fields } of api.structs) {
  lines.push(`${kind} Same${name} {`, ...fields.map((field) => `    ${declare(field)};`), '};');
  check(`sizeof(${name}) == sizeof(${kind} Same${name})`);
  fields.forEach((field) => {
    check(`offsetof(${name}, ${field.name}) == offsetof(${kind} Same${name}, ${field.name})`);
    if (field.length || field.type === 'function') return;
    lines.push(`static ${field.type}* ${name}_${field.name}(${name}* thing) { return &thing->${field.name}; }`);
  });
}
for (const { name, returns, parameters } of api.callbacks)
  lines.push(`static ${returns} (*const is_${name})(${typesOf(parameters)}) = (${name})0;`);
for (const { name, returns, parameters } of api.functions)
  lines.push(`static ${returns} (*const to_${name})(${typesOf(parameters)}) = ${name};`);

// The program uses all of these, so that no compiler calls one unused.
lines.push('', 'int main(void) {', '    int used = 0;');
for (const { name } of api.integers) lines.push(`    used += is_${name} == NULL;`);
for (const { name, fields } of api.structs)
  for (const field of fields)
    if (!field.length && field.type !== 'function') lines.push(`    used += ${name}_${field.name} != NULL;`);
for (const { name } of api.callbacks) lines.push(`    used += is_${name} == NULL;`);
for (const { name } of api.functions) lines.push(`    used += to_${name} != NULL;`);
lines.push('    return used > 0 ? 0 : 1;', '}', '');
process.stdout.write(lines.join('\n'));
