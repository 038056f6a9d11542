// A file that is to become a place or part of one: how it will look, and what can be set before anything changes.

import { Component, type VNode } from 'preact';
import { sentenceOf } from '../../model/file_trouble';
import type { GroundPoint } from '../../model/plane';
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
import { drawingOf, factsOf } from '../../model/place_files/place_drawing';
import { Button } from '../widgets/buttons';
import { Field } from '../widgets/dialog';
import { PlacePicture } from './place_picture';

/** What was set is worked out so long after the last key [ms]. */
const kPause = 200;
const kWrongNumber = 'A number is missing or out of its range.';
const kDamaged = 'The file cannot be used: parts of it are damaged.';

interface Limits {
  readonly name: string;
  readonly min: number;
  readonly max: number;
  readonly step?: number | undefined;
}

interface NumberSetting extends Limits {
  readonly name: 'people' | 'scale' | 'turn' | 'cell' | 'usualHeight' | 'wallWidth';
  readonly label: string;
  readonly kinds: readonly ImportSource['kind'][];
}

const kFields: readonly NumberSetting[] = [
  { name: 'scale', label: 'Scale', min: 0.0001, max: 10000, kinds: ['geojson', 'model'] },
  { name: 'turn', label: 'Turn [°]', min: -360, max: 360, kinds: ['geojson', 'model'] },
  { name: 'cell', label: 'Cell of the map [m]', min: 0.1, max: 100, kinds: ['map'] },
  { name: 'usualHeight', label: 'Usual height [m]', min: 0.1, max: 500, kinds: ['geojson'] },
  { name: 'wallWidth', label: 'Width of walls [m]', min: 0.1, max: 20, kinds: ['geojson'] },
  { name: 'people', label: 'People', min: 1, max: 5000, step: 1, kinds: ['geojson', 'model', 'map'] },
];
const kFar = { min: -1e5, max: 1e5 };

/** What is to be imported. */
export interface Import {
  readonly source: ImportSource;
  /** The place as it is now, where that is known. */
  readonly present: PlaceDefinition | null;
  readonly settings: ImportSettings;
  /** As it comes out at first. */
  readonly imported: Imported;
}

/** `at` is where the view looks. Throws where the file is bad. */
export function importOf(source: ImportSource, present: PlaceDefinition | null, at: GroundPoint): Import {
  const settings = { ...usualSettings(source), at: { x: Math.round(at.x), y: Math.round(at.y) } };
  return { source, present, settings, imported: importedFrom(source, settings) };
}

interface Made {
  readonly settings: ImportSettings;
  /** Null where a field is wrong, or nothing can be made. */
  readonly imported: Imported | null;
  readonly note: string;
}

export interface PlaceImportProps {
  readonly given: Import;
  readonly actions: PlaceActions;
}

function NumberInput({ value, step = undefined, ...limits }: Limits & { readonly value: number }): VNode {
  return (
    <input type="number" inputMode="decimal" step={step ?? 'any'} required defaultValue={String(value)} {...limits} />
  );
}

export class PlaceImport extends Component<PlaceImportProps, Made> {
  private form_: HTMLFormElement | null = null;
  private picture_: HTMLElement | null = null;
  private timer_ = 0;
  override state: Made = { ...this.props.given, note: this.props.given.imported.notes.join(' ') };

  /** Not a field has the focus: on phones its keyboard would cover the drawing. */
  override componentDidMount(): void {
    this.picture_?.focus();
  }

  override componentWillUnmount(): void {
    window.clearTimeout(this.timer_);
  }

  /** What is set now; null where a field is wrong. */
  private settings(): ImportSettings | null {
    if (!this.form_!.checkValidity()) return null;
    const form = new FormData(this.form_!);
    const { settings } = this.props.given;
    const number = (name: string, otherwise: number): number => (form.has(name) ? Number(form.get(name)) : otherwise);
    return {
      ...settings,
      ...Object.fromEntries(kFields.map(({ name }) => [name, number(name, settings[name])])),
      name: (form.get('name') as string).trim() || 'Place',
      up: form.has('up') ? (form.get('up') as ImportSettings['up']) : settings.up,
      at: { x: number('x', settings.at.x), y: number('y', settings.at.y) },
    };
  }

