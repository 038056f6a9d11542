// Dialogs for words as a formation, for shapes of one's own, and for a new group. This file is loaded when the first of them is opened.

import { PanelLayout } from '../widgets/panel_layout';
import { formationKind } from '../../model/sequence';
import { spreadOver, type Mask } from '../../model/spread';
import type { GroundPoint } from '../../model/plane';
import type { ShapeActions } from '../../model/shape_actions';
import type { StudioActions } from '../../model/studio_actions';
import type { StudioStore } from '../../model/studio_store';
import { element, setText } from '../widgets/dom';
import { dialogOf, drawPlaces, field } from '../widgets/dialog_parts';
import { groundWords, leave, lookOrTake } from './try_parts';
import { PlacingBar } from './placing_bar';
import { TryBar } from './try_bar';
import { kFormations } from './formation_panel';
import { OwnShapeDialog } from './own_shape_dialog';

/** Letters at most, and the height of a letter in the picture that is spread over [cells]. */
const kMostLetters = 24;
const kLetterCells = 72;
/** With fewer people per letter than this, letters are thin lines. */
const kThin = 26;

/** The words in black on a picture as small as serves. */
function maskOf(words: string, perLetter: number): Mask {
  const canvas = document.createElement('canvas');
  const font = `${perLetter < kThin ? 250 : 750} ${kLetterCells}px "Inter Variable", Inter, system-ui, sans-serif`;
  const pen = canvas.getContext('2d', { willReadFrequently: true });
  if (!pen) return { width: 0, height: 0, cells: [] };
  pen.font = font;
  canvas.width = Math.ceil(pen.measureText(words).width) + 8;
  canvas.height = Math.ceil(1.35 * kLetterCells);
  pen.font = font;
  pen.textBaseline = 'middle';
  pen.fillText(words, 4, canvas.height / 2);
  const { data, width, height } = pen.getImageData(0, 0, canvas.width, canvas.height);
  return {
    width,
    height,
    cells: Uint8Array.from({ length: width * height }, (_, i) => (data[4 * i + 3]! > 110 ? 1 : 0)),
  };
}

class TextDialog {
  private readonly parts_;
  private readonly words_ = element('input', {
    type: 'text',
    maxlength: kMostLetters,
    autocomplete: 'off',
    spellcheck: 'false',
    required: true,
  });
  private readonly picture_ = element('canvas', { class: 'shape-preview', 'aria-hidden': 'true' });
  private readonly note_ = element('p', { class: 'secondary shape-note' });
  private places_: readonly GroundPoint[] = [];
  private gap_ = 1;

  constructor(
    private readonly store_: StudioStore,
    private readonly shapes_: ShapeActions,
    close: () => void,
  ) {
    const shapes = shapes_;
    this.parts_ = dialogOf('Write words', () => leave(this.store_, shapes, close));
    this.parts_.form.append(
      field('Words', this.words_),
      this.picture_,
      this.note_,
      groundWords(store_),
      lookOrTake(() => this.tryOut()),
    );
    this.words_.addEventListener('input', () => this.spread());
    this.parts_.form.addEventListener('submit', (event) => {
      event.preventDefault();
      if (this.places_.length === 0) return;
      shapes.takeShape(shapes.words(this.places_, this.gap_), this.words_.value.trim());
      this.root.close();
    });
  }

  get root(): HTMLDialogElement {
    return this.parts_.root;
  }

  open(): void {
    this.root.showModal();
    this.words_.select();
    this.spread();
  }

  private spread(): void {
    const { groups, active } = this.store_.state;
    const count = groups[active]?.count ?? 0;
    const words = this.words_.value.trim();
    const letters = words.replace(/\s/g, '').length;
    const { places, gap } = letters > 0 ? spreadOver(maskOf(words, count / letters), count) : { places: [], gap: 1 };
    [this.places_, this.gap_] = [places.length === count ? places : [], gap];
    const few = letters > 0 && count / letters < 5;
    setText(
      this.note_,
      few
        ? `${count} people for ${letters} letters: it will be hard to read.`
        : `${groups[active]?.name ?? 'The group'}: ${count} people.`,
    );
    drawPlaces(this.picture_, places, this.gap_);
    this.shapes_.lookAt(this.places_.length > 0 ? this.shapes_.words(this.places_, gap) : null);
  }

