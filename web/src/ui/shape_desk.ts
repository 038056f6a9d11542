// Formations of a visitor's own, and new groups: an outline drawn with a finger, words, and a group put on the ground.

import type { MessageSender } from '../link/studio_client';
import { commandText, moveEvent, type CommandEvent } from '../model/commands';
import { areaOf, centreOf, outlineFrom } from '../model/outline';
import type { GroundPoint } from '../model/plane';
import type { NewGroup, ShapeActions } from '../model/shape_actions';
import type { OwnShape } from '../model/shape_edit';
import type { StudioFrame } from '../model/studio_frame';
import type { StudioStore } from '../model/studio_store';
import { problem } from '../protocol/problem';
import type { Contact, ContactOwner } from '../tools/contact';
import { OutlineDraw, PlacePress, type OutlineSink } from '../tools/outline_draw';

/** Distance of neighbours in a drawn formation [m]: as the drawing has room, between these. */
const kSpacing = { least: 0.7, most: 3 };
/** Of neighbours in a triangular lattice: the share of its square that one takes. */
const kLattice = Math.sqrt(3) / 2;
/** An outline drawn so near to the middle of the group changes its shape where it is [m]. */
const kHere = 4;
/** Neighbours in words stand so far apart [m]. */
const kWordGap = 0.9;
const kStyle = { manner: 'march', turn: 'keep', mode: 'replace' } as const;

export interface ShapeDeskHost {
  readonly client: MessageSender;
  readonly store: StudioStore;
  /** The shape of a group; undefined where its mesh has not come yet. */
  shapeOf(group: number): OwnShape | undefined;
  /** Direction of view on the ground, from +y [rad]. */
  viewTurn(): number;
  previewControl(groupIndex: number, points: readonly GroundPoint[] | null, closed: boolean): void;
  say(text: string): void;
}

export class ShapeDesk implements ShapeActions, OutlineSink {
  private frame_: StudioFrame | null = null;
  private held_: NewGroup | null = null;
  private picture_: File | null = null;

  constructor(private readonly host_: ShapeDeskHost) {}

  observe(frame: StudioFrame): void {
    this.frame_ = frame;
  }

  /** Who owns a contact, by the tool in hand; null where it is no concern of shapes. */
  owner(contact: Contact): ContactOwner | null {
    const { tool } = this.host_.store.state;
    if (!contact.ground || contact.button > 0) return null;
    if (tool === 'draw') return new OutlineDraw(this);
    if (tool !== 'place' || !this.held_) return null;
    return new PlacePress(
      (at) => this.previewGroup(at),
      (at) => this.putDown(at),
    );
  }

  toggleDraw(): void {
    const { tool } = this.host_.store.state;
    this.host_.store.set({ tool: tool === 'draw' ? 'steer' : 'draw' });
    this.host_.say(tool === 'draw' ? 'Steer' : 'Draw an outline on the ground');
  }

  takeWords(places: readonly GroundPoint[], gap: number, words: string): void {
    const { group, facing } = this.active();
    if (!group) return;
    const scale = kWordGap / Math.max(gap, 1e-9);
    // Words are read from where the visitor looks: their right is the picture's right.
    const turn = this.host_.viewTurn() - facing;
    const [c, s] = [Math.cos(turn), Math.sin(turn)];
    const points = places.map(({ x, y }) => [round(scale * (c * x - s * y)), round(scale * (s * x + c * y))]);
    this.send([{ kind: 'formation', group: group.id, formation: { kind: 'points', spacing: kWordGap, points } }]);
    this.host_.say(`${group.name}: ${words}`);
  }

  shape(): OwnShape | null {
    const { group } = this.active();
    return (group && this.host_.shapeOf(group.id)) ?? null;
  }

  openPicture(picture: File): void {
    this.picture_ = picture;
    // A dialog that is open reads it at once.
    this.host_.store.set({ dialog: 'none' });
    this.host_.store.set({ dialog: 'shape' });
  }

  takePicture(): File | null {
    const picture = this.picture_;
    this.picture_ = null;
    return picture;
  }

  takeShape({ spacing, places }: OwnShape, title: string): void {
    const { group } = this.active();
    if (!group) return;
    const points = places.map(({ x, y }) => [round(x), round(y)]);
    const formation = { kind: 'points', spacing: round(spacing), points };
    this.send([{ kind: 'formation', group: group.id, formation }]);
    this.host_.say(`${group.name}: ${title}`);
  }

  holdGroup(group: NewGroup): void {
    this.held_ = group;
    this.host_.store.set({ tool: 'place' });
    this.host_.say(`Press on the ground where ${group.name} shall stand`);
  }

  previewOutline(points: readonly GroundPoint[] | null): void {
    this.host_.previewControl(Math.max(0, this.host_.store.state.active), points, true);
  }

  outlineDrawn(stroke: readonly GroundPoint[]): void {
    const { group, at, facing, count } = this.active();
    if (!group) return;
    const outline = outlineFrom(stroke);
    if ('why' in outline) {
      this.host_.store.set({ notice: problem('outline', outline.why) });
      return;
    }
    const centre = centreOf(outline.corners);
    const room = Math.sqrt(areaOf(outline.corners) / (Math.max(1, count) * kLattice));
    const [c, s] = [Math.cos(-facing), Math.sin(-facing)];
    const corners = outline.corners.map(({ x, y }) => {
      const [dx, dy] = [x - centre.x, y - centre.y];
      return [round(c * dx - s * dy), round(s * dx + c * dy)];
    });
    const spacing = round(Math.min(kSpacing.most, Math.max(kSpacing.least, room)));
    const formation = { kind: 'outline', spacing, outline: corners };
    const here = Math.hypot(centre.x - at.x, centre.y - at.y) < kHere;
    const move = moveEvent(group.id, { target: centre, facing, width: 0, route: [], formation }, kStyle);
    this.send(here ? [{ kind: 'formation', group: group.id, formation }] : [move]);
    this.host_.store.set({ tool: 'steer' });
    this.host_.say(`${group.name}: drawn outline`);
  }

  private active() {
    const { groups, active } = this.host_.store.state;
    const seen = this.frame_?.groups[active];
    const group = groups[active];
    const at = { x: seen?.x ?? 0, y: seen?.y ?? 0 };
    return { group, at, facing: seen?.facing ?? 0, count: group?.count ?? 0 };
  }

  /** The square that the new group takes up. */
  private previewGroup(at: GroundPoint | null): void {
    const held = this.held_;
    const half = held ? (held.spacing * Math.sqrt(held.count)) / 2 : 0;
    const corners = [
      [-1, -1],
      [1, -1],
      [1, 1],
      [-1, 1],
    ].map(([u, v]) => ({ x: (at?.x ?? 0) + half * u!, y: (at?.y ?? 0) + half * v! }));
    this.host_.previewControl(this.host_.store.state.groups.length, at ? corners : null, true);
  }

  private putDown(at: GroundPoint): void {
    const { held_: held } = this;
    if (!held) return;
    const { name, count, formation, spacing, radius, speed } = held;
    const definition = {
      name,
      count,
      formation: { kind: formation, spacing },
      position: [round(at.x), round(at.y)],
      bodies: [{ radius, maxSpeed: speed }],
    };
    this.send([{ kind: 'group', definition }]);
    this.held_ = null;
    this.host_.store.set({ tool: 'steer' });
    this.host_.say(`${name} comes`);
  }

  private send(events: readonly CommandEvent[]): void {
    this.host_.client.send({ type: 'Commands', events: commandText(events) });
  }
}

function round(value: number): number {
  return Math.round(value * 1000) / 1000;
}
