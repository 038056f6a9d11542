// Calls the functions of the C API: encodes what is given, decodes what comes back, and throws failures.

import { Status } from '../generated/enums.js';
import type { FunctionName } from '../generated/signatures.js';
import { MusterError, wrongValue } from '../muster_error.js';
import { Arena } from './arena.js';
import { Callbacks } from './callbacks.js';
import { Decoder } from './decoder.js';
import { Encoder, type Span } from './encoder.js';
import type { Handle } from './handle.js';
import { kPointer, layoutOf, scalarOf, sizeOf } from './layout.js';
import { ModuleMemory } from './module_memory.js';
import type { MusterModule, NativeFunction } from './module_types.js';
import { signatureOf, type Parameter, type Signature } from './signature.js';

export type HandleClass = new (invoker: Invoker, index1: number, generation: number) => Handle;

/** One call on its way. */
interface Call {
  readonly self: Handle | null;
  readonly native: number[];
  /** Reads the results once the function has returned. */
  readonly results: { readonly name: string; readonly read: () => unknown }[];
  readonly callbacks: number[];
  /** Where the function writes its count. */
  countAt: number;
}

const kHandle = 8;
const kBuffer = 8;

export class Invoker {
  readonly memory: ModuleMemory;
  private readonly arena_: Arena;
  private readonly encoder_: Encoder;
  private readonly decoder_: Decoder;
  private readonly callbacks_: Callbacks;
  private broken_ = '';

  constructor(
    private readonly module_: MusterModule,
    private readonly handles_: Readonly<Record<string, HandleClass>>,
  ) {
    this.memory = new ModuleMemory(module_);
    this.arena_ = new Arena(this.memory);
    this.encoder_ = new Encoder(this.memory, this.arena_, (name) => this.native(name));
    this.decoder_ = new Decoder(this.memory);
    this.callbacks_ = new Callbacks(module_, {
      LogFunction: {
        signature: 'viii',
        arguments: ([level, message]) => [level, this.memory.text(message!)],
      },
      ReplayFunction: {
        signature: 'iii',
        arguments: ([world]) => [this.handleAt('World', world!)],
      },
      ProgressFunction: { signature: 'iid', arguments: (given) => given },
    });
  }

  call(name: FunctionName, self: Handle | null, given: readonly unknown[]): unknown {
    return this.guarded(() => this.arena_.within(() => this.run(signatureOf(name), self, given)));
  }

  setLog(action: unknown): void {
    this.guarded(() => this.callbacks_.setLog(action, (index) => this.native('muster_set_log')(index, 0)));
  }

  /** Nothing can be called once the module has stopped, nor by the log's function. */
  private guarded<T>(action: () => T): T {
    if (this.broken_) throw new MusterError(Status.Internal, this.broken_);
    if (this.callbacks_.logs)
      throw new MusterError(Status.InvalidArgument, 'the log’s function must not call the library');
    try {
      return action();
    } catch (error) {
      if (this.callbacks_.hasThrown(error)) throw error;
      // C++ exceptions come as numbers.
      if (typeof error !== 'number' && !(error instanceof WebAssembly.RuntimeError)) throw error;
      const size = Math.round(this.memory.bytes.length / 1e6);
      this.broken_ = `the module has stopped, most likely for lack of memory (it has ${size} MB): load it anew`;
      throw new MusterError(Status.Internal, this.broken_);
    }
  }

  private native(name: string): NativeFunction {
    return (this.module_ as unknown as Readonly<Record<string, NativeFunction>>)[`_${name}`]!;
  }

  private run(signature: Signature, self: Handle | null, given: readonly unknown[]): unknown {
    const call: Call = {
      self,
      native: [],
      results: [],
      callbacks: [],
      countAt: 0,
    };
    const returned = signature.returns === 'struct' ? this.out(signature.type, call, call.native) : null;
    let next = 0;
    const take = (): unknown => given[next++];
    try {
      for (const parameter of signature.parameters) this.parameter(parameter, call, take);
      const code = this.native(signature.name)(...call.native);
      this.callbacks_.rethrow();
      if (signature.returns === 'status' && code !== Status.Ok) throw this.failure(code);
      if (signature.moves) self?.moved();
      return returned ? returned() : this.returned(signature, call, code);
    } finally {
      for (const index of call.callbacks) this.callbacks_.remove(index);
    }
  }

  private returned({ returns, type, count }: Signature, call: Call, value: number): unknown {
    if (returns === 'text') return this.decoder_.text(value);
    if (returns === 'bool') return value !== 0;
    if (returns === 'list') return this.decoder_.list(type, value, this.countOf(call), 'copy', call.self);
    if (returns === 'fixed') return this.decoder_.list(type, value, count, 'copy', call.self);
    if (scalarOf(returns)) return value;
    const [first, ...others] = call.results;
    if (others.length === 0) return first?.read();
    return Object.fromEntries(call.results.map(({ name, read }) => [name, read()]));
  }

  private failure(code: number): MusterError {
    return new MusterError(code as Status, this.memory.text(this.native('muster_last_error')()));
  }

  private countOf({ countAt }: Call): number {
    return this.memory.view.getInt32(countAt, true);
  }

