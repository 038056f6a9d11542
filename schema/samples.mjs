// Random commands of every kind, for tests of all that carries commands.
import { commands, isEnumeration } from './read.mjs';
import { kBanner } from './cpp.mjs';
import { isId, plain } from './types.mjs';

/** An expression that draws one value of a type. */
function item({ type, range, name }) {
  if (isId(type)) return `${type}{draw.number()}`;
  if (isEnumeration(type)) return `draw.value<${type}>()`;
  if (type === 'Vec2') return 'draw.place()';
  if (type === 'text') return 'draw.text()';
  if (type === 'bool') return 'draw.flag()';
  if (type === 'Colour') return 'draw.number() & 0xffffffu';
  if (type === 'f64') return `draw.real(${range?.low ?? '0'}, ${range?.high ?? '1'})`;
  if (type === 'i32') return `draw.whole(${range.low}, ${range.high})`;
  if (plain(type)) return name === 'unused' ? 'std::uint8_t{0}' : 'draw.number()';
  return `random${type}(draw)`;
}

function statement(field) {
  const { name, type, isList, isOptional } = field;
  if (isList && isOptional) return `            if (draw.flag()) draw.list(c.${name}.emplace(), [&] { return ${item(field)}; });`;
  if (isList && type === 'CharacterId') return `            c.${name} = draw.ids();`;
  if (isList) return `            draw.list(c.${name}, [&] { return ${item(field)}; });`;
  if (isOptional) return `            if (draw.flag()) c.${name} = ${item(field)};`;
  return `            c.${name} = ${item(field)};`;
}

const kind = (command) => `        case ${command.index}: {
            ${command.name} c;
${command.fields.map(statement).join('\n')}
            draw.relate(c);
            return c;
        }`;

export const sampleFiles = () => ({
  'tests/generated/random_commands.h': `${kBanner}// Random commands of every kind.
#pragma once

#include "command_draw.h"
#include "generated/random_definitions.h"

namespace muster {

/// A valid command of that kind, an index into CommandKinds.
inline CommandBody randomCommand(std::size_t kind, CommandDraw& draw) {
    switch (kind) {
${commands.map(kind).join('\n')}
        default:
            return Touch{};
    }
}

}  // namespace muster
`,
});
