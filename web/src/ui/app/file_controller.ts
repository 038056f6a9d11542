// Opens files that a visitor chooses or drops, each by what stands in it.

import { isForPlaces, kindOfFile, refusal } from '../../model/file_kind';
import type { ShapeActions } from '../../model/shape_actions';
import type { StudioActions } from '../../model/studio_actions';
import type { StudioStore } from '../../model/studio_store';
import { problem } from '../../protocol/problem';

export class FileController {
  constructor(
    private readonly store_: StudioStore,
    private readonly actions_: Pick<StudioActions, 'openCharacter' | 'openTake' | 'showPlaces'>,
    private readonly shapes_: Pick<ShapeActions, 'openPicture'>,
  ) {}

  /** Opens one file, or a character or model with its parts; says why where it cannot. */
  async open(files: readonly File[]): Promise<void> {
    const [first] = files;
    if (!first) return;
    try {
      const kinds = await Promise.all(files.map(kindOfFile));
      if (kinds.includes('character')) return this.actions_.openCharacter(files);
      if (kinds.includes('scenery')) return this.actions_.showPlaces('import', files);
      const [kind] = kinds;
      const text = refusal(kind!, first.name);
      if (text !== null) return this.refuse(text);
      if (isForPlaces(kind!)) this.actions_.showPlaces(kind === 'scenario' ? 'shelf' : 'import', [first]);
      else if (kind === 'take') this.actions_.openTake(first);
      else this.shapes_.openPicture(first);
    } catch {
      this.refuse(`“${first.name}” cannot be read.`);
    }
  }

  /** Files dropped anywhere on the page. */
  acceptDrops(page: Window): void {
    page.addEventListener('dragover', (event) => {
      if (event.dataTransfer?.types.includes('Files')) event.preventDefault();
    });
    page.addEventListener('drop', (event) => {
      const files = [...(event.dataTransfer?.files ?? [])];
      if (files.length === 0) return;
      event.preventDefault();
      void this.open(files);
    });
  }

  private refuse(text: string): void {
    this.store_.set({ notice: problem('file', text) });
  }
}
