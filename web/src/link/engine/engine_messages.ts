// Messages between the page and the worker that runs the engine, and over the port between that worker and the link's.

import type { EngineAnswer } from 'muster-engine/studio';

export interface EngineRequest {
  readonly id: number;
  readonly method: string;
  /** "/takes", "/scenario?name=market" */
  readonly target: string;
  readonly body: Uint8Array;
}

export type ToEngine =
  /** Loads all of the engine, so that it can start, or go on, without a network. */
  | { readonly kind: 'prepare'; readonly base: string }
  /** Runs the studio. `port` leads to the link's worker. */
  | {
      readonly kind: 'start';
      readonly base: string;
      readonly scenario: string;
      readonly threads: number;
      readonly port: MessagePort;
    }
  | ({ readonly kind: 'ask' } & EngineRequest)
  /** Makes one export of a take and ends. */
  | {
      readonly kind: 'export';
      readonly base: string;
      readonly order: string;
      readonly name: string;
      readonly take: Uint8Array;
    };

export type FromEngine =
  | { readonly kind: 'prepared' }
  | { readonly kind: 'answer'; readonly id: number; readonly answer: EngineAnswer }
  | { readonly kind: 'failed'; readonly problem: string }
  | { readonly kind: 'progress'; readonly share: number }
  | { readonly kind: 'exported'; readonly file: string; readonly bytes: Uint8Array<ArrayBuffer> };

/** Over the port: a WebSocket's events and calls. */
export type SocketMessage =
  { readonly kind: 'open' } | { readonly kind: 'bytes'; readonly bytes: ArrayBuffer } | { readonly kind: 'close' };
