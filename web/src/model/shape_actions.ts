// What panels ask for formations of a visitor's own and for new groups.

import type { GroundPoint } from './plane';
import type { OwnShape } from './shape_edit';

/** A group to be put on the ground. */
export interface NewGroup {
  readonly name: string;
  readonly count: number;
  /** Of the library. */
  readonly formation: string;
  /** Between neighbours [m]. */
  readonly spacing: number;
  /** Of each body [m]. */
  readonly radius: number;
  /** The fastest that they run [m/s]. */
  readonly speed: number;
}

export interface ShapeActions {
  /** Takes the tool that draws outlines, or puts it away. */
  toggleDraw(): void;
  /** The active group writes words: places in any unit about their middle, y up, the least gap between two of them. */
  takeWords(places: readonly GroundPoint[], gap: number, words: string): void;
  /** The formation of the active group as it would stand undisturbed; null where there is none. */
  shape(): OwnShape | null;
  /** Opens the dialog with a picture, which shall become a formation. */
  openPicture(picture: File): void;
  /** A picture that waits to become a formation; once. */
  takePicture(): File | null;
  /** The active group takes up a shape, in its own axes. */
  takeShape(shape: OwnShape, title: string): void;
  /** Takes a new group in hand; the next press on the ground puts it down. */
  holdGroup(group: NewGroup): void;
}