  private tryOut(): void {
    if (this.places_.length === 0) return this.words_.focus();
    const shape = this.shapes_.words(this.places_, this.gap_);
    this.shapes_.tryOut({ title: this.words_.value.trim(), dialog: 'text', shape });
    this.root.close();
  }
}

interface NumberDef {
  readonly label: string;
  readonly min: number;
  readonly max: number;
  readonly step: number;
  /** Empty for what is usual in the world. */
  readonly value: number | '';
}

function numberInput({ min, max, step, value }: NumberDef): HTMLInputElement {
  return element('input', {
    type: 'number',
    inputmode: 'decimal',
    min,
    max,
    step,
    value: String(value),
    required: value !== '',
    placeholder: value === '' ? 'as usual' : undefined,
  });
}

class GroupDialog {
  private readonly parts_;
  private readonly name_ = element('input', { type: 'text', maxlength: 40, autocomplete: 'off', required: true });
  private readonly formation_ = element(
    'select',
    {},
    ...kFormations.slice(0, 8).map(({ name, label }) => element('option', { value: name }, label)),
  );
  private readonly count_ = numberInput({ label: 'People', min: 1, max: 5000, step: 1, value: 36 });
  private readonly spacing_ = numberInput({ label: 'Spacing', min: 0.5, max: 10, step: 0.1, value: 1 });
  private readonly radius_ = numberInput({ label: 'Radius', min: 0.05, max: 1.5, step: 0.01, value: '' });
  private readonly speed_ = numberInput({ label: 'Speed', min: 0.1, max: 12, step: 0.1, value: '' });

  constructor(
    private readonly store_: StudioStore,
    shapes: ShapeActions,
    close: () => void,
  ) {
    this.parts_ = dialogOf('Add a group', close);
    const done = element('button', { type: 'submit', class: 'solid' }, 'Place it');
    this.parts_.form.append(
      field('Name', this.name_),
      field('People', this.count_),
      field('Formation', this.formation_),
      field('Spacing [m]', this.spacing_),
      field('Radius of a body [m]', this.radius_),
      field('Top speed [m/s]', this.speed_),
      element('p', { class: 'secondary shape-note' }, 'Then press on the ground where it shall stand.'),
      done,
    );
    this.parts_.form.addEventListener('submit', (event) => {
      event.preventDefault();
      shapes.holdGroup({
        name: this.name_.value.trim(),
        count: this.count_.valueAsNumber,
        formation: formationKind(this.formation_.value),
        spacing: this.spacing_.valueAsNumber,
        radius: this.radius_.valueAsNumber || 0,
        speed: this.speed_.valueAsNumber || 0,
      });
      this.root.close();
    });
  }

  get root(): HTMLDialogElement {
    return this.parts_.root;
  }

  open(): void {
    const { groups } = this.store_.state;
    this.name_.value = `Group ${groups.length + 1}`;
    this.root.showModal();
    this.name_.select();
  }
}

/** Opens the dialog that the state names, and tells the state when it has closed. */
export function watchShapeDialogs(
  page: HTMLElement,
  store: StudioStore,
  actions: Pick<StudioActions, 'openDialog'>,
  shapes: ShapeActions,
): void {
  const close = (): void => actions.openDialog('none');
  const dialogs = {
    text: new TextDialog(store, shapes, close),
    shape: new OwnShapeDialog(store, shapes, close),
    group: new GroupDialog(store, shapes, close),
  };
  for (const dialog of Object.values(dialogs)) page.append(dialog.root);
  PanelLayout.of(page).add('try', new TryBar(store, shapes).root);
  PanelLayout.of(page).add('placing', new PlacingBar(store).root);
  store.watch(['dialog'], ({ dialog }) => {
    if (dialog !== 'none' && !dialogs[dialog].root.open) dialogs[dialog].open();
  });
}
