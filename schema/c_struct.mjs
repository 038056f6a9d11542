// The structs of C: the members that stand for each field, and the lines that carry a struct from C to C++ or back.
import { apiStructs } from './api.mjs';
import { definitionOf, isDefinition, isEnumeration } from './read.mjs';
import { aligned, docComment, hasOf, singular, upperWords, withUnit } from './text.mjs';
import { cType, isId, mayBeNone, plain } from './types.mjs';

/** The function that makes a struct with a version. */
export const makerOf = ({ name }) => `muster_default_${upperWords(name).toLowerCase()}`;

/** A sentence without what is only said in C++. */
export const asInC = (sentence) =>
  sentence
    .replace(/(\w)::(\w)/g, '$1.$2')
    .replace(/ \(SPEC [^)]*\)/, '')
    .replace(/\b(?=(World|Group)Def\b)/g, 'Muster');

/** The comment of a member that stands for the whole field. In C ids, lists, pointers and texts are none in another way than in C++. */
function aboutOf(struct, field) {
  if (field.flags.has('internal')) return 'Not used; 0.';
  const sentence = struct.isGiven ? asInC(withUnit(field)) : withUnit(field);
  if (field.isList) return sentence.replace(/; empty for none\b/, '').replace(/\bempty\b/, 'none');
  if (!struct.isGiven) return sentence;
  if (field.type === 'text' && !field.isOptional) return `${sentence.replace(/(?<!\.)\.$/, '').replace(/; (may be empty|empty for none)/, '')}; null for none.`;
  if (isId(field.type)) return sentence.replace(/\bnone\b/, '0');
  return isDefinition(field.type) && field.isOptional ? sentence.replace(/\bnone\b/, 'null') : sentence;
}

/** The name of the number of a list. */
const countOf = (struct, { name, countName }) => countName || (struct.flags.has('columns') ? 'count' : `${singular(name)}Count`);

/** A list, its number where that is no field of its own, and whether there is one where there may be none. */
function listMembers(struct, field, type, about) {
  const count = countOf(struct, field);
  const [sentence, none = ''] = field.isOptional ? about.replace(/\.$/, '').split('; none for ') : [];
  const has = field.isOptional ? [{ type: 'bool', name: hasOf(field.name), about: `False: ${none}.` }] : [];
  const list = { type: `const ${type}*`, name: field.name, about: field.isOptional ? `${sentence}.` : about, count };
  const isOwn = struct.flags.has('columns') || field.countName !== '';
  return isOwn ? [list] : [...has, list, { type: 'int32_t', name: count, about: 'Their number.' }];
}

function membersOf(struct, field) {
  const { name, type, length } = field;
  const item = cType(type);
  const about = aboutOf(struct, field);
  if (type === 'function') {
    const parameters = field.parameters.map((one) => ({ name: one.name, type: cType(one.type) }));
    return [{ type, name, about, parameters, returns: cType(field.returns) }];
  }
  if (field.isList) return listMembers(struct, field, item, about);
  if (type === 'PolygonWithHoles')
    return [{ type: item, name, about }, ...listMembers(struct, { name: 'holes', countName: '' }, item, 'Its holes, clockwise, apart from each other [m].')];
  if (type === 'Parameters')
    return [
      { type: 'const char*', name: 'preset', about: 'Preset of parameters, "units", "people" or "paper"; null for "units".' },
      ...listMembers(struct, field, 'MusterParameterValue', 'Parameters that differ from the preset, set in this order.'),
    ];
  if (field.isPointer || (field.isOptional && isDefinition(type))) return [{ type: `const ${item}*`, name, about }];
  if (!mayBeNone(field)) return [{ type: field.isChanged ? `${item}*` : item, name, about, length }];
  const [is, none = ''] = about.replace(/\.$/, '').split('; none for ');
  return [{ type: 'bool', name: hasOf(name), about: `False: ${none}.` }, { type: item, name, about: `${is}.` }];
}

/** The fields in the order of the C struct. */
function inCOrder(fields) {
  const ordered = fields.filter(({ cAfter }) => cAfter === '');
  for (const field of fields.filter(({ cAfter }) => cAfter !== ''))
    ordered.splice(ordered.findIndex(({ name }) => name === field.cAfter) + 1, 0, field);
  return ordered;
}

/** The members of a struct of C: {type, name, about, length, count, parameters, returns}. */
export function structMembers(struct) {
  const version = { type: 'uint32_t', name: 'structVersion', about: `Set by ${makerOf(struct)}().` };
  const members = inCOrder(struct.fields.filter(({ flags }) => !flags.has('cpp-only'))).flatMap((field) => membersOf(struct, field));
  return struct.version ? [version, ...members] : members;
}

const pairs = (parameters) => parameters.map(({ name, type }) => `${type} ${name}`);

