// The dialog in which a formation is changed, saved with a name, or taken from a picture, before the crowd moves.

import { maskOfPixels, readSize } from '../../model/picture_mask';
import { kMostLetters, removeShape, savedShapes, saveShape, type SavedShape } from '../../model/saved_shapes';
import { forCount, loosened, mirrored, turned, type OwnShape } from '../../model/shape_edit';
import type { ShapeActions } from '../../model/shape_actions';
import { spreadOver } from '../../model/spread';
import type { StudioStore } from '../../model/studio_store';
import { element, setText } from '../widgets/dom';
import { icon } from '../widgets/icons';
import { dialogOf, drawPlaces, field } from '../widgets/dialog_parts';
import { groundWords, leave, lookOrTake } from './try_parts';

/** Size of the preview, and of those of saved formations [CSS px]. */
const kPreview = { width: 340, height: 200 };
const kSmall = { width: 56, height: 40 };
/** A picture is read with at most so many pixels on a side. */
const kMostPixels = 400;
/** Neighbours in a picture stand so far apart at first [m]. */
const kGap = 0.9;
const kTurn = Math.PI / 8;
const kLooser = 1.15;

const storage = (): Storage => window.localStorage;

/** As they look from behind the group: ahead is up. */
function seenFromBehind({ places }: OwnShape): { x: number; y: number }[] {
  return places.map(({ x, y }) => ({ x: -y, y: x }));
}

export class OwnShapeDialog {
  private readonly parts_;
  private readonly picture_ = element('canvas', { class: 'shape-preview shape-preview-tall', 'aria-hidden': 'true' });
  private readonly note_ = element('p', { class: 'secondary shape-note', role: 'status' });
  private readonly name_ = element('input', { type: 'text', maxlength: kMostLetters, autocomplete: 'off' });
  private readonly file_ = element('input', {
    type: 'file',
    accept: 'image/*',
    hidden: true,
    'aria-label': 'Picture',
    tabindex: -1,
  });
  private readonly saved_ = element('ul', { class: 'shape-saved', 'aria-label': 'Saved formations' });
  private shape_: OwnShape | null = null;
  private title_ = '';

  constructor(
    private readonly store_: StudioStore,
    private readonly shapes_: ShapeActions,
    close: () => void,
  ) {
    this.parts_ = dialogOf('Change the formation', () => leave(store_, shapes_, close));
    const save = element('button', { type: 'button', class: 'soft shape-save' }, 'Save');
    this.parts_.form.append(
      this.picture_,
      this.tools(),
      this.note_,
      groundWords(store_),
      element('div', { class: 'shape-naming' }, field('Name', this.name_), save),
      this.saved_,
      lookOrTake(() => this.tryOut()),
      this.file_,
    );
    save.addEventListener('click', () => this.save());
    this.name_.addEventListener('keydown', (event) => {
      if (event.key !== 'Enter') return;
      event.preventDefault();
      this.save();
    });
    this.file_.addEventListener('change', () => {
      const file = this.file_.files?.[0];
      this.file_.value = '';
      if (file) void this.read(file);
    });
    this.parts_.form.addEventListener('submit', (event) => {
      event.preventDefault();
      if (!this.shape_) return;
      shapes_.takeShape(this.shape_, this.title_ || 'another formation');
      this.root.close();
    });
  }

  get root(): HTMLDialogElement {
    return this.parts_.root;
  }

  open(): void {
    const group = this.group();
    this.root.showModal();
    this.listSaved();
    // Back from the ground it goes on with what was tried out there.
    if (this.store_.state.trying && this.shape_) return this.show(this.shape_, '');
    this.title_ = '';
    this.name_.value = '';
    const picture = this.shapes_.takePicture();
    if (picture) void this.read(picture);
    this.show(this.shapes_.shape(), group ? `${group.name}: ${group.count} people.` : 'There is no group.');
  }

  private group() {
    const { groups, active } = this.store_.state;
    return groups[active];
  }

