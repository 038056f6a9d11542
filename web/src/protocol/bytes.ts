// Little-endian bytes of messages: what the generated code reads and writes with.

/** A message that does not follow the protocol. */
export class ProtocolError extends Error {
  override name = 'ProtocolError';
}

type Numbers = Uint8Array | Int8Array | Uint16Array | Int16Array | Uint32Array | Float32Array | Float64Array;

/** Reads values in turn; throws ProtocolError where the bytes do not suffice or have no such value. */
export class ByteReader {
  private readonly view_: DataView;
  private at_ = 0;

  constructor(private readonly buffer_: ArrayBuffer) {
    this.view_ = new DataView(buffer_);
  }

  u8(): number {
    return this.view_.getUint8(this.advance(1));
  }
  u16(): number {
    return this.view_.getUint16(this.advance(2), true);
  }
  i16(): number {
    return this.view_.getInt16(this.advance(2), true);
  }
  i32(): number {
    return this.view_.getInt32(this.advance(4), true);
  }
  u32(): number {
    return this.view_.getUint32(this.advance(4), true);
  }
  f32(): number {
    return this.view_.getFloat32(this.advance(4), true);
  }
  f64(): number {
    return this.view_.getFloat64(this.advance(8), true);
  }
  bool(): boolean {
    return this.choice(2) === 1;
  }
  /** A byte below `count`. */
  choice(count: number): number {
    const value = this.u8();
    if (value >= count) throw new ProtocolError(`byte ${this.at_ - 1}: ${value} where 0 to ${count - 1} was expected`);
    return value;
  }
  /** Where a byte stands among these. */
  among(numbers: readonly number[]): number {
    const at = numbers.indexOf(this.u8());
    if (at < 0) throw new ProtocolError(`byte ${this.at_ - 1}: found no kind of that number`);
    return at;
  }
  text(): string {
    const length = this.u32();
    const from = this.advance(length);
    return new TextDecoder().decode(new Uint8Array(this.buffer_, from, length));
  }
  u8s(): Uint8Array {
    return new Uint8Array(this.slice(1));
  }
  i8s(): Int8Array {
    return new Int8Array(this.slice(1));
  }
  u16s(): Uint16Array {
    return new Uint16Array(this.slice(2));
  }
  i16s(): Int16Array {
    return new Int16Array(this.slice(2));
  }
  u32s(): Uint32Array {
    return new Uint32Array(this.slice(4));
  }
  f32s(): Float32Array {
    return new Float32Array(this.slice(4));
  }
  f64s(): Float64Array {
    return new Float64Array(this.slice(8));
  }
  list<T>(read: (reader: ByteReader) => T): T[] {
    const count = this.u32();
    if (count > this.view_.byteLength - this.at_) throw new ProtocolError(`a list of ${count} does not fit`);
    const items: T[] = [];
    for (let i = 0; i < count; ++i) items.push(read(this));
    return items;
  }
  /** How many bytes are left. */
  get left(): number {
    return this.view_.byteLength - this.at_;
  }
  /** Throws where bytes are left over. */
  end(): void {
    if (this.left > 0) throw new ProtocolError(`${this.left} bytes too many`);
  }

  /** Copies an array's bytes, so that the result is aligned and the message can be freed or transferred. */
  private slice(bytesEach: number): ArrayBuffer {
    const size = this.u32() * bytesEach;
    const from = this.advance(size);
    return this.buffer_.slice(from, from + size);
  }
  private advance(size: number): number {
    const from = this.at_;
    if (size > this.view_.byteLength - from)
      throw new ProtocolError(`the message ends at byte ${this.view_.byteLength}`);
    this.at_ += size;
    return from;
  }
}

/** Appends values. */
export class ByteWriter {
  private buffer_ = new ArrayBuffer(256);
  private view_ = new DataView(this.buffer_);
  private size_ = 0;

  u8(value: number): void {
    const at = this.reserve(1);
    this.view_.setUint8(at, value);
  }
  u16(value: number): void {
    const at = this.reserve(2);
    this.view_.setUint16(at, value, true);
  }
  i16(value: number): void {
    const at = this.reserve(2);
    this.view_.setInt16(at, value, true);
  }
  i32(value: number): void {
    const at = this.reserve(4);
    this.view_.setInt32(at, value, true);
  }
  u32(value: number): void {
    const at = this.reserve(4);
    this.view_.setUint32(at, value, true);
  }
  f32(value: number): void {
    const at = this.reserve(4);
    this.view_.setFloat32(at, value, true);
  }
  f64(value: number): void {
    const at = this.reserve(8);
    this.view_.setFloat64(at, value, true);
  }
  bool(value: boolean): void {
    this.u8(value ? 1 : 0);
  }
  text(value: string): void {
    this.u8s(new TextEncoder().encode(value));
  }
  u8s(values: Uint8Array): void {
    this.raw(values);
  }
  i8s(values: Int8Array): void {
    this.raw(values);
  }
  u16s(values: Uint16Array): void {
    this.raw(values);
  }
  i16s(values: Int16Array): void {
    this.raw(values);
  }
  u32s(values: Uint32Array): void {
    this.raw(values);
  }
  f32s(values: Float32Array): void {
    this.raw(values);
  }
  f64s(values: Float64Array): void {
    this.raw(values);
  }
  list<T>(items: readonly T[], write: (writer: ByteWriter, item: T) => void): void {
    this.u32(items.length);
    for (const item of items) write(this, item);
  }
  /** What was written. */
  bytes(): ArrayBuffer {
    return this.buffer_.slice(0, this.size_);
  }

  /** Every platform that browsers run on is little-endian, as the protocol is. */
  private raw(values: Numbers): void {
    this.u32(values.length);
    const from = this.reserve(values.byteLength);
    new Uint8Array(this.buffer_, from).set(new Uint8Array(values.buffer, values.byteOffset, values.byteLength));
  }
  /** May exchange the view: call it before reading `this.view`. */
  private reserve(size: number): number {
    const from = this.size_;
    this.size_ += size;
    if (this.size_ > this.buffer_.byteLength) {
      const larger = new ArrayBuffer(Math.max(this.size_, 2 * this.buffer_.byteLength));
      new Uint8Array(larger).set(new Uint8Array(this.buffer_, 0, from));
      this.buffer_ = larger;
      this.view_ = new DataView(larger);
    }
    return from;
  }
}