  /** Adds one parameter to the C arguments. */
  private parameter(parameter: Parameter, call: Call, take: () => unknown): void {
    const { name, role, type } = parameter;
    const { native } = call;
    const span = ({ at, count }: Span): void => void native.push(at, count);
    if (scalarOf(role)) native.push(this.encoder_.number(role, take(), name));
    else if (role === 'text') native.push(this.encoder_.text(take(), name).at);
    else if (role === 'chars') span(this.charsOf(take(), name));
    else if (role === 'bytes') span(this.bytesOf(take(), name));
    else if (role === 'struct') native.push(this.structOf(type, take(), name));
    else if (role === 'list') span(this.encoder_.list(type, take(), name));
    else if (role === 'self') native.push(this.handle(call.self!));
    else if (role === 'handle') native.push(this.handle(this.checkedHandle(type, take(), name)));
    else if (role === 'callback') this.callback(type, take(), name, call);
    else if (role === 'count') native.push((call.countAt = this.arena_.take(kPointer)));
    else this.result(parameter, call);
  }

  private result({ name, role, type, count }: Parameter, call: Call): void {
    const { native, results } = call;
    const place = (size: number): number => {
      const at = this.arena_.take(size);
      native.push(at);
      return at;
    };
    const add = (read: () => unknown): void => void results.push({ name, read });
    const pointerAt = (at: number): number => this.memory.view.getUint32(at, true);
    if (role === 'out') {
      add(this.out(type, call, native));
    } else if (role === 'new') {
      const at = place(kHandle);
      add(() => this.handleAt(type, at));
    } else if (role === 'outList' || role === 'outRows') {
      const at = place(kPointer);
      const mode = role === 'outRows' ? 'readOut' : 'copy';
      add(() => this.decoder_.list(type, pointerAt(at), this.countOf(call), mode, call.self));
    } else if (role === 'outTexts') {
      const at = place(kPointer);
      add(() => this.decoder_.list('text', pointerAt(at), this.countOf(call), 'definition', null));
    } else if (role === 'outMaybe') {
      const at = place(kPointer);
      add(() => (pointerAt(at) === 0 ? null : this.decoder_.one(type, pointerAt(at), call.self)));
    } else if (role === 'outFixed') {
      const at = place(count * sizeOf(type));
      add(() => this.decoder_.list(type, at, count, 'copy', null));
    } else if (role === 'outCommands') {
      const at = place(kHandle);
      add(() => this.commands(at));
    } else {
      const at = place(kBuffer);
      add(() => this.buffer(at, role === 'outChars'));
    }
  }

  /** Room for one value that the function writes, and how to read it. */
  private out(type: string, { self }: Call, native: number[]): () => unknown {
    const at = this.arena_.take(sizeOf(type));
    // Structs with a version are told apart from others by it.
    const maker = scalarOf(type) ? null : layoutOf(type).maker;
    if (maker && layoutOf(type).name !== 'Command') this.native(maker)(at);
    native.push(at);
    return () => this.decoder_.one(type, at, self);
  }

  private structOf(type: string, value: unknown, place: string): number {
    return value === null || value === undefined ? 0 : this.encoder_.struct(type, value, place);
  }

  private charsOf(value: unknown, place: string): Span {
    if (typeof value === 'string') return this.encoder_.bytes(new TextEncoder().encode(value));
    if (value instanceof Uint8Array) return this.encoder_.bytes(value);
    throw wrongValue(place, value, 'a text or its bytes');
  }

  private bytesOf(value: unknown, place: string): Span {
    if (value instanceof Uint8Array) return this.encoder_.bytes(value);
    if (value instanceof ArrayBuffer) return this.encoder_.bytes(new Uint8Array(value));
    throw wrongValue(place, value, 'a Uint8Array');
  }

  private handle({ index1, generation }: Handle): number {
    const at = this.arena_.take(kHandle);
    this.memory.view.setUint32(at, index1, true);
    this.memory.view.setUint32(at + kPointer, generation, true);
    return at;
  }

  private checkedHandle(type: string, value: unknown, place: string): Handle {
    const wanted = this.handles_[type]!;
    if (!(value instanceof wanted)) throw wrongValue(place, value, `a ${type}`);
    if (value.invoker !== this) throw wrongValue(place, value, `a ${type} of the same module`);
    return value;
  }

  private handleAt(type: string, at: number): Handle {
    const { view } = this.memory;
    return new this.handles_[type]!(this, view.getUint32(at, true), view.getUint32(at + kPointer, true));
  }

  private callback(kind: string, value: unknown, place: string, { native, callbacks }: Call): void {
    const index = this.callbacks_.add(kind, value, place);
    if (index !== 0) callbacks.push(index);
    native.push(index, 0);
  }

  /** The commands of a list, which ends. */
  private commands(list: number): unknown {
    const [at, count] = [this.arena_.take(kPointer), this.arena_.take(kPointer)];
    try {
      const code = this.native('muster_command_list_get')(list, at, count);
      if (code !== Status.Ok) throw this.failure(code);
      const { view } = this.memory;
      return this.decoder_.list('Command', view.getUint32(at, true), view.getInt32(count, true), 'definition', null);
    } finally {
      this.native('muster_command_list_destroy')(list);
    }
  }

  /** The content of a buffer, which is given back. */
  private buffer(at: number, isText: boolean): unknown {
    const { view } = this.memory;
    const bytes = this.memory.copy(view.getUint32(at, true), view.getUint32(at + kPointer, true));
    this.native('muster_free_buffer')(at);
    return isText ? new TextDecoder().decode(bytes) : bytes;
  }
}
