// A long array of structs in the module's memory: rows are decoded one by one, or one field of all of them is copied.

import { wrongValue } from '../muster_error.js';
import type { Decoder } from './decoder.js';
import { layoutOf, scalarOf, sizeOf, type Layout, type NumberArray } from './layout.js';
import { checkEpoch, type Owner } from './read_out.js';

/** Valid until its owner steps, goes back or ends, as a read-out. */
export class Rows<T> implements Iterable<T> {
  private readonly epoch_: number;

  /** @internal */
  constructor(
    private readonly decoder_: Decoder,
    private readonly layout_: Layout,
    private readonly at_: number,
    readonly length: number,
    private readonly owner_: Owner,
  ) {
    this.epoch_ = owner_.epoch;
  }

  /** One row, counted from 0. */
  at(index: number): T {
    this.check();
    if (!Number.isInteger(index) || index < 0 || index >= this.length)
      throw wrongValue('index', index, `a whole number from 0 to ${this.length - 1}`);
    return this.decoder_.one(this.layout_.name, this.at_ + index * this.layout_.size, this.owner_) as T;
  }

  *[Symbol.iterator](): Iterator<T> {
    for (let k = 0; k < this.length; k += 1) yield this.at(k);
  }

  /**
   * One field of all rows as numbers, one row after the other: 'position' gives x, y of each. They are copied into a new array, or
   * into `into`, which must be of the same kind and long enough.
   */
  column(name: keyof T & string, into?: NumberArray): NumberArray {
    this.check();
    const field = this.layout_.byName.get(name);
    const nested = field && !scalarOf(field.type) ? layoutOf(field.type).flat : field?.type;
    const make = nested ? scalarOf(nested)?.array : undefined;
    if (!field || !nested || !make)
      throw wrongValue('name', name, `one of ${[...this.layout_.byName.keys()].join(', ')}`);
    const each = sizeOf(field.type) / sizeOf(nested);
    const stride = this.layout_.size / sizeOf(nested);
    const result = into ?? new make(new ArrayBuffer(this.length * sizeOf(field.type)), 0, this.length * each);
    if (!(result instanceof make) || result.length < this.length * each)
      throw wrongValue('into', result, `a ${make.name} of at least ${this.length * each} numbers`);
    if (this.length === 0) return result;
    const source = this.decoder_.numbers(nested, this.at_ + field.at, (this.length - 1) * stride + each);
    for (let row = 0, to = 0; row < this.length; row += 1)
      for (let k = 0; k < each; k += 1, to += 1) result[to] = source[row * stride + k]!;
    return result;
  }

  private check(): void {
    checkEpoch(this.layout_.name, this.owner_, this.epoch_);
  }
}
