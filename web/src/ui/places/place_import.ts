// A file that is to become a place or part of one: how it will look, and what can be set before anything changes.

import { sentenceOf } from '../../model/file_trouble';
import {
  importedFrom,
  usualSettings,
  type Imported,
  type ImportSettings,
  type ImportSource,
  movedTo,
} from '../../model/place_files/imports';
import type { PlaceActions } from '../../model/place_files/place_actions';
import { obstacleOf, type PlaceDefinition } from '../../model/place_files/place';
import { drawingOf, factsOf, type PlaceDrawing } from '../../model/place_files/place_drawing';
import { element, setText } from '../widgets/dom';
import { icon } from '../widgets/icons';
import { field } from '../widgets/dialog_parts';
import { placePicture } from './place_picture';

/** What was set is worked out so long after the last key [ms]. */
const kPause = 200;

type NumberKey = 'people' | 'scale' | 'turn' | 'cell' | 'usualHeight' | 'wallWidth';

interface NumberField {
  readonly key: NumberKey;
  readonly label: string;
  readonly min: number;
  readonly max: number;
  readonly step: number | 'any';
  readonly kinds: readonly ImportSource['kind'][];
}

const kFields: readonly NumberField[] = [
  { key: 'scale', label: 'Scale', min: 0.0001, max: 10000, step: 'any', kinds: ['geojson', 'model'] },
  { key: 'turn', label: 'Turn [°]', min: -360, max: 360, step: 'any', kinds: ['geojson', 'model'] },
  { key: 'cell', label: 'Cell of the map [m]', min: 0.1, max: 100, step: 'any', kinds: ['map'] },
  { key: 'usualHeight', label: 'Usual height [m]', min: 0.1, max: 500, step: 'any', kinds: ['geojson'] },
  { key: 'wallWidth', label: 'Width of walls [m]', min: 0.1, max: 20, step: 'any', kinds: ['geojson'] },
  { key: 'people', label: 'People', min: 1, max: 5000, step: 1, kinds: ['geojson', 'model', 'map'] },
];

export class PlaceImport {
  private readonly picture_ = element('div', {
    class: 'place-preview',
    tabindex: -1,
    role: 'group',
    'aria-label': 'How it will look',
  });
  private readonly note_ = element('p', { class: 'place-note', role: 'status' });
  private readonly fields_ = element('div', { class: 'place-fields' });
  private readonly name_ = element('input', { type: 'text', maxlength: 80, autocomplete: 'off', required: true });
  private readonly up_ = element(
    'select',
    {},
    element('option', { value: 'y' }, 'y'),
    element('option', { value: 'z' }, 'z'),
  );
  private readonly shown_ = element('input', { type: 'checkbox', checked: true });
  private readonly east_ = this.numberInput(-1e5, 1e5, 'any');
  private readonly north_ = this.numberInput(-1e5, 1e5, 'any');
  private readonly add_ = element('button', { type: 'button', class: 'soft' }, icon('plus'), 'Add to this place');
  private readonly make_ = element('button', { type: 'submit', class: 'solid' }, 'New place');
  private readonly choose_ = element('button', { type: 'button', class: 'soft' }, icon('open'), 'Choose a file…');
  private readonly form_ = element('form', { class: 'place-import', hidden: true });
  readonly root = element('div', { class: 'place-section' });
  private readonly inputs_ = new Map<NumberKey, HTMLInputElement>();
  private source_: ImportSource | null = null;
  private imported_: Imported | null = null;
  private present_: PlaceDefinition | null = null;
  private settings_: ImportSettings | null = null;
  private timer_ = 0;

  constructor(actions: PlaceActions, chooseFiles: () => void) {
    this.choose_.addEventListener('click', chooseFiles);
    this.form_.append(
      this.picture_,
      this.note_,
      this.fields_,
      element('div', { class: 'place-acts' }, this.add_, this.make_),
    );
    this.root.append(
      this.choose_,
      element(
        'p',
        { class: 'secondary place-note' },
        'Footprints of houses as GeoJSON, models as OBJ or glTF, grid maps (.map). Files may also be dropped on the page.',
      ),
      this.form_,
    );
    this.form_.addEventListener('input', () => this.changed());
    this.form_.addEventListener('submit', (event) => {
      event.preventDefault();
      this.act((...parts) => actions.openImported(...parts));
    });
    this.add_.addEventListener('click', () => this.act((...parts) => actions.addImported(...parts)));
  }

  get source(): ImportSource | null {
    return this.source_;
  }

