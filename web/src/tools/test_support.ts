// Shared by the tests of the tools: a client that records messages, contacts, and frames.

import type { Command } from '../protocol/generated/commands';
import type { ClientMessage, ControlFrame, TouchEvent } from '../protocol/messages';
import type { StudioFrame } from '../model/studio_frame';
import { kIdle } from '../model/test_frames';
import type { Cut, Cuttable } from '../model/cut';
import type { OrderedGroup, PlannedMove } from '../model/order_plan';
import type { CameraControls } from '../scene/camera/camera_controls';
import { CameraGesture } from './camera_gesture';
import type { Contact } from './contact';
import type { CutPreview } from './cut_tool';
import { OrderChooser, type OrderControllerSink } from './order_chooser';
import type { OrderPreview } from './order_tools';
import type { GroundPoint, ScreenPoint } from '../model/plane';

export class FakeClient {
  readonly sent: ClientMessage[] = [];

  send(message: ClientMessage): void {
    this.sent.push(message);
  }

  /** All touch events that were sent, in order. */
  touches(): TouchEvent[] {
    return this.sent.flatMap((message) => (message.type === 'Touches' ? message.events : []));
  }

  /** All commands that were sent, in order. */
  commands(): Command[] {
    return this.sent.flatMap((message) => (message.type === 'Commands' ? message.commands : []));
  }

  /** What was sent, in order: kinds of commands, and types of other messages. */
  types(): string[] {
    return this.sent.flatMap((message) =>
      message.type === 'Commands' ? message.commands.map(({ kind }) => kind) : [message.type],
    );
  }
}

/** A metre on the ground is 100 px on this screen. */
export function onScreen({ x, y }: GroundPoint): ScreenPoint {
  return { x: x * 100, y: y * 100 };
}

export function contactAt(x: number, y: number, more: Partial<Contact> = {}): Contact {
  return {
    pointer: 1,
    kind: 'touch',
    screen: onScreen({ x, y }),
    ground: { x, y },
    time: 0,
    button: 0,
    shift: false,
    alt: false,
    ...more,
  };
}

export function controlFrame(
  id: number,
  kind: 0 | 1 | 2,
  at: readonly GroundPoint[],
  more: Partial<ControlFrame> = {},
): ControlFrame {
  const points = at.map(({ x, y }, i) => ({ touch: i + 1, down: false, x, y, path: new Float32Array() }));
  return { id, kind, client: 1, pinned: false, open: false, points, supplementary: new Float32Array(), ...more };
}

/** A frame with one group, 5, that has these controls. */
export function frameWith(step: number, controls: readonly ControlFrame[]): StudioFrame {
  const group = {
    id: 5,
    meshVersion: 1,
    lag: 0,
    vertices: new Float32Array(),
    places: new Float32Array(),
    fit: new Uint8Array(),
    controls,
    ...kIdle,
  };
  return { type: 'Frame', step, groups: [group] } as unknown as StudioFrame;
}

/** An order chooser that has no tool in hand and no groups and no groups. */
export function noOrders(): OrderChooser {
  const camera = new CameraGesture({
    pan: () => undefined,
    pinch: () => undefined,
  } as unknown as CameraControls);
  return new OrderChooser({ orders: new FakeController(), camera, tool: () => 'steer', toGround: (at) => at });
}

/** Records what orders, cuts and boxes come to. */
export class FakeController implements OrderControllerSink {
  readonly did: string[] = [];
  ordered: readonly OrderedGroup[] = [];
  cuttable: readonly Cuttable[] = [];
  moves: readonly PlannedMove[] = [];
  shown: OrderPreview | null = null;
  cutShown: CutPreview | null = null;
  chosenAt: (at: GroundPoint) => boolean = () => false;

  groups = (): readonly OrderedGroup[] => this.ordered;
  formations = (): readonly Cuttable[] => this.cuttable;
  isChosenAt = (at: GroundPoint): boolean => this.chosenAt(at);
  previewOrder(preview: OrderPreview | null): void {
    this.shown = preview;
  }
  previewCut(preview: CutPreview | null): void {
    this.cutShown = preview;
  }
  previewBox(): void {}
  move(moves: readonly PlannedMove[], { shift, alt }: Contact): void {
    this.moves = moves;
    this.did.push(`move${shift ? ' queued' : ''}${alt ? ' free' : ''}`);
  }
  guard(centre: GroundPoint, half: GroundPoint): void {
    this.did.push(`guard ${centre.x},${centre.y} ${half.x},${half.y}`);
  }
  follow(at: GroundPoint): void {
    this.did.push(`follow ${at.x},${at.y}`);
  }
  leave(at: GroundPoint): void {
    this.did.push(`leave ${at.x},${at.y}`);
  }
  wait(at: GroundPoint): void {
    this.did.push(`wait ${at.x},${at.y}`);
  }
  split(cut: Cut): void {
    this.did.push(`split ${cut.group}: ${cut.left} | ${cut.right}`);
  }
  merge(into: number, dragged: number): void {
    this.did.push(`merge ${dragged} into ${into}`);
  }
  missed(): void {
    this.did.push('missed');
  }
  choose(index: number, add: boolean): void {
    this.did.push(`choose ${index}${add ? ' too' : ''}`);
  }
  chooseWithin(from: ScreenPoint, to: ScreenPoint): void {
    this.did.push(`box ${from.x},${from.y} ${to.x},${to.y}`);
  }
}

export class FakeScene {
  readonly marks: [number, GroundPoint | null, number][] = [];
  preview: readonly GroundPoint[] | null = null;

  touchMark(id: number, world: GroundPoint | null, groupIndex: number): void {
    this.marks.push([id, world, groupIndex]);
  }
  previewControl(_group: number, points: readonly GroundPoint[] | null): void {
    this.preview = points && [...points];
  }
  worldToScreen = onScreen;
}
