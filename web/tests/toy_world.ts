// A world that moves just enough to look at the page: meshes follow the mean movement of their fingers.

import {
  ControlKind, OverlayKind, TouchPhase, TransportAction,
  type ClientMessage, type ControlFrame, type Frame, type GroupFrame, type GroupMesh, type ServerMessage, type TouchEvent,
} from '../src/protocol/messages';

interface Finger {
  x: number;
  y: number;
  down: boolean;
  readonly control: number;
}

interface ToyGroup {
  readonly id: number;
  readonly name: string;
  readonly side: number;
  formation: string;
  version: number;
  x: number;
  y: number;
}

const SPACING = 1.1;
const JOIN_SECONDS = 0.15;

function square(side: number): { triangles: number[]; boundary: number[] } {
  const n = side + 1;
  const triangles: number[] = [];
  for (let j = 0; j < side; ++j) {
    for (let i = 0; i < side; ++i) {
      const a = j * n + i;
      triangles.push(a, a + 1, a + n + 1, a, a + n + 1, a + n);
    }
  }
  const loop: number[] = [];
  for (let i = 0; i < side; ++i) loop.push(i);
  for (let j = 0; j < side; ++j) loop.push(j * n + side);
  for (let i = side; i > 0; --i) loop.push(side * n + i);
  for (let j = side; j > 0; --j) loop.push(j * n);
  return { triangles, boundary: [loop.length, ...loop] };
}

export class ToyWorld {
  private frame = 0;
  private steps = 0;
  private playing = true;
  private speed = 1;
  private recorded = -1;
  private echo = 0;
  private nextControl = 1;
  private readonly groups: ToyGroup[] = [
    { id: 1, name: 'North', side: 8, formation: 'square', version: 1, x: -5, y: 0 },
    { id: 2, name: 'South', side: 6, formation: 'wedge', version: 1, x: 7, y: -3 },
  ];
  private readonly fingers = new Map<number, Finger>();
  private readonly controls = new Map<number, { group: number; began: number; pinned: boolean; touches: number[] }>();

  greeting(): ServerMessage[] {
    const scenarios = ['Open', 'Block', 'Corridor', 'Woodland'].map((title) => {
      return { name: title.toLowerCase(), title, description: 'A scenario of the mock, to see how the list looks.', characters: 100 };
    });
    return [{ type: 'Welcome', client: 1, version: 'mock', scenarios }, this.scene(), ...this.groups.map((group) => this.mesh(group))];
  }

  receive(message: ClientMessage): ServerMessage[] {
    switch (message.type) {
      case 'Touches':
        for (const event of message.events) this.touch(event);
        return [];
      case 'AddControl': {
        const id = this.nextControl++;
        this.controls.set(id, { group: message.group, began: -1, pinned: false, touches: [...message.touches] });
        message.touches.forEach((touch, i) => this.fingers.set(touch, { x: message.xs[i]!, y: message.ys[i]!, down: true, control: id }));
        return [];
      }
      case 'PinControl':
        this.controls.get(message.control)!.pinned = message.pinned;
        return [];
      case 'RemoveControl':
        this.controls.delete(message.control);
        return [];
      case 'Transport':
        if (message.action === TransportAction.Play) this.playing = true;
        if (message.action === TransportAction.Pause) this.playing = false;
        return [];
      case 'SetSpeed':
        this.speed = message.factor;
        return [];
      case 'Record':
        this.recorded = message.on ? 0 : -1;
        return [];
      case 'SetFormation': {
        const group = this.groups.find((one) => one.id === message.group)!;
        group.formation = message.formation;
        group.version += 1;
        return [this.mesh(group)];
      }
      case 'LoadScenario':
        return [this.scene(message.name), { type: 'Notice', level: 2, code: 'load', text: `scenarios/${message.name}.json: line 12: “count” is 0, expected 1 to 100000.` }];
      case 'SetOverlay':
        return message.kind === OverlayKind.None ? [] : [this.overlay(message.kind, message.character)];
      case 'Ping':
        return [{ type: 'Pong', time: message.time }];
      default:
        return [];
    }
  }

  step(): Frame {
    this.frame += 1;
    if (this.playing) this.steps += 1;
    if (this.recorded >= 0 && this.playing) this.recorded += 1 / 60;
    const groups = this.groups.map((group) => this.groupFrame(group));
    const all = groups.flatMap((group) => Array.from(group.places));
    const x = Float32Array.from(all.filter((_, i) => i % 2 === 0));
    const y = Float32Array.from(all.filter((_, i) => i % 2 === 1));
    const wave = Math.sin(this.frame / 40);
    return {
      type: 'Frame', frame: this.frame, step: this.steps, time: this.steps / 60, playing: this.playing, speed: this.speed,
      recordedSeconds: this.recorded, replaying: false, touchEcho: this.echo, sceneRevision: 1,
      ids: Uint32Array.from(x, (_, i) => i), group: Uint8Array.from(x, (_, i) => (i < 64 ? 0 : 1)), x, y,
      heading: Float32Array.from(x, () => 1.2), motion: new Uint8Array(x.length), phase: Uint8Array.from(x, (_, i) => (this.steps * 4 + i * 31) % 256),
      groups, moving: [], collected: new Uint8Array(), stepMs: 6.2 + wave, lagP95: 0.84 + 0.1 * wave, swapsPerSecond: 0.02, events: [],
    };
  }

