// TypeScript types of the C API's values: what is read, and, with the ending Init, what may be given.
const kArrays = {
  u8: 'Uint8Array',
  u16: 'Uint16Array',
  i32: 'Int32Array',
  u32: 'Uint32Array',
  f32: 'Float32Array',
  f64: 'Float64Array',
};

export class TypeNames {
  constructor(model) {
    this.model = model;
    this.structs = new Map(model.structs.map((struct) => [struct.type, struct]));
    this.bodies = new Set(model.types.structs.get('MusterCommandBody').fields.map(({ type }) => type));
  }

  /** 'f64', 'text' or the name of a struct: how layouts and signatures spell a type. */
  code(type) {
    return type === 'text' ? 'text' : (this.model.types.scalar(type) ?? this.model.nameOf(type));
  }

  /** One value that is read. */
  one(type) {
    if (type === 'text') return 'string';
    const scalar = this.model.types.scalar(type);
    if (!scalar) return this.model.nameOf(type);
    if (this.model.types.integers.has(type)) return this.model.nameOf(type);
    return { bool: 'boolean', u64: 'bigint' }[scalar] ?? 'number';
  }

  /** An array that is read from a struct of that mode: 'readOut', 'copy' or 'definition'. */
  list(type, mode) {
    const scalar = this.model.types.scalar(type);
    const struct = this.structs.get(type);
    if (mode === 'definition') return scalar ? 'number[]' : `${this.one(type)}[]`;
    if (scalar) return kArrays[scalar];
    if (struct.flat) return kArrays[struct.flat];
    return mode === 'readOut' && struct.rows ? `Rows<${this.one(type)}>` : `readonly ${this.one(type)}[]`;
  }

  /** What a field reads as. */
  field({ type, shape, extra }, mode) {
    if (shape === 'list') return this.list(type, mode);
    if (shape === 'given') return `${this.list(type, mode)} | null`;
    if (shape === 'maybe' || shape === 'has') return `${this.one(type)} | null`;
    if (shape === 'fixed') return this.model.types.scalar(type) ? 'readonly number[]' : `readonly ${this.one(type)}[]`;
    return shape === 'body' ? `CommandBodies[CommandKind] /* ${extra} */` : this.one(type);
  }

  /** True where less may be given than is read. */
  hasInit(type) {
    if (type === 'MusterCommand') return true;
    const struct = this.structs.get(type);
    if (!struct) return false;
    return this.bodies.has(type) || struct.fields.some((field) => this.isOptional(struct, field) || this.hasInit(field.type));
  }

  isOptional(struct, { type, shape }) {
    if (struct.maker || this.bodies.has(struct.type)) return true;
    if (['list', 'maybe', 'has', 'given'].includes(shape) || type === 'text') return true;
    return this.model.types.scalar(type) === 'bool' || Boolean(this.structs.get(type)?.maker);
  }

  /** One value that is given. */
  givenOne(type) {
    if (this.model.types.scalar(type) === 'u64') return 'bigint | number';
    return this.hasInit(type) ? `${this.model.nameOf(type)}Init` : this.one(type);
  }

  givenList(type) {
    if (this.model.types.scalar(type)) return 'ArrayLike<number>';
    const { flat } = this.structs.get(type);
    return `readonly ${this.givenOne(type)}[]${flat ? ` | ${kArrays[flat]}` : ''}`;
  }

  givenField({ type, shape }) {
    if (shape === 'list') return this.givenList(type);
    if (shape === 'given') return `${this.givenList(type)} | null`;
    if (shape === 'maybe' || shape === 'has') return `${this.givenOne(type)} | null`;
    if (shape === 'fixed') return `readonly ${this.givenOne(type)}[]`;
    return type === 'text' ? 'string | null' : this.givenOne(type);
  }
}
