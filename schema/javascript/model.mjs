// The C API as TypeScript sees it: names, kinds of values, and which functions become methods of which class.
import { Types } from './wasm_layout.mjs';

/** Handles and structs whose names would be taken twice, or hide a name of the language. */
const kRenamed = { MusterTake: 'TakeContents', MusterBvh: 'BvhContents', MusterMapId: 'GridMap' };

/** Structs that are read lazily, with views of the module's memory. */
const kReadOuts = new Set(['MusterCharacters', 'MusterGroup', 'MusterTake', 'MusterBvh', 'MusterClip']);

/** Structs whose arrays are shown as plain numbers, one after the other. */
const kNumbers = new Set([
  'MusterVec2',
  'MusterVec3',
  'MusterQuat',
  'MusterTransform',
  'MusterTriangle',
  'MusterBodyPose',
  'MusterTravel',
]);

/** Structs whose arrays in read-outs may be long: their rows are decoded one by one. */
const kRows = new Set(['MusterBody', 'MusterMeshPoint', 'MusterMotionState']);

/** Functions that have no verb, with the reason. */
export const kLeftOut = {
  muster_set_allocator: 'memory is the module’s own',
  muster_allocator_covers_engine: 'memory is the module’s own',
  muster_default_task_runner: 'the module has one thread',
  muster_world_create_on: 'the module has one thread',
  muster_world_restore_on: 'the module has one thread',
};

/** Functions that the binding itself calls. */
export const kWithin = new Set([
  'muster_last_error',
  'muster_free_buffer',
  'muster_set_log',
  'muster_command_list_get',
  'muster_command_list_destroy',
]);

/** Arrays of a fixed length that only a comment tells of. */
const kFixed = { muster_skeleton: 21, muster_joint_transforms: 21, muster_motion_joints: 21 };

/** Functions after which read-outs of their first argument are no longer valid. */
const kMoves =
  /^muster_(world_(step|rewind|destroy)|motion_(update|restart|go_back|destroy)|(clips|take|bvh|scenario|map)_destroy)$/;

const kHidden = new Set(['MusterAllocator', 'MusterBuffer', 'MusterTaskRunner']);

export const pascal = (words) => words.map((word) => word[0].toUpperCase() + word.slice(1).toLowerCase()).join('');
const lowerFirst = (text) => text[0].toLowerCase() + text.slice(1);
const camel = (words) => lowerFirst(pascal(words));
const bare = (type) => type.replace(/^const /, '').replace(/( const)?\*.*$/, '');
const singular = (name) => name.replace(/ies$/, 'y').replace(/s$/, '');

const kPrefixes = {
  MusterClipLibraryId: ['clips'],
  MusterMotionMomentId: ['motion', 'moment'],
  MusterTakeWriterId: ['take', 'writer'],
};

/** The words that the functions of a handle begin with. */
const prefixOf = (handle) => kPrefixes[handle] ?? [handle.replace(/^Muster|Id$/g, '').toLowerCase()];

export class Model {
  constructor(api) {
    this.api = api;
    this.types = new Types(api);
    this.handles = new Set(api.structs.filter(({ handle }) => handle).map(({ name }) => name));
    this.makers = new Map();
    for (const { name, returns } of api.functions)
      if (name.startsWith('muster_default_')) this.makers.set(returns, name);
    this.given = this.reachableInputs();
    this.structs = api.structs
      .filter(({ name, handle, kind }) => !handle && kind === 'struct' && !kHidden.has(name))
      .map((struct) => this.structOf(struct));
    this.functions = api.functions.map((one) => this.functionOf(one));
  }

  nameOf(type) {
    return kRenamed[type] ?? type.replace(/^Muster/, '').replace(/Id$/, (id) => (this.handles.has(type) ? '' : id));
  }

  isReadOut(type) {
    return kReadOuts.has(type);
  }

