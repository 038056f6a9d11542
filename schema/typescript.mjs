// Commands as the page writes them: events of gesture files, in a Commands message.
import { commands, enumerations } from './read.mjs';
import { kBanner } from './cpp.mjs';
import { lowerFirst } from './text.mjs';
import { definition, enumerated, isId, plain } from './types.mjs';

const kOrderKinds = 'OrderKind';
const kGiveOrder = 'GiveOrder';

/** Definitions and what stands inline have forms of their own (docs/scenario-format.md). */
function typeOf({ type, isList }) {
  const item =
    type === 'text' ? 'string'
    : isId(type) ? 'number'
    : enumerations.some(({ name }) => name === type) ? `${type}Word`
    : definition(type) ? 'Fields'
    : plain(type).ts;
  return isList ? `readonly ${item.startsWith('readonly') ? `(${item})` : item}[]` : item;
}

const isOptional = (field) =>
  !field.flags.has('required') &&
  (field.isOptional || field.initial !== '' || field.flags.has('omit') || (field.isList && field.type !== 'CharacterId' && !isId(field.type)) || field.flags.has('unchecked') && field.isList);

/** A field as a line of an interface, with its comment; none for what files do not have. */
function member(field) {
  const { name, type, flags } = field;
  if (flags.has('internal') || (name === 'time' && type === 'f64')) return [];
  const about = `  /** ${field.unit === '' ? field.sentence : `${field.sentence.replace(/\.$/, '')} [${field.unit}].`} */`;
  if (type === 'Vec2' && !field.isList) return [about, '  readonly x: number;', '  readonly y: number;'];
  const named = definition(type);
  const key = named && !named.inline ? (named.key ?? 'definition') : (enumerated(type)?.key ?? name);
  return [about, `  readonly ${key}${isOptional(field) ? '?' : ''}: ${typeOf(field)};`];
}

/** Fields that stand among those of the command, in a form of their own. */
const isInline = ({ type, isList }) => definition(type)?.inline !== undefined && !(isList && (type === 'Body' || type === 'RoleDef'));

function event(command) {
  const kind = command.name === kGiveOrder ? `${kOrderKinds}Word` : `'${command.file}'`;
  const byHand = command.name === 'AddControl';
  const own = command.fields.filter((field) => !isInline(field) && !(byHand && field.type !== 'GroupId' && field.type !== 'ControlKind'));
  const extends_ = byHand || command.fields.some(isInline) ? ' extends Fields' : '';
  return [`/** ${command.sentence} */`, `export interface ${command.name}Event${extends_} {`, `  readonly kind: ${kind};`, ...own.flatMap(member), '}'].join('\n');
}

function words({ name, sentence, values }) {
  const list = values.map((value) => `'${lowerFirst(value.name)}'`);
  return `/** ${sentence} In the order of values. */
// prettier-ignore
export const k${name}Words = [${list.join(', ')}] as const;
export type ${name}Word = (typeof k${name}Words)[number];`;
}

/** Enumerations that fields of commands have, and those of orders. */
export const isUsed = ({ name }) => enumerated(name) !== undefined || [kOrderKinds, 'Manner', 'Turn', 'Stance'].includes(name);

export const typescriptFiles = () => ({
  'web/src/protocol/generated/commands.ts': `${kBanner}// Commands as events of gesture files: what a Commands message carries.

/** What has a form of its own: definitions, orders, conducts (docs/scenario-format.md). */
export type Fields = Readonly<Record<string, unknown>>;

${enumerations.filter(isUsed).map(words).join('\n\n')}

${commands.map(event).join('\n\n')}

/** Any command, as the page writes it. */
export type CommandEvent =
${commands.map(({ name }) => `  | ${name}Event`).join('\n')};
`,
});
