// The page's side of the connection: typed events in, messages out.

import type {
  ClientMessage,
  Directors,
  EditHistory,
  Forecasts,
  Frame,
  GroupMesh,
  Marks,
  Motions,
  Notice,
  Overlay,
  Places,
  Standings,
  Pong,
  Said,
  Scene,
  ServerMessage,
  StageTimes,
  StudyForm,
  StudyState,
  TakeKept,
  TakeEdits,
  TakePath,
  TakeReady,
  TakeTracks,
  Ask,
  AskAnswered,
  PlaceKept,
  Scenarios,
  SharedWorld,
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
  places: Places;
  standings: Standings;
  said: Said;
  marks: Marks;
  studyForm: StudyForm;
  studyState: StudyState;
  directors: Directors;
  takeState: TakeState;
  sharedWorld: SharedWorld;
  ask: Ask;
  askAnswered: AskAnswered;
  scenarios: Scenarios;
  placeKept: PlaceKept;
  takeReady: TakeReady;
  takeTracks: TakeTracks;
  takeKept: TakeKept;
  editHistory: EditHistory;
  takePath: TakePath;
  takeEdits: TakeEdits;
  stageTimes: StageTimes;
}

/** The events of messages that are handed on as they come. */
const kEvents = {
  Welcome: 'welcome',
  Scene: 'scene',
  Motions: 'motions',
  GroupMesh: 'groupMesh',
  Overlay: 'overlay',
  Notice: 'notice',
  Forecasts: 'forecasts',
  Places: 'places',
  Standings: 'standings',
  Said: 'said',
  Marks: 'marks',
  StudyForm: 'studyForm',
  StudyState: 'studyState',
  Directors: 'directors',
  TakeState: 'takeState',
  SharedWorld: 'sharedWorld',
  Ask: 'ask',
  AskAnswered: 'askAnswered',
  Scenarios: 'scenarios',
  PlaceKept: 'placeKept',
  TakeReady: 'takeReady',
  TakeTracks: 'takeTracks',
  TakeKept: 'takeKept',
  EditHistory: 'editHistory',
  TakePath: 'takePath',
  TakeEdits: 'takeEdits',
  StageTimes: 'stageTimes',
} as const satisfies Record<Exclude<ServerMessage, Frame | Pong>['type'], keyof StudioEvents>;

/** What the client needs of a Worker. */
export interface WorkerPort {
  onmessage: ((event: MessageEvent<FromWorker>) => void) | null;
  postMessage(message: ToWorker, transfer?: Transferable[]): void;
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

  /** Connects to the engine beside the page. */
  connectEngine(port: MessagePort): void {
    this.worker_.postMessage({ kind: 'engine', port }, [port]);
  }

  send(message: ClientMessage): void {
    this.worker_.postMessage({ kind: 'send', message });
  }

  /** Tells the visitor of something that went wrong on the page's side. */
  tell(notice: Notice): void {
    this.emit('notice', notice);
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
    if (message.type === 'Pong') return;
    if (message.type === 'Welcome') this.clientId = message.client;
    // Each type has the event of its own name.
    this.emit(kEvents[message.type], message);
  }
}