  /** Structs that callers give, at any depth. */
  reachableInputs() {
    const found = new Set();
    const visit = (type) => {
      const struct = this.types.structs.get(type);
      if (!struct || struct.handle || found.has(type)) return;
      found.add(type);
      for (const field of struct.fields) visit(bare(field.type));
    };
    for (const { parameters, name } of this.api.functions)
      if (!(name in kLeftOut)) for (const { type, out } of parameters) if (!out) visit(bare(type));
    return found;
  }

  /** How a struct is read: 'readOut', 'definition' (as it may be given) or 'copy'. */
  modeOf(type) {
    if (kReadOuts.has(type)) return 'readOut';
    return this.given.has(type) ? 'definition' : 'copy';
  }

  structOf(struct) {
    const { name, doc, fields } = struct;
    const { size, offsets } = this.types.place(name);
    const at = (field) => offsets[fields.findIndex((one) => one.name === field)];
    const counts = new Set(fields.map(({ count }) => count).filter((count) => count && count !== 'count'));
    for (const { name: of, type } of fields)
      if (type === 'const char*' && at(`${singular(of)}Count`) !== undefined) counts.add(`${singular(of)}Count`);
    const flagged = new Map(fields.map((one) => [`has${one.name[0].toUpperCase()}${one.name.slice(1)}`, one.name]));
    const isFlag = (field) => field.type === 'bool' && flagged.has(field.name);
    const shown = fields.filter((field) => field.name !== 'structVersion' && !counts.has(field.name) && !isFlag(field));
    return {
      type: name,
      name: this.nameOf(name),
      doc,
      size,
      mode: this.modeOf(name),
      flat: kNumbers.has(name) ? this.types.flat(name) : undefined,
      rows: kRows.has(name),
      maker: this.makers.get(name),
      given: this.given.has(name),
      fields: shown.map((field) => ({ ...this.fieldOf(field, at), doc: this.docOfField(field, fields) })),
    };
  }

  docOfField(field, fields) {
    const flag = fields.find(({ name }) => name === `has${field.name[0].toUpperCase()}${field.name.slice(1)}`);
    return flag ? `${field.doc} Null: ${flag.doc.replace(/^False: /, '')}` : field.doc;
  }

  /** {name, at, type, shape, extra}: where and what a field is. */
  fieldOf(field, at) {
    const one = { name: field.name, at: at(field.name), type: field.type, shape: 'one' };
    const flag = at(`has${field.name[0].toUpperCase()}${field.name.slice(1)}`);
    if (field.type === 'const char*') {
      const count = at(`${singular(field.name)}Count`);
      const shape = count !== undefined ? { shape: 'counted', extra: count } : flag !== undefined ? { shape: 'has', extra: flag } : {};
      return { ...one, type: 'text', ...shape };
    }
    if (field.type.endsWith('*')) {
      const type = bare(field.type);
      if (field.count && flag !== undefined) return { ...one, type, shape: 'given', extra: flag };
      return field.count ? { ...one, type, shape: 'list', extra: at(field.count) } : { ...one, type, shape: 'maybe' };
    }
    if (field.length) return { ...one, shape: 'fixed', extra: field.length };
    if (this.types.structs.get(field.type)?.kind === 'union') return { ...one, shape: 'body', extra: at('kind') };
    return flag === undefined ? one : { ...one, shape: 'has', extra: flag };
  }

  /** Kinds of commands and their bodies: {value, kind, member, type}. */
  bodies() {
    const union = this.types.structs.get('MusterCommandBody');
    const values = this.types.integers.get('MusterCommandKind').values.filter(({ name }) => name !== 'MUSTER_COMMAND_COUNT');
    if (values.length !== union.fields.length)
      throw new Error(`MusterCommandBody: found ${union.fields.length} members, expected ${values.length}`);
    return union.fields.map((member, k) => {
      const kind = pascal(values[k].name.replace('MUSTER_COMMAND_', '').split('_'));
      if (values[k].value !== k || lowerFirst(kind) !== member.name)
        throw new Error(`MusterCommandBody.${member.name}: found it at place ${k}, expected ${lowerFirst(kind)}`);
      return { value: k, kind, type: this.nameOf(member.type), doc: values[k].doc };
    });
  }

