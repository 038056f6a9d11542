// The actions of buttons, keys and gestures. Panels know no more of the studio.

import type { OverlayKind } from '../protocol/messages';
import type { DialogName, HintStep, PlacesView } from './studio_state';
import type { Layers } from './view_settings';

export interface StudioActions {
  togglePlay(): void;
  singleStep(): void;
  restart(): void;
  /** Restarts with the touches of the scenario; restarts without them where they are playing. */
  toggleDemonstration(): void;
  /** To the next of the usual speeds; backwards where `back`. */
  nextSpeed(back?: boolean): void;
  toggleRecord(): void;
  /** The shelf of takes, or away with it. */
  showShelf(open: boolean): void;
  downloadTake(): void;
  openTake(file: File): void;
  /** A character from files in place of our people, and back. */
  openCharacter(files: readonly File[]): void;
  ourPeople(): void;
  loadScenario(name: string): void;
  /** Ends a replay: the scenario comes back. */
  leaveReplay(): void;
  setFormation(name: string): void;
  /** Shows where everybody would stand in a formation of the library; null takes that away. */
  lookAtFormation(name: string | null): void;
  setActiveGroup(index: number): void;
  /** What plans make least: an index into kObjectives. */
  setObjective(index: number): void;
  toggleLayer(layer: keyof Layers): void;
  /** Shows the overlay, or takes it away where it is shown. */
  toggleOverlay(kind: OverlayKind): void;
  /** The readout's figures, or its words alone. */
  toggleFigures(): void;
  /** Opens a dialog, or closes it with 'none'. */
  openDialog(dialog: DialogName): void;
  /** Opens the dialog of places, with files if there are any, or closes it. */
  showPlaces(view: PlacesView, files?: readonly File[]): void;
  /** The tool that draws an outline as the formation, or none. */
  toggleDraw(): void;
  /** The tool is in hand while a key or a button is held; one that was lost has pressed nothing. */
  holdDraw(held: boolean, lost?: boolean): void;
  toggleTheme(): void;
  showHelp(open: boolean): void;
  /** The list of control schemes. */
  showSchemes(open: boolean): void;
  /** Inputs are judged by this control scheme; empty: by the page itself. */
  chooseScheme(name: string): void;
  dismissHint(): void;
  /** The visitor has done what a step of the hint tells of. */
  tried(step: HintStep): void;
  dismissNotice(): void;
  /** Brings the spot that the message is about into view. */
  showNoticePlace(): void;
  /** Shows who cannot be in their places. */
  showBarred(): void;
  retry(): void;
  /** The engine in this browser goes on with the world of a lost server. */
  goOnAlone(): void;
  fit(): void;
  /** The camera goes along with the crowd, or stays. */
  toggleFollow(): void;
  /** Brings one group into view. */
  frameGroup(index: number): void;
  /** From above; without perspective. */
  toggleTop(): void;
  toggleFlat(): void;
  /** Views 1 to 9. */
  saveView(number: number): void;
  showView(number: number): void;
  /** Nothing but the scene, without marks and panels. */
  toggleClean(): void;
}
