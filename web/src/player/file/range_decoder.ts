// Reads numbers that an adaptive range coder wrote (src/files/export/player/range_encoder.h has the writer, with the same models).

const kShareBits = 15;
const kLeastRange = 1 << 24;
const kQuick = 4;
const kSlow = 7;
const kWhole = 0xffff;
const kLengths = 32;
/** The coder reads so many bytes ahead of what it needs. */
const kAhead = 8;

/** How likely a bit is 0, learnt from the bits before it. */
export class BitModel {
  quick = 1 << 15;
  slow = 1 << 15;
}

/** The models of a whole number: its length in unary, its two leading bits, its sign. */
export class NumberModel {
  readonly length = models(kLengths);
  readonly leading = models(3 * kLengths);
  readonly sign = new BitModel();
}

function models(count: number): readonly BitModel[] {
  return Array.from({ length: count }, () => new BitModel());
}

/** Thrown where bytes cannot be what a writer made. */
export class DamagedFile extends Error {}

export class RangeDecoder {
  private range_ = 0xffffffff;
  private code_ = 0;
  private at_ = 1;

  constructor(private readonly bytes_: Uint8Array) {
    for (let k = 0; k < 4; ++k) this.code_ = ((this.code_ << 8) | this.next()) >>> 0;
  }

  bit(model: BitModel): boolean {
    const one = this.narrow((this.range_ >>> kShareBits) * ((model.quick + model.slow) >> 2));
    if (one) {
      model.quick -= model.quick >> kQuick;
      model.slow -= model.slow >> kSlow;
    } else {
      model.quick += (kWhole - model.quick) >> kQuick;
      model.slow += (kWhole - model.slow) >> kSlow;
    }
    return one;
  }

  /** `count` bits without a model, the highest first. */
  plain(count: number): number {
    let value = 0;
    for (let k = 0; k < count; ++k) value = value * 2 + (this.narrow(this.range_ >>> 1) ? 1 : 0);
    return value;
  }

  /** A number from 0 to 2^32 - 2. */
  natural(model: NumberModel): number {
    let length = 0;
    while (length < kLengths - 1 && this.bit(model.length[length]!)) ++length;
    let value = 1;
    let left = length;
    let seen = 0;
    for (let k = 0; k < 2 && left > 0; ++k, --left) {
      const one = this.bit(model.leading[3 * length + seen]!);
      value = 2 * value + (one ? 1 : 0);
      seen = one ? 2 : 1;
    }
    return value * 2 ** left + this.plain(left) - 1;
  }

  /** A number from 0 to `most`; a larger one means damage. `what` names what is counted. */
  count(model: NumberModel, most: number, what: string): number {
    const value = this.natural(model);
    if (value > most) throw new DamagedFile(`${what}: found ${value}, expected 0 to ${most}`);
    this.check();
    return value;
  }

  /** A number of any sign. */
  whole(model: NumberModel): number {
    const value = this.natural(model);
    return value !== 0 && this.bit(model.sign) ? -value : value;
  }

  /** Fails where more was read than there is. */
  check(): void {
    if (this.at_ > this.bytes_.length + kAhead) throw new DamagedFile('found its end too early');
  }

  private narrow(bound: number): boolean {
    const one = this.code_ >= bound;
    if (one) {
      this.code_ -= bound;
      this.range_ -= bound;
    } else {
      this.range_ = bound;
    }
    while (this.range_ < kLeastRange) {
      this.range_ = (this.range_ << 8) >>> 0;
      this.code_ = ((this.code_ << 8) | this.next()) >>> 0;
    }
    return one;
  }

  private next(): number {
    return this.bytes_[this.at_++] ?? 0;
  }
}
