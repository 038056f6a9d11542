// Formations of a visitor's own, and new groups: an outline drawn with a finger, words, and a group put on the ground.

import type { Forecast } from '../../model/forecast';
import { moveCommand, type Command } from '../../model/commands';
import { areaOf, centreOf, outlineFrom } from '../../model/outline';
import type { GroundPoint } from '../../model/plane';
import type { Design, NewGroup, ShapeActions } from '../../model/shape_actions';
import { formationKind, type FormationWords } from '../../model/sequence';
import { forCount, mirrored, turned, type OwnShape } from '../../model/shape_edit';
import type { StandPose } from '../../model/stand';
import type { StudioFrame } from '../../model/studio_frame';
import type { StudioStore } from '../../model/studio_store';
import type { Vec2 } from '../../protocol/generated/commands';
import { NoticeLevel } from '../../protocol/messages';
import { problem } from '../../protocol/problem';
import type { Contact, ContactOwner } from '../../tools/contact';
import { OutlineDraw, PlacePress, type OutlineSink } from '../../tools/outline_draw';
import type { PlacesLink } from '../orders/place_asker';
import { lazyGhost, type Ghost } from './lazy_ghost';
import { StandPreview, type StandScene } from './stand_preview';

/** Distance of neighbours in a drawn formation [m]: as the drawing has room, between these. */
const kSpacing = { least: 0.7, most: 3 };
/** Of neighbours in a triangular lattice: the share of its square that one takes. */
const kLattice = Math.sqrt(3) / 2;
/** An outline drawn so near to the middle of the group changes its shape where it is [m]. */
const kHere = 4;
const kStyle = { manner: 'march', turn: 'keep', mode: 'replace' } as const;

/** A key or a button that is held no longer is pressed [ms]. */
const kPressMs = 400;

/** What a stroke makes of a group. */
interface DrawnFormation {
  readonly formation: FormationWords;
  readonly centre: GroundPoint;
  /** It changes its shape where it is; else it goes to the centre. */
  readonly here: boolean;
  /** Where it would stand. */
  readonly at: StandPose;
}

export interface ShapeControllerHost {
  readonly client: PlacesLink;
  readonly store: StudioStore;
  /** The shape of a group; undefined where its mesh has not come yet. */
  shapeOf(group: number): OwnShape | undefined;
  /** Forecasts of orders that wait, by their ids. */
  known(): ReadonlyMap<number, Forecast>;
  readonly view: {
    /** `turn`: direction of view on the ground, from +y [rad]. */
    readonly camera: { readonly pose: { readonly turn: number } };
    readonly orders: StandScene;
    previewControl(groupIndex: number, points: readonly GroundPoint[] | null, closed: boolean): void;
  };
  say(text: string): void;
}

export class ShapeController implements ShapeActions, OutlineSink {
  private frame_: StudioFrame | null = null;
  /** A new group that waits for its place. */
  private held_: { readonly group: NewGroup; readonly ghost: Ghost } | null = null;
  private picture_: File | null = null;
  private readonly stands_: StandPreview;
  private tried_: Design | null = null;
  /** When a key or a button that holds the drawing tool went down [ms], and whether something was drawn since. */
  private drawHeld_: { readonly since: number; used: boolean; readonly was: boolean } | null = null;

  constructor(private readonly host_: ShapeControllerHost) {
    const { client, store, view } = host_;
    const [known, say] = [() => host_.known(), (text: string): void => host_.say(text)];
    this.stands_ = new StandPreview({ client, store, orders: view.orders, known, say });
    // What is shown is about the active group, and gone with a replay or another world.
    store.watch(['active', 'replaying', 'scenario'], () => this.endTry('drop'));
    store.watch(['tool'], ({ tool }) => tool !== 'place' && this.dropGroup());
  }

  observe(frame: StudioFrame): void {
    this.frame_ = frame;
    this.stands_.observe(frame);
  }

