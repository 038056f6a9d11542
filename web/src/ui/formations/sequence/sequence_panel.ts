// The list of formations along a way: which, after how many metres, in which order.

import { savedShapes } from '../../../model/saved_shapes';
import type { FormationWords } from '../../../model/sequence';
import type { StandWords } from '../../../model/stand';
import type { StudioStore } from '../../../model/studio_store';
import { kFormations } from '../formation_panel';
import { element, setAttribute, setText } from '../../widgets/dom';
import { formationIcon } from '../../widgets/formation_icons';
import { accentVariable } from '../../widgets/group_marks';
import { icon, type IconName } from '../../widgets/icons';

export interface SequenceRow {
  readonly at: number;
  readonly formation: FormationWords;
  /** Places there that cannot be reached, of how many. */
  readonly bad: number;
  readonly all: number;
}

export interface SequenceActions {
  close(): void;
  add(): void;
  /** At another distance along the way [m]. */
  place(index: number, at: number): void;
  /** A formation of the library, or `saved:` and the name of one in this browser. */
  choose(index: number, name: string): void;
  earlier(index: number): void;
  remove(index: number): void;
}

const kLibrary = kFormations.slice(0, 8);
const kOwn = 'own';

function labelOf({ kind }: FormationWords): string {
  return kLibrary.find(({ name }) => name === kind)?.label ?? 'Own shape';
}

function iconButton(name: IconName, label: string, run: () => void): HTMLButtonElement {
  const button = element('button', { type: 'button', class: 'sequence-act', 'aria-label': label }, icon(name, 18));
  button.addEventListener('click', run);
  return button;
}

/** One row's elements; it is kept while its values change. */
class Row {
  private readonly icon_ = element('span', { class: 'sequence-icon', 'aria-hidden': 'true' });
  private readonly select_ = element('select', {});
  private readonly at_ = element('input', { type: 'number', inputmode: 'decimal', min: 0, step: 0.5 });
  private readonly bad_ = element('span', { class: 'sequence-bad' });
  private readonly earlier_: HTMLButtonElement;
  readonly root: HTMLElement;
  private shown_ = '';

  constructor(index: number, actions: SequenceActions) {
    const number = index + 1;
    setAttribute(this.select_, 'aria-label', `Formation ${number}`);
    setAttribute(this.at_, 'aria-label', `Formation ${number} is taken up after [m]`);
    this.earlier_ = iconButton('earlier', `Formation ${number} earlier`, () => actions.earlier(index));
    const remove = iconButton('close', `Remove formation ${number}`, () => actions.remove(index));
    this.select_.addEventListener('change', () => actions.choose(index, this.select_.value));
    this.at_.addEventListener('change', () => {
      const at = this.at_.valueAsNumber;
      if (Number.isFinite(at)) actions.place(index, Math.max(0, at));
    });
    const metres = element(
      'label',
      { class: 'sequence-at' },
      this.at_,
      element('span', { 'aria-hidden': 'true' }, 'm'),
    );
    this.root = element('li', {}, this.icon_, this.select_, metres, this.earlier_, remove, this.bad_);
    setAttribute(this.earlier_, 'aria-disabled', String(index === 0));
  }

  show({ at, formation, bad, all }: SequenceRow): void {
    const key = JSON.stringify(formation);
    if (key !== this.shown_) {
      this.shown_ = key;
      this.icon_.replaceChildren(formationIcon(formation));
      this.select_.replaceChildren(...optionsFor(formation));
    }
    if (document.activeElement !== this.at_) {
      const text = String(Math.round(at * 10) / 10);
      if (this.at_.value !== text) this.at_.value = text;
    }
    setText(this.bad_, bad > 0 ? `${bad} of ${all} places cannot be reached` : '');
  }
}

function optionsFor(formation: FormationWords): HTMLElement[] {
  const isOwn = !kLibrary.some(({ name }) => name === formation.kind);
  const saved = savedShapes(() => window.localStorage);
  return [
    ...(isOwn ? [element('option', { value: kOwn, selected: true }, labelOf(formation))] : []),
    ...kLibrary.map(({ name, label }) => element('option', { value: name, selected: name === formation.kind }, label)),
    ...saved.map(({ name }) => element('option', { value: `saved:${name}` }, name)),
  ];
}

export class SequencePanel {
  private readonly note_ = element('p', { class: 'secondary sequence-note', role: 'status' });
  private readonly list_ = element('ol', { class: 'sequence-list' });
  private readonly add_ = element('button', { type: 'button', class: 'soft' }, icon('plus'), 'Add');
  readonly root: HTMLElement;
  private rows_: Row[] = [];

  constructor(
    private readonly store_: StudioStore,
    private readonly actions_: SequenceActions,
  ) {
    const close = iconButton('close', 'Close the formations along the way', () => actions_.close());
    this.add_.addEventListener('click', () => actions_.add());
    this.root = element(
      'section',
      { class: 'queue panel sequence', 'aria-label': 'Formations along the way', hidden: true },
      element('header', {}, element('h2', {}, 'Along the way'), this.add_, close),
      this.note_,
      this.list_,
    );
    this.root.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape') return;
      event.stopPropagation();
      actions_.close();
    });
  }

  show(rows: readonly SequenceRow[], length: number, room: boolean): void {
    const opens = this.root.hidden;
    this.root.hidden = false;
    const { groups, active } = this.store_.state;
    this.root.style.setProperty('--accent', accentVariable(groups[active]?.colour ?? 0));
    if (rows.length !== this.rows_.length) {
      this.rows_ = rows.map((_, index) => new Row(index, this.actions_));
      this.list_.replaceChildren(...this.rows_.map(({ root }) => root));
      this.list_.lastElementChild?.scrollIntoView({ block: 'nearest' });
    }
    rows.forEach((row, index) => this.rows_[index]!.show(row));
    this.add_.disabled = !room;
    const way = `${Math.round(length)} m`;
    const words =
      rows.length === 0
        ? `The way ahead is ${way} long. Add what the group takes up on it.`
        : `Each is taken up after so many metres; the way ahead is ${way}.`;
    setText(this.note_, words);
    if (opens) this.add_.focus({ preventScroll: true });
  }

  /** What is said of the ground. */
  say({ warns }: StandWords): void {
    this.root.classList.toggle('warns', warns);
  }
}
