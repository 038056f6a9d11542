// What a take can become: a film, a picture, or a file for another program; with progress and a way to stop.

import { element, setText } from '../widgets/dom';
import { icon } from '../widgets/icons';

/** Something that a take can become. */
export interface ExportKind {
  readonly name: string;
  readonly label: string;
  readonly about: string;
  /** Made by the page. */
  readonly here: boolean;
  /** A film: it has a size. */
  readonly film?: boolean;
  /** Its frames a second can be chosen. */
  readonly frames?: boolean;
  /** Frames a second that suit it. */
  readonly fps?: number;
}

/** Players draw as many pictures as the display shows between the frames of the file. */
const kPlayerFps = 15;

export const kExportKinds: readonly ExportKind[] = [
  { name: 'film', label: 'Film', about: 'MP4 or WebM of what you see', here: true, film: true, frames: true },
  { name: 'picture', label: 'Picture', about: 'PNG of the shown moment', here: true },
  {
    name: 'player-page',
    label: 'Web page',
    about: 'One HTML file that plays in any browser',
    here: false,
    fps: kPlayerFps,
  },
  {
    name: 'player-folder',
    label: 'Player',
    about: 'Script, crowd and the lines to copy, in a ZIP',
    here: false,
    fps: kPlayerFps,
  },
  {
    name: 'glb',
    label: 'glTF',
    about: 'Bodies in motion on their ground, for Blender and engines',
    here: false,
    frames: true,
  },
  { name: 'usda', label: 'USD', about: 'The same for Houdini, Maya, Omniverse', here: false, frames: true },
  { name: 'bvh', label: 'BVH', about: 'One motion file per person, in a ZIP', here: false, frames: true },
  { name: 'jupedsim', label: 'JuPedSim', about: 'Trajectories as SQLite', here: false, frames: true },
  { name: 'pedpy', label: 'PedPy', about: 'Trajectories as text', here: false, frames: true },
];

export const kFilmSizes: Readonly<Record<string, readonly [number, number]>> = {
  '1280 × 720': [1280, 720],
  '1920 × 1080': [1920, 1080],
  '1080 × 1920': [1080, 1920],
  '1080 × 1080': [1080, 1080],
};

export interface ExportChoice {
  readonly kind: ExportKind;
  readonly fps: number;
  readonly size: readonly [number, number];
  /** Without meshes, places and paths. */
  readonly clean: boolean;
}

export interface ExportDialogActions {
  begin(choice: ExportChoice): void;
  cancel(): void;
}

export class ExportDialog {
  private readonly title_ = element('h2', { id: 'export-title' });
  private readonly kinds_ = element(
    'fieldset',
    { class: 'export-kinds' },
    element('legend', { class: 'unseen' }, 'Kind'),
  );
  private readonly fps_ = this.select('Pictures a second', ['24', '25', '30', '60'], '30');
  private readonly size_ = this.select('Size', Object.keys(kFilmSizes), '1280 × 720');
  private readonly clean_ = element('input', { type: 'checkbox', checked: true });
  private readonly fpsRow_ = element('label', { class: 'export-row' }, 'Frames a second', this.fps_);
  private readonly sizeRow_ = element('label', { class: 'export-row' }, 'Size', this.size_);
  private readonly cleanRow_ = element('label', { class: 'export-row' }, 'Without marks', this.clean_);
  private readonly begin_ = element(
    'button',
    { type: 'button', class: 'solid export-begin' },
    icon('download'),
    'Export',
  );
  private readonly bar_ = element('progress', { max: 1, value: 0, 'aria-label': 'Progress of the export' });
  private readonly said_ = element('p', { class: 'export-said', role: 'status' });
  private readonly stop_ = element('button', { type: 'button', class: 'soft export-stop' }, 'Cancel');
  private readonly running_ = element('div', { class: 'export-running', hidden: true }, this.bar_, this.stop_);
  readonly root = element('dialog', { class: 'export-dialog', 'aria-labelledby': 'export-title' });
  private kind_: ExportKind;

  constructor(kinds: readonly ExportKind[], actions: ExportDialogActions) {
    this.kind_ = kinds[0]!;
    for (const kind of kinds) this.kinds_.append(this.choice(kind));
    const close = element('button', { type: 'button', 'aria-label': 'Close the export' }, icon('close'));
    close.addEventListener('click', () => this.root.close());
    this.begin_.addEventListener('click', () => actions.begin(this.chosen));
    this.stop_.addEventListener('click', () => actions.cancel());
    this.root.addEventListener('close', () => actions.cancel());
    this.root.addEventListener('keydown', (event) => event.stopPropagation());
    this.root.append(
      element('header', {}, this.title_, close),
      this.kinds_,
      this.fpsRow_,
      this.sizeRow_,
      this.cleanRow_,
      this.said_,
      this.running_,
      this.begin_,
    );
    this.showRows();
  }

  get chosen(): ExportChoice {
    return {
      kind: this.kind_,
      fps: this.kind_.fps ?? Number(this.fps_.value),
      size: kFilmSizes[this.size_.value] ?? [1280, 720],
      clean: this.clean_.checked,
    };
  }

  open(title: string): void {
    setText(this.title_, `Export “${title}”`);
    setText(this.said_, '');
    this.setRunning(false);
    if (!this.root.open) this.root.showModal();
    this.kinds_.querySelector<HTMLInputElement>('input:checked')?.focus();
  }

  setProgress(share: number): void {
    this.bar_.value = share;
    setText(this.said_, `${Math.floor(100 * share)} %`);
  }

  setRunning(running: boolean): void {
    this.running_.hidden = !running;
    this.begin_.hidden = running;
    this.kinds_.disabled = running;
    if (running) this.setProgress(0);
    if (this.root.open) this.keepFocus(running ? this.stop_ : this.begin_);
  }

  /** What had the focus has gone: without any, Escape would not close the dialog. */
  private keepFocus(next: HTMLButtonElement): void {
    const { activeElement } = document;
    const stays = activeElement?.closest('.export-dialog') === this.root && !activeElement.closest('[hidden]');
    if (!stays || next === this.stop_) next.focus();
  }

  /** What became of it. */
  say(text: string): void {
    setText(this.said_, text);
  }

  private select(label: string, options: readonly string[], value: string): HTMLSelectElement {
    const select = element('select', { 'aria-label': label });
    for (const one of options) select.append(element('option', { value: one, selected: one === value }, one));
    return select;
  }

  private choice(kind: ExportKind): HTMLElement {
    const input = element('input', {
      type: 'radio',
      name: 'export-kind',
      value: kind.name,
      checked: kind === this.kind_,
    });
    input.addEventListener('change', () => {
      this.kind_ = kind;
      this.showRows();
    });
    const words = element(
      'span',
      { class: 'export-words' },
      element('strong', {}, kind.label),
      element('span', { class: 'secondary' }, kind.about),
    );
    return element('label', { class: 'export-kind' }, input, words);
  }

  private showRows(): void {
    this.fpsRow_.hidden = !this.kind_.frames;
    this.sizeRow_.hidden = !this.kind_.film;
    this.cleanRow_.hidden = !this.kind_.here;
  }
}
