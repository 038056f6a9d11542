// Shared by the tests of the tools: a client that records messages, contacts, and frames.

import type { ClientMessage, ControlFrame, TouchEvent } from '../protocol/messages';
import type { StudioFrame } from '../model/studio_frame';
import type { Contact } from './contact';
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

  types(): string[] {
    return this.sent.map((message) => message.type);
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
  };
  return { type: 'Frame', step, groups: [group] } as unknown as StudioFrame;
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
