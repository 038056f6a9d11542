// Exports beside the page: each in a worker of its own, which ends where it is cancelled.

import type { Ask } from '../answers';
import type { EnginePort } from './engine_link';

interface Job {
  readonly worker: EnginePort;
  state: 'running' | 'done' | 'failed';
  share: number;
  file: string;
  bytes: Uint8Array<ArrayBuffer> | null;
  problem: string;
  /** The bytes say in JSON how large it would be. */
  readonly estimate: boolean;
}

/** Finished files that are kept. */
const kMostKept = 6;

const sentence = (status: number, words: string): Response => new Response(`${words}\n`, { status });

function json(value: object): Response {
  return new Response(JSON.stringify(value), { headers: { 'Content-Type': 'application/json' } });
}

export class EngineExports {
  private readonly jobs_ = new Map<string, Job>();
  private last_ = 0;

  constructor(
    private readonly base_: string,
    private readonly makeWorker_: () => EnginePort,
    private readonly ask_: Ask,
  ) {}

  async answer(method: string, target: string, body: BodyInit | null | undefined): Promise<Response> {
    if (method === 'POST') return this.begin(await new Response(body ?? '').text());
    const [, , number = '', rest = ''] = target.split('/');
    const job = this.jobs_.get(number);
    if (!job) return sentence(404, 'there is no such export');
    if (method === 'DELETE') return this.cancel(number, job);
    if (rest === 'file') return job.bytes ? new Response(job.bytes) : sentence(404, 'The export is not done.');
    const { state, share, file, bytes, problem, estimate } = job;
    const told = estimate && bytes ? (JSON.parse(new TextDecoder().decode(bytes)) as object) : {};
    return json({ state, share, file, bytes: bytes?.length ?? 0, ...told, ...(problem ? { problem } : {}) });
  }

  private async begin(order: string): Promise<Response> {
    const { take, estimate = false } = JSON.parse(order) as { readonly take: string; readonly estimate?: boolean };
    const found = await this.ask_(`takes/${take}`);
    if (!found.ok) return found;
    this.forgetOldest();
    const number = String(++this.last_);
    const worker = this.makeWorker_();
    const job: Job = { worker, state: 'running', share: 0, file: '', bytes: null, problem: '', estimate };
    this.jobs_.set(number, job);
    worker.onmessage = ({ data }) => {
      if (data.kind === 'progress') job.share = data.share;
      if (data.kind === 'exported') Object.assign(job, { state: 'done', share: 1, file: data.file, bytes: data.bytes });
      if (data.kind === 'failed') Object.assign(job, { state: 'failed', problem: data.problem });
      if (data.kind !== 'progress') worker.terminate();
    };
    const bytes = new Uint8Array(await found.arrayBuffer());
    worker.postMessage({ kind: 'export', base: this.base_, order, name: take, take: bytes }, [bytes.buffer]);
    return json({ number });
  }

  private cancel(number: string, job: Job): Response {
    job.worker.terminate();
    this.jobs_.delete(number);
    return json({});
  }

  private forgetOldest(): void {
    if (this.jobs_.size < kMostKept) return;
    for (const [number, { state }] of this.jobs_) if (state !== 'running') return void this.jobs_.delete(number);
  }
}
