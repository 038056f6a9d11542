// What panels ask for formations of a visitor's own and for new groups.

import type { FormationKindWord } from '../protocol/generated/words';
import type { GroundPoint } from './plane';
import type { OwnShape } from './shape_edit';
import type { DialogName } from './studio_state';

/** A group to be put on the ground. */
export interface NewGroup {
  readonly name: string;
  readonly count: number;
  /** Of the library. */
  readonly formation: FormationKindWord;
  /** Between neighbours [m]. */
  readonly spacing: number;
  /** Of each body [m]. */
  readonly radius: number;
  /** The fastest that they run [m/s]. */
  readonly speed: number;
}

/** A formation that is not of the library, before it is taken up. */
export interface Design {
  readonly title: string;
  /** Where it is made. */
  readonly dialog: DialogName;
  readonly shape: OwnShape;
}

export interface ShapeActions {
  /** Takes the tool that draws outlines, or puts it away. */
  toggleDraw(): void;
  /** The tool is in hand while a key or a button is held. A short press takes it, or puts it away, unless it was lost. */
  holdDraw(held: boolean, lost?: boolean): void;
  /** Places as a shape that lies before the visitor as they do: x to the right, y up, about their middle [m]. */
  asSeen(places: readonly GroundPoint[], spacing: number): OwnShape;
  /** A shape as the visitor sees it: x to the right, y up [m]. */
  seen(shape: OwnShape): GroundPoint[];
  /** Its left and right change, as the visitor sees them. */
  mirrored(shape: OwnShape): OwnShape;
  /** The active group gets more people, or fewer. */
  setPeople(count: number): void;
  /** The formation of the active group as it would stand undisturbed; null where there is none. */
  shape(): OwnShape | null;
  /** Opens the dialog with a picture, which shall become a formation. */
  openPicture(picture: File): void;
  /** A picture that waits to become a formation; once. */
  takePicture(): File | null;
  /** The active group takes up a shape, in its own axes. */
  takeShape(shape: OwnShape, title: string): void;
  /** Shows where everybody would stand in a formation of the library, or in a shape; null takes that away. */
  lookAt(formation: string | OwnShape | null): void;
  /** Puts a shape on the ground to look at, before it is taken up. */
  tryOut(design: Design): void;
  /** What is tried out is taken up, goes back to its dialog, or is dropped. */
  endTry(how: 'take' | 'change' | 'drop'): void;
  /** Takes a new group in hand; the next press on the ground puts it down. */
  holdGroup(group: NewGroup): void;
}
