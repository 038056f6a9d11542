// How the persons of a chosen group differ: none, adults, or sorts of one's own with the spread of each number.

import { Component, type VNode } from 'preact';
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
import { Button } from '../widgets/buttons';
import { numberField, NumberField, selectField, TextField } from '../widgets/fields';
import type { BuildActions } from './build_actions';

const kAlike = 'All alike';
const kAdultsWord = 'Adults';
const kOwn = 'Sorts of one’s own';
const kAsUsual = 'As all';
const kFar = 1e9;
const kShares = { min: 0, max: 1, unit: '×' };
/** After so long without an answer what is shown counts again [ms]. */
const kPatience = 1500;
const kClasses: readonly string[] = ['None', '1', '2', '3', '4', '5', '6'];

function percent(share: number, all: number): string {
  return `${Math.round((100 * share) / Math.max(1e-9, all))} %`;
}

interface SpreadProps {
  readonly of: DrawnNumber;
  readonly sort: () => PersonSort;
  readonly prefix: string;
  readonly change: (fields: Partial<PersonSort>) => void;
}

/** How one number is spread. */
class SpreadFields extends Component<SpreadProps> {
  private refused_ = '';

  private set(next: Spreading | undefined): boolean {
    this.refused_ = next ? spreadTrouble(this.props.of, next) : '';
    this.forceUpdate();
    if (!this.refused_) this.props.change({ [this.props.of]: next });
    return !this.refused_;
  }

  override render({ of, sort, prefix }: SpreadProps): VNode {
    const { label, unit } = kNumbers[of];
    const now = sort()[of];
    return (
      <div class="build-spread">
        {selectField(
          `${label} [${unit}]`,
          [kAsUsual, ...Object.values(kSpreads).map(({ word }) => word)],
          now ? kSpreads[now.spread].word : kAsUsual,
          (word) => {
            const spread = (Object.keys(kSpreads) as Spread[]).find((one) => kSpreads[one].word === word);
            this.set(respread(of, sort()[of], spread));
          },
          `${prefix}${label}`,
        )}
        <div class="build-numbers">
          {now &&
            kSpreads[now.spread].fields.map(([field, name]) => {
              const value = now[field] as number;
              return (
                <NumberField
                  key={field}
                  label={name}
                  name={`${prefix}${label}, ${name.toLowerCase()}`}
                  value={field === 'most' && value >= kFar ? NaN : value}
                  range={{ min: -kFar, max: kFar }}
                  act={(typed) => this.set({ ...(sort()[of] ?? now), [field]: typed })}
                />
              );
            })}
        </div>
        <p class="build-refused" role="alert">
          {this.refused_}
        </p>
      </div>
    );
  }
}

export class PersonFields extends Component<{ readonly one: Thing; readonly actions: BuildActions }> {
  /** Which sorts are unfolded. */
  private readonly unfolded_ = new Set<number>();
  /** What the world has been told and does not show yet: the next change goes on from it. */
  private given_: { readonly sorts: readonly PersonSort[]; readonly at: number } | null = null;

  private get shown(): readonly PersonSort[] {
    return (this.props.one.rest['people'] ?? []) as readonly PersonSort[];
  }

  /** As the world shows them, or will. */
  private get now(): readonly PersonSort[] {
    const { given_: given, shown } = this;
    if (JSON.stringify(given?.sorts) === JSON.stringify(shown)) this.given_ = null;
    return given && performance.now() - given.at < kPatience ? given.sorts : shown;
  }

  private give(sorts: readonly PersonSort[]): void {
    this.given_ = { sorts, at: performance.now() };
    this.props.actions.editGroup('Persons', ({ id }) => ({ kind: 'changeGroup', group: id, people: sorts }));
  }

  private sort(sort: PersonSort, k: number, all: number): VNode {
    const change = (fields: Partial<PersonSort>): void =>
      this.give(this.now.map((other, n) => (n === k ? { ...other, ...fields } : other)));
    const prefix = this.shown.length > 1 ? `Sort ${k + 1}, ` : '';
    const drawn = kDrawnNumbers.flatMap((key) => (sort[key] ? [spreadWords(key, sort[key])] : []));
    const words = [sort.name || `Sort ${k + 1}`, percent(sort.share, all), ...drawn.slice(0, 2)];
    return (
      <details
        key={k}
        class="build-sort"
        open={this.unfolded_.has(k)}
        onToggle={({ currentTarget: { open } }) => (open ? this.unfolded_.add(k) : this.unfolded_.delete(k))}
      >
        <summary>{words.join(' · ')}</summary>
        <div class="build-fields">{this.facts(sort, prefix, change)}</div>
        {kDrawnNumbers.map((of) => (
          <SpreadFields key={of} of={of} sort={() => this.now[k] ?? sort} prefix={prefix} change={change} />
        ))}
        <Button
          act={() => {
            this.unfolded_.clear();
            this.give(this.now.filter((_, n) => n !== k));
          }}
        >
          Remove this sort
        </Button>
      </details>
    );
  }

  private facts(sort: PersonSort, prefix: string, change: (fields: Partial<PersonSort>) => void): VNode {
    const stairs = (key: 'upstairs' | 'downstairs', label: string): VNode =>
      numberField(
        label,
        sort[key],
        kShares,
        (value) => change({ [key]: value === 0 ? 0 : Math.max(0.01, value) }),
        `${prefix}${label}`,
      );
    return (
      <>
        <TextField label="Name" name={`${prefix}name of the sort`} value={sort.name} act={(name) => change({ name })} />
        {numberField('Share', sort.share, { min: 1e-6, max: 1e6 }, (share) => change({ share }), `${prefix}share`)}
        {stairs('upstairs', 'Up stairs, 0: as all')}
        {stairs('downstairs', 'Down stairs, 0: as all')}
        {selectField(
          'Class',
          kClasses,
          kClasses[sort.unitClass] ?? String(sort.unitClass),
          (word) => change({ unitClass: Number(word) || 0 }),
          `${prefix}class of the sort`,
        )}
      </>
    );
  }

  override render(): VNode {
    const sorts = this.shown;
    const adults = JSON.stringify(sorts) === JSON.stringify([kAdults]);
    const word = sorts.length === 0 ? kAlike : adults ? kAdultsWord : kOwn;
    const all = sorts.reduce((sum, { share }) => sum + share, 0);
    return (
      <div class="build-persons">
        {selectField('Persons', [kAlike, kAdultsWord, kOwn], word, (chosen) => {
          if (chosen === kOwn) this.unfolded_.add(0);
          // By its name it is no longer the word of scenario files.
          this.give(chosen === kAlike ? [] : chosen === kAdultsWord ? [kAdults] : [{ ...kAdults, name: 'Sort 1' }]);
        })}
        {word === kOwn && sorts.map((sort, k) => this.sort(sort, k, all))}
        {word === kOwn && (
          <Button
            act={() => {
              const { now } = this;
              this.unfolded_.add(now.length);
              this.give([...now, { ...kAdults, name: `Sort ${now.length + 1}` }]);
            }}
          >
            Add a sort
          </Button>
        )}
      </div>
    );
  }
}
