// The fields of commands in files of gestures and in messages of pages.
import { commands, definitionOf, formerCommands, isEnumeration } from './read.mjs';
import { call, kWidth, limit, listed, quoted, real } from './text.mjs';
import { kBanner } from './cpp.mjs';
import { isId, mayBeNone } from './types.mjs';

/** A call, broken where it is too long for its line. */
export function line(head, words, close = ');', indent = '        ') {
  return call(head, words, close, indent).flatMap((text) => (text.length <= kWidth ? [text] : breakText(text)));
}

/** A text that is too long goes on in a second literal. */
function breakText(text) {
  const at = text.lastIndexOf(' ', kWidth - 2);
  const indent = ' '.repeat(text.search(/\S/));
  return [`${text.slice(0, at + 1)}"`, `${indent}"${text.slice(at + 1)}`];
}

function rangeOf(field) {
  const { type, range } = field;
  if (type === 'CharacterId' || type === 'u32' || isId(type) || type === 'OrderId') return 'kId';
  if (field.unit === 'rad') return 'kAngle';
  if (range === null) throw new Error(`schema/commands.txt: ${field.name} needs a range, as files tell it`);
  return `{${real(range.low)}, ${real(range.high)}}`;
}

/** The lines that describe one field. One that may be none is there where files have its key. */
function describe(field) {
  if (!mayBeNone(field) || isEnumeration(field.type) || field.type === 'Colour') return describeValue(field, `c.${field.name}`);
  const named = definitionOf(field.type)?.inCommands;
  if (named?.visit === 'object' && !field.isList) {
    const inner = named.describe.replace('#', 'def');
    return line('maybe(', [`"${field.name}"`, `c.${field.name}`, quoted(field.inFiles || field.sentence), `[](auto& inner, auto& def) { ${inner}; }`]);
  }
  const inner = describeValue({ ...field, isOptional: false, flags: new Set([...field.flags, 'given']) }, 'value');
  const head = `        given("${field.name}", c.${field.name}, [&](auto& value, Need need) {`;
  const short = `${head} ${inner[0].trim()} });`;
  if (inner.length === 1 && short.length <= kWidth) return [short];
  return [head, ...inner.map((text) => `    ${text}`), '        });'];
}

function describeValue(field, value) {
  const { name, type } = field;
  const about = quoted(field.inFiles || field.sentence);
  const named = definitionOf(type)?.inCommands;
  const isNeeded = field.flags.has('required') || (field.initial === '' && !field.isOptional && !field.flags.has('omit'));
  const given = field.flags.has('given');
  const need = given ? ['need'] : isNeeded ? ['Need::Required'] : [];
  if (field.flags.has('internal')) return [];
  if (name === 'time' && type === 'f64') return ['        c.time = time;'];
  if (given && !field.isList && named?.visit === 'objectOrKind') return line('describeShape(', ['v', `"${name}"`, value, about, 'need']);
  if (named?.among) return [`        ${named.among.replace('#', value).replace('&', given ? 'need' : field.flags.has('required') ? 'Need::Required' : 'Need::Optional')};`];
  if (named) {
    const inner = `            "${named.key}", "", [&](auto& inner) { ${named.describe.replace('#', value)}; },`;
    const ends = inner.length + ' Need::Required);'.length <= kWidth ? [`${inner} Need::Required);`] : [inner, '            Need::Required);'];
    return [`        v.${named.visit}(`, ...ends];
  }
  if (field.isList) {
    if (type === 'Vec2') return line('v.points(', [`"${name}"`, value, field.count?.low ?? '0', limit(field.count?.high ?? '200000'), about, ...(field.flags.has('required') ? need : [])]);
    const most = type === 'GroupId' || name === 'shares' ? 'kMaxGroups' : 'kMaxCharacters';
    const wanted = given ? need : field.flags.has('required') || (type === 'CharacterId' && !field.flags.has('unchecked')) || type === 'GroupId' ? ['Need::Required'] : [];
    if (isId(type)) return line('describeIds(', ['v', `"${name}"`, value, most, about, 'Need::Required']);
    return line('v.numbers(', [`"${name}"`, value, rangeOf(field), most, about, ...wanted]);
  }
  if (type === 'Vec2') return [`        spot(${value});`];
  if (isId(type)) {
    const whole = line('v.whole(', [`"${name}"`, `${value}.value`, 'kId', about, ...(field.isOptional ? [] : ['Need::Required'])]);
    return field.isOptional ? [`        if (takesPart<Visitor>(static_cast<bool>(${value})))`, ...whole.map((text) => `    ${text}`)] : whole;
  }
  if (isEnumeration(type)) return line('describeWord(', ['v', `"${field.key || name}"`, value, `k${type}Words`, about, ...need]);
  if (type === 'text') return line('v.text(', [`"${name}"`, value, about, ...need]);
  if (type === 'Colour') return line('v.colour(', [`"${name}"`, value, about]);
  if (type === 'bool' && field.flags.has('omit'))
    return [`        if (takesPart<Visitor>(${value}))`, ...line('v.flag(', [`"${name}"`, value, about], ');', '            ')];
  if (type === 'bool') return line('v.flag(', [`"${name}"`, value, about]);
  const visit = type === 'f64' ? 'number' : 'whole';
  const lines = line(`v.${visit}(`, [`"${name}"`, value, rangeOf(field), about, ...need]);
  return field.flags.has('omit') ? [`        if (takesPart<Visitor>(${value} != 0))`, ...lines.map((text) => `    ${text}`)] : lines;
}

