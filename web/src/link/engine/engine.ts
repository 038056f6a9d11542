// The engine: the studio's session in this thread, with messages and answers as JavaScript has them.

import type { EngineModule } from './engine_module';

export interface EngineAnswer {
  readonly status: number;
  readonly type: string;
  readonly bytes: Uint8Array<ArrayBuffer>;
}

export class Engine {
  constructor(private readonly module_: EngineModule) {}

  get files(): EngineModule['FS'] {
    return this.module_.FS;
  }

  /** Begins with a scenario by name, '' for the default. Throws a sentence. */
  open(scenario: string, version: string): void {
    const failed = this.withTexts([scenario, version], ([name, ofPage]) => this.module_._muster_open(name!, ofPage!));
    if (failed !== 0) throw new Error(this.text(this.module_._muster_text()));
  }

  connect(): number {
    return this.module_._muster_connect();
  }

  disconnect(client: number): void {
    this.module_._muster_disconnect(client);
  }

  receive(client: number, bytes: Uint8Array): void {
    this.withBytes(bytes, (at) => this.module_._muster_receive(client, at, bytes.length));
  }

  /** Lets time pass [s] and does one piece of work; when it wants to be called again [s]. */
  advance(seconds: number): number {
    return this.module_._muster_advance(seconds);
  }

  /** The messages for a client, in buffers of their own. */
  outgoing(client: number): ArrayBuffer[] {
    const count = this.module_._muster_collect(client);
    return Array.from({ length: count }, (_, k) => {
      const at = this.module_._muster_message(k);
      return this.copy(at, this.module_._muster_message_size(k)).buffer;
    });
  }

  ask(method: string, target: string, body: Uint8Array): EngineAnswer {
    const status = this.withTexts([method, target], ([verb, path]) =>
      this.withBytes(body, (at) => this.module_._muster_ask(verb!, path!, at, body.length)),
    );
    const bytes = this.copy(this.module_._muster_answer(), this.module_._muster_answer_size());
    return { status, type: this.text(this.module_._muster_answer_type()), bytes };
  }

  /** Makes the file of an export; the name to save it by. Throws a sentence. */
  export(order: string, path: string): string {
    const failed = this.withTexts([order, path], ([text, at]) => this.module_._muster_export(text!, at!));
    const said = this.text(this.module_._muster_text());
    if (failed !== 0) throw new Error(said);
    return said;
  }

  private copy(at: number, size: number): Uint8Array<ArrayBuffer> {
    return this.module_.HEAPU8.slice(at, at + size);
  }

  /** A text that ends with a zero. */
  private text(at: number): string {
    const { HEAPU8: heap } = this.module_;
    return new TextDecoder().decode(heap.slice(at, heap.indexOf(0, at)));
  }

  private withBytes<T>(bytes: Uint8Array, use: (at: number) => T): T {
    const at = this.module_._muster_reserve(Math.max(1, bytes.length));
    if (at === 0) throw new Error('The engine has no memory left.');
    try {
      this.module_.HEAPU8.set(bytes, at);
      return use(at);
    } finally {
      this.module_._muster_release(at);
    }
  }

  private withTexts<T>(texts: readonly string[], use: (at: readonly number[]) => T, at: readonly number[] = []): T {
    const [first, ...others] = texts;
    if (first === undefined) return use(at);
    const bytes = new TextEncoder().encode(`${first}\0`);
    return this.withBytes(bytes, (one) => this.withTexts(others, use, [...at, one]));
  }
}
