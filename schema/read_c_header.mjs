// Reads the headers of the C API: a small part of C, as clang-format writes it. Every declaration needs a doc comment.

/** Comments and declarations of a header, without what is for the preprocessor or for C++. */
function withoutPreprocessor(text) {
  return text
    .replace(/#ifdef __cplusplus\n[^#]*#endif\n/g, '')
    .replace(/\/\*[^]*?\*\//g, '')
    .replace(/^#.*(\\\n.*)*$/gm, '');
}

/** The text as tokens: {doc}, {after} for comments, {word} for the rest. */
function tokensOf(text) {
  const tokens = [];
  const pattern = /\/\/\/<([^\n]*)|\/\/\/([^\n]*)|([A-Za-z_]\w*|\d+|[{}()\[\];,=*])|(\s+)|(.)/g;
  for (const [, after, doc, word, , other] of text.matchAll(pattern)) {
    if (other !== undefined) throw new Error(`found "${other}", expected a part of a declaration`);
    const last = tokens[tokens.length - 1];
    if (after !== undefined && last?.after !== undefined) last.after += ` ${after.trim()}`;
    else if (after !== undefined) tokens.push({ after: after.trim() });
    else if (doc !== undefined && last?.doc !== undefined) last.doc += ` ${doc.trim()}`;
    else if (doc !== undefined) tokens.push({ doc: doc.trim() });
    else if (word !== undefined) tokens.push({ word });
  }
  return tokens;
}

/** Walks over tokens. */
class Reader {
  constructor(tokens) {
    this.tokens = tokens;
    this.at = 0;
  }
  get done() {
    return this.at >= this.tokens.length;
  }
  peek() {
    return this.tokens[this.at]?.word;
  }
  next() {
    return this.tokens[this.at++]?.word;
  }
  take(word) {
    const found = this.next();
    if (found !== word) throw new Error(`found "${found}", expected "${word}"`);
  }
  /** The comment before a declaration. */
  doc() {
    const token = this.tokens[this.at];
    if (token?.doc === undefined) return '';
    this.at += 1;
    return token.doc;
  }
  /** The comment behind a declaration. */
  after() {
    const token = this.tokens[this.at];
    if (token?.after === undefined) return '';
    this.at += 1;
    return token.after;
  }
}

/** A type as C spells it: "const MusterVec2**". */
function typeOf(reader) {
  let type = '';
  while (reader.peek() === 'const') type += `${reader.next()} `;
  type += reader.next();
  for (;;) {
    if (reader.peek() === '*') type += reader.next();
    else if (reader.peek() === 'const') type += ` ${reader.next()}`;
    else return type;
  }
}

function parametersOf(reader) {
  const parameters = [];
  reader.take('(');
  while (reader.peek() !== ')') {
    const type = typeOf(reader);
    if (type === 'void') break;
    const parameter = { name: reader.next(), type };
    if (/^out[A-Z]/.test(parameter.name)) parameter.out = true;
    parameters.push(parameter);
    if (reader.peek() === ',') reader.next();
  }
  reader.take(')');
  addParameterCounts(parameters);
  return parameters;
}

/** `RETURN (*NAME)(PARAMETERS)`, where RETURN was read. */
function callbackOf(reader, returns) {
  reader.take('(');
  reader.take('*');
  const name = reader.next();
  reader.take(')');
  return { name, returns, parameters: parametersOf(reader) };
}

function fieldOf(reader) {
  let doc = reader.doc();
  const type = typeOf(reader);
  const field = reader.peek() === '(' ? { ...callbackOf(reader, type), type: 'function' } : { name: reader.next(), type };
  if (reader.peek() === '[') {
    reader.next();
    field.length = Number(reader.next());
    reader.take(']');
  }
  reader.take(';');
  doc ||= reader.after();
  return { ...field, doc };
}

const singularOf = (name) => name.replace(/ies$/, 'y').replace(/(ch|sh|ss)es$/, '$1').replace(/s$/, '');
const isArray = (type) => type.endsWith('*') && type !== 'const char*' && type !== 'void*';

/** Gives arrays their count: `points` has `pointCount`; arrays without one of their name have the next count that is nobody's
 * by name, or `count`. */
function addCounts(fields) {
  const names = new Set(fields.map((field) => field.name));
  const byName = (field) => [`${singularOf(field.name)}Count`, `${field.name}Count`].find((name) => names.has(name));
  const arrays = fields.filter((field) => isArray(field.type));
  const claimed = new Set(arrays.map(byName).filter(Boolean));
  for (const field of arrays) {
    const behind = fields.slice(fields.indexOf(field) + 1);
    const next = behind.find(({ name }) => name.endsWith('Count'))?.name;
    const count = byName(field) ?? (next && !claimed.has(next) ? next : names.has('count') ? 'count' : undefined);
    if (count) field.count = count;
  }
}

/** The same for parameters: `outPoints` has `outCount`, `ids` has `idCount`, bytes and text have `size`. */
function addParameterCounts(parameters) {
  const names = new Set(parameters.map(({ name }) => name));
  for (const parameter of parameters) {
    const own = `${singularOf(parameter.name)}Count`;
    if (/^const (char|uint8_t)\*$/.test(parameter.type) && parameters[parameters.indexOf(parameter) + 1]?.name === 'size')
      parameter.count = 'size';
    else if (isArray(parameter.type) && names.has(own)) parameter.count = own;
    else if (parameter.out && /(\*|const)\*$/.test(parameter.type) && names.has('outCount')) parameter.count = 'outCount';
  }
}

function structOf(reader, doc, kind) {
  const name = reader.next();
  reader.take('{');
  const fields = [];
  while (reader.peek() !== '}') fields.push(fieldOf(reader));
  reader.take('}');
  reader.take(name);
  reader.take(';');
  addCounts(fields);
  return { name, kind, doc, fields };
}

function valuesOf(reader, doc) {
  const name = reader.next();
  reader.take('{');
  const values = [];
  while (reader.peek() !== '}') {
    const value = { name: reader.next() };
    reader.take('=');
    value.value = Number(reader.next());
    if (reader.peek() === ',') reader.next();
    value.doc = reader.after();
    values.push(value);
  }
  reader.take('}');
  reader.take(';');
  return { name, doc, values };
}

function typedefOf(reader, doc) {
  if (reader.peek() === 'struct' || reader.peek() === 'union') {
    const kind = reader.next();
    return { list: 'structs', entry: structOf(reader, doc, kind) };
  }
  const type = typeOf(reader);
  if (reader.peek() === '(') {
    const callback = callbackOf(reader, type);
    reader.take(';');
    return { list: 'callbacks', entry: { ...callback, doc } };
  }
  const name = reader.next();
  reader.take(';');
  return { list: 'integers', entry: { name, type, doc: doc || reader.after() } };
}

/** The declarations of one header: {list, entry}, in their order. */
export function parseHeader(text) {
  const reader = new Reader(tokensOf(withoutPreprocessor(text)));
  const found = [];
  while (!reader.done) {
    const doc = reader.doc();
    const word = reader.next();
    if (word === 'typedef') {
      found.push(typedefOf(reader, doc));
    } else if (word === 'enum') {
      found.push({ list: 'values', entry: valuesOf(reader, doc) });
    } else if (word === 'MUSTER_API') {
      const returns = typeOf(reader);
      const name = reader.next();
      const parameters = parametersOf(reader);
      reader.take(';');
      found.push({ list: 'functions', entry: { name, returns, parameters, doc } });
    } else {
      throw new Error(`found "${word}", expected a declaration`);
    }
  }
  return found;
}
