// What the dialog of places asks of the page.

import type { PlacesView } from '../studio_state';
import type { ImportSettings, Imported, ImportSource } from './imports';
import type { KeptPlace } from './kept_place';
import type { Template } from './templates';

export interface PlaceActions {
  show(view: PlacesView): void;
  /** Files of any kind that the visitor chose. */
  openFiles(files: readonly File[]): void;
  openTemplate(template: Template): void;
  openPlace(place: KeptPlace): void;
  duplicatePlace(place: KeptPlace): void;
  renamePlace(place: KeptPlace, name: string): void;
  downloadPlace(place: KeptPlace): void;
  removePlace(place: KeptPlace): void;
  /** Brings back what was removed last. */
  restorePlace(): void;
  /** The present place, into the browser or as a file. */
  savePresent(name: string): void;
  downloadPresent(name: string): void;
  /** Saves it, and shows a link to it. */
  sharePresent(name: string): void;
  /** What was imported, as a place of its own or into the present one. `shown`: the model is drawn, too. */
  openImported(source: ImportSource, imported: Imported, settings: ImportSettings, shown: boolean): void;
  addImported(source: ImportSource, imported: Imported, settings: ImportSettings, shown: boolean): void;
}
