// Values of JavaScript as structs of C. Every wrong value is named with its place: "def.groups[1].count: found ...".

import { kBodies } from '../generated/layouts.js';
import { wrongValue } from '../muster_error.js';
import type { Arena } from './arena.js';
import {
  kPointer,
  layoutOf,
  scalarOf,
  sizeOf,
  type Field,
  type Layout,
  type NumberArray,
  type Scalar,
} from './layout.js';
import type { ModuleMemory } from './module_memory.js';
import type { NativeFunction } from './module_types.js';

type Fields = Readonly<Record<string, unknown>>;

export interface Span {
  readonly at: number;
  readonly count: number;
}

const kNone: Span = { at: 0, count: 0 };

export class Encoder {
  private readonly utf8_ = new TextEncoder();

  constructor(
    private readonly memory_: ModuleMemory,
    private readonly arena_: Arena,
    private readonly native_: (name: string) => NativeFunction,
  ) {}

  /** A number as C takes it. Throws what is wrong with it. */
  number(type: string, value: unknown, place: string): number {
    const scalar = scalarOf(type)!;
    if (type === 'bool') {
      if (typeof value !== 'boolean') throw wrongValue(place, value, 'true or false');
      return value ? 1 : 0;
    }
    if (typeof value !== 'number') throw wrongValue(place, value, 'a number');
    if (scalar.range) {
      const [least, most] = scalar.range;
      if (!Number.isInteger(value) || value < least || value > most)
        throw wrongValue(place, value, `a whole number from ${least} to ${most}`);
    }
    return value;
  }

  /** Bytes with a zero behind them. */
  bytes(bytes: Uint8Array): Span {
    const at = this.arena_.take(bytes.length + 1);
    this.memory_.bytes.set(bytes, at);
    return { at, count: bytes.length };
  }

  /** A text that ends with a zero; null for none. */
  text(value: unknown, place: string): Span {
    if (typeof value !== 'string') throw wrongValue(place, value, 'a text');
    if (value.includes('\0')) throw wrongValue(place, value, 'a text without zero characters');
    return this.bytes(this.utf8_.encode(value));
  }

  struct(type: string, value: unknown, place: string): number {
    const at = this.arena_.take(layoutOf(type).size);
    this.fill(layoutOf(type), at, value, place, false);
    return at;
  }

  list(type: string, value: unknown, place: string): Span {
    const layout = scalarOf(type) ? null : layoutOf(type);
    const numbers = layout ? layout.flat : type;
    if (numbers && ArrayBuffer.isView(value)) {
      const perItem = layout ? layout.size / sizeOf(numbers) : 1;
      return this.numbers(scalarOf(numbers)!, perItem, value, place, layout !== null);
    }
    if (!Array.isArray(value)) throw wrongValue(place, value, 'an array');
    if (value.length === 0) return kNone;
    const size = sizeOf(type);
    const at = this.arena_.take(size * value.length);
    value.forEach((one: unknown, k) => {
      const where = `${place}[${k}]`;
      if (layout) this.fill(layout, at + k * size, one, where, false);
      else scalarOf(type)!.set(this.memory_.view, at + k * size, this.number(type, one, where));
    });
    return { at, count: value.length };
  }

  /** An array of numbers as it is: of one kind, for structs of that kind; converted, for numbers. */
  private numbers(scalar: Scalar, perItem: number, value: ArrayBufferView, place: string, exact: boolean): Span {
    const wanted = scalar.array!;
    if (value instanceof DataView || (exact && !(value instanceof wanted)))
      throw wrongValue(place, value, `a ${wanted.name}`);
    const given = value as NumberArray;
    if (given.length % perItem !== 0) throw wrongValue(`${place}.length`, given.length, `a multiple of ${perItem}`);
    if (given.length === 0) return kNone;
    const at = this.arena_.take(given.length * scalar.size);
    if (scalar.range && !(given instanceof wanted))
      for (let k = 0; k < given.length; k += 1) this.inRange(scalar, given[k]!, `${place}[${k}]`);
    new wanted(this.memory_.bytes.buffer, at, given.length).set(given);
    return { at, count: given.length / perItem };
  }