/** The declaration of a member, without its semicolon. */
function declared({ type, name, length, parameters, returns }) {
  if (type === 'function') return `${returns} (*${name})(${pairs(parameters).join(', ')})`;
  return `${type} ${name}${length ? `[${length}]` : ''}`;
}

/** Members with their comments behind them; pointers to functions have them before. */
function memberLines(members) {
  const lines = [];
  let rows = [];
  const flush = () => {
    if (rows.length > 0) lines.push(...aligned(rows));
    rows = [];
  };
  for (const member of members) {
    const row = { code: `${declared(member)};`, about: member.about };
    if (member.type === 'function') {
      flush();
      lines.push(...docComment(row.about, '    '), `    ${row.code}`);
    } else {
      rows.push(row);
    }
  }
  flush();
  return lines;
}

/** The lines of a struct or a union with these members. */
export const membersLines = (name, sentence, members, kind = 'struct') =>
  [...docComment(sentence), `typedef ${kind} Muster${name} {`, ...memberLines(members), `} Muster${name};`];

/** What a struct is, in one sentence or a few. */
export const structSentence = ({ sentences, isGiven }) => (isGiven ? asInC(sentences[0]) : sentences[0]);

/** The lines of a struct. */
export const structLines = (struct) => membersLines(struct.name, structSentence(struct), structMembers(struct));

/** True for types whose C struct holds the same bytes as that of C++. */
export function isFlat(type) {
  if (['Polygon', 'PolygonWithHoles', 'Parameters'].includes(type)) return false;
  if (plain(type) || isId(type) || isEnumeration(type) || ['Pose', 'MeshPoint', 'Triangle'].includes(type)) return true;
  if (isDefinition(type)) return definitionOf(type).flags.has('flat');
  const struct = apiStructs.find(({ name }) => name === type);
  return struct !== undefined && struct.fields.every((field) => !field.isList && !field.isOptional && field.type !== 'text' && isFlat(field.type));
}

/** The lines that carry one field, for both directions; none where it is the number of a list. */
function marshal(struct, field) {
  const { name, type, flags } = field;
  if (flags.has('cpp-only') || (flags.has('c-only') && field.as === '')) return [];
  const from = `p.${field.as || name}`;
  const both = `c.${name}, ${from}`;
  const has = `c.${hasOf(name)}`;
  if (field.isList) {
    const visit = isFlat(type) ? 'list' : 'items';
    const words = (list) => `c.${name}, c.${countOf(struct, field)}, ${list}, "${name}"`;
    return [field.isOptional ? `if (m.given(${has}, ${from})) m.${visit}(${words(`*${from}`)});` : `m.${visit}(${words(from)});`];
  }
  if (type === 'PolygonWithHoles')
    return [`m.part(c.${name}, ${from}.outline, "${name}");`, `m.items(c.holes, c.holeCount, ${from}.holes, "holes");`];
  if (type === 'Parameters') return [`parameterFields(m, c, ${from});`];
  if (isId(type)) return [`m.id(${both});`];
  if (type === 'text') return [field.isOptional ? `if (m.given(${has}, ${from})) m.text(c.${name}, *${from});` : `m.text(${both});`];
  if (isEnumeration(type))
    return [field.isOptional ? `m.optionalChoice(${has}, ${both}, kLastOf<${type}>, "${name}");` : `m.choice(${both}, kLastOf<${type}>, "${name}");`];
  if (field.isOptional) return [isDefinition(type) ? `m.optionalPart(${both}, "${name}");` : `m.optional(${has}, ${both});`];
  return [isFlat(type) ? `m.plain(${both});` : `m.part(${both}, "${name}");`];
}

/** The function that carries a struct. */
export function marshalled(struct) {
  const { name, cpp, version } = struct;
  const head = version ? [`m.template version<Muster${name}>(c.structVersion);`] : [];
  const lines = struct.flags.has('flat') ? ['m.plain(c, p);'] : inCOrder(struct.fields).flatMap((field) => marshal(struct, field));
  return `template <class M>
void fields(M& m, C<M, Muster${name}>& c, P<M, ${cpp}>& p) {
${[...head, ...lines].map((line) => `    ${line}`).join('\n')}
}`;
}

/** The line that says a struct's version to the functions that take it. */
export const versionLine = (struct) =>
  `MUSTER_STRUCT_VERSION(Muster${struct.name}, ${struct.version.kind}, ${struct.version.version}, "${makerOf(struct)}");`;

/** Members of both sides stand at the same places, as conditions. */
export const sameLayout = ({ name, cpp, fields }) => [
  `sizeof(Muster${name}) == sizeof(${cpp})`,
  ...fields.slice(1).map((field) => `offsetof(Muster${name}, ${field.name}) == offsetof(${cpp}, ${field.name})`),
];
