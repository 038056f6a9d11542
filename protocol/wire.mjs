// Bytes of messages to the server, by messages.json: for scripts and tests that have no page.
import { client, schema, server, structs } from './schema.mjs';

const numbered = (entries) => Object.fromEntries(entries.map(({ name, number }) => [name, number]));
/** First bytes of messages, by name. */
export const fromClient = numbered(client);
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

function one({ kind, item }, value) {
  if (kind === 'number') return number(item, value);
  if (kind === 'bool') return number('u8', value ? 1 : 0);
  if (kind === 'enum') return number('u8', schema.enums[item].indexOf(value));
  if (kind === 'struct') return all(structs.find(({ name }) => name === item).fields, value);
  const text = Buffer.from(value);
  return withLength(text.length, text);
}

function all(fields, values) {
  return Buffer.concat(
    fields.map((field) => {
      const value = values[field.name];
      return field.array ? withLength(value.length, ...value.map((part) => one(field, part))) : one(field, value);
    }),
  );
}

/** A message of a client: its name, and its fields by name, enumerations by their words. */
export function encode(name, values = {}) {
  return Buffer.concat([number('u8', fromClient[name]), all(client[fromClient[name]].fields, values)]);
}
