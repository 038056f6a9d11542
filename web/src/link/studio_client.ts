// The page's side of the connection: typed events in, messages out.

import type {
  ClientMessage,
  Directors,
  Forecasts,
  Frame,
  GroupMesh,
  Marks,
  Motions,
  Notice,
  Overlay,
  Scene,
  ServerMessage,
  StudyForm,
  StudyState,
  TakeKept,
  TakeReady,
  TakeState,
  Welcome,
} from '../protocol/messages';
import { Emitter } from './emitter';
import type { StudioFrame } from '../model/studio_frame';
import type { FromWorker, ToWorker } from './link_messages';
import type { LinkState } from '../model/link_state';

export interface StudioEvents {
  link: LinkState;
  welcome: Welcome;
  scene: Scene;
  motions: Motions;
  groupMesh: GroupMesh;
  /** `receivedAt` by performance.now() [ms]. */
  frame: { readonly frame: StudioFrame; readonly receivedAt: number };
  overlay: Overlay;
  notice: Notice;
  forecasts: Forecasts;
  marks: Marks;
  studyForm: StudyForm;
  studyState: StudyState;
  directors: Directors;
  takeState: TakeState;
  takeReady: TakeReady;
  takeKept: TakeKept;
}

/** What the client needs of a Worker. */
export interface WorkerPort {
  onmessage: ((event: MessageEvent<FromWorker>) => void) | null;
  postMessage(message: ToWorker): void;
}

/** Tools and panels hold no more of the client than this. */
export interface MessageSender {
  send(message: ClientMessage): void;
}

export class StudioClient extends Emitter<StudioEvents> implements MessageSender {
  /** Our number; 0 before the welcome. */
  clientId = 0;
  state: LinkState = { phase: 'connecting' };

  constructor(
    private readonly worker_: WorkerPort,
    private readonly timeOrigin_: number = performance.timeOrigin,
  ) {
    super();
    worker_.onmessage = (event) => this.receive(event.data);
  }

  connect(url: string): void {
    this.worker_.postMessage({ kind: 'open', url });
  }

  send(message: ClientMessage): void {
    this.worker_.postMessage({ kind: 'send', message });
  }

  /** Tries to reach a lost server now. */
  retry(): void {
    this.worker_.postMessage({ kind: 'retry' });
  }

  private receive(message: FromWorker): void {
    switch (message.kind) {
      case 'link':
        this.state = message.state;
        this.emit('link', message.state);
        break;
      case 'frame':
        // The next frame may come as soon as this one is taken: drawing is not waited for.
        this.worker_.postMessage({ kind: 'ready' });
        this.emit('frame', { frame: message.frame, receivedAt: message.receivedAt - this.timeOrigin_ });
        break;
      case 'message':
        this.dispatch(message.message);
        break;
    }
  }

  private dispatch(message: Exclude<ServerMessage, Frame>): void {
    switch (message.type) {
      case 'Welcome':
        this.clientId = message.client;
        this.emit('welcome', message);
        break;
      case 'Scene':
        this.emit('scene', message);
        break;
      case 'Motions':
        this.emit('motions', message);
        break;
      case 'GroupMesh':
        this.emit('groupMesh', message);
        break;
      case 'Overlay':
        this.emit('overlay', message);
        break;
      case 'Notice':
        this.emit('notice', message);
        break;
      case 'Forecasts':
        this.emit('forecasts', message);
        break;
      case 'Marks':
        this.emit('marks', message);
        break;
      case 'StudyForm':
        this.emit('studyForm', message);
        break;
      case 'StudyState':
        this.emit('studyState', message);
        break;
      case 'Directors':
        this.emit('directors', message);
        break;
      case 'TakeState':
        this.emit('takeState', message);
        break;
      case 'TakeReady':
        this.emit('takeReady', message);
        break;
      case 'TakeKept':
        this.emit('takeKept', message);
        break;
      case 'Pong':
        break;
    }
  }
}
