// How the persons of a chosen group differ: none, adults, or sorts of one's own with the spread of each number.

import {
  kAdults,
  kDrawnNumbers,
  kNumbers,
  kSpreads,
  respread,
  spreadTrouble,
  spreadWords,
  type DrawnNumber,
  type PersonSort,
  type Spread,
  type Spreading,
} from '../../model/place/people';
import type { Thing } from '../../model/place/things';
import { element } from '../widgets/dom';
import type { BuildActions } from './build_actions';
import { numberField, selectField, textField } from '../widgets/fields';

const kAlike = 'All alike';
const kAdultsWord = 'Adults';
const kOwn = 'Sorts of one’s own';
const kAsUsual = 'As all';
const kFar = 1e9;
/** After so long without an answer what is shown counts again [ms]. */
const kPatience = 1500;
const kClasses: readonly string[] = ['None', '1', '2', '3', '4', '5', '6'];

/** The field's name for readers of the screen: several have the same label. */
function named(field: HTMLElement, name: string): HTMLElement {
  field.querySelector('input, select')?.setAttribute('aria-label', name);
  return field;
}

function percent(share: number, all: number): string {
  return `${Math.round((100 * share) / Math.max(1e-9, all))} %`;
}

export class PersonFields {
  /** Which sorts are unfolded; it stays while the fields are made anew. */
  private readonly unfolded_ = new Set<number>();
  private group_ = 0;
  private shown_: readonly PersonSort[] = [];
  /** What the world has been told and does not show yet: the next change goes on from it. */
  private given_: { readonly sorts: readonly PersonSort[]; readonly at: number } | null = null;

  constructor(private readonly actions_: BuildActions) {}

  make(one: Thing): HTMLElement {
    const sorts = (one.rest['people'] ?? []) as readonly PersonSort[];
    if (one.id !== this.group_) this.unfolded_.clear();
    if (one.id !== this.group_ || JSON.stringify(this.given_?.sorts) === JSON.stringify(sorts)) this.given_ = null;
    this.group_ = one.id;
    this.shown_ = sorts;
    const adults = JSON.stringify(sorts) === JSON.stringify([kAdults]);
    const shown = sorts.length === 0 ? kAlike : adults ? kAdultsWord : kOwn;
    const choice = selectField('Persons', [kAlike, kAdultsWord, kOwn], shown, (word) => {
      if (word === kOwn) this.unfolded_.add(0);
      // By its name it is no longer the word of scenario files.
      this.give(word === kAlike ? [] : word === kAdultsWord ? [kAdults] : [{ ...kAdults, name: 'Sort 1' }]);
    });
    const parts = shown === kOwn ? sorts.map((sort, k) => this.sort(sort, k, sorts)) : [];
    if (shown === kOwn) parts.push(this.adding());
    return element('div', { class: 'build-persons' }, named(choice, 'Persons'), ...parts);
  }

  /** As the world shows them, or will. */
  private get now(): readonly PersonSort[] {
    const { given_: given } = this;
    return given && performance.now() - given.at < kPatience ? given.sorts : this.shown_;
  }

  private give(sorts: readonly PersonSort[]): void {
    this.given_ = { sorts, at: performance.now() };
    this.actions_.editGroup('Persons', ({ id }) => ({ kind: 'changeGroup', group: id, people: sorts }));
  }

  private adding(): HTMLElement {
    const button = element('button', { type: 'button', class: 'soft' }, 'Add a sort');
    button.addEventListener('click', () => {
      const { now } = this;
      this.unfolded_.add(now.length);
      this.give([...now, { ...kAdults, name: `Sort ${now.length + 1}` }]);
    });
    return button;
  }

