// What panel and keys ask of whoever builds.

import type { BuildTool, DrawingOptions } from '../../model/place/drawing';
import type { PlaceChange, Thing, ThingKind } from '../../model/place/things';
import type { ArrowKey } from '../../tools/keyboard_steering';
import type { SceneFacts } from '../../protocol/scene';

/** Formations that people and checkpoints may have. */
export const kShapes: readonly string[] = ['square', 'line', 'column', 'wedge', 'circle', 'ring', 'crescent', 'cross'];

export interface BuildActions {
  readonly options: DrawingOptions;
  readonly scene: SceneFacts | null;
  /** Of the world [s]. */
  readonly time: number;
  setOptions(change: Partial<DrawingOptions>): void;
  setTool(tool: BuildTool): void;
  setSnaps(on: boolean): void;
  toggleLayer(kind: ThingKind, what: 'hidden' | 'locked', on: boolean): void;
  edit(label: string, change: (one: Thing) => Thing): void;
  /** The same where what is chosen may become a thing of another kind. */
  become(label: string, change: (one: Thing) => Thing): void;
  editGroup(label: string, event: (one: Thing) => PlaceChange): void;
  /** The same while a slider is dragged: begins, goes on, ends. All of it is one step of the history. */
  dragBegins(): void;
  dragGroup(label: string, event: (one: Thing) => PlaceChange, ends: boolean): void;
  undo(redo?: boolean): void;
  remove(): void;
  copy(): void;
  paste(): void;
  duplicate(): void;
  /** An arrow moves what is chosen, else the cursor on the ground. */
  arrow(key: ArrowKey, long: boolean): void;
  /** Enter takes what is under the cursor, and begins and ends what is drawn. */
  enter(shift: boolean): void;
  /** The keys go on to the ground. */
  toGround(): void;
  togglePlay(): void;
  /** A sentence in the panel. */
  say(text: string): void;
  turnChosen(angle: number): void;
  chooseAll(): void;
  leave(): void;
}