  /** `present` is the place as it is now, where that is known; `at` is where the view looks. Throws where the file is bad. */
  open(source: ImportSource, present: PlaceDefinition | null, at: { readonly x: number; readonly y: number }): void {
    const settings = { ...usualSettings(source), at: { x: Math.round(at.x), y: Math.round(at.y) } };
    importedFrom(source, settings);
    this.source_ = source;
    this.present_ = present;
    this.fill(source, settings);
    this.shown_.checked = true;
    this.form_.hidden = false;
    this.add_.hidden = source.kind === 'map';
    this.work();
    // Not a field: on phones its keyboard would cover the drawing.
    this.picture_.focus();
  }

  private numberInput(min: number, max: number, step: number | 'any'): HTMLInputElement {
    return element('input', { type: 'number', inputmode: 'decimal', min, max, step, required: true });
  }

  private fill(source: ImportSource, settings: ImportSettings): void {
    this.name_.value = settings.name;
    this.inputs_.clear();
    const numbers = kFields
      .filter(({ kinds }) => kinds.includes(source.kind))
      .map(({ key, label, min, max, step }) => {
        const input = this.numberInput(min, max, step);
        input.value = String(settings[key]);
        this.inputs_.set(key, input);
        return field(label, input);
      });
    this.up_.value = settings.up;
    [this.east_.value, this.north_.value] = [String(settings.at.x), String(settings.at.y)];
    const model =
      source.kind === 'model'
        ? [
            ...(source.up === null ? [field('Axis that stands up', this.up_)] : []),
            element('label', { class: 'place-check' }, this.shown_, element('span', {}, 'Show the model itself')),
          ]
        : [];
    const middle =
      source.kind === 'map'
        ? []
        : [element('div', { class: 'place-pair' }, field('Added at x [m]', this.east_), field('y [m]', this.north_))];
    this.fields_.replaceChildren(field('Name', this.name_), ...numbers, ...model, ...middle);
  }

  private changed(): void {
    window.clearTimeout(this.timer_);
    this.timer_ = window.setTimeout(() => this.work(), kPause);
  }

  /** What is set now; null where a field is wrong. */
  private settings(): ImportSettings | null {
    const { source_: source } = this;
    if (!source || !this.form_.checkValidity()) return null;
    const numbers = Object.fromEntries([...this.inputs_].map(([key, input]) => [key, input.valueAsNumber]));
    return {
      ...usualSettings(source),
      ...numbers,
      name: this.name_.value.trim() || 'Place',
      up: this.up_.value === 'z' ? 'z' : 'y',
      at: { x: this.east_.valueAsNumber, y: this.north_.valueAsNumber },
    };
  }

  private work(): void {
    window.clearTimeout(this.timer_);
    const [source, settings] = [this.source_, this.settings()];
    this.settings_ = settings;
    this.imported_ = null;
    if (!source || !settings) return this.tell('A number is missing or out of its range.');
    try {
      this.imported_ = importedFrom(source, settings);
      this.tell(this.imported_.notes.join(' '));
      this.draw(this.imported_, settings);
    } catch (error) {
      this.tell(sentenceOf(error, 'The file cannot be used: parts of it are damaged.'));
      this.picture_.replaceChildren();
    }
  }

  private tell(text: string): void {
    setText(this.note_, text);
    const nothing = this.imported_ === null;
    this.make_.disabled = nothing;
    this.add_.disabled = nothing || this.imported_?.outlines.length === 0;
  }

  /** As a place of its own, and beside it where it would stand in the present one. */
  private draw({ place, outlines }: Imported, { at }: ImportSettings): void {
    const pictures: [string, SVGSVGElement][] = [[`New: ${factsOf(place)}`, placePicture(drawingOf(place))]];
    if (this.present_ && outlines.length > 0) {
      const added: PlaceDrawing = drawingOf({ ...place, groups: [], obstacles: movedTo(outlines, at).map(obstacleOf) });
      pictures.push(['Added to this place', placePicture(added, drawingOf(this.present_))]);
    }
    this.picture_.replaceChildren(
      ...pictures.map(([words, svg]) =>
        element('figure', {}, svg, element('figcaption', { class: 'secondary' }, words)),
      ),
    );
  }

  private act(act: (...parts: Parameters<PlaceActions['openImported']>) => void): void {
    this.work();
    const { source_: source, imported_: imported, settings_: settings } = this;
    if (source && imported && settings) act(source, imported, settings, source.kind === 'model' && this.shown_.checked);
    else this.form_.reportValidity();
  }
}
