// Chooses the owner of a contact once, by where and how it begins.

import type { ControlFrame } from '../protocol/messages';
import type { StudioFrame } from '../model/studio_frame';
import type { CameraGesture, OrbitGesture } from './camera_gesture';
import type { Contact, ContactOwner } from './contact';
import { ControlDrag, Lasso, RubberBand, type AreaTarget, type ControlPreview } from './drawn_controls';
import { FingersTogether } from './fingers_together';
import {
  fingertipFrom,
  metresFrom,
  type FormationHit,
  type FormationHitTest,
  type RimReach,
} from './formation_hit_test';
import { grabAt, type Grab, type Grabbable } from './grab';
import type { OrderChooser } from './order_chooser';
import { distance, middleOf, pointsOf, type GroundPoint, type ScreenPoint } from '../model/plane';
import type { VirtualControls } from './virtual_controls';
import type { TouchEditor, TouchMarks } from './touch_editor';

export interface ChooserScene extends TouchMarks, ControlPreview {
  worldToScreen(point: GroundPoint): ScreenPoint;
}

export interface ChooserTools {
  readonly scene: ChooserScene;
  readonly hitTest: FormationHitTest;
  readonly editor: TouchEditor;
  readonly camera: CameraGesture;
  readonly orbit: OrbitGesture;
  readonly controls: VirtualControls;
  readonly orders: OrderChooser;
  /** Who draws outlines and puts groups down; null where another tool is in hand. */
  readonly shapes: (contact: Contact) => ContactOwner | null;
  readonly tell: (text: string) => void;
}

/** A rubber band may begin so near the mesh [m]. */
const kNear = 3;
const kMiddle = 1;
const kRight = 2;

const kSmallLoop = 'The loop holds fewer than three points of a mesh: draw it larger, round a part of the crowd';

/** The corners that hold a point of the mesh each, the nearest: no two can hold the same. */
function holding(corners: readonly GroundPoint[], mesh: readonly GroundPoint[]): readonly GroundPoint[] {
  const held = new Map<GroundPoint | undefined, GroundPoint>();
  for (const corner of corners) {
    const nearest = mesh.reduce<GroundPoint | undefined>(
      (best, one) => (best && distance(best, corner) <= distance(one, corner) ? best : one),
      undefined,
    );
    if (!held.has(nearest)) held.set(nearest, corner);
  }
  return [...held.values()];
}

export class ToolChooser {
  private frame_: StudioFrame | null = null;
  private readonly together_ = new FingersTogether();
  /** Space is held: the left button pans. */
  panning = false;

  constructor(private readonly tools_: ChooserTools) {}

  observe(frame: StudioFrame): void {
    this.frame_ = frame;
  }

  choose(contact: Contact): ContactOwner {
    const { camera, orbit, orders } = this.tools_;
    if (contact.kind === 'mouse') {
      if (contact.button === kMiddle || (contact.button === kRight && this.panning)) return orbit;
      if (this.panning) return camera;
    }
    const { ground } = contact;
    if (!ground) return contact.button === kRight ? orbit : camera;
    const shaped = this.tools_.shapes(contact);
    if (shaped) return shaped;
    const ordered = orders.choose(contact, this.formation(ground)?.index ?? -1);
    return ordered ?? this.drawing(contact, ground) ?? this.editing(contact, ground) ?? camera;
  }

  /** The control whose handle, bar or inside lies here, if it may be grabbed. */
  grab(ground: GroundPoint): Grab | null {
    return this.grabWhere(ground, (control, group) => this.tools_.controls.grabbable(control, group));
  }

  /** The control here, whoever holds it. */
  nearest(ground: GroundPoint): Grab | null {
    return this.grabWhere(ground, () => 'whole');
  }

  /** The formation under the point, or within a fingertip of it. */
  formation(ground: GroundPoint): FormationHit | null {
    return this.find(ground, fingertipFrom(ground, this.toScreen));
  }

  /** What a mouse that points there could take. */
  cursor(ground: GroundPoint): 'grab' | 'pointer' | 'default' {
    if (this.grab(ground)) return 'grab';
    return this.formation(ground) ? 'pointer' : 'default';
  }

  private readonly toScreen = (point: GroundPoint): ScreenPoint => this.tools_.scene.worldToScreen(point);

  private grabWhere(ground: GroundPoint, grabbable: (control: ControlFrame, group: number) => Grabbable): Grab | null {
    return grabAt(this.frame_?.groups ?? [], ground, this.toScreen, grabbable);
  }

  private find(ground: GroundPoint, reach: RimReach): FormationHit | null {
    return this.tools_.hitTest.find(ground, reach);
  }

  /** Keys held with a mouse or a pen draw a whole control. */
  private drawing(contact: Contact, ground: GroundPoint): ContactOwner | null {
    if (contact.kind === 'touch' || (!contact.shift && !contact.alt)) return null;
    const { controls, scene } = this.tools_;
    const near = this.find(ground, metresFrom(ground, kNear));
    if (contact.alt) return new Lasso((corners) => this.lassoed(corners), near?.index ?? 0, controls, scene);
    return near ? new RubberBand(near, controls, scene) : this.tools_.orders.box();
  }

  private editing(contact: Contact, ground: GroundPoint): ContactOwner | null {
    const { controls, scene, editor } = this.tools_;
    const grab = this.grab(ground);
    const hit = grab && contact.kind !== 'touch' ? null : this.formation(ground);
    const drag = (): ContactOwner => new ControlDrag(grab!, controls, scene);
    if (!hit) return grab ? drag() : null;
    const fresh = editor.ownerFor(hit);
    return contact.kind === 'touch' ? this.together_.ownerFor(contact, hit, grab, drag, fresh) : fresh;
  }

  private lassoed(corners: readonly GroundPoint[]): AreaTarget | null {
    for (const point of corners.length > 0 ? [middleOf(corners), ...corners] : []) {
      const target = this.find(point, metresFrom(point, kNear));
      if (!target) continue;
      const held = holding(corners, pointsOf(this.frame_?.groups[target.index]?.vertices ?? []));
      if (held.length >= 3) return { ...target, corners: held };
    }
    this.tools_.tell(kSmallLoop);
    return null;
  }
}