  private work(): Made {
    window.clearTimeout(this.timer_);
    const made = this.made();
    this.setState(made);
    return made;
  }

  private made(): Made {
    const settings = this.settings();
    if (!settings) return { settings: this.state.settings, imported: null, note: kWrongNumber };
    try {
      const imported = importedFrom(this.props.given.source, settings);
      return { settings, imported, note: imported.notes.join(' ') };
    } catch (error) {
      return { settings, imported: null, note: sentenceOf(error, kDamaged) };
    }
  }

  private readonly changed = (): void => {
    window.clearTimeout(this.timer_);
    this.timer_ = window.setTimeout(() => this.work(), kPause);
  };

  private act(act: PlaceActions['openImported']): void {
    const { settings, imported } = this.work();
    const shown = new FormData(this.form_!).has('shown');
    if (imported) act(this.props.given.source, imported, settings, shown);
    else this.form_!.reportValidity();
  }

  /** As a place of its own, and beside it where it would stand in the present one. */
  private pictures({ imported, settings }: Made): VNode | null {
    const { present } = this.props.given;
    if (!imported) return null;
    const { place, outlines } = imported;
    const added = present && outlines.length > 0;
    const obstacles = movedTo(outlines, settings.at).map(obstacleOf);
    return (
      <>
        <figure>
          <PlacePicture drawing={drawingOf(place)} />
          <figcaption class="secondary">{`New: ${factsOf(place)}`}</figcaption>
        </figure>
        {added && (
          <figure>
            <PlacePicture drawing={drawingOf({ ...place, groups: [], obstacles })} present={drawingOf(present)} />
            <figcaption class="secondary">Added to this place</figcaption>
          </figure>
        )}
      </>
    );
  }

  private fields(): VNode {
    const { source, settings } = this.props.given;
    return (
      <div class="place-fields">
        <Field label="Name">
          <input type="text" name="name" maxLength={80} autocomplete="off" required defaultValue={settings.name} />
        </Field>
        {kFields
          .filter(({ kinds }) => kinds.includes(source.kind))
          .map(({ label, name, min, max, step }) => (
            <Field key={label} label={label}>
              <NumberInput name={name} min={min} max={max} step={step} value={settings[name]} />
            </Field>
          ))}
        {source.kind === 'model' && source.up === null && (
          <Field label="Axis that stands up">
            <select name="up" defaultValue={settings.up}>
              <option>y</option>
              <option>z</option>
            </select>
          </Field>
        )}
        {source.kind === 'model' && (
          <label class="place-check">
            <input type="checkbox" name="shown" defaultChecked />
            <span>Show the model itself</span>
          </label>
        )}
        {source.kind !== 'map' && (
          <div class="place-pair">
            <Field label="Added at x [m]">
              <NumberInput name="x" {...kFar} value={settings.at.x} />
            </Field>
            <Field label="y [m]">
              <NumberInput name="y" {...kFar} value={settings.at.y} />
            </Field>
          </div>
        )}
      </div>
    );
  }

  override render({ given, actions }: PlaceImportProps, made: Made): VNode {
    const { imported, note } = made;
    return (
      <form
        class="place-import"
        ref={(element) => void (this.form_ = element)}
        onInput={this.changed}
        onSubmit={(event) => {
          event.preventDefault();
          this.act((...parts) => actions.openImported(...parts));
        }}
      >
        <div
          class="place-preview"
          tabIndex={-1}
          role="group"
          aria-label="How it will look"
          ref={(element) => void (this.picture_ = element)}
        >
          {this.pictures(made)}
        </div>
        <p class="place-note" role="status">
          {note}
        </p>
        {this.fields()}
        <div class="place-acts">
          <Button
            icon="plus"
            hidden={given.source.kind === 'map'}
            disabled={!imported || imported.outlines.length === 0}
            act={() => this.act((...parts) => actions.addImported(...parts))}
          >
            Add to this place
          </Button>
          <Button type="submit" class="solid" disabled={!imported}>
            New place
          </Button>
        </div>
      </form>
    );
  }
}