  private tools(): HTMLElement {
    const changes: readonly [string, (shape: OwnShape) => OwnShape][] = [
      ['Mirror', mirrored],
      ['Turn left', (shape) => turned(shape, kTurn)],
      ['Turn right', (shape) => turned(shape, -kTurn)],
      ['Closer', (shape) => loosened(shape, 1 / kLooser)],
      ['Looser', (shape) => loosened(shape, kLooser)],
    ];
    const buttons = changes.map(([label, change]) => {
      const button = element('button', { type: 'button', class: 'soft' }, label);
      button.addEventListener('click', () => this.shape_ && this.show(change(this.shape_), ''));
      return button;
    });
    const picture = element('button', { type: 'button', class: 'soft' }, icon('open'), 'Picture…');
    picture.addEventListener('click', () => this.file_.click());
    return element('div', { class: 'shape-tools', role: 'group', 'aria-label': 'Changes' }, ...buttons, picture);
  }

  private show(shape: OwnShape | null, note: string): void {
    this.shape_ = shape;
    const metres = shape ? `Neighbours stand ${shape.spacing.toFixed(2)} m apart.` : '';
    setText(this.note_, [note, metres].filter((one) => one !== '').join(' '));
    drawPlaces(this.picture_, shape ? seenFromBehind(shape) : [], shape?.spacing ?? 1, kPreview);
    this.shapes_.lookAt(shape);
  }

  private tryOut(): void {
    if (!this.shape_) return;
    this.shapes_.tryOut({ title: this.title_ || 'Changed formation', dialog: 'shape', shape: this.shape_ });
    this.root.close();
  }

  /** What is dark in a picture becomes the formation; its upper edge is the front. */
  private async read(file: File): Promise<void> {
    const count = this.group()?.count ?? 0;
    const picture = await createImageBitmap(file).catch(() => null);
    if (!picture) {
      setText(this.note_, `“${file.name}” is no picture that this browser can read.`);
      return;
    }
    const { width, height } = readSize(picture.width, picture.height, kMostPixels);
    const canvas = element('canvas', { width, height });
    const pen = canvas.getContext('2d', { willReadFrequently: true });
    pen?.drawImage(picture, 0, 0, width, height);
    picture.close();
    const data = pen?.getImageData(0, 0, width, height).data ?? [];
    const { places, gap } = spreadOver(maskOfPixels(data, width, height), count);
    if (places.length < Math.max(1, count)) {
      setText(this.note_, `“${file.name}” has too little that is dark for ${count} people: dark is where they stand.`);
      return;
    }
    const scale = kGap / Math.max(gap, 1e-9);
    this.title_ = file.name.replace(/\.\w+$/, '');
    this.name_.value = this.title_.slice(0, kMostLetters);
    this.show(
      { spacing: kGap, places: places.map(({ x, y }) => ({ x: scale * y, y: -scale * x })) },
      `From “${file.name}”.`,
    );
  }

  private save(): void {
    const name = this.name_.value.trim();
    if (!this.shape_) return;
    if (name === '') {
      setText(this.note_, 'A formation that is saved needs a name.');
      this.name_.focus();
      return;
    }
    const kept = saveShape(storage, { name, ...this.shape_ });
    setText(this.note_, kept ? `“${name}” is saved in this browser.` : 'This browser has no room for it.');
    this.title_ = name;
    this.listSaved();
  }

  private listSaved(): void {
    this.saved_.replaceChildren(
      ...savedShapes(storage)
        .reverse()
        .map((shape) => this.item(shape)),
    );
  }

  private item(shape: SavedShape): HTMLElement {
    const small = element('canvas', { 'aria-hidden': 'true' });
    const take = element(
      'button',
      { type: 'button', class: 'shape-saved-take' },
      small,
      element('span', {}, shape.name),
    );
    take.addEventListener('click', () => {
      this.title_ = shape.name;
      this.name_.value = shape.name;
      this.show(forCount(shape, this.group()?.count ?? 0), '');
    });
    const remove = element('button', { type: 'button', class: 'shape-saved-remove' }, icon('close'));
    remove.setAttribute('aria-label', `Remove ${shape.name}`);
    remove.addEventListener('click', () => {
      removeShape(storage, shape.name);
      this.listSaved();
      setText(this.note_, `“${shape.name}” is removed.`);
    });
    requestAnimationFrame(() => drawPlaces(small, seenFromBehind(shape), shape.spacing, kSmall));
    return element('li', {}, take, remove);
  }
}
