// Where the fields of structs stand in memory, read from the generated table when first needed.

import { kLayouts } from '../generated/layouts.js';

export type ScalarName = 'u8' | 'u16' | 'i32' | 'u32' | 'u64' | 'f32' | 'f64' | 'bool';
export type NumberArray = Uint8Array | Uint16Array | Int32Array | Uint32Array | Float32Array | Float64Array;
export type NumberArrayMaker = new (buffer: ArrayBufferLike, at: number, length: number) => NumberArray;

/** One number in memory. */
export interface Scalar {
  readonly size: number;
  get(view: DataView, at: number): number | bigint | boolean;
  set(view: DataView, at: number, value: number): void;
  /** Of arrays of it; none for 64-bit integers. */
  readonly array?: NumberArrayMaker;
  /** The range of whole numbers; none for fractions. */
  readonly range?: readonly [number, number];
}

const kScalars: Readonly<Record<ScalarName, Scalar>> = {
  u8: {
    size: 1,
    get: (v, at) => v.getUint8(at),
    set: (v, at, n) => v.setUint8(at, n),
    array: Uint8Array,
    range: [0, 255],
  },
  u16: {
    size: 2,
    get: (v, at) => v.getUint16(at, true),
    set: (v, at, n) => v.setUint16(at, n, true),
    array: Uint16Array,
    range: [0, 65535],
  },
  i32: {
    size: 4,
    get: (v, at) => v.getInt32(at, true),
    set: (v, at, n) => v.setInt32(at, n, true),
    array: Int32Array,
    range: [-2147483648, 2147483647],
  },
  u32: {
    size: 4,
    get: (v, at) => v.getUint32(at, true),
    set: (v, at, n) => v.setUint32(at, n, true),
    array: Uint32Array,
    range: [0, 4294967295],
  },
  u64: {
    size: 8,
    get: (v, at) => v.getBigUint64(at, true),
    set: (v, at, n) => v.setBigUint64(at, BigInt(n), true),
  },
  f32: {
    size: 4,
    get: (v, at) => v.getFloat32(at, true),
    set: (v, at, n) => v.setFloat32(at, n, true),
    array: Float32Array,
  },
  f64: {
    size: 8,
    get: (v, at) => v.getFloat64(at, true),
    set: (v, at, n) => v.setFloat64(at, n, true),
    array: Float64Array,
  },
  bool: {
    size: 1,
    get: (v, at) => v.getUint8(at) !== 0,
    set: (v, at, n) => v.setUint8(at, n),
    array: Uint8Array,
  },
};

const kScalarsByName: ReadonlyMap<string, Scalar> = new Map(Object.entries(kScalars));

export function scalarOf(type: string): Scalar | undefined {
  return kScalarsByName.get(type);
}

/** Size of a pointer. */
export const kPointer = 4;

/**
 * How a field is stored. one: as it is. list: pointer and count. maybe: a pointer that may be null. has: with a flag. given: a list
 * with a flag, its count behind its pointer. fixed: so many. counted: text and count. body: that of the kind of a command.
 */
export type Shape = 'one' | 'list' | 'maybe' | 'has' | 'given' | 'fixed' | 'counted' | 'body';

export interface Field {
  readonly name: string;
  readonly at: number;
  /** A scalar, 'text' or a struct. */
  readonly type: string;
  /** Of fields that are one number. */
  readonly number: Scalar | null;
  readonly shape: Shape;
  /** Where the count, the flag or the kind stands; how many there are. */
  readonly extra: number;
}

export interface Layout {
  readonly name: string;
  /** How it is read: lazily; or as an object whose arrays hold objects; or whose arrays are arrays of numbers where they can be. */
  readonly mode: 'readOut' | 'definition' | 'copy';
  readonly size: number;
  /** The scalar of a struct whose arrays are shown as numbers. */
  readonly flat: ScalarName | null;
  /** True where long arrays of it are decoded row by row. */
  readonly rows: boolean;
  /** The C function that sets its defaults. */
  readonly maker: string | null;
  readonly fields: readonly Field[];
  readonly byName: ReadonlyMap<string, Field>;
}

function fieldOf(text: string): Field {
  const [name = '', at, type = '', shape = 'one', extra] = text.split(' ');
  const number = shape === 'one' ? (scalarOf(type) ?? null) : null;
  return { name, at: Number(at), type, number, shape: shape as Shape, extra: Number(extra ?? 0) };
}

function parsed(name: string, text: string): Layout {
  const [head = '', ...rest] = text.split(' | ');
  const [mode, size, flat, rows, maker] = head.split(' ');
  const fields = rest.map(fieldOf);
  return {
    name,
    mode: mode as Layout['mode'],
    size: Number(size),
    flat: flat === '-' ? null : (flat as ScalarName),
    rows: rows === 'rows',
    maker: maker === '-' || maker === undefined ? null : maker,
    fields,
    byName: new Map(fields.map((field) => [field.name, field])),
  };
}

const kKnown = new Map<string, Layout>();

export function layoutOf(name: string): Layout {
  let layout = kKnown.get(name);
  if (!layout) {
    const text = kLayouts[name];
    if (text === undefined) throw new Error(`found no layout of ${name}, expected one`);
    layout = parsed(name, text);
    kKnown.set(name, layout);
  }
  return layout;
}

/** The size of one value of a type. */
export function sizeOf(type: string): number {
  return type === 'text' ? 4 : (scalarOf(type)?.size ?? layoutOf(type).size);
}
