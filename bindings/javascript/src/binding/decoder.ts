// Structs of C as values of JavaScript. Copies, but for read-outs and rows.

import { kBodies } from '../generated/layouts.js';
import { kPointer, layoutOf, scalarOf, sizeOf, type Field, type Layout, type NumberArray } from './layout.js';
import type { ModuleMemory } from './module_memory.js';
import { makeReadOut, type Owner } from './read_out.js';
import { Rows } from './rows.js';

/** How arrays are shown: as views, as copies, or as arrays of objects. */
export type ListMode = 'readOut' | 'copy' | 'definition';

export class Decoder {
  constructor(readonly memory: ModuleMemory) {}

  /** One value at an address of the module, or in a view of its bytes. */
  one(type: string, at: number, owner: Owner | null, view: DataView = this.memory.view): unknown {
    const scalar = scalarOf(type);
    if (scalar) return scalar.get(view, at);
    if (type === 'text') return this.text(view.getUint32(at, true)) ?? '';
    const layout = layoutOf(type);
    if (layout.mode === 'readOut' && owner) return makeReadOut(layout, this, view, at, owner);
    return this.struct(layout, at, owner, view);
  }

  private struct(layout: Layout, at: number, owner: Owner | null, view: DataView): object {
    const made: Record<string, unknown> = {};
    for (const field of layout.fields) {
      const { name, number } = field;
      made[name] = number ? number.get(view, at + field.at) : this.field(layout, field, at, owner, view);
    }
    return made;
  }

  text(at: number): string | null {
    return at === 0 ? null : this.memory.text(at);
  }

  field({ mode }: Layout, field: Field, start: number, owner: Owner | null, view: DataView): unknown {
    const { type, shape, extra } = field;
    const at = start + field.at;
    const pointer = (): number => view.getUint32(at, true);
    // What belongs to nobody would not be valid for long.
    const listMode = mode === 'readOut' && !owner ? 'copy' : mode;
    if (shape === 'list') return this.list(type, pointer(), view.getInt32(start + extra, true), listMode, owner);
    if (shape === 'given')
      return view.getUint8(start + extra) === 0
        ? null
        : this.list(type, pointer(), view.getInt32(at + kPointer, true), listMode, owner);
    if (shape === 'maybe') return pointer() === 0 ? null : this.one(type, pointer(), owner);
    if (shape === 'has') return view.getUint8(start + extra) === 0 ? null : this.one(type, at, owner, view);
    if (shape === 'fixed')
      return Array.from({ length: extra }, (_, k) => this.one(type, at + k * sizeOf(type), owner, view));
    if (shape === 'counted') {
      const bytes = this.memory.copy(pointer(), view.getInt32(start + extra, true));
      return new TextDecoder().decode(bytes);
    }
    if (shape === 'body') return this.one(kBodies[view.getInt32(start + extra, true)]!, at, owner, view);
    return this.one(type, at, owner, view);
  }

  list(type: string, at: number, count: number, mode: ListMode, owner: Owner | null): unknown {
    const layout = scalarOf(type) || type === 'text' ? null : layoutOf(type);
    const numbers = layout ? layout.flat : type;
    if (mode !== 'definition' && numbers && scalarOf(numbers)?.array) {
      const view = this.numbers(numbers, at, layout ? count * (layout.size / sizeOf(numbers)) : count);
      return mode === 'readOut' ? view : view.slice();
    }
    if (layout?.rows && mode === 'readOut' && owner) return new Rows(this, layout, at, count, owner);
    const size = sizeOf(type);
    return Array.from({ length: count }, (_, k) => this.one(type, at + k * size, owner));
  }

  /** Numbers as they lie in memory, without a copy. */
  numbers(type: string, at: number, length: number): NumberArray {
    const make = scalarOf(type)!.array!;
    return length === 0 ? new make(new ArrayBuffer(0), 0, 0) : new make(this.memory.bytes.buffer, at, length);
  }
}
