// What a take can become: a film, a picture, or a file for another program; of whom, of which part, and how large; with
// progress and a way to stop.

import { render, type ComponentChildren, type VNode } from 'preact';
import { Button } from '../widgets/buttons';
import { Modal } from '../widgets/dialog';
import { element } from '../widgets/dom';
import { kExportKinds, kFilmSizes, type ExportChoice, type ExportKind, type ExportRange } from './export_kinds';

/** So long a choice stands before its size is asked for [ms]. */
const kThink = 350;
const kRates = ['24', '25', '30', '60'] as const;
const kNobody: ExportRange = { title: '', from: 0, to: 0, end: 0, groups: [] };

export interface ExportDialogActions {
  begin(choice: ExportChoice): void;
  cancel(): void;
  /** What is said about the size of a choice; null where another was made meanwhile. */
  size(choice: ExportChoice): Promise<string | null>;
}

/** What the fields hold; numbers as they are typed. */
interface Fields extends Omit<ExportChoice, 'kind' | 'fps' | 'size' | 'people' | 'from' | 'to'> {
  readonly kind: string;
  readonly fps: string;
  readonly size: string;
  readonly first: string;
  readonly last: string;
  readonly from: string;
  readonly to: string;
}

type Change = (change: Partial<Fields>) => void;

function Row({ label, children }: { readonly label: string; readonly children: ComponentChildren }): VNode {
  return (
    <label class="export-row">
      {label}
      {children}
    </label>
  );
}

function Select(props: {
  readonly label: string;
  readonly options: readonly string[];
  readonly value: string;
  readonly act: (value: string) => void;
}): VNode {
  return (
    <select aria-label={props.label} value={props.value} onChange={(event) => props.act(event.currentTarget.value)}>
      {props.options.map((one) => (
        <option key={one} value={one}>
          {one}
        </option>
      ))}
    </select>
  );
}

function Check({
  label,
  on,
  act,
}: {
  readonly label: string;
  readonly on: boolean;
  readonly act: (on: boolean) => void;
}): VNode {
  return (
    <Row label={label}>
      <input type="checkbox" checked={on} onChange={(event) => act(event.currentTarget.checked)} />
    </Row>
  );
}

/** Two numbers with a word before each. */
function Span(props: {
  readonly label: string;
  readonly values: readonly [string, string];
  readonly hint: string;
  readonly step: number;
  readonly act: (first: string, last: string) => void;
}): VNode {
  const input = (which: 0 | 1, name: string): VNode => (
    <input
      type="number"
      min={0}
      step={props.step}
      value={props.values[which]}
      placeholder={props.hint}
      aria-label={`${props.label} ${name}`}
      onInput={({ currentTarget: { value } }) =>
        which === 0 ? props.act(value, props.values[1]) : props.act(props.values[0], value)
      }
    />
  );
  return (
    <div class="export-row export-span">
      {props.label}
      {input(0, 'from')}
      <span class="secondary">to</span>
      {input(1, 'to')}
    </div>
  );
}

function Kinds({
  offered,
  kind,
  busy,
  choose,
}: {
  readonly offered: (kind: ExportKind) => boolean;
  readonly kind: string;
  readonly busy: boolean;
  readonly choose: (name: string) => void;
}): VNode {
  return (
    <fieldset class="export-kinds" disabled={busy}>
      <legend class="unseen">Kind</legend>
      {Object.entries(kExportKinds).map(([purpose, kinds]) => (
        <div key={purpose} role="group" aria-label={purpose}>
          <h3>{purpose}</h3>
          {kinds.filter(offered).map(({ name, label, about }) => (
            <label key={name} class="export-kind">
              <input
                type="radio"
                name="export-kind"
                value={name}
                checked={name === kind}
                onChange={() => choose(name)}
              />
              <span class="export-words">
                <strong>{label}</strong>
                <span class="secondary">{about}</span>
              </span>
            </label>
          ))}
        </div>
      ))}
    </fieldset>
  );
}

export class ExportDialog {
  readonly root = element('div', { class: 'dialogs' });
  private open_ = false;
  private range_ = kNobody;
  private fields_: Fields;
  private running_ = false;
  private share_ = 0;
  private said_ = '';
  private size_ = '';
  private asking_ = 0;

  constructor(
    private readonly offered_: (kind: ExportKind) => boolean,
    private readonly actions_: ExportDialogActions,
  ) {
    const kind = Object.values(kExportKinds).flat().find(offered_)!.name;
    const look = { fps: '30', size: '1280 × 720', clean: true, sky: true, shadows: true };
    this.fields_ = { kind, ...look, from: '', to: '', groups: [], first: '', last: '' };
    this.root.addEventListener('keydown', (event) => event.stopPropagation());
  }

  get chosen(): ExportChoice {
    const { fps, size, first, last, from, to, kind: name, ...rest } = this.fields_;
    const kind = Object.values(kExportKinds)
      .flat()
      .find((one) => one.name === name)!;
    const everybody = first === '' && last === '';
    return {
      ...rest,
      kind,
      fps: kind.fps ?? Number(fps),
      size: kFilmSizes[size] ?? [1280, 720],
      from: this.range_.from + Number(from),
      to: to === '' ? this.range_.end : this.range_.from + Number(to),
      people: everybody ? null : [Number(first), last === '' ? 0xffffffff : Number(last)],
    };
  }

