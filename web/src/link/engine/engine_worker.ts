// The worker that runs the engine: the whole studio's session, or one export.

import {
  Engine,
  loadStudioModule,
  loadThreadedModule,
  ModuleMemory,
  webSource,
  type ExportParts,
  type LoadedStudioModule,
} from 'muster-engine/studio';
import { XzReadableStream } from 'xz-decompress';
import { EngineLoop, type LoopTimers } from './engine_loop';
import type { FromEngine, SocketMessage, ToEngine } from './engine_messages';
import { KeptFiles } from './kept_files';
import { ShelfFiles, type EngineFiles } from './shelf_files';

const kTakes = '/takes';
const kScenarios = '/scenarios';
const kExport = '/export';
const kPlayer = '/player';
/** How often the shelf's files are looked through [ms]. */
const kSaveEvery = 1000;
const kVersion = 'in this browser';

function post(message: FromEngine, transfer: Transferable[] = []): void {
  self.postMessage(message, { transfer });
}

/** Timers of a worker wait for 4 ms at least; a message to oneself does not. */
function workerTimers(): LoopTimers {
  const waiting: (() => void)[] = [];
  const channel = new MessageChannel();
  channel.port2.onmessage = () => waiting.shift()?.();
  return {
    now: () => performance.now(),
    after: (ms, action) => self.setTimeout(action, ms),
    cancel: (handle) => self.clearTimeout(handle),
    soon: (action) => {
      waiting.push(action);
      channel.port1.postMessage(null);
    },
  };
}

type Texts = Readonly<Record<string, string>>;

async function fetchTexts(address: string): Promise<Texts> {
  const answer = await fetch(address);
  if (!answer.ok) throw new Error(`${address}: ${answer.statusText || answer.status}`);
  return (await answer.json()) as Texts;
}

function putTexts(files: EngineFiles, texts: Texts): void {
  for (const [path, text] of Object.entries(texts)) {
    files.mkdirTree(`${kScenarios}/${path}`.replace(/\/[^/]*$/, ''));
    files.writeFile(`${kScenarios}/${path}`, text);
  }
}

/** The module with threads; null where none are wanted, or where this browser cannot run it. */
async function loadThreads(base: string, threads: number): Promise<LoadedStudioModule | null> {
  return threads > 1 ? loadThreadedModule(base, threads).catch(() => null) : null;
}

/** Loads the engine, with the scenarios in its files. */
async function load(base: string, parts: ExportParts = {}, threads = 1): Promise<LoadedStudioModule> {
  const scenarios = fetchTexts(new URL('scenarios.json', base).href);
  const source = webSource((packed) => new XzReadableStream(packed));
  const loaded = (await loadThreads(base, threads)) ?? (await loadStudioModule(base, source, parts));
  loaded.module.FS.mkdirTree(kTakes);
  putTexts(loaded.module.FS, await scenarios);
  return loaded;
}

/** The engine, which is loaded once. */
let prepared: Promise<LoadedStudioModule> | null = null;

function prepare(base: string, threads = 1): Promise<LoadedStudioModule> {
  prepared ??= load(base, {}, threads);
  return prepared;
}

let gestures: Promise<void> | null = null;

/** The touches that scenarios carry. */
function loadGestures(files: EngineFiles, base: string): Promise<void> {
  gestures ??= fetchTexts(new URL('gestures.json', base).href).then((texts) => putTexts(files, texts));
  return gestures;
}

/** Loads everything, also what comes when the first crowd walks. */
async function complete(base: string): Promise<void> {
  const { module, loadRest } = await prepare(base);
  await Promise.all([loadRest(), loadGestures(module.FS, base)]);
}

/** Writes the shelf to the browser's database, one time after the other. */
function keepShelf(shelf: ShelfFiles): void {
  const again = (): void => void self.setTimeout(() => void shelf.save().then(again, again), kSaveEvery);
  again();
}

async function start({ base, scenario, threads, port }: Extract<ToEngine, { kind: 'start' }>): Promise<EngineHost> {
  const engine = new Engine((await prepare(base, threads)).module);
  const shelf = new ShelfFiles(engine.files, new KeptFiles(), [kTakes, `${kTakes}/removed`]);
  await shelf.load();
  engine.open(scenario, kVersion, threads);
  keepShelf(shelf);
  const loop = new EngineLoop(engine, port, workerTimers());
  port.onmessage = ({ data }: MessageEvent<SocketMessage>) => loop.handle(data);
  return { engine, loop };
}

interface EngineHost {
  readonly engine: Engine;
  readonly loop: EngineLoop;
}

/** What pages with a player are made of lies beside the engine. */
async function addPlayer(base: string, files: EngineFiles): Promise<void> {
  files.mkdirTree(kPlayer);
  for (const name of ['muster-player.js', 'page.html']) {
    const answer = await fetch(new URL(`../player/${name}`, base).href);
    if (!answer.ok) throw new Error(`${name}: ${answer.statusText || answer.status}`);
    files.writeFile(`${kPlayer}/${name}`, await answer.text());
  }
}

async function makeExport({ base, order, name, take }: Extract<ToEngine, { kind: 'export' }>): Promise<void> {
  const { format } = JSON.parse(order) as { format?: unknown };
  const parts: ExportParts = { onProgress: (share) => post({ kind: 'progress', share }) };
  if (format === 'jupedsim') parts.sql = await (await import('./load_sqlite')).loadSqlite();
  const { module, loadRest } = await load(base, parts);
  await loadRest();
  const memory = new ModuleMemory(module);
  if (typeof format === 'string' && format.startsWith('player-')) await addPlayer(base, module.FS);
  module.FS.writeFile(`${kTakes}/${name}`, take);
  const wrong = memory.withTexts([order, kExport], ([wish, path]) => module._muster_export(wish!, path!));
  const said = memory.text(module._muster_text());
  if (wrong !== 0) throw new Error(said);
  const bytes = module.FS.readFile(kExport).slice();
  post({ kind: 'exported', file: said, bytes }, [bytes.buffer]);
}

function failed(error: unknown): void {
  post({ kind: 'failed', problem: error instanceof Error ? error.message : String(error) });
}

let host: Promise<EngineHost> | null = null;

async function answer({ id, method, target, body }: Extract<ToEngine, { kind: 'ask' }>): Promise<void> {
  if (!host) return;
  const { engine, loop } = await host;
  const made = engine.ask(method, target, body);
  post({ kind: 'answer', id, answer: made }, [made.bytes.buffer]);
  loop.wake();
}

self.onmessage = ({ data }: MessageEvent<ToEngine>) => {
  if (data.kind === 'prepare') {
    complete(data.base)
      .then(() => post({ kind: 'prepared' }))
      .catch(failed);
  } else if (data.kind === 'start') {
    host = start(data);
    host.catch(failed);
  } else if (data.kind === 'ask') answer(data).catch(failed);
  else makeExport(data).catch(failed);
};
