// Writes a C99 program from docs/api/muster_api.json that calls every function with nothing: null pointers, handles that are none
// or made up, zeroed structs, numbers at their ends. It must come to its end, and no function of a handle may succeed.
import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const root = join(dirname(fileURLToPath(import.meta.url)), '../../..');
const api = JSON.parse(readFileSync(join(root, 'docs/api/muster_api.json'), 'utf8'));
const structs = new Map(api.structs.map((struct) => [struct.name, struct]));

/** What is given for a parameter in a round: nothing at all; made-up handles and zeroed structs behind pointers; numbers at an end. */
function argument({ type, out }, round, name) {
  const pointed = type.replace(/^const /, '').replace(/\*$/, '');
  const struct = structs.get(type) ?? structs.get(pointed);
  if (type.endsWith('*')) {
    if (round === 0 || (!struct && !out) || pointed.endsWith('const') || pointed.endsWith('*')) return `(${type})0`;
    return struct ? `(memset(&${name}_${pointed}, 0, sizeof(${pointed})), &${name}_${pointed})` : `(${type})&room`;
  }
  if (struct?.handle) return round === 0 ? 'none_' + type : 'wrong_' + type;
  if (struct) return 'none_' + type;
  if (api.callbacks.some((callback) => callback.name === type)) return `(${type})0`;
  if (type === 'double' || type === 'float') return round === 2 ? '1e300' : '0';
  return round === 2 ? `(${type})-1` : '0';
}

/** Functions that may succeed with nothing, as their comments say. */
const kFine = new Set(['muster_set_allocator', 'muster_scenario_schema', 'muster_gestures_schema', 'muster_parameter_info',
  'muster_clips_own', 'muster_clips_create', 'muster_gestures_text', 'muster_timed_path_at', 'muster_joint_transforms',
  'muster_blend_poses']);

const lines = ['#include <muster/muster.h>', '#include <stdio.h>', '#include <string.h>', '', 'static double room[64];'];
for (const { name, handle } of api.structs) {
  lines.push(`static ${name} none_${name}, given_${name};`);
  if (handle) lines.push(`static const ${name} wrong_${name} = {3, 12345};`);
}
lines.push('', 'int main(void) {', '    int failed = 0;');
let calls = 0;
for (let round = 0; round < 3; ++round)
  for (const { name, returns, parameters } of api.functions) {
    const given = parameters.map((parameter) => argument(parameter, round === 2 && /size|Count|count/.test(parameter.name) ? 1 : round, 'given'));
    const called = `${name}(${given.join(', ')})`;
    calls += 1;
    if (returns === 'MusterStatus' && !kFine.has(name))
      lines.push(`    if (${called} == MUSTER_OK) printf("%s succeeds with nothing, round ${round}\\n", "${name}"), ++failed;`);
    else lines.push(`    (void)${called};`);
  }
lines.push(`    printf("${calls} calls with nothing, %d that should have failed\\n", failed);`, '    (void)room;');
for (const { name } of api.structs) lines.push(`    (void)none_${name}, (void)given_${name};`);
lines.push('    return failed == 0 ? 0 : 1;', '}', '');
process.stdout.write(lines.join('\n'));