  /** Who owns a contact, by the tool in hand; null where it is no concern of shapes. */
  owner(contact: Contact): ContactOwner | null {
    const { tool } = this.host_.store.state;
    if (!contact.ground || contact.button > 0) return null;
    if (tool === 'draw') return new OutlineDraw(this);
    if (tool !== 'place' || !this.held_) return null;
    return new PlacePress(
      (at) => at && this.pointed(at),
      (at) => this.putDown(at),
    );
  }

  /** A mouse, or a finger that is down, points there. */
  pointed(at: GroundPoint): void {
    if (this.frame_) this.held_?.ghost.show(at, this.frame_);
  }

  toggleDraw(): void {
    const { tool } = this.host_.store.state;
    this.host_.store.set({ tool: tool === 'draw' ? 'steer' : 'draw' });
    this.host_.say(tool === 'draw' ? 'Steer' : 'Draw an outline on the ground');
  }

  holdDraw(held: boolean, lost = false): void {
    const { tool } = this.host_.store.state;
    if (held) {
      this.drawHeld_ = { since: performance.now(), used: false, was: tool === 'draw' };
      if (tool !== 'draw') this.toggleDraw();
      return;
    }
    const hold = this.drawHeld_;
    this.drawHeld_ = null;
    if (!hold) return;
    if (lost && hold.was) return;
    // A short press leaves the tool in hand, or puts away what was in hand before.
    const isPress = !lost && !hold.used && performance.now() - hold.since < kPressMs;
    if (tool === 'draw' && (!isPress || hold.was)) this.toggleDraw();
  }

  asSeen(places: readonly GroundPoint[], spacing: number): OwnShape {
    return turned({ spacing, places }, this.viewTurn());
  }

  seen(shape: OwnShape): GroundPoint[] {
    return [...turned(shape, -this.viewTurn()).places];
  }

  mirrored(shape: OwnShape): OwnShape {
    return mirrored(shape, this.viewTurn() + Math.PI / 2);
  }

  /** From the group's axes to the picture's: its right lies so far to the left of the group's front [rad]. */
  private viewTurn(): number {
    return this.host_.view.camera.pose.turn - this.active().facing;
  }

