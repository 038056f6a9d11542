// A WebAssembly module in two files (scripts/wasm/split.mjs): the functions that are called at once, and the rest.

type Exports = WebAssembly.Exports;

/** Where compiled code comes from. */
export interface ModuleSource {
  /** Loads and compiles a file. */
  compile(address: string): Promise<WebAssembly.Module>;
  /** The same while everything waits. */
  compileNow(address: string): WebAssembly.Module;
}

/** The browser's, for workers; what comes in the format of xz is unpacked by `unpack`. */
export function webSource(unpack: (packed: ReadableStream<Uint8Array>) => ReadableStream<Uint8Array>): ModuleSource {
  return {
    async compile(address) {
      const answer = await fetch(address);
      if (!answer.ok || !answer.body) throw new Error(`${address}: ${answer.statusText || answer.status}`);
      const plain = address.endsWith('.xz') ? unpack(answer.body) : answer.body;
      return WebAssembly.compileStreaming(new Response(plain, { headers: { 'Content-Type': 'application/wasm' } }));
    },
    compileNow(address) {
      const request = new XMLHttpRequest();
      request.open('GET', address, false);
      request.responseType = 'arraybuffer';
      request.send();
      if (request.status !== 200) throw new Error(`${address}: ${request.statusText || request.status}`);
      return new WebAssembly.Module(request.response as ArrayBuffer);
    },
  };
}

/** The instance of such a module. A function of the second file that is called before that file is there is waited for. */
export class SplitModule {
  private exports_: Exports | null = null;
  private complete_ = false;

  private constructor(
    private readonly first_: WebAssembly.Module,
    private readonly rest_: string,
    private readonly source_: ModuleSource,
  ) {}

  /** Loads the first file. */
  static async load(first: string, rest: string, source: ModuleSource): Promise<SplitModule> {
    return new SplitModule(await source.compile(first), rest, source);
  }

  /** Makes the instance as emscripten asks for it. */
  instantiate(imports: WebAssembly.Imports): Promise<WebAssembly.Instance> {
    const waiting = new Proxy<Record<string, WebAssembly.ImportValue>>(
      {},
      {
        get:
          (_, slot) =>
          (...given: unknown[]) =>
            this.callRest(Number(slot), given),
      },
    );
    return WebAssembly.instantiate(this.first_, { ...imports, placeholder: waiting }).then((instance) => {
      this.exports_ = instance.exports;
      return instance;
    });
  }

  /** Loads the second file, if it is not there. */
  async loadRest(): Promise<void> {
    if (!this.complete_) this.add(await this.source_.compile(this.rest_));
  }

  /** Its functions take the places of those that wait in the table. */
  private add(rest: WebAssembly.Module): void {
    if (this.complete_ || !this.exports_) return;
    void new WebAssembly.Instance(rest, { primary: this.exports_ as WebAssembly.ModuleImports });
    this.complete_ = true;
  }

  private callRest(slot: number, given: unknown[]): unknown {
    this.add(this.source_.compileNow(this.rest_));
    const table = Object.values(this.exports_ ?? {}).find((value) => value instanceof WebAssembly.Table);
    const called = (table as WebAssembly.Table).get(slot) as (...given: unknown[]) => unknown;
    return called(...given);
  }
}
