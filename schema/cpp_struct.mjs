// The structs of C++: their fields, their archives, and what compares them.
import { definitionOf, isDefinition, isEnumeration } from './read.mjs';
import { aligned, call, docComment, rowsOf, withUnit } from './text.mjs';
import { isId, mayBeNone, plain } from './types.mjs';

/** Types of structs that C does not have. */
const kOther = {
  text: 'std::string',
  EventCounts: 'std::array<std::uint64_t, kCountOf<EventKind>>',
  StageMeans: 'std::array<double, kStageCount>',
};

/** How C++ spells the type of a single value. */
const cppItem = (type) => kOther[type] ?? plain(type)?.cpp ?? definitionOf(type)?.cpp ?? type;

/** How C++ spells the type of a field. Columns hold ids as numbers; what is a span is not copied. */
function typeOf({ flags }, field) {
  const { type, isList, length } = field;
  const isColumn = flags.has('columns');
  const isRead = isColumn || flags.has('spans');
  const item = isColumn && isId(type) ? 'std::uint32_t' : cppItem(type);
  if (length) return `std::array<${item}, ${length}>`;
  if (isList && isRead) return `std::span<const ${item}>`;
  if (type === 'text' && isRead) return 'std::string_view';
  const whole = isList ? `std::vector<${item}>` : item;
  return mayBeNone(field) ? `std::optional<${whole}>` : whole;
}

/** "0.0", "SplitBy::Ids", "{}" for its first value; empty where the type has a default of its own. */
function initialOf(struct, field) {
  const { type, initial, isList, isOptional, length } = field;
  // Of commands programs name a few fields: compilers would miss those that may be none.
  if (isOptional) return 'number' in struct && mayBeNone(field) ? '{}' : '';
  if (isEnumeration(type) && !isList) return initial === '' ? '{}' : `${type}::${initial}`;
  if (type === 'Box') return initial.replace(/,(?=\S)/g, ', ');
  if (type === 'f64' && /^-?\d+$/.test(initial)) return `${initial}.0`;
  if (initial !== '') return initial;
  if (length || ['EventCounts', 'StageMeans'].includes(type)) return '{}';
  return isList || isDefinition(type) ? '' : (plain(type)?.initial ?? '');
}

/** A field as a member: {type, name, initial}. */
export const memberOf = (struct, field) => ({ type: typeOf(struct, field), name: field.as || field.name, initial: initialOf(struct, field) });

/** "double speed = 1.0;" and its comment. */
function row(struct, field) {
  const { type, name, initial } = memberOf(struct, field);
  const value = initial === '' || (initial.startsWith('{') && !field.isOptional) ? initial : ` = ${initial}`;
  return { code: `${type} ${name}${value};`, about: withUnit(field) };
}

/** Fields as archives take them: those of one version together. */
function archiveLines(fields) {
  const groups = [];
  for (const { name, since, flags } of fields) {
    const head = flags.has('unhashed') ? `archive.optionalSince(${since}, ` : since === '' ? 'archive(' : `archive.since(${since}, `;
    const last = groups.at(-1);
    if (last?.head === head && !flags.has('unhashed')) last.names.push(name);
    else groups.push({ head, names: [name] });
  }
  return groups.flatMap(({ head, names }) => call(head, names, ');', '        '));
}

/**
 * The lines of a struct. `archived` is what its archive reads or writes; empty where it has none. `isRoomy`: comments that are
 * too long for their lines stand before their fields.
 */
export function structLines(struct, { archived = '', isRoomy = false } = {}) {
  const { cpp, sentences, functions, flags } = struct;
  const fields = struct.fields.filter((field) => !field.flags.has('c-only'));
  const rows = fields.map((field) => row(struct, field));
  const lines = [...sentences.flatMap((sentence) => (sentence === '' ? ['///'] : docComment(sentence))), `struct ${cpp} {`, ...(isRoomy ? rowsOf : aligned)(rows)];
  if (flags.has('columns')) lines.push('', '    std::size_t size() const { return id.size(); }  ///< Number of entries.');
  if (functions.length > 0) lines.push('');
  for (const { sentence, code } of functions) lines.push(...docComment(sentence, '    '), ...code.split('\\n').map((line) => `    ${line}`));
  if (archived !== '')
    lines.push('', `    /// Lets an archive read or write ${archived}.`, '    template <class Archive>', '    void visit(Archive& archive) {', ...archiveLines(fields), '    }');
  if (flags.has('equal')) lines.push('    /// Equal in all parts.', `    friend bool operator==(const ${cpp}&, const ${cpp}&) = default;`);
  return [...lines, '};'];
}
