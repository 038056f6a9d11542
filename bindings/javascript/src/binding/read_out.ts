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
export function checkMoment(what: string, owner: Owner, epoch: number): void {
  if (owner.epoch !== epoch)
    throw new MusterError(Status.InvalidArgument, `${what}: found what was read before a later step or the end, expected it to be read again`);
}

abstract class LazyStruct {
  abstract readonly layout: Layout;
  private readonly known_ = new Map<string, unknown>();
  private readonly epoch_: number;

  constructor(
    private readonly decoder_: Decoder,
    /** The struct's own bytes. */
    private readonly view_: DataView,
    private readonly owner_: Owner,
  ) {
    this.epoch_ = owner_.epoch;
  }

  read(field: Field): unknown {
    checkMoment(this.layout.name, this.owner_, this.epoch_);
    const known = this.known_.get(field.name);
    // Views are of a buffer that is gone once the memory has grown.
    if (known !== undefined && (!isView(field) || (known as ArrayBufferView).buffer === this.decoder_.memory.bytes.buffer)) return known;
    const made = this.decoder_.field(this.layout, field, 0, this.owner_, this.view_);
    this.known_.set(field.name, made);
    return made;
  }

  copy(): object {
    return Object.fromEntries(this.layout.fields.map((field) => [field.name, copyOf(this.read(field))]));
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

type LazyClass = new (decoder: Decoder, view: DataView, owner: Owner) => LazyStruct;

const kClasses = new Map<string, LazyClass>();

function classOf(layout: Layout): LazyClass {
  let made = kClasses.get(layout.name);
  if (!made) {
    made = class extends LazyStruct {
      readonly layout = layout;
    };
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
  return new (classOf(layout))(decoder, new DataView(bytes.buffer), owner);
}