  private touch(event: TouchEvent): void {
    this.echo = Math.max(this.echo, event.time);
    const finger = this.fingers.get(event.touch);
    if (event.phase === TouchPhase.Down) {
      const open = [...this.controls].find(([, one]) => one.group === event.group && one.began >= 0 && event.time - one.began < JOIN_SECONDS);
      const id = open?.[0] ?? this.nextControl++;
      if (!open) this.controls.set(id, { group: event.group, began: event.time, pinned: false, touches: [] });
      this.controls.get(id)!.touches.push(event.touch);
      this.fingers.set(event.touch, { x: event.x, y: event.y, down: true, control: id });
      return;
    }
    const control = finger && this.controls.get(finger.control);
    if (!finger || !control) return;
    if (event.phase === TouchPhase.Move) {
      const group = this.groups.find((one) => one.id === control.group)!;
      group.x += (event.x - finger.x) / control.touches.length;
      group.y += (event.y - finger.y) / control.touches.length;
      finger.x = event.x;
      finger.y = event.y;
      return;
    }
    finger.down = false;
    const gone = control.touches.every((touch) => !this.fingers.get(touch)?.down);
    if (gone && !control.pinned) this.controls.delete(finger.control);
  }

  private groupFrame(group: ToyGroup): GroupFrame {
    const vertices: number[] = [];
    const places: number[] = [];
    const half = group.side / 2;
    for (let j = 0; j <= group.side; ++j) for (let i = 0; i <= group.side; ++i) vertices.push(group.x + (i - half) * SPACING, group.y + (j - half) * SPACING);
    for (let j = 0; j < group.side; ++j) for (let i = 0; i < group.side; ++i) places.push(group.x + (i - half + 0.5) * SPACING, group.y + (j - half + 0.5) * SPACING);
    return {
      id: group.id, meshVersion: group.version, lag: 0.4, vertices: Float32Array.from(vertices), places: Float32Array.from(places),
      fit: Uint8Array.from(places.slice(0, places.length / 2), () => 1), controls: this.controlFrames(group.id),
    };
  }

  private controlFrames(group: number): ControlFrame[] {
    return [...this.controls].filter(([, one]) => one.group === group).map(([id, one]) => {
      const kind = one.touches.length === 1 ? ControlKind.Point : one.touches.length === 2 ? ControlKind.Line : ControlKind.Area;
      const points = one.touches.map((touch) => {
        const { x, y, down } = this.fingers.get(touch)!;
        return { touch, down, x, y, path: new Float32Array() };
      });
      return { id, kind, client: 1, pinned: one.pinned, open: false, points, supplementary: new Float32Array() };
    });
  }

  private mesh(group: ToyGroup): GroupMesh {
    const { triangles, boundary } = square(group.side);
    return {
      type: 'GroupMesh', group: group.id, version: group.version, formation: group.formation,
      triangles: Uint32Array.from(triangles), boundary: Uint32Array.from(boundary),
    };
  }

  private overlay(kind: OverlayKind, character: number): ServerMessage {
    const width = 80;
    const values = Float32Array.from({ length: width * width }, (_, i) => Math.hypot((i % width) - 40, Math.floor(i / width) - 40) / 2);
    return {
      type: 'Overlay', kind, character, x: -20, y: -20, cell: 0.5, width, height: width, values, cost: 9.3, way: 28.2, straight: 24.6,
      path: Float32Array.from([-8, 6, -2, 2, 0, 0]),
    };
  }

  private scene(name = 'open'): ServerMessage {
    const box = (x: number, y: number, w: number, h: number) => [[x, y], [x + w, y], [x + w, y + h], [x, y + h]];
    const json = JSON.stringify({
      name, title: 'Market square', description: '', credit: 'Map data: OpenStreetMap contributors', box: { min: [-20, -20], max: [20, 20] }, cell: 0.5, radius: 0.25,
      obstacles: [
        { id: 1, name: 'House', polygon: box(-19, 9, 12, 6), height: 6, moving: false },
        { id: 2, name: 'House', polygon: box(10, 10, 8, 8), height: 6, moving: false },
        { id: 3, name: 'Fountain', centre: [0, 8], radius: 1.6, height: 1, moving: false },
      ],
      patches: [
        { id: 1, name: 'Net', polygon: box(-3, 3, 6, 3), motion: 1, speed: 0.21, moving: false },
        { id: 2, name: 'Pool', polygon: box(5, 3, 7, 4), motion: 2, speed: 0.34, moving: false },
      ],
      clips: [{ name: 'run', speed: 1, cyclic: true }, { name: 'crawl', speed: 0.21, cyclic: true }, { name: 'swim', speed: 0.34, cyclic: true }],
      groups: this.groups.map((group, i) => ({ id: group.id, name: group.name, count: group.side ** 2, formation: group.formation, colour: i })),
    });
    return { type: 'Scene', revision: 1, json };
  }
}
