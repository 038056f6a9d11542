// Definitions as scenario files have them, in TypeScript.
import { definitions, enumerations, isDefinition, isEnumeration } from './read.mjs';
import { kDefinitionsBanner } from './definitions_cpp.mjs';
import { inFileOrder } from './definitions_files.mjs';
import { lowerFirst } from './text.mjs';
import { isId, plain } from './types.mjs';

/** Forms that files have beside the definition itself. */
const kForms = {
  FormationDef: 'FormationKindWord | FormationDef',
  Distribution: 'number | Distribution',
  'Body[]': 'readonly (Body & { readonly count?: number })[]',
  'PeopleDef[]': "'adults' | PeopleDef | readonly ('adults' | PeopleDef)[]",
  MapGround: 'MapDef & { readonly file?: string; readonly rows?: readonly string[] }',
  Polygon: 'readonly Point[]',
  PolygonWithHoles: 'readonly Point[]',
  Vec2: 'Point',
  Box: 'readonly [Point, Point]',
};

const inFiles = definitions.filter(({ flags }) => !flags.has('no-files'));

function typeOf({ type, isList }) {
  const own = kForms[isList ? `${type}[]` : type];
  if (own) return own;
  const item = kForms[type] ?? (type === 'text' ? 'string' : isId(type) ? 'number' : isEnumeration(type) ? `${type}Word` : isDefinition(type) ? type : plain(type).ts);
  return isList ? `readonly ${item.includes(' ') ? `(${item})` : item}[]` : item;
}

const comment = ({ sentence, inFiles: about, unit }) =>
  `  /** ${unit === '' ? about || sentence : `${(about || sentence).replace(/(?<!\.)\.$/, '')} [${unit}].`} */`;

/** A field as lines of an interface. */
function member(field) {
  const { name, key, type, flags } = field;
  const mark = flags.has('required') ? '' : '?';
  const about = comment(field);
  if (flags.has('xy') || (type === 'Vec2' && field.apart)) return [about, '  readonly x?: number;', '  readonly y?: number;'];
  const line = `  readonly ${key || name}${mark}: ${typeOf(field)};`;
  if (type !== 'PolygonWithHoles') return [about, line];
  return [about, line, '  /** Corners of each hole. */', '  readonly holes?: readonly (readonly Point[])[];'];
}

function structure({ name, sentences, fields }) {
  const lines = [...`${sentences[0].replace(/ \(SPEC [^)]*\)/, '')}`.match(/.{1,110}(?:\s|$)/g)].map((line) => ` * ${line.trim()}`);
  const about = lines.length === 1 ? [`/** ${lines[0].slice(3)} */`] : ['/**', ...lines, ' */'];
  return [...about, `export interface ${name} {`, ...inFileOrder(fields).flatMap(member), '}'].join('\n');
}

const used = enumerations.filter(({ name }) => inFiles.some(({ fields }) => fields.some(({ type }) => type === name)));
/** A type of words; those that are too many for a line go on below. */
function word({ name, sentence, values }) {
  const head = `export type ${name}Word =`;
  const list = values.map((value) => `'${lowerFirst(value.name)}'`).join(' | ');
  return [`/** ${sentence} */`, `${head}${head.length + list.length + 2 > 120 ? '\n ' : ''} ${list};`].join('\n');
}

/** Words that commands have, too, are declared with these. */
export const definitionTypescriptFiles = (inCommands) => ({
  'web/src/protocol/generated/definitions.ts': `${kDefinitionsBanner}// Definitions as scenario files have them (docs/scenario-format.md).

import type { ${used.filter(inCommands).map(({ name }) => `${name}Word`).join(', ')} } from './words';

export type Point = readonly [x: number, y: number];

${used.filter((one) => !inCommands(one)).map(word).join('\n\n')}

${inFiles.map(structure).join('\n\n')}
`,
});