  setPeople(count: number): void {
    const { group } = this.active();
    const shape = this.shape();
    if (!group) return;
    // Places of one's own have to be as many as there are people.
    const own = group.formation === 'points' && shape ? { formation: formationOf(forCount(shape, count)) } : {};
    this.send([{ kind: 'changeGroup', group: group.id, count, ...own }]);
    this.host_.say(`${group.name}: ${count} people`);
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

  takeShape(shape: OwnShape, title: string): void {
    const { group } = this.active();
    if (!group) return;
    const { stand } = this.host_.store.state;
    this.endTry('drop');
    this.send([{ kind: 'changeGroup', group: group.id, formation: formationOf(shape) }]);
    if (!stand?.warns) return this.host_.say(`${group.name}: ${title}`);
    this.host_.store.set({ notice: { ...problem('places', `${title}: ${stand.text}.`), level: NoticeLevel.Warning } });
  }

  lookAt(formation: string | OwnShape | null): void {
    const { group } = this.active();
    if (this.tried_) return;
    if (formation === null || !group) return this.stands_.hide();
    const spacing = this.host_.shapeOf(group.id)?.spacing ?? 1;
    const words = typeof formation === 'string' ? { kind: formationKind(formation), spacing } : formationOf(formation);
    this.stands_.show(words);
  }

  tryOut(design: Design): void {
    this.tried_ = null;
    this.lookAt(design.shape);
    this.tried_ = design;
    this.host_.store.set({ dialog: 'none', trying: { title: design.title, dialog: design.dialog } });
  }

  endTry(how: 'take' | 'change' | 'drop'): void {
    const { tried_: tried } = this;
    this.tried_ = null;
    this.stands_.hide();
    if (!tried) return;
    if (how === 'take') this.takeShape(tried.shape, tried.title);
    // The dialog goes on with it while it is still said to be tried out.
    if (how === 'change') this.host_.store.set({ dialog: tried.dialog });
    this.host_.store.set({ trying: null });
  }

  holdGroup(group: NewGroup): void {
    const { client, store, view } = this.host_;
    this.dropGroup();
    this.held_ = { group, ghost: lazyGhost({ client, store, orders: view.orders }, group) };
    this.host_.store.set({ tool: 'place', placing: group.name });
    this.host_.say(`Press on the ground where ${group.name} shall stand`);
  }

  previewOutline(points: readonly GroundPoint[] | null): void {
    this.host_.view.previewControl(Math.max(0, this.host_.store.state.active), points, true);
    const drawn = points && this.drawn(points);
    if (!drawn || 'why' in drawn) return this.stands_.hide();
    this.stands_.show(drawn.formation, drawn.at, false);
  }

  outlineDrawn(stroke: readonly GroundPoint[]): void {
    const { group, facing } = this.active();
    const drawn = this.drawn(stroke);
    if (!group || !drawn) return;
    if ('why' in drawn) {
      this.host_.store.set({ notice: problem('outline', drawn.why) });
      return;
    }
    const { formation, here, centre } = drawn;
    const move = moveCommand(group.id, { target: centre, facing, width: 0, route: [], formation }, kStyle);
    this.send(here ? [{ kind: 'changeGroup', group: group.id, formation }] : [move]);
    if (this.drawHeld_) this.drawHeld_.used = true;
    else this.host_.store.set({ tool: 'steer' });
    this.host_.say(`${group.name}: drawn outline`);
  }

  /** What a stroke makes of the active group; null where there is none. */
  private drawn(stroke: readonly GroundPoint[]): DrawnFormation | { readonly why: string } | null {
    const { group, at, facing, count } = this.active();
    if (!group) return null;
    const outline = outlineFrom(stroke);
    if ('why' in outline) return outline;
    const centre = centreOf(outline.corners);
    const room = Math.sqrt(areaOf(outline.corners) / (Math.max(1, count) * kLattice));
    const [c, s] = [Math.cos(-facing), Math.sin(-facing)];
    const corners = outline.corners.map(({ x, y }): Vec2 => {
      const [dx, dy] = [x - centre.x, y - centre.y];
      return [round(c * dx - s * dy), round(s * dx + c * dy)];
    });
    const spacing = round(Math.min(kSpacing.most, Math.max(kSpacing.least, room)));
    const formation = { kind: 'outline', spacing, outline: { outline: corners } } as const;
    const here = Math.hypot(centre.x - at.x, centre.y - at.y) < kHere;
    return { formation, centre, here, at: { ...(here ? at : centre), facing } };
  }

  private active() {
    const { groups, active } = this.host_.store.state;
    const seen = this.frame_?.groups[active];
    const group = groups[active];
    const at = { x: seen?.x ?? 0, y: seen?.y ?? 0 };
    return { group, at, facing: seen?.facing ?? 0, count: group?.count ?? 0 };
  }

  private dropGroup(): void {
    this.held_?.ghost.hide();
    this.held_ = null;
    this.host_.store.set({ placing: '' });
  }

  private putDown(at: GroundPoint): void {
    if (!this.held_) return;
    const { name, count, formation, spacing, radius, speed } = this.held_.group;
    const group = {
      name,
      count,
      formation: { kind: formation, spacing },
      position: [round(at.x), round(at.y)] as const,
      bodies: [{ radius, maxSpeed: speed }],
    };
    this.send([{ kind: 'group', group }]);
    this.host_.store.set({ tool: 'steer' });
    this.host_.say(`${name} comes`);
  }

  private send(commands: readonly Command[]): void {
    this.host_.client.send({ type: 'Commands', commands });
  }
}

function formationOf({ spacing, places }: OwnShape): FormationWords {
  return { kind: 'points', spacing: round(spacing), points: places.map(({ x, y }) => [round(x), round(y)] as const) };
}

function round(value: number): number {
  return Math.round(value * 1000) / 1000;
}
