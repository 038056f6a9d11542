// The list of formations along a way: which, after how many metres, in which order.

import { Component, render, type VNode } from 'preact';
import { savedShapes } from '../../../model/saved_shapes';
import type { FormationWords } from '../../../model/sequence';
import type { StudioStore } from '../../../model/studio_store';
import { kFormations } from '../formation_panel';
import { Button, Icon } from '../../widgets/buttons';
import { element } from '../../widgets/dom';
import { formationIcon } from '../../widgets/formation_icons';
import { accentVariable } from '../../widgets/group_marks';
import { Held } from '../../widgets/held';
import type { IconName } from '../../widgets/icons';

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

interface ActProps {
  readonly icon: IconName;
  readonly label: string;
  readonly idle?: boolean;
  readonly act: () => void;
}

function Act({ icon, label, idle, act }: ActProps): VNode {
  return (
    <button type="button" class="sequence-act" aria-label={label} aria-disabled={idle} onClick={act}>
      <Icon name={icon} size={18} />
    </button>
  );
}

/** Those of the library, those of this browser, and before them its own where it is none of them. */
function Choices({ formation: { kind } }: Pick<SequenceRow, 'formation'>): VNode {
  return (
    <>
      {!kLibrary.some(({ name }) => name === kind) && <option value={kOwn}>Own shape</option>}
      {kLibrary.map(({ name, label }) => (
        <option key={name} value={name}>
          {label}
        </option>
      ))}
      {savedShapes(() => window.localStorage).map(({ name }) => (
        <option key={name} value={`saved:${name}`}>
          {name}
        </option>
      ))}
    </>
  );
}

interface RowProps extends SequenceRow {
  readonly index: number;
  readonly actions: SequenceActions;
}

class Row extends Component<RowProps> {
  private root_: HTMLElement | null = null;
  private at_: HTMLInputElement | null = null;

  override componentDidMount(): void {
    this.root_!.scrollIntoView?.({ block: 'nearest' });
    this.componentDidUpdate();
  }

  /** What is being typed stays. */
  override componentDidUpdate(): void {
    const text = String(Math.round(this.props.at * 10) / 10);
    if (document.activeElement !== this.at_ && this.at_!.value !== text) this.at_!.value = text;
  }

  override render({ index, formation, bad, all, actions }: RowProps): VNode {
    const name = `Formation ${index + 1}`;
    const known = kLibrary.some((one) => one.name === formation.kind);
    return (
      <li ref={(made) => void (this.root_ = made)}>
        <span class="sequence-icon" aria-hidden="true">
          <Held key={JSON.stringify(formation)} make={() => formationIcon(formation)} />
        </span>
        <select
          aria-label={name}
          value={known ? formation.kind : kOwn}
          onChange={({ currentTarget }) => actions.choose(index, currentTarget.value)}
        >
          <Choices formation={formation} />
        </select>
        <label class="sequence-at">
          <input
            type="number"
            inputMode="decimal"
            min={0}
            step={0.5}
            aria-label={`${name} is taken up after [m]`}
            ref={(made) => void (this.at_ = made)}
            onChange={({ currentTarget: { valueAsNumber: at } }) =>
              Number.isFinite(at) && actions.place(index, Math.max(0, at))
            }
          />
          <span aria-hidden="true">m</span>
        </label>
        <Act icon="earlier" label={`${name} earlier`} idle={index === 0} act={() => actions.earlier(index)} />
        <Act icon="close" label={`Remove ${name.toLowerCase()}`} act={() => actions.remove(index)} />
        <span class="sequence-bad">{bad > 0 ? `${bad} of ${all} places cannot be reached` : ''}</span>
      </li>
    );
  }
}

export class SequencePanel {
  readonly root = element('section', {
    class: 'queue panel sequence',
    'aria-label': 'Formations along the way',
    hidden: true,
  });

  constructor(
    private readonly store_: StudioStore,
    private readonly actions_: SequenceActions,
  ) {
    this.root.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape') return;
      event.stopPropagation();
      actions_.close();
    });
  }

  /** `length` of the way ahead [m]; `room`: one more has room on it. */
  show(rows: readonly SequenceRow[], length: number, room: boolean): void {
    const opens = this.root.hidden;
    this.root.hidden = false;
    const { groups, active } = this.store_.state;
    this.root.style.setProperty('--accent', accentVariable(groups[active]?.colour ?? 0));
    const way = `${Math.round(length)} m`;
    const { actions_: actions } = this;
    render(
      <>
        <header>
          <h2>Along the way</h2>
          <Button icon="plus" disabled={!room} act={() => actions.add()}>
            Add
          </Button>
          <Act icon="close" label="Close the formations along the way" act={() => actions.close()} />
        </header>
        <p class="secondary sequence-note" role="status">
          {rows.length === 0
            ? `The way ahead is ${way} long. Add what the group takes up on it.`
            : `Each is taken up after so many metres; the way ahead is ${way}.`}
        </p>
        <ol class="sequence-list">
          {rows.map((row, index) => (
            <Row key={`${rows.length} ${index}`} {...row} index={index} actions={actions} />
          ))}
        </ol>
      </>,
      this.root,
    );
    if (opens) this.root.querySelector<HTMLElement>('.soft')!.focus({ preventScroll: true });
  }
}
