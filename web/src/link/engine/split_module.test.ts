import { describe, expect, it, vi } from 'vitest';
import { SplitModule, type ModuleSource } from 'muster-engine/studio';

const text = (words: string): number[] => [words.length, ...new TextEncoder().encode(words)];
const section = (id: number, ...content: number[]): number[] => [id, content.length, ...content];
const kHead = [0, 0x61, 0x73, 0x6d, 1, 0, 0, 0];
/** The type of functions without parameters that give an i32, and one function of it. */
const kTypes = section(1, 1, 0x60, 0, 1, 0x7f);
const kFunctions = section(3, 1, 0);
/** Puts function 0 into the table's first place. */
const kElements = section(9, 1, 0, 0x41, 0, 0x0b, 1, 0);

/** As wasm-split makes them: `call` calls what stands in the table, which is imported until the rest puts its function there. */
const kFirst = new Uint8Array([
  ...kHead,
  ...kTypes,
  ...section(2, 1, ...text('placeholder'), ...text('0'), 0, 0),
  ...kFunctions,
  ...section(4, 1, 0x70, 0, 1),
  ...section(7, 2, ...text('%table'), 1, 0, ...text('call'), 0, 1),
  ...kElements,
  ...section(10, 1, 7, 0, 0x41, 0, 0x11, 0, 0, 0x0b),
]);
const kRest = new Uint8Array([
  ...kHead,
  ...kTypes,
  ...section(2, 1, ...text('primary'), ...text('%table'), 1, 0x70, 0, 1),
  ...kFunctions,
  ...kElements,
  ...section(10, 1, 4, 0, 0x41, 42, 0x0b),
]);

function source() {
  const file = (address: string): WebAssembly.Module => {
    if (address === 'gone') throw new Error('gone: Not Found');
    return new WebAssembly.Module(address === 'first' ? kFirst : kRest);
  };
  return {
    compile: vi.fn((address: string) => Promise.resolve().then(() => file(address))),
    compileNow: vi.fn(file),
  } satisfies ModuleSource;
}

type Call = () => number;

describe('a module in two files', () => {
  it('calls functions of the second once it is loaded', async () => {
    const files = source();
    const split = await SplitModule.load('first', 'rest', files);
    const { exports } = await split.instantiate({});
    await split.loadRest();
    await split.loadRest();
    expect((exports['call'] as Call)()).toBe(42);
    expect(files.compile.mock.calls).toEqual([['first'], ['rest']]);
    expect(files.compileNow).not.toHaveBeenCalled();
  });

  it('waits for the second where one is called before', async () => {
    const files = source();
    const split = await SplitModule.load('first', 'rest', files);
    const { exports } = await split.instantiate({});
    const loading = split.loadRest();
    expect((exports['call'] as Call)()).toBe(42);
    expect((exports['call'] as Call)()).toBe(42);
    expect(files.compileNow.mock.calls).toEqual([['rest']]);
    await loading;
    expect((exports['call'] as Call)()).toBe(42);
  });

  it('says what is missing', async () => {
    await expect(SplitModule.load('gone', 'rest', source())).rejects.toThrow('gone: Not Found');
    const split = await SplitModule.load('first', 'gone', source());
    const { exports } = await split.instantiate({});
    await expect(split.loadRest()).rejects.toThrow('gone: Not Found');
    expect(() => (exports['call'] as Call)()).toThrow('gone: Not Found');
  });
});