  private sort(sort: PersonSort, k: number, sorts: readonly PersonSort[]): HTMLElement {
    const change = (fields: Partial<PersonSort>): void =>
      this.give(this.now.map((other, n) => (n === k ? { ...other, ...fields } : other)));
    const prefix = sorts.length > 1 ? `Sort ${k + 1}, ` : '';
    const all = sorts.reduce((sum, { share }) => sum + share, 0);
    const drawn = kDrawnNumbers.flatMap((key) => (sort[key] ? [spreadWords(key, sort[key])] : []));
    const words = [sort.name || `Sort ${k + 1}`, percent(sort.share, all), ...drawn.slice(0, 2)];
    const made = element(
      'details',
      { class: 'build-sort', open: this.unfolded_.has(k) },
      element('summary', {}, words.join(' · ')),
      element('div', { class: 'build-fields' }, ...this.facts(sort, prefix, change)),
      ...kDrawnNumbers.map((key) => this.number(key, () => this.now[k] ?? sort, prefix, change)),
      this.removing(k),
    );
    made.addEventListener('toggle', () => (made.open ? this.unfolded_.add(k) : this.unfolded_.delete(k)));
    return made;
  }

  private facts(sort: PersonSort, prefix: string, change: (fields: Partial<PersonSort>) => void): HTMLElement[] {
    const shares = { min: 0, max: 1, unit: '×' };
    const stairs = (key: 'upstairs' | 'downstairs', label: string): HTMLElement =>
      named(
        numberField(label, sort[key], shares, (value) => change({ [key]: value === 0 ? 0 : Math.max(0.01, value) })),
        `${prefix}${label}`,
      );
    return [
      named(
        textField('Name', sort.name, (name) => change({ name })),
        `${prefix}name of the sort`,
      ),
      named(
        numberField('Share', sort.share, { min: 1e-6, max: 1e6 }, (share) => change({ share })),
        `${prefix}share`,
      ),
      stairs('upstairs', 'Up stairs, 0: as all'),
      stairs('downstairs', 'Down stairs, 0: as all'),
      named(
        selectField('Class', kClasses, kClasses[sort.unitClass] ?? String(sort.unitClass), (word) =>
          change({ unitClass: Number(word) || 0 }),
        ),
        `${prefix}class of the sort`,
      ),
    ];
  }

  private number(
    key: DrawnNumber,
    sort: () => PersonSort,
    prefix: string,
    change: (fields: Partial<PersonSort>) => void,
  ): HTMLElement {
    const { label, unit } = kNumbers[key];
    const now = sort()[key];
    const words = [kAsUsual, ...Object.values(kSpreads).map(({ word }) => word)];
    const refused = element('p', { class: 'build-refused', role: 'alert' });
    const set = (next: Spreading | undefined): boolean => {
      const trouble = next ? spreadTrouble(key, next) : '';
      refused.textContent = trouble;
      if (!trouble) change({ [key]: next });
      return !trouble;
    };
    const choice = selectField(`${label} [${unit}]`, words, now ? kSpreads[now.spread].word : kAsUsual, (word) => {
      const spread = (Object.keys(kSpreads) as Spread[]).find((one) => kSpreads[one].word === word);
      set(respread(key, sort()[key], spread));
    });
    const fields = now ? kSpreads[now.spread].fields : [];
    const numbers = fields.map(([field, name]) => {
      const value = now![field] as number;
      const shown = field === 'most' && value >= kFar ? NaN : value;
      const input = numberField(name, shown, { min: -kFar, max: kFar }, (typed) => {
        if (set({ ...(sort()[key] ?? now!), [field]: typed })) return;
        // After the field has written what was typed.
        queueMicrotask(() => (input.querySelector('input')!.value = Number.isFinite(shown) ? String(shown) : ''));
      });
      return named(input, `${prefix}${label}, ${name.toLowerCase()}`);
    });
    return element(
      'div',
      { class: 'build-spread' },
      named(choice, `${prefix}${label}`),
      element('div', { class: 'build-numbers' }, ...numbers),
      refused,
    );
  }

  private removing(k: number): HTMLElement {
    const button = element('button', { type: 'button', class: 'soft' }, 'Remove this sort');
    button.addEventListener('click', () => {
      this.unfolded_.clear();
      this.give(this.now.filter((_, n) => n !== k));
    });
    return button;
  }
}