function body(command) {
  if (command.flags.has('by-hand')) return `    void operator()(${command.name}& c) { describeByHand(v, c, time); }`;
  const lines = command.fields.flatMap(describe);
  if (lines.length === 0) return `    void operator()(${command.name}&) {}`;
  const short = `    void operator()(${command.name}& c) { ${lines[0].trim()} }`;
  if (lines.length === 1 && short.length <= kWidth) return short;
  return [`    void operator()(${command.name}& c) {`, ...lines, '    }'].join('\n');
}

function header() {
  return `${kBanner}// The fields of each kind of command in gesture files, except t, kind, client and step.
#pragma once

#include "files/scenario/command_by_hand.h"

namespace muster {

/// What files call each kind of command. Orders are called by what they ask for.
// clang-format off
inline constexpr std::array kCommandWords{
${listed(commands.map(({ file }) => `"${file}"`), '};')}
// clang-format on
static_assert(kCommandWords.size() == std::variant_size_v<CommandKinds>);

/// What older files call commands that worlds no longer have.
// clang-format off
inline constexpr std::array kFormerWords{
${listed(formerCommands.map(({ file }) => `"${file}"`), '};')}
// clang-format on
static_assert(kFormerWords.size() == std::variant_size_v<FormerKinds>);

/// Describes the fields of each kind of command to a visitor.
template <class Visitor>
struct BodyFields {
    Visitor& v;
    double& time;

${[...commands, ...formerCommands].map(body).join('\n')}

private:
    void spot(Vec2& p) {
        v.number("x", p.x, kCoordinate, "World coordinate.", Need::Required);
        v.number("y", p.y, kCoordinate, "World coordinate.", Need::Required);
    }
    /// A value that may be left out: \`describe(value, need)\` where it is given.
    template <class Value, class Describe>
    void given(const char* key, std::optional<Value>& value, const Describe& describe) {
        if constexpr (Visitor::kSchema) {
            Value none{};
            describe(none, Need::Optional);
            v.eraseDefault(key);
        } else if constexpr (Visitor::kReading) {
            if (v.has(key)) describe(value.emplace(), Need::Required);
        } else if (value) {
            describe(*value, Need::Required);
        }
    }
    /// A definition that may be left out.
    template <class Def, class Describe>
    void maybe(const char* key, std::optional<Def>& def, const char* about, const Describe& describe) {
        given(key, def, [&](auto& value, Need need) {
            v.object(
                key, about, [&](auto& inner) { describe(inner, value); }, need);
        });
    }
};

}  // namespace muster
`;
}

export const scenarioFiles = () => ({ 'src/files/scenario/generated/command_fields.h': header() });