  open(range: ExportRange): void {
    this.range_ = range;
    const [from, to] = ['0', String(Number((range.to - range.from).toFixed(1)))];
    this.fields_ = { ...this.fields_, from, to, groups: [], first: '', last: '' };
    this.said_ = '';
    this.open_ = true;
    this.running_ = false;
    this.change({});
    this.root.querySelector<HTMLInputElement>('input:checked')?.focus();
  }

  setProgress(share: number): void {
    this.share_ = share;
    this.say(`${Math.floor(100 * share)} %`);
  }

  setRunning(running: boolean): void {
    this.running_ = running;
    if (running) this.setProgress(0);
    this.draw();
    if (this.open_) this.keepFocus(running);
  }

  /** What had the focus has gone: without any, Escape would not close the dialog. */
  private keepFocus(running: boolean): void {
    const { activeElement } = document;
    const stays = this.root.contains(activeElement) && !activeElement?.closest('[hidden]');
    if (!stays || running) this.root.querySelector<HTMLElement>(running ? '.export-stop' : '.export-begin')?.focus();
  }

  /** What became of it. */
  say(text: string): void {
    this.said_ = text;
    this.draw();
  }

  private readonly change: Change = (change) => {
    this.fields_ = { ...this.fields_, ...change };
    [this.said_, this.size_] = ['', ''];
    this.draw();
    clearTimeout(this.asking_);
    this.asking_ = window.setTimeout(() => void this.askSize(), kThink);
  };

  private async askSize(): Promise<void> {
    const { fields_: asked } = this;
    const size = await this.actions_.size(this.chosen);
    // What is said of an older choice is no longer true.
    if (size === null || asked !== this.fields_) return;
    this.size_ = size;
    this.draw();
  }

  private readonly close = (): void => {
    this.open_ = false;
    clearTimeout(this.asking_);
    this.actions_.cancel();
    this.draw();
  };

  private draw(): void {
    render(this.open_ && this.content(), this.root);
  }

  private content(): VNode {
    const { running_: running, fields_: fields, change } = this;
    const title = `Export “${this.range_.title}”`;
    return (
      <Modal title={title} class="help export-dialog" closes="Close the export" close={this.close}>
        <Kinds offered={this.offered_} kind={fields.kind} busy={running} choose={(kind) => change({ kind })} />
        <fieldset class="export-rows" disabled={running}>
          <legend class="unseen">Part and look</legend>
          {this.part()}
          {this.look()}
        </fieldset>
        <p class="export-size secondary" hidden={this.size_ === '' || running}>
          {this.size_}
        </p>
        <p class="export-said" role="status">
          {this.said_}
        </p>
        <div class="export-running" hidden={!running}>
          <progress max={1} value={this.share_} aria-label="Progress of the export" />
          <Button class="soft export-stop" act={() => this.actions_.cancel()}>
            Cancel
          </Button>
        </div>
        <Button
          icon="download"
          class="solid export-begin"
          hidden={running}
          act={() => this.actions_.begin(this.chosen)}
        >
          Export
        </Button>
      </Modal>
    );
  }

  /** Who, and from when to when. */
  private part(): VNode {
    const { fields_: fields, change, range_: range } = this;
    const { kind } = this.chosen;
    const whole = kind.name === 'picture';
    return (
      <>
        {!kind.here && range.groups.length > 1 && this.groups()}
        {!kind.here && (
          <Span
            label="Persons"
            hint="all"
            step={1}
            values={[fields.first, fields.last]}
            act={(first, last) => change({ first, last })}
          />
        )}
        {!whole && (
          <Span
            label="Seconds"
            hint=""
            step={0.1}
            values={[fields.from, fields.to]}
            act={(from, to) => change({ from, to })}
          />
        )}
      </>
    );
  }

  private groups(): VNode {
    const { groups } = this.fields_;
    const all = this.range_.groups;
    const toggle = (id: number, on: boolean): void =>
      this.change({ groups: on ? [...groups, id] : groups.filter((one) => one !== id) });
    return (
      <div class="export-groups" role="group" aria-label="Groups">
        <span>Groups</span>
        <span class="secondary">{groups.length === 0 ? 'all' : `${groups.length} of ${all.length}`}</span>
        <div>
          {all.map(({ id, name }) => (
            <label key={id}>
              <input
                type="checkbox"
                value={id}
                checked={groups.includes(id)}
                onChange={(event) => toggle(id, event.currentTarget.checked)}
              />
              {name}
            </label>
          ))}
        </div>
      </div>
    );
  }

  private look(): VNode {
    const { fields_: fields, change } = this;
    const { kind } = this.chosen;
    return (
      <>
        {(kind.series || kind.frames) && (
          <Row label="Frames a second">
            <Select label="Frames a second" options={kRates} value={fields.fps} act={(fps) => change({ fps })} />
          </Row>
        )}
        {kind.series && (
          <Row label="Size">
            <Select
              label="Size"
              options={Object.keys(kFilmSizes)}
              value={fields.size}
              act={(size) => change({ size })}
            />
          </Row>
        )}
        {kind.here && kind.name !== 'pictures' && (
          <>
            <Check label="Without marks" on={fields.clean} act={(clean) => change({ clean })} />
            <Check label="Sky and horizon" on={fields.sky} act={(sky) => change({ sky })} />
          </>
        )}
        {kind.name === 'pictures' && (
          <Check label="With shadows" on={fields.shadows} act={(shadows) => change({ shadows })} />
        )}
      </>
    );
  }
}
