// Where the fields of the C API's structs stand in WebAssembly's memory (wasm32): sizes, alignments and offsets.

const kScalars = {
  uint8_t: [1, 'u8'],
  uint16_t: [2, 'u16'],
  int32_t: [4, 'i32'],
  uint32_t: [4, 'u32'],
  uint64_t: [8, 'u64'],
  size_t: [4, 'u32'],
  float: [4, 'f32'],
  double: [8, 'f64'],
  bool: [1, 'bool'],
};

const up = (at, align) => Math.ceil(at / align) * align;

/** The API, by names. */
export class Types {
  constructor(api) {
    this.structs = new Map(api.structs.map((struct) => [struct.name, struct]));
    this.integers = new Map(api.integers.map((integer) => [integer.name, integer]));
    this.callbacks = new Map(api.callbacks.map((callback) => [callback.name, callback]));
    this.placed_ = new Map();
  }

  /** 'u8', 'f64'... of a type that is one number; undefined for others. */
  scalar(type) {
    return kScalars[this.integers.get(type)?.type ?? type]?.[1];
  }

  sizeOf(type) {
    if (type.endsWith('*') || type === 'function' || this.callbacks.has(type)) return { size: 4, align: 4 };
    const scalar = kScalars[this.integers.get(type)?.type ?? type];
    if (scalar) return { size: scalar[0], align: scalar[0] };
    return this.place(type);
  }

  /** {size, align, offsets}; offsets in the order of the fields. */
  place(name) {
    const known = this.placed_.get(name);
    if (known) return known;
    const struct = this.structs.get(name);
    if (!struct) throw new Error(`type ${name}: found no description, expected one`);
    let [end, most, align] = [0, 0, 1];
    const offsets = struct.fields.map((field) => {
      const one = this.sizeOf(field.type);
      const at = struct.kind === 'union' ? 0 : up(end, one.align);
      end = at + one.size * (field.length ?? 1);
      most = Math.max(most, end);
      align = Math.max(align, one.align);
      return at;
    });
    const placed = { size: up(most, align), align, offsets };
    this.placed_.set(name, placed);
    return placed;
  }

  /** The scalar of a struct whose fields are all of one kind without gaps, else undefined: MusterVec2 is two f64. */
  flat(name) {
    const kinds = new Set();
    const collect = (type) => {
      const scalar = this.scalar(type);
      if (scalar || type.endsWith('*') || !this.structs.has(type)) return void kinds.add(scalar);
      for (const field of this.structs.get(type).fields) collect(field.type);
    };
    collect(name);
    const [only] = kinds;
    return kinds.size === 1 && only !== 'bool' && only !== 'u64' ? only : undefined;
  }
}
