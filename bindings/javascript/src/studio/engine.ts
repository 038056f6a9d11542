// The studio's session in this thread, with messages and answers as JavaScript has them.

import type { StudioModule } from './studio_module.js';
import { ModuleMemory } from '../binding/module_memory.js';

export interface EngineAnswer {
  readonly status: number;
  readonly type: string;
  readonly bytes: Uint8Array<ArrayBuffer>;
}

export class Engine {
  private readonly memory_: ModuleMemory;

  constructor(private readonly module_: StudioModule) {
    this.memory_ = new ModuleMemory(module_);
  }

  get files(): StudioModule['FS'] {
    return this.module_.FS;
  }

  /** Begins with a scenario by name, '' for the default, on so many threads where the module has some. Throws a sentence. */
  open(scenario: string, version: string, threads = 1): void {
    const failed = this.memory_.withTexts([scenario, version], ([name, ofPage]) =>
      this.module_._muster_open(name!, ofPage!, threads),
    );
    if (failed !== 0) throw new Error(this.memory_.text(this.module_._muster_text()));
  }

  connect(): number {
    return this.module_._muster_connect();
  }

  disconnect(client: number): void {
    this.module_._muster_disconnect(client);
  }

  receive(client: number, bytes: Uint8Array): void {
    this.memory_.withBytes(bytes, (at) => this.module_._muster_receive(client, at, bytes.length));
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
      return this.memory_.copy(at, this.module_._muster_message_size(k)).buffer;
    });
  }

  ask(method: string, target: string, body: Uint8Array): EngineAnswer {
    const status = this.memory_.withTexts([method, target], ([verb, path]) =>
      this.memory_.withBytes(body, (at) => this.module_._muster_ask(verb!, path!, at, body.length)),
    );
    const bytes = this.memory_.copy(this.module_._muster_answer(), this.module_._muster_answer_size());
    return {
      status,
      type: this.memory_.text(this.module_._muster_answer_type()),
      bytes,
    };
  }
}
