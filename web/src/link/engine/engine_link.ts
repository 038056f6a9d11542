// The page's side of the engine: requests are answered as by the server; exports run in workers of their own.

import type { Ask } from '../answers';
import type { EngineAnswer } from 'muster-engine/studio';
import type { FromEngine, ToEngine } from './engine_messages';
import { EngineExports } from './engine_exports';

/** What is needed of a Worker. */
export interface EnginePort {
  onmessage: ((event: MessageEvent<FromEngine>) => void) | null;
  postMessage(message: ToEngine, transfer?: Transferable[]): void;
  terminate(): void;
}

export function responseOf({ status, type, bytes }: EngineAnswer): Response {
  return new Response(bytes, { status, headers: { 'Content-Type': type } });
}

async function bytesOf(body: BodyInit | null | undefined): Promise<Uint8Array> {
  return new Uint8Array(await new Response(body ?? '').arrayBuffer());
}

export interface EngineBegin {
  /** Folder of the engine's files. */
  readonly base: string;
  readonly scenario: string;
  /** Of the world; more than one need an isolated page. */
  readonly threads: number;
}

export class EngineLink {
  /** Leads to the engine, for the link's worker. */
  readonly port: MessagePort;
  private readonly waiting_ = new Map<number, (answer: Response) => void>();
  private readonly exports_: EngineExports;
  private readonly base_: string;
  private last_ = 0;

  /** `failed` is told where the engine cannot run. */
  constructor(
    private readonly worker_: EnginePort,
    begin: EngineBegin,
    makeWorker: () => EnginePort,
    private readonly failed_: (problem: string) => void,
  ) {
    const channel = new MessageChannel();
    this.port = channel.port1;
    this.base_ = begin.base;
    this.exports_ = new EngineExports(begin.base, makeWorker, (path) => this.ask(path));
    worker_.onmessage = ({ data }) => this.receive(data);
    worker_.postMessage({ kind: 'start', ...begin, port: channel.port2 }, [channel.port2]);
  }

  readonly ask: Ask = async (path, init = {}) => {
    const target = `/${path}`;
    const method = init.method ?? 'GET';
    if (target === '/exports' || target.startsWith('/exports/')) return this.exports_.answer(method, target, init.body);
    const body = await bytesOf(init.body);
    const id = ++this.last_;
    return new Promise((done) => {
      this.waiting_.set(id, done);
      this.worker_.postMessage({ kind: 'ask', id, method, target, body });
    });
  };

  /** Loads what a crowd that walks did not need. */
  complete(): void {
    this.worker_.postMessage({ kind: 'prepare', base: this.base_ });
  }

  private receive(message: FromEngine): void {
    if (message.kind === 'failed') this.failed_(message.problem);
    if (message.kind !== 'answer') return;
    this.waiting_.get(message.id)?.(responseOf(message.answer));
    this.waiting_.delete(message.id);
  }
}
