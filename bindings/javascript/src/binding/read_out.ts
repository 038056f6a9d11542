// What is read of a world, a take... without copying it: fields are decoded when they are asked for, arrays of numbers are views
// of the module's memory.

import { Status } from '../generated/enums.js';
import { MusterError } from '../muster_error.js';
import type { Decoder } from './decoder.js';
import { scalarOf, layoutOf, type Field, type Layout } from './layout.js';
import { Rows } from './rows.js';

/** What a read-out belongs to. `epoch` rises whenever its read-outs are no longer valid. */
export interface Owner {
  readonly epoch: number;
}

/** Valid until its owner steps, goes back or ends: after that its fields throw. */
export interface ReadOut {
  /** All fields as copies, which stay. */
  copy(): Omit<this, 'copy'>;
}

/** Throws where the owner has gone on. */
export function checkEpoch(what: string, owner: Owner, epoch: number): void {
  if (owner.epoch !== epoch)
    throw new MusterError(
      Status.InvalidArgument,
      `${what}: found what was read before a later step or the end, expected it to be read again`,
    );
}

/** What it knows of itself is hidden, so that only its fields are seen. */
abstract class LazyStruct {
  readonly #known = new Map<string, unknown>();
  readonly #layout: Layout;
  readonly #decoder: Decoder;
  readonly #view: DataView;
  readonly #owner: Owner;
  readonly #epoch: number;

  /** `view`: the struct's own bytes. */
  constructor(layout: Layout, decoder: Decoder, view: DataView, owner: Owner) {
    this.#layout = layout;
    this.#decoder = decoder;
    this.#view = view;
    this.#owner = owner;
    this.#epoch = owner.epoch;
  }

  read(field: Field): unknown {
    checkEpoch(this.#layout.name, this.#owner, this.#epoch);
    const known = this.#known.get(field.name);
    // Views are of a buffer that is gone once the memory has grown.
    const { buffer } = this.#decoder.memory.bytes;
    if (known !== undefined && (!isView(field) || (known as Uint8Array).buffer === buffer)) return known;
    const made = this.#decoder.field(this.#layout, field, 0, this.#owner, this.#view);
    this.#known.set(field.name, made);
    return made;
  }

  copy(): object {
    return Object.fromEntries(this.#layout.fields.map((field) => [field.name, copyOf(this.read(field))]));
  }

  toJSON(): object {
    return this.copy();
  }
}

function isView({ type, shape }: Field): boolean {
  return shape === 'list' && (scalarOf(type) !== undefined || layoutOf(type).flat !== null);
}

function copyOf(value: unknown): unknown {
  if (ArrayBuffer.isView(value)) return (value as Uint8Array).slice();
  if (value instanceof Rows) return [...(value as Rows<unknown>)];
  return value;
}

type LazyClass = new (layout: Layout, decoder: Decoder, view: DataView, owner: Owner) => LazyStruct;

const kClasses = new Map<string, LazyClass>();

function classOf(layout: Layout): LazyClass {
  let made = kClasses.get(layout.name);
  if (!made) {
    made = class extends LazyStruct {};
    Object.defineProperty(made, 'name', { value: layout.name });
    for (const field of layout.fields)
      Object.defineProperty(made.prototype, field.name, {
        enumerable: true,
        get(this: LazyStruct) {
          return this.read(field);
        },
      });
    kClasses.set(layout.name, made);
  }
  return made;
}

export function makeReadOut(layout: Layout, decoder: Decoder, view: DataView, at: number, owner: Owner): object {
  const bytes = new Uint8Array(view.buffer, view.byteOffset + at, layout.size).slice();
  return new (classOf(layout))(layout, decoder, new DataView(bytes.buffer), owner);
}
