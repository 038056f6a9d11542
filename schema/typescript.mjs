// Commands and definitions as the page has them: their types, and the layouts by which web/src/protocol/codec.ts reads and
// writes their bytes.
import { commands, definitionOf, enumerations, isEnumeration } from './read.mjs';
import { kBanner } from './cpp.mjs';
import { messageDefinitions } from './messages.mjs';
import { lowerFirst } from './text.mjs';
import { isId, mayBeNone } from './types.mjs';

const kGiven = 'What is left out is as the declarations say.';

/** Types of single values: in TypeScript, and in layouts where they are called otherwise there. */
const kPlain = {
  text: ['string'], bool: ['boolean'], Vec2: ['Vec2'], Polygon: ['readonly Vec2[]', 'Vec2*'], PolygonWithHoles: ['PolygonWithHoles'],
  CharacterId: ['number', 'u32'], OrderId: ['number', 'u32'], MotionIndex: ['number', 'i32'], Colour: ['number', 'u32'],
};

/** Definitions that these fields have, each behind those that it has itself. */
function reached(fields, found = new Set()) {
  for (const { type } of fields) {
    const definition = definitionOf(type);
    if (!definition || found.has(definition)) continue;
    reached(definition.fields, found);
    found.add(definition);
  }
  return found;
}

const used = [...reached([...commands.flatMap(({ fields }) => fields), ...messageDefinitions.map((type) => ({ type }))])];
const fieldsOfAll = [...commands, ...used].flatMap(({ fields }) => fields);
/** True of an enumeration whose words the page has (words.ts). */
export const isUsed = ({ name }) => usedEnumerations.some((one) => one.name === name);
const usedEnumerations = enumerations.filter(({ name }) => fieldsOfAll.some(({ type }) => type === name));

const typeOfItem = (type) =>
  isEnumeration(type) ? `${type}Word` : definitionOf(type) ? type : (kPlain[type]?.[0] ?? 'number');

/** As in files: `kind` is that of the command. */
const nameOf = ({ name, key }) => key || name;

function typeOf(field) {
  const item = typeOfItem(field.type);
  const whole = field.isList ? `readonly ${item.startsWith('readonly') ? `(${item})` : item}[]` : item;
  return mayBeNone(field) ? `${whole} | null` : whole;
}

/** "shape:PartShape=asHeld": name, type and default. */
function layoutOf(fields, nameOfField = ({ name }) => name) {
  const word = (field) => {
    const { type, initial, isList } = field;
    const item = isId(type) ? 'u32' : (kPlain[type]?.[1] ?? type);
    const start = initial === '' || isList ? '' : isEnumeration(type) ? lowerFirst(initial) : initial.replace(/"|\.0$/g, '').replace(/^(false|0)$/, '').replace('true', '1');
    return `${nameOfField(field)}:${item}${isList ? '*' : ''}${mayBeNone(field) ? '?' : ''}${start === '' ? '' : `=${start}`}`;
  };
  return fields.map(word).join(' ');
}

const about = (field) => `  /** ${field.unit === '' ? field.sentence : `${field.sentence.replace(/\.$/, '')} [${field.unit}].`} */`;

const definitionType = ({ name, sentences, fields }) =>
  [
    `/** ${sentences[0]} */`,
    `export interface ${name} {`,
    ...fields.flatMap((field) => [...(field.sentence === '' ? [] : [about(field)]), `  readonly ${field.name}: ${typeOf(field)};`]),
    '}',
  ].join('\n');

/** A command has to say what has no default. */
const isNeeded = (field) =>
  field.flags.has('required') ||
  (field.initial === '' && !field.isOptional && !field.flags.has('omit') && (!field.isList || field.type === 'CharacterId' || isId(field.type)) && field.type !== 'bool');

const commandType = (command) =>
  [
    `/** ${command.sentences[0]} */`,
    `export interface ${command.name}Command {`,
    `  readonly kind: '${command.file}';`,
    ...command.fields
      .filter(({ flags }) => !flags.has('internal'))
      .flatMap((field) => {
        const type = typeOf(field);
        return [about(field), `  readonly ${nameOf(field)}${isNeeded(field) ? '' : '?'}: ${definitionOf(field.type) ? `Given<${type}>` : type};`];
      }),
    '}',
  ].join('\n');

function words({ name, sentence, values }) {
  const list = values.map((value) => `'${lowerFirst(value.name)}'`);
  return `/** ${sentence} In the order of values. */
// prettier-ignore
export const k${name}Words = [${list.join(', ')}] as const;
export type ${name}Word = (typeof k${name}Words)[number];`;
}

const wordFile = () => `${kBanner.replace('commands.txt', 'enumerations.txt')}${usedEnumerations.map(words).join('\n\n')}

/** By name. */
export const kWords: Readonly<Record<string, readonly string[]>> = {
${usedEnumerations.map(({ name }) => `  ${name}: k${name}Words,`).join('\n')}
};
`;

const typeFile = () => `${kBanner.replace('commands.txt', 'definitions.txt and commands.txt')}import type {
${usedEnumerations.map(({ name }) => `  ${name}Word,`).join('\n')}
} from './words';

export type Vec2 = readonly [number, number];

/** A polygon with holes. */
export interface PolygonWithHoles {
  readonly outline: readonly Vec2[];
  readonly holes: readonly (readonly Vec2[])[];
}

/** ${kGiven} */
export type Given<T> = T extends Vec2
  ? T
  : T extends readonly (infer Item)[]
    ? readonly Given<Item>[]
    : T extends object
      ? { readonly [Key in keyof T]?: Given<T[Key]> | undefined }
      : T;

${used.map(definitionType).join('\n\n')}

${commands.map(commandType).join('\n\n')}

/** Any command. */
export type Command =
${commands.map(({ name }) => `  | ${name}Command`).join('\n')};
`;

const layoutFile = () => `${kBanner.replace('commands.txt', 'definitions.txt and commands.txt')}// prettier-ignore
/** The fields of definitions: name, type and default (codec.ts). */
export const kDefinitionLayouts: Readonly<Record<string, string>> = {
  Vec2: '0:f64 1:f64',
  PolygonWithHoles: 'outline:Vec2* holes:Vec2**',
${used.map(({ name, fields }) => `  ${name}: '${layoutOf(fields)}',`).join('\n')}
};

// prettier-ignore
/** What bytes call the kinds of commands, in the order of kCommandLayouts. */
export const kCommandNumbers: readonly number[] = [${commands.map(({ number }) => number).join(', ')}];

// prettier-ignore
/** Commands: kind and fields. */
export const kCommandLayouts: readonly (readonly [string, string])[] = [
${commands.map(({ file, fields }) => `  ['${file}', '${layoutOf(fields, nameOf)}'],`).join('\n')}
];
`;

export const typescriptFiles = () => ({
  'web/src/protocol/generated/words.ts': wordFile(),
  'web/src/protocol/generated/commands.ts': typeFile(),
  'web/src/protocol/generated/command_layouts.ts': layoutFile(),
});
