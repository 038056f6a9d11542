// Messages between page and worker.

import type { LinkState } from '../model/link_state';
import type { ClientMessage, Frame, ServerMessage } from '../protocol/messages';
import type { StudioFrame } from '../model/studio_frame';

export type ToWorker =
  | { readonly kind: 'open'; readonly url: string }
  /** The port leads to the engine beside the page, which is connected to instead of a server. */
  | { readonly kind: 'engine'; readonly port: MessagePort }
  | { readonly kind: 'send'; readonly message: ClientMessage }
  /** The page has taken the last frame and has time for another. */
  | { readonly kind: 'ready' }
  | { readonly kind: 'retry' };

export type FromWorker =
  | { readonly kind: 'message'; readonly message: Exclude<ServerMessage, Frame> }
  /** `receivedAt` since the epoch [ms], as worker and page have different origins of time. */
  | { readonly kind: 'frame'; readonly frame: StudioFrame; readonly receivedAt: number }
  | { readonly kind: 'link'; readonly state: LinkState };
