// Messages in TypeScript: their types, and the layouts by which web/src/protocol/codec.ts reads and writes them.
import { kCommand, kNumbers, messageDefinitions, page, parts, server, shared, values, version } from './messages.mjs';

const kBanner = '// Made by schema/generate.mjs from schema/messages.txt: change these, not this file.\n';

/** Lists of numbers are typed arrays. */
const kArrays = {
  u8: 'Uint8Array', i8: 'Int8Array', u16: 'Uint16Array', i16: 'Int16Array', u32: 'Uint32Array', f32: 'Float32Array', f64: 'Float64Array',
};

const choices = [...values, ...shared.map((one) => ({ ...one, values: one.values.map(({ name }) => name) }))];
const choiceOf = (type) => choices.find(({ name }) => name === type);

/** What the page only gives need not be whole. */
const given = new Set(['ForecastAsk', 'PlacesAsk']);

function tsType({ type, isList, isOptional }, owner) {
  if (type === kCommand) return 'readonly Command[]';
  if (kNumbers.includes(type)) return isList ? kArrays[type] : `number${isOptional ? ' | null' : ''}`;
  const named = { bool: 'boolean', text: 'string' }[type] ?? type;
  const item = given.has(owner) && messageDefinitions.includes(type) ? `Given<${named}>` : named;
  if (isOptional) return `${item} | null`;
  return isList ? `${item}[]` : item;
}

/** The comment of a field, with its unit before its first stop or semicolon. */
function about({ sentence, unit }) {
  if (unit === '') return sentence;
  return sentence === '' ? `[${unit}].` : sentence.replace(/[.;]/, (stop) => ` [${unit}]${stop}`);
}

function member(field, owner) {
  const text = about(field);
  return [...(text === '' ? [] : [`  /** ${text} */`]), `  ${field.name}: ${tsType(field, owner)};`];
}

const isInline = ({ flags }) => flags.has('inline');

/** What has fields of a definition in itself extends it. */
function interfaceOf(entry) {
  const bases = entry.fields.filter(isInline).map(({ type }) => type);
  return [
    `/** ${entry.sentence} */`,
    `export interface ${entry.name} ${bases.length > 0 ? `extends ${bases.join(', ')} ` : ''}{`,
    ...(entry.number === null ? [] : [`  type: '${entry.name}';`]),
    ...entry.fields.filter((field) => !isInline(field)).flatMap((field) => member(field, entry.name)),
    '}',
  ].join('\n');
}

/** "events:TouchEvent*": a name, a type, and * for a list; s for a typed array; ? where it may be none; <4 for a byte below 4; "..." as the name of fields that are its owner's. */
function layoutOf({ fields }) {
  const word = (field) => {
    const { name, type, isList, isOptional } = field;
    const choice = choiceOf(type);
    if (choice) return `${name}:<${choice.values.length}`;
    if (type === kCommand) return `${name}:${type}+`;
    if (isInline(field)) return `...:${type}`;
    if (isOptional) return `${name}:${type}?`;
    return `${name}:${type}${isList ? (kNumbers.includes(type) ? 's' : '*') : ''}`;
  };
  return fields.map(word).join(' ');
}

const constant = ({ name, sentence, values: words }) => `/** ${sentence} */
export const ${name} = {
${words.map((value, number) => `  ${value}: ${number},`).join('\n')}
} as const;
export type ${name} = (typeof ${name})[keyof typeof ${name}];`;

const choiceFile = () => `${kBanner}
export const VERSION = ${version};
/** Of the WebSocket. */
export const SUBPROTOCOL = 'muster.v${version}';

${choices.map(constant).join('\n\n')}
`;

const union = (side, entries) => `export type ${side}Message =\n${entries.map(({ name }) => `  | ${name}`).join('\n')};`;

const typeFile = () => `${kBanner}import type {
${choices.map(({ name }) => `  ${name},`).join('\n')}
} from './choices';
import type {
${[kCommand, ...messageDefinitions, 'Given', 'Vec2'].map((name) => `  ${name},`).join('\n')}
} from './commands';

${[...parts, ...page, ...server].map(interfaceOf).join('\n\n')}

/** Any message of the page. */
${union('Client', page)}

/** Any message of the server. */
${union('Server', server)}
`;

const numbered = (entries) => entries.map((entry) => `  ['${entry.name}', '${layoutOf(entry)}'],`).join('\n');

const layoutFile = () => `${kBanner}// prettier-ignore
/** The fields of parts: name and type (codec.ts). */
export const kPartLayouts: Readonly<Record<string, string>> = {
${parts.map((entry) => `  ${entry.name}: '${layoutOf(entry)}',`).join('\n')}
};

// prettier-ignore
/** Messages of the page in the order of their numbers: name and fields. */
export const kClientLayouts: readonly (readonly [string, string])[] = [
${numbered(page)}
];

// prettier-ignore
/** Messages of the server. */
export const kServerLayouts: readonly (readonly [string, string])[] = [
${numbered(server)}
];
`;

export const messageTypescriptFiles = () => ({
  'web/src/protocol/generated/choices.ts': choiceFile(),
  'web/src/protocol/generated/messages.ts': typeFile(),
  'web/src/protocol/generated/layouts.ts': layoutFile(),
});