  /** Where a function goes: {owner, verb, own}: a method of the class `owner`, or, not `own`, of its maker. */
  placeOf({ name, parameters }) {
    const words = name.replace(/^muster_/, '').split('_');
    const begins = (prefix) => prefix.every((word, k) => words[k] === word) && words.length > prefix.length;
    const isClass = (type) => this.handles.has(type) && type !== 'MusterCommandListId';
    const self = parameters.map(({ type }) => type).slice(0, 1).find(isClass);
    const made = parameters.filter(({ out }) => out).map(({ type }) => bare(type)).find(isClass);
    // muster_motion_create() belongs to Motion, though a clip library comes first.
    const own = self !== undefined && (begins(prefixOf(self)) || !made || !begins(prefixOf(made)));
    const owner = own ? self : made;
    if (!owner) return { owner: 'Muster', verb: camel(words), own: true };
    const prefix = prefixOf(owner);
    return { owner: this.nameOf(owner), verb: camel(begins(prefix) ? words.slice(prefix.length) : words), own };
  }

  functionOf(one) {
    const { name, parameters, returns, doc } = one;
    const parts = [];
    for (const parameter of parameters) {
      const skipped = ['size', 'context', 'idCount', 'clipCount', 'commandCount'].includes(parameter.name);
      if (!skipped) parts.push(this.partOf(parameter, one));
    }
    const place = this.placeOf(one);
    if (place.own && place.owner !== 'Muster') parts[0].role = 'self';
    const moves = kMoves.test(name);
    return { name, doc, ...place, moves, returns: this.returnOf(returns, name, parameters), parts };
  }

  returnOf(returns, name, parameters) {
    if (returns === 'MusterStatus') return { role: 'status' };
    if (returns === 'void') return { role: 'void' };
    if (returns === 'const char*') return { role: 'text' };
    if (kFixed[name]) return { role: 'fixed', type: bare(returns), extra: kFixed[name] };
    if (returns.endsWith('*')) return { role: 'list', type: bare(returns), counted: parameters.length === 1 };
    return this.types.scalar(returns) ? { role: 'number', type: returns } : { role: 'struct', type: returns };
  }

  /** One parameter: {name, role, type, extra}. */
  partOf({ name, type, out, count }, { name: of, doc }) {
    if (out) return { ...this.outPart(name, type, count, of), doc };
    const part = { name, type: bare(type) };
    if (this.types.callbacks.has(type)) return { ...part, role: 'callback', type };
    if (type === 'const char*') return { ...part, role: count === 'size' ? 'chars' : 'text' };
    if (type === 'const uint8_t*' && count === 'size') return { ...part, role: 'bytes' };
    if (type.endsWith('*')) return { ...part, role: count ? 'list' : 'struct' };
    if (this.handles.has(type)) return { ...part, role: 'handle' };
    return { ...part, role: this.types.scalar(type) ? 'number' : 'struct' };
  }

  outPart(name, type, count, of) {
    const target = bare(type);
    const part = { name: lowerFirst(name.replace(/^out/, '')), type: target };
    if (name === 'outCount' && target === 'int32_t' && !/_count$/.test(of)) return { ...part, role: 'count' };
    if (target === 'MusterCommandListId') return { ...part, role: 'outCommands' };
    if (this.handles.has(target)) return { ...part, role: 'new' };
    if (target === 'MusterBuffer') return { ...part, role: name === 'outText' ? 'outChars' : 'outBytes' };
    if (target === 'char') return { ...part, role: 'outTexts' };
    if (kFixed[of]) return { ...part, role: 'outFixed', extra: kFixed[of] };
    if (/\*\*$/.test(type)) {
      if (!count) return { ...part, role: 'outMaybe' };
      return { ...part, role: kRows.has(target) ? 'outRows' : 'outList' };
    }
    return { ...part, role: 'out' };
  }
}
