// Who owns a contact: decided once, where and how it begins.

import type { Frame } from '../protocol/messages';
import type { GroundPoint } from '../view/camera_types';
import type { CameraGesture, OrbitGesture } from './camera_gesture';
import type { Contact, ContactOwner } from './contact';
import { ControlDrag, Lasso, RubberBand, type ControlPreview, type DrawTarget } from './drawn_controls';
import { rimReach, type FormationHitTest } from './formation_hit_test';
import { grabAt, type Grab } from './grab';
import { centroid } from './ground_geometry';
import type { HeldControls } from './held_controls';
import type { TouchEditor, TouchMarks } from './touch_editor';

export interface ChooserScene extends TouchMarks, ControlPreview {
  pixelsPerMetre(): number;
}

export interface ChooserTools {
  readonly scene: ChooserScene;
  readonly hitTest: FormationHitTest;
  readonly editor: TouchEditor;
  readonly camera: CameraGesture;
  readonly orbit: OrbitGesture;
  readonly controls: HeldControls;
}

/** Handles draw at 22 px but catch 48. */
const HANDLE_PX = 24;
/** A rubber band may begin so near the mesh [m]. */
const NEAR = 3;
const MIDDLE = 1;
const RIGHT = 2;

export class ToolChooser {
  private frame: Frame | null = null;
  /** Space is held: the left button pans. */
  panning = false;

  constructor(private readonly tools: ChooserTools) {}

  observe(frame: Frame): void {
    this.frame = frame;
  }

  choose(contact: Contact): ContactOwner {
    const { camera, orbit } = this.tools;
    if (contact.kind === 'mouse') {
      if (contact.button === RIGHT) return orbit;
      if (contact.button === MIDDLE || this.panning) return camera;
    }
    const { ground } = contact;
    if (!ground) return camera;
    return this.drawing(contact, ground) ?? this.editing(ground) ?? camera;
  }

  /** The control whose handle, bar or inside lies here, if it may be grabbed. */
  grab(ground: GroundPoint): Grab | null {
    const { controls, scene } = this.tools;
    const reach = HANDLE_PX / Math.max(scene.pixelsPerMetre(), 1e-6);
    return grabAt(this.frame?.groups ?? [], ground, reach, (control) => controls.grabbable(control));
  }

  /** The control here, whoever holds it. */
  nearest(ground: GroundPoint): Grab | null {
    const reach = HANDLE_PX / Math.max(this.tools.scene.pixelsPerMetre(), 1e-6);
    return grabAt(this.frame?.groups ?? [], ground, reach, () => 'whole');
  }

  /** The formation under the point. */
  formation(ground: GroundPoint, reach?: number): DrawTarget | null {
    return this.tools.hitTest.find(ground, reach ?? rimReach(this.tools.scene.pixelsPerMetre()));
  }

  /** Keys held with a mouse or a pen draw a whole control. */
  private drawing(contact: Contact, ground: GroundPoint): ContactOwner | null {
    if (contact.kind === 'touch' || (!contact.shift && !contact.alt)) return null;
    const { controls, scene } = this.tools;
    const near = this.formation(ground, NEAR);
    if (contact.alt) return new Lasso((corners) => this.lassoed(corners), near?.index ?? 0, controls, scene);
    return near ? new RubberBand(near, controls, scene) : null;
  }

  private editing(ground: GroundPoint): ContactOwner | null {
    const { controls, scene, editor, hitTest } = this.tools;
    const grab = this.grab(ground);
    if (grab) return new ControlDrag(grab, controls, scene);
    const hit = hitTest.find(ground, rimReach(scene.pixelsPerMetre()));
    return hit ? editor.ownerFor(hit) : null;
  }

  private lassoed(corners: readonly GroundPoint[]): DrawTarget | null {
    for (const point of [centroid(corners), ...corners]) {
      const target = this.formation(point, NEAR);
      if (target) return target;
    }
    return null;
  }
}
