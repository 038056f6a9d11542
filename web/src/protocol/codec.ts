// Values as bytes, by their layouts: "id:u32 points:Vec2* name:text" are fields in their order. Behind a type, * means a list of
// it. <4 is a byte below 4, u32s an array of numbers. Any other type has a layout of its own, or is a method of reader and writer.

import type { ByteReader, ByteWriter } from './bytes';

export type Layouts = Readonly<Record<string, string>>;

/** Reads and writes one type. */
interface Codec {
  read(r: ByteReader): unknown;
  write(w: ByteWriter, value: unknown): void;
}

type Fields = Record<string, unknown>;
type Reads = Record<string, () => unknown>;
type Writes = Record<string, (value: unknown) => void>;

/** Codecs of all types that layouts name, made when they are first asked for. */
export class Codecs {
  private readonly made_ = new Map<string, Codec>();

  constructor(private readonly layouts_: Layouts) {}

  of(type: string): Codec {
    let codec = this.made_.get(type);
    if (!codec) this.made_.set(type, (codec = this.make(type)));
    return codec;
  }

  private make(type: string): Codec {
    const base = type.slice(0, -1);
    if (type.endsWith('*')) return this.list(base);
    if (type.startsWith('<')) {
      const count = Number(type.slice(1));
      return { read: (r) => r.choice(count), write: (w, value) => w.u8(value as number) };
    }
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

  private struct(layout: string): Codec {
    const fields = layout.split(' ').map((field) => {
      const [name, type] = field.split(':') as [string, string];
      return { name, codec: this.of(type) };
    });
    return {
      read: (r) => Object.fromEntries(fields.map(({ name, codec }) => [name, codec.read(r)])),
      write: (w, value) => {
        for (const { name, codec } of fields) codec.write(w, (value as Fields)[name]);
      },
    };
  }
}
