// The engine that waits in this browser while a server simulates: where that is lost, the world goes on here.

import { answerBy, type Ask } from '../answers';
import type { StudioClient } from '../studio_client';
import { EngineLink, type EnginePort } from './engine_link';
import { KeptWorld } from './kept_world';

/** The world is asked for this often at least, and less often where it is large [ms]. */
const kShortestPause = 2000;
const kLongestPause = 30000;
/** As much as that may be sent for it [bytes/ms]. */
const kMostTraffic = 150;

/** The pause after a handover of so many bytes [ms]. */
export function pauseAfter(bytes: number): number {
  return Math.min(kLongestPause, Math.max(kShortestPause, bytes / kMostTraffic));
}

export interface StandbyParts {
  readonly client: Pick<StudioClient, 'connectEngine' | 'state'>;
  /** Folder of the engine's files. */
  readonly base: string;
  readonly makeWorker: () => EnginePort;
  /** Requests to the server. */
  readonly askServer: Ask;
  /** True while nobody sees the page. */
  readonly hidden: () => boolean;
  readonly failed: (problem: string) => void;
}

export class Standby {
  private readonly kept_ = new KeptWorld();
  private worker_: EnginePort | null = null;
  private timer_: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly parts_: StandbyParts) {}

  /** Loads the engine; resolves when it can start without a network. */
  prepare(): Promise<void> {
    const worker = this.parts_.makeWorker();
    return new Promise((done, failed) => {
      worker.onmessage = ({ data }) => {
        if (data.kind === 'prepared') {
          this.worker_ = worker;
          done();
        } else if (data.kind === 'failed') {
          worker.terminate();
          failed(new Error(data.problem));
        }
      };
      worker.postMessage({ kind: 'prepare', base: this.parts_.base });
    });
  }

  /** Keeps the server's world from now on. */
  keep(pause = 0): void {
    this.timer_ = setTimeout(() => {
      const again = (bytes: number): void => this.keep(pauseAfter(bytes));
      this.keepOnce().then(again, () => again(0));
    }, pause);
  }

  /** The engine goes on with the world that is kept, or begins with a scenario where there is none. */
  async goOn(scenario: string): Promise<void> {
    if (!this.worker_) await this.prepare();
    const worker = this.worker_!;
    // An engine that has begun cannot begin again.
    this.worker_ = null;
    const { base, makeWorker, failed, client } = this.parts_;
    const link = new EngineLink(worker, { base, scenario, threads: 1 }, makeWorker, failed);
    const world = this.kept_.whole();
    if (world) {
      const taken = await link.ask('handover', { method: 'POST', body: world });
      if (!taken.ok) {
        worker.terminate();
        throw new Error((await taken.text()).trim());
      }
    }
    clearTimeout(this.timer_);
    answerBy(link.ask);
    client.connectEngine(link.port);
  }

  /** The bytes that came. */
  private async keepOnce(): Promise<number> {
    const { askServer, client, hidden } = this.parts_;
    if (client.state.phase !== 'open' || hidden()) return 0;
    const answer = await askServer(this.kept_.query);
    if (!answer.ok) return 0;
    const bytes = new Uint8Array(await answer.arrayBuffer());
    this.kept_.add(bytes);
    return bytes.length;
  }
}