  private inRange({ range }: Scalar, value: number, place: string): void {
    const [least, most] = range!;
    if (!Number.isInteger(value) || value < least || value > most)
      throw wrongValue(place, value, `a whole number from ${least} to ${most}`);
  }

  /** Sets the defaults and then what is given. `lenient`: the defaults are there already. */
  private fill(layout: Layout, at: number, value: unknown, place: string, lenient: boolean): void {
    if (typeof value !== 'object' || value === null || Array.isArray(value) || ArrayBuffer.isView(value))
      throw wrongValue(place, value, `an object, as ${layout.name} describes it`);
    const given = value as Fields;
    for (const name of Object.keys(given))
      if (!layout.byName.has(name))
        throw wrongValue(place, name, `no other fields than ${[...layout.byName.keys()].join(', ')}`);
    if (layout.name === 'Command') return this.command(layout, at, given, place);
    if (layout.maker) this.native_(layout.maker)(at);
    for (const field of layout.fields) {
      const one = given[field.name];
      const where = `${place}.${field.name}`;
      if (one !== undefined) this.field(field, at, one, where);
      else if (!lenient && !layout.maker && isNeeded(field)) throw wrongValue(where, one, kindOf(field));
    }
  }

  private command(layout: Layout, at: number, given: Fields, place: string): void {
    const kind = this.number('i32', given['kind'], `${place}.kind`);
    const body = kBodies[kind];
    if (body === undefined) throw wrongValue(`${place}.kind`, kind, `a CommandKind, 0 to ${kBodies.length - 1}`);
    this.native_(layout.maker!)(at, kind);
    for (const field of layout.fields) {
      const one = given[field.name];
      if (one === undefined) continue;
      if (field.shape !== 'body') this.field(field, at, one, `${place}.${field.name}`);
      else this.fill(layoutOf(body), at + field.at, one, `${place}.${field.name}`, true);
    }
  }

  private field(field: Field, at: number, value: unknown, place: string): void {
    const { type, shape, extra } = field;
    const here = at + field.at;
    const number = (where: number, what: number): void => this.memory_.view.setUint32(where, what, true);
    if (shape === 'has' || shape === 'given') this.memory_.view.setUint8(at + extra, value === null ? 0 : 1);
    if (shape === 'list' || shape === 'given') {
      const { at: items, count } = value === null ? kNone : this.list(type, value, place);
      number(here, items);
      number(shape === 'list' ? at + extra : here + kPointer, count);
    } else if (shape === 'maybe') {
      number(here, value === null ? 0 : this.struct(type, value, place));
    } else if (shape === 'has' && type !== 'text') {
      if (value !== null) this.one(type, here, value, place);
    } else if (shape === 'fixed') {
      if (!Array.isArray(value) || value.length !== extra) throw wrongValue(place, value, `an array of ${extra}`);
      value.forEach((one: unknown, k) => this.one(type, here + k * sizeOf(type), one, `${place}[${k}]`));
    } else if (type === 'text') {
      const { at: text, count } = value === null || value === '' ? kNone : this.text(value, place);
      number(here, text);
      if (shape === 'counted') number(at + extra, count);
    } else {
      this.one(type, here, value, place);
    }
  }

  private one(type: string, at: number, value: unknown, place: string): void {
    const scalar = scalarOf(type);
    if (!scalar) return this.fill(layoutOf(type), at, value, place, false);
    if (type !== 'u64') return scalar.set(this.memory_.view, at, this.number(type, value, place));
    const whole = typeof value === 'number' && Number.isSafeInteger(value) ? BigInt(value) : value;
    if (typeof whole !== 'bigint' || whole < 0n || whole >= 1n << 64n)
      throw wrongValue(place, value, 'a whole number from 0 to 2^64 - 1');
    this.memory_.view.setBigUint64(at, whole, true);
  }
}

/** True for fields without a default: numbers, and structs that have none. */
function isNeeded({ type, shape }: Field): boolean {
  if (shape === 'fixed') return true;
  if (shape !== 'one' || type === 'text' || type === 'bool') return false;
  return scalarOf(type) !== undefined || layoutOf(type).maker === null;
}

function kindOf({ type, shape, extra }: Field): string {
  if (shape === 'fixed') return `an array of ${extra}`;
  return scalarOf(type) ? 'a number' : `an object, as ${type} describes it`;
}
