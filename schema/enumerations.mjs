// Enumerations in C++, and the words of their values in files and messages.
import { enumerations } from './read.mjs';
import { docComment, kWidth, lowerFirst, rowsOf, wrap } from './text.mjs';

const kFrom = 'Made by schema/generate.mjs from schema/enumerations.txt: change these, not this file.';

export function inCpp({ name, sentence, values, isCounted }) {
  const rows = values.map((value) => ({ code: `${value.name},`, about: value.sentence }));
  if (isCounted) rows.push({ code: 'Count,', about: 'Their number.' });
  return [...docComment(sentence), `enum class ${name} : std::uint8_t {`, ...rowsOf(rows), '};'].join('\n');
}

function words({ name, values }) {
  const list = wrap(values.map((value) => `"${lowerFirst(value.name)}"`).join(', '), kWidth - 4).map((line) => `    ${line}`);
  const line = `inline constexpr std::array k${name}Words{${list.map((text) => text.trim()).join(' ')}};`;
  if (line.length <= kWidth) return line;
  return `// clang-format off\ninline constexpr std::array k${name}Words{\n${list.join('\n')}};\n// clang-format on`;
}

const cppHeader = () => `// ${kFrom}
// The enumerations of definitions, orders, commands and events.
#pragma once

#include <cstddef>
#include <cstdint>

namespace muster {

${enumerations.map(inCpp).join('\n\n')}

/// The last value of an enumeration.
template <class Enum>
inline constexpr Enum kLastOf{};
${enumerations.map(({ name, values }) => `template <>\ninline constexpr ${name} kLastOf<${name}> = ${name}::${values.at(-1).name};`).join('\n')}
/// How many values an enumeration has.
template <class Enum>
inline constexpr std::size_t kCountOf = static_cast<std::size_t>(kLastOf<Enum>) + 1;

}  // namespace muster
`;

const wordHeader = () => `// ${kFrom}
// The words of enumerations in files and messages, in the order of their values.
#pragma once

#include <array>

namespace muster {

${enumerations.map(words).join('\n')}

}  // namespace muster
`;

export const enumerationFiles = () => ({
  'include/muster/generated/enumerations.h': cppHeader(),
  'src/base/generated/enumeration_words.h': wordHeader(),
});
