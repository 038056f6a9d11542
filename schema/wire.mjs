// Bytes of messages to the server, by messages.txt: for scripts and tests that have no page.
import { page, parts, server, shared, values, version } from './messages.mjs';

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

function one({ type }, value) {
  if (type in kNumbers) return number(type, value);
  if (type === 'bool') return number('u8', value ? 1 : 0);
  if (named(values, type)) return number('u8', named(values, type).values.indexOf(value));
  if (named(shared, type)) return number('u8', named(shared, type).values.findIndex(({ name }) => name === value));
  if (named(parts, type)) return all(named(parts, type).fields, value);
  const text = Buffer.from(value);
  return withLength(text.length, text);
}

function all(fields, values) {
  return Buffer.concat(
    fields.map((field) => {
      const value = values[field.name];
      return field.isList ? withLength(value.length, ...value.map((part) => one(field, part))) : one(field, value);
    }),
  );
}

/** A message of a client: its name, and its fields by name, enumerations by their words. */
export function encode(name, values = {}) {
  return Buffer.concat([number('u8', fromClient[name]), all(page[fromClient[name]].fields, values)]);
}
