// Values as bytes, by their layouts: "id:u32 points:Vec2* share:f64=0.95" are fields in their order, each with its type and its
// default if that is not zero or empty. Behind a type, * means a list of it, + such a list with its length in bytes, and ? that
// it may be none (null). The fields of what is called ... are those of its owner. <4 is a byte below 4, u32s an array of numbers; an enumeration is a word. Any other type has a layout of
// its own, or is a method of reader and writer.

import { ByteReader, ByteWriter } from './bytes';

export type Layouts = Readonly<Record<string, string>>;

/** Reads and writes one type; `undefined` is written as its default. */
export interface Codec {
  read(r: ByteReader): unknown;
  write(w: ByteWriter, value: unknown): void;
}

type Fields = Readonly<Record<string, unknown>>;
type Reads = Record<string, () => unknown>;
type Writes = Record<string, (value: unknown) => void>;

const kTuple = '0';
const kInline = '...';

/** Codecs of all types that layouts name, made when they are first asked for. */
export class Codecs {
  private readonly made_ = new Map<string, Codec>();

  constructor(
    private readonly layouts_: Layouts,
    private readonly words_: Readonly<Record<string, readonly string[]>> = {},
  ) {}

  /** The codec of a type. */
  of(type: string): Codec {
    let codec = this.made_.get(type);
    if (!codec) this.made_.set(type, (codec = this.make(type)));
    return codec;
  }

  /** What is one of several, which its first byte, a number of `numbers`, and its field `tag` say. */
  addUnion(
    type: string,
    tag: string,
    layouts: readonly (readonly [string, string])[],
    numbers: readonly number[] = layouts.map((_, at) => at),
  ): void {
    const kinds = layouts.map(([kind]) => kind);
    const codecs = layouts.map(([, layout]) => this.struct(layout));
    this.made_.set(type, {
      read: (r) => {
        const at = r.among(numbers);
        return Object.assign({ [tag]: kinds[at] }, codecs[at]!.read(r));
      },
      write: (w, value) => {
        const at = kinds.indexOf((value as Fields)[tag] as string);
        w.u8(numbers[at]!);
        codecs[at]!.write(w, value);
      },
    });
  }

  private make(type: string): Codec {
    const item = type.slice(0, -1);
    if (type.endsWith('*')) return this.list(item);
    if (type.endsWith('+')) return this.bytes(item);
    if (type.endsWith('?')) return this.optional(item);
    if (type.startsWith('<')) {
      const count = Number(type.slice(1));
      return { read: (r) => r.choice(count), write: (w, value) => w.u8(value as number) };
    }
    const words = this.words_[type];
    if (words)
      return { read: (r) => words[r.choice(words.length)], write: (w, value) => w.u8(words.indexOf(value as string)) };
    const layout = this.layouts_[type];
    if (layout !== undefined) return this.struct(layout);
    return {
      read: (r) => (r as unknown as Reads)[type]!(),
      write: (w, value) => (w as unknown as Writes)[type]!(value),
    };
  }

  private list(item: string): Codec {
    return {
      read: (r) => r.list((one) => this.of(item).read(one)),
      write: (w, value) => w.list(value as unknown[], (one, part) => this.of(item).write(one, part)),
    };
  }

  private bytes(item: string): Codec {
    return {
      read: (r) => {
        const inner = new ByteReader(r.u8s().buffer as ArrayBuffer);
        const items: unknown[] = [];
        while (inner.left > 0) items.push(this.of(item).read(inner));
        return items;
      },
      write: (w, value) => {
        const inner = new ByteWriter();
        for (const one of value as unknown[]) this.of(item).write(inner, one);
        w.u8s(new Uint8Array(inner.bytes()));
      },
    };
  }

  private optional(item: string): Codec {
    return {
      read: (r) => (r.bool() ? this.of(item).read(r) : null),
      write: (w, value) => {
        w.bool(value !== null);
        if (value !== null) this.of(item).write(w, value);
      },
    };
  }

  private struct(layout: string): Codec {
    const fields = layout.split(' ').map((field) => {
      const [name, type, initial] = field.split(/[:=]/) as [string, string, string?];
      return { name, codec: this.of(type), otherwise: this.defaultOf(type, initial) };
    });
    const isTuple = fields[0]!.name === kTuple;
    return {
      read: (r) => {
        if (isTuple) return fields.map(({ codec }) => codec.read(r));
        const value: Record<string, unknown> = {};
        for (const { name, codec } of fields)
          if (name === kInline) Object.assign(value, codec.read(r));
          else value[name] = codec.read(r);
        return value;
      },
      write: (w, value) => {
        for (const { name, codec, otherwise } of fields)
          codec.write(w, name === kInline ? value : ((value as Fields)[name] ?? otherwise));
      },
    };
  }

  private defaultOf(type: string, initial = ''): unknown {
    if (/[*+s]$/.test(type)) return [];
    if (type.endsWith('?')) return null;
    if (this.words_[type]) return initial || this.words_[type][0];
    if (this.layouts_[type] !== undefined) return {};
    return type === 'text' ? initial : Number(initial);
  }
}
