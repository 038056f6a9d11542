// Bytes of messages to the server, by messages.txt: for scripts and tests that have no page.
import { page, parts, server, values, version } from './messages.mjs';
import { definitions, enumerations } from './read.mjs';
import { lowerFirst } from './text.mjs';
import { isId } from './types.mjs';

const numbered = (entries) => Object.fromEntries(entries.map(({ name, number }) => [name, number]));
/** The WebSocket's subprotocol. */
export const kSubprotocol = `muster.v${version}`;
/** First bytes of messages, by name. */
export const fromClient = numbered(page);
export const fromServer = numbered(server);

/** Size, and writer of Buffer, of each type of number. */
const kNumbers = {
  u8: [1, 'writeUInt8'],
  i8: [1, 'writeInt8'],
  u16: [2, 'writeUInt16LE'],
  i16: [2, 'writeInt16LE'],
  u32: [4, 'writeUInt32LE'],
  i32: [4, 'writeInt32LE'],
  f32: [4, 'writeFloatLE'],
  f64: [8, 'writeDoubleLE'],
};

function number(type, value) {
  const [size, write] = kNumbers[type];
  const bytes = Buffer.alloc(size);
  bytes[write](value);
  return bytes;
}

/** Text and arrays have their length before them. */
const withLength = (length, ...parts) => Buffer.concat([number('u32', length), ...parts]);

const named = (entries, type) => entries.find(({ name }) => name === type);

/** Types of definitions that are numbers. */
const kAs = { CharacterId: 'u32', OrderId: 'u32', MotionIndex: 'i32', Colour: 'u32' };
/** Structs that are not declared. */
const kStructs = {
  Vec2: [{ name: 0, type: 'f64' }, { name: 1, type: 'f64' }],
  PolygonWithHoles: [{ name: 'outline', type: 'Vec2', isList: true }, { name: 'holes', type: 'Polygon', isList: true }],
};
const fieldsOf = (type) => kStructs[type] ?? (named(parts, type) ?? named(definitions, type))?.fields;

/** What a field is where it is left out. */
function defaultOf({ type, initial = '', isList }) {
  if (isList || type === 'Polygon') return [];
  const choice = named(enumerations, type);
  if (choice) return initial || choice.values[0].name;
  if (fieldsOf(type)) return {};
  return type === 'text' ? initial.replace(/"/g, '') : type === 'bool' ? initial === 'true' : Number(initial);
}

function one(field, value) {
  const { type } = field;
  const as = isId(type) ? 'u32' : (kAs[type] ?? type);
  if (as in kNumbers) return number(as, value);
  if (type === 'bool') return number('u8', value ? 1 : 0);
  if (named(values, type)) return number('u8', named(values, type).values.indexOf(value));
  const choice = named(enumerations, type);
  if (choice) return number('u8', choice.values.findIndex(({ name }) => name === value || lowerFirst(name) === value));
  if (type === 'Polygon') return list({ type: 'Vec2' }, value);
  if (fieldsOf(type)) return all(fieldsOf(type), value);
  const text = Buffer.from(value);
  return withLength(text.length, text);
}

const list = (field, items) => withLength(items.length, ...items.map((part) => one(field, part)));

function all(fields, given) {
  return Buffer.concat(
    fields.map((field) => {
      const value = given[field.name];
      const write = field.isList ? list : one;
      if (field.isOptional && !isId(field.type))
        return value === undefined || value === null ? number('u8', 0) : Buffer.concat([number('u8', 1), write(field, value)]);
      return write(field, value ?? defaultOf(field));
    }),
  );
}

/** A message of a client without commands: its name, and its fields by name, enumerations by their words. */
export function encode(name, values = {}) {
  return Buffer.concat([number('u8', fromClient[name]), all(page[fromClient[name]].fields, values)]);
}
