// The TypeScript side of the protocol.
import { banner, client, numbers, schema, server, structs } from './schema.mjs';

function tsType(field) {
  if (field.array) return field.kind === 'number' ? numbers[field.item][1] : `${field.item}[]`;
  if (field.kind === 'number') return 'number';
  return field.kind === 'bool' ? 'boolean' : field.item;
}

function tsRead(field) {
  if (field.kind === 'struct') return field.array ? `r.list(read${field.item})` : `read${field.item}(r)`;
  if (field.kind === 'enum') return `r.choice(${schema.enums[field.item].length}) as ${field.item}`;
  return `r.${field.item}${field.array ? 's' : ''}()`;
}

function tsWrite(field) {
  if (field.kind === 'struct') {
    return field.array ? `w.list(m.${field.name}, write${field.item})` : `write${field.item}(w, m.${field.name})`;
  }
  if (field.kind === 'enum') return `w.u8(m.${field.name})`;
  return `w.${field.item}${field.array ? 's' : ''}(m.${field.name})`;
}

function tsEntry(entry, message) {
  let text = `/** ${entry.note} */\nexport interface ${entry.name} {\n`;
  if (message) text += `  type: '${entry.name}';\n`;
  for (const field of entry.fields) {
    if (field.note) text += `  /** ${field.note} */\n`;
    text += `  ${field.name}: ${tsType(field)};\n`;
  }
  text += `}\n\nexport function read${entry.name}(r: ByteReader): ${entry.name} {\n  return {\n`;
  if (message) text += `    type: '${entry.name}',\n`;
  for (const field of entry.fields) text += `    ${field.name}: ${tsRead(field)},\n`;
  text += `  };\n}\n\nexport function write${entry.name}(w: ByteWriter, m: ${entry.name}): void {\n`;
  if (message) text += `  w.u8(${entry.number});\n`;
  for (const field of entry.fields) text += `  ${tsWrite(field)};\n`;
  return text + '}\n\n';
}

function tsSide(side, all) {
  const readers = all.map((entry) => `  read${entry.name},\n`).join('');
  const cases = all.map((entry) => `    case '${entry.name}':\n      write${entry.name}(w, message);\n      break;\n`).join('');
  return `export type ${side}Message =\n${all.map((entry) => `  | ${entry.name}`).join('\n')};

const read${side}: readonly ((r: ByteReader) => ${side}Message)[] = [\n${readers}];

/** Reads a message; throws ProtocolError where it does not fit. */
export function decode${side}(buffer: ArrayBuffer): ${side}Message {
  const r = new ByteReader(buffer);
  const message = read${side}[r.choice(read${side}.length)]!(r);
  r.end();
  return message;
}

/** A message's bytes. */
export function encode${side}(message: ${side}Message): ArrayBuffer {
  const w = new ByteWriter();
  switch (message.type) {
${cases}  }
  return w.bytes();
}
`;
}

/** The protocol's version and the enumerations. */
function tsEnums() {
  let text = `${banner}
export const VERSION = ${schema.version};
/** Of the WebSocket. */
export const SUBPROTOCOL = 'muster.v${schema.version}';
`;
  for (const [name, values] of Object.entries(schema.enums)) {
    const pairs = values.map((value, i) => `  ${value}: ${i},\n`).join('');
    text += `\nexport const ${name} = {\n${pairs}} as const;\nexport type ${name} = (typeof ${name})[keyof typeof ${name}];\n`;
  }
  return text;
}

/** Interfaces with what reads and writes them. */
function tsEntries(entries, messages) {
  const text = entries.map((entry) => tsEntry(entry, messages)).join('').trimEnd();
  return `${banner}import { ByteReader, ByteWriter } from './bytes';\n${tsImports(entries)}\n${text}\n`;
}

/** Lines that import names from a module. */
function importLines(names, module) {
  const sorted = [...names].sort((a, b) => a.replace('type ', '').localeCompare(b.replace('type ', '')));
  return sorted.length > 0 ? `import {\n${sorted.map((name) => `  ${name},\n`).join('')}} from './${module}';\n` : '';
}

/** The structs that fields refer to, with those that these refer to. */
function structsOf(fields) {
  const names = fields.filter((field) => field.kind === 'struct').map((field) => field.item);
  const found = structs.filter(({ name }) => names.includes(name));
  return found.flatMap((entry) => [entry, ...structsOf(entry.fields)]);
}

/** Parts of a frame have a module of their own. */
const frameParts = new Set(structsOf(server.find(({ name }) => name === 'Frame').fields).map(({ name }) => name));
const modules = ['frame_parts', 'parts'];
const entriesOf = (module) => structs.filter(({ name }) => frameParts.has(name) === (module === 'frame_parts'));

/** Enumerations and parts that the fields of entries refer to, but those of the same module. */
function tsImports(entries) {
  const fields = entries.flatMap((entry) => entry.fields);
  const enums = new Set(fields.filter((field) => field.kind === 'enum').map((field) => `type ${field.item}`));
  const parts = new Set(fields.filter((field) => field.kind === 'struct').map((field) => field.item));
  const lines = modules.map((module) => {
    const names = entriesOf(module).filter((entry) => parts.has(entry.name) && !entries.includes(entry));
    return importLines(
      names.flatMap(({ name }) => [`type ${name}`, `read${name}`, `write${name}`]),
      module,
    );
  });
  return importLines(enums, 'enums') + lines.join('');
}

/** What encodes and decodes messages, and all of the other modules. */
function tsMessages() {
  const names = (entries) => entries.flatMap((entry) => [`type ${entry.name}`, `read${entry.name}`, `write${entry.name}`]);
  return `${banner}import { ByteReader, ByteWriter } from './bytes';
${importLines(names(client), 'client_messages')}${importLines(names(server), 'server_messages')}
export * from './enums';
${modules.map((module) => `export * from './${module}';`).join('\n')}
export * from './client_messages';
export * from './server_messages';

${tsSide('Client', client)}
${tsSide('Server', server)}`;
}

/** Files by path. */
export function typescriptFiles() {
  return {
    'web/src/protocol/enums.ts': tsEnums(),
    'web/src/protocol/frame_parts.ts': tsEntries(entriesOf('frame_parts'), false),
    'web/src/protocol/parts.ts': tsEntries(entriesOf('parts'), false),
    'web/src/protocol/client_messages.ts': tsEntries(client, true),
    'web/src/protocol/server_messages.ts': tsEntries(server, true),
    'web/src/protocol/messages.ts': tsMessages(),
  };
}
