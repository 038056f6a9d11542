// The panel of whoever builds: tools, what new things are like, what is chosen, layers, and the way back.

import { render, type VNode } from 'preact';
import { kBuildTools, type BuildTool, type DrawingOptions } from '../../model/place/drawing';
import { kClimbed, kJumped } from '../../model/place/motions';
import { kThingKinds, type Thing, type ThingKind } from '../../model/place/things';
import type { HistoryFacts } from '../../model/studio_state';
import { BuildIcon } from '../widgets/build_icons';
import { Icon } from '../widgets/buttons';
import { element } from '../widgets/dom';
import { NumberField, type NumberRange, selectField } from '../widgets/fields';
import { GateTimeFields, JoinField } from './area_fields';
import { kShapes, type BuildActions } from './build_actions';
import { kToolKeys } from './build_keys';
import { ChosenFields } from './chosen_fields';

/** What it is called, and how it is made. */
const kTools: Readonly<Record<BuildTool, readonly [label: string, hint: string]>> = {
  select: ['Select', 'Tap a thing, or drag a box round several.'],
  wall: ['Wall', `Drag along the wall. People climb over one of up to ${kClimbed.most} m.`],
  door: ['Door', 'Tap a wall where the door shall be.'],
  gate: ['Gate', 'Drag along the gate: it slides open and shut, at times or when you say so.'],
  hedge: ['Hedge', `Drag along the hedge. People jump over one of up to ${kJumped.most} m, else they go round.`],
  water: ['Water', 'Drag from corner to corner: people swim there.'],
  net: ['Net', 'Drag from corner to corner: people crawl under it.'],
  branches: ['Branches', 'Drag from corner to corner: people duck there.'],
  stairs: ['Stairs', 'Drag from the foot to the top.'],
  car: ['Car', 'Draw its way: it drives there and back, or round.'],
  box: ['Box', 'Drag from corner to corner.'],
  disc: ['Pillar', 'Drag from the middle.'],
  polygon: ['Polygon', 'Tap corners; tap the first again to end.'],
  route: ['Route', 'Draw from a thing: it moves there and back. From an exit: people queue along the line.'],
  exit: ['Exit', 'Drag from corner to corner: who is told to leave leaves there.'],
  source: ['Source', 'Drag from corner to corner: people come there.'],
  waiting: ['Waiting', 'Drag from corner to corner: who is told to wait stands there.'],
  people: ['People', 'Drag from where they stand to where they face.'],
  item: ['Item', 'Tap where it shall lie.'],
  checkpoint: ['Checkpoint', 'Drag from the middle: who passes changes the formation.'],
};

const kRate = { min: 0, max: 1000, unit: '1/s' };
const kHigh = { min: 0.1, max: 100, unit: 'm' };
const kWide = { min: 0.05, max: 20, unit: 'm' };
const kFactor = { min: 0.01, max: 100, unit: '×' };

/** Numbers of new things, by tool. */
type NumberKey = {
  [Key in keyof DrawingOptions]: DrawingOptions[Key] extends number ? Key : never;
}[keyof DrawingOptions];
type OptionFields = readonly (readonly [NumberKey, string, NumberRange])[];
const kHeightField: OptionFields = [['height', 'Height', kHigh]];
const kSpeedField: OptionFields = [['speed', 'Speed', { min: 0.1, max: 20, unit: 'm/s' }]];
const kOptionFields: Partial<Record<BuildTool, OptionFields>> = {
  wall: [['width', 'Width', kWide], ...kHeightField],
  door: [['doorWidth', 'Width', { ...kWide, min: 0.3 }]],
  hedge: [['hedgeHeight', 'Height', kHigh]],
  box: kHeightField,
  disc: kHeightField,
  polygon: kHeightField,
  car: kSpeedField,
  route: kSpeedField,
  stairs: [
    ['stairsWidth', 'Width', { min: 0.3, max: 100, unit: 'm' }],
    ['speedUp', 'Speed up', kFactor],
    ['speedDown', 'Speed down', kFactor],
  ],
  exit: [['exitRate', 'At most, 0: all', kRate]],
  source: [['sourceRate', 'People', kRate]],
  people: [
    ['count', 'People', { min: 1, max: 5000, whole: true }],
    ['spacing', 'Spacing', { min: 0.3, max: 20, unit: 'm' }],
  ],
};

const kLayers: Record<ThingKind, string> = {
  obstacle: 'Obstacles',
  patch: 'Ground',
  area: 'Exits and sources',
  item: 'Items',
  checkpoint: 'Checkpoints',
  group: 'People',
};

/** Numbers follow what is dragged so often [ms]. */
const kNumbersFollow = 150;

/** What the next thing will be like. */
function Options({ tool, actions }: { readonly tool: BuildTool; readonly actions: BuildActions }): VNode {
  const { options } = actions;
  return (
    <div class="build-fields" key={tool}>
      {kOptionFields[tool]?.map(([key, label, range]) => (
        <NumberField
          key={key}
          label={label}
          value={options[key]}
          range={range}
          act={(value) => actions.setOptions({ [key]: value })}
        />
      ))}
      {(tool === 'checkpoint' || tool === 'people') &&
        selectField('Formation', kShapes, options.formation, (formation) => actions.setOptions({ formation }))}
      {tool === 'source' && (
        <JoinField
          group={options.sourceGroup}
          first="A new group"
          actions={actions}
          act={(sourceGroup) => actions.setOptions({ sourceGroup })}
        />
      )}
      {tool === 'gate' && <GateTimeFields times={options} actions={actions} act={(to) => actions.setOptions(to)} />}
    </div>
  );
}

function Layers({ actions }: { readonly actions: BuildActions }): VNode {
  const box = (kind: ThingKind, what: 'hidden' | 'locked', label: string): VNode => (
    <label>
      <input
        type="checkbox"
        aria-label={`${label} ${kLayers[kind].toLowerCase()}`}
        onChange={({ currentTarget }) => actions.toggleLayer(kind, what, currentTarget.checked)}
      />
      {label}
    </label>
  );
  return (
    <details class="build-layers">
      <summary>Layers and grid</summary>
      <label class="build-snap">
        <input
          type="checkbox"
          defaultChecked
          onChange={({ currentTarget }) => actions.setSnaps(currentTarget.checked)}
        />
        Snap to grid and corners
      </label>
      <ul>
        {kThingKinds.map((kind) => (
          <li key={kind}>
            <span>{kLayers[kind]}</span>
            {box(kind, 'hidden', 'Hide')}
            {box(kind, 'locked', 'Lock')}
          </li>
        ))}
      </ul>
    </details>
  );
}

interface ActProps {
  readonly label: string;
  readonly disabled?: boolean;
  readonly act: () => void;
  readonly children: VNode;
}

function Act({ label, disabled = false, act, children }: ActProps): VNode {
  return (
    <button type="button" aria-label={label} data-tip={label} disabled={disabled} onClick={act}>
      {children}
    </button>
  );
}

interface Shown {
  readonly tool: BuildTool;
  readonly hint: string;
  readonly chosen: readonly Thing[];
  readonly history: HistoryFacts;
  readonly playing: boolean;
}

export class BuildPanel {
  readonly root = element('section', { class: 'build-panel panel', 'aria-label': 'Build' });
  private soon_ = 0;
  private shown_: Shown = {
    tool: 'select',
    hint: kTools.select[1],
    chosen: [],
    history: { undo: 0, undoLabel: '', redo: 0, redoLabel: '' },
    playing: false,
  };

  constructor(private readonly actions_: BuildActions) {
    this.show({});
  }

  /** What the panel shows now. */
  show(change: Partial<Shown>): void {
    window.clearTimeout(this.soon_);
    this.soon_ = 0;
    this.shown_ = { ...this.shown_, ...change };
    this.root.toggleAttribute('data-chosen', this.shown_.chosen.length > 0);
    render(this.content(), this.root);
  }

  /** Where it is being dragged the numbers follow a few times a second. */
  showChosen(chosen: readonly Thing[], soon: boolean): void {
    this.shown_ = { ...this.shown_, chosen };
    if (soon) this.soon_ ||= window.setTimeout(() => this.show({}), kNumbersFollow);
    else this.show({});
  }

  setTool(tool: BuildTool): void {
    this.show({ tool, hint: kTools[tool][1] });
  }

  say(hint: string): void {
    this.show({ hint });
  }

  focus(): void {
    this.root.querySelector<HTMLElement>('.build-tool')?.focus();
  }

  /** To numbers and words of what is chosen. */
  toFields(): void {
    this.root.querySelector<HTMLElement>('.build-chosen-fields input')?.focus();
  }

  /** Ends typing, as Enter does. */
  leaveField(): void {
    const { activeElement: field } = document;
    if (field instanceof HTMLElement && this.root.contains(field)) field.blur();
  }

  /** Ends building whatever is being drawn. */
  private end(): void {
    this.actions_.setTool('select');
    for (let k = 0; k < 3; ++k) this.actions_.leave();
  }

  private content(): VNode {
    const { actions_: actions } = this;
    const { tool, hint, chosen } = this.shown_;
    return (
      <>
        {this.header()}
        <div class="build-tools" role="toolbar" aria-label="What to build">
          {kBuildTools.map((one) => (
            <button
              key={one}
              type="button"
              class="build-tool"
              aria-pressed={one === tool}
              aria-keyshortcuts={kToolKeys[one].toUpperCase()}
              data-tip={kTools[one][1]}
              data-key={kToolKeys[one].toUpperCase()}
              onClick={({ detail }) => {
                actions.setTool(one);
                if (detail === 0) actions.toGround(); // By a key.
              }}
            >
              <BuildIcon name={one} />
              <span>{kTools[one][0]}</span>
            </button>
          ))}
        </div>
        <p class="secondary build-hint" role="status">
          {hint}
        </p>
        {chosen.length === 0 && <Options tool={tool} actions={actions} />}
        <ChosenFields chosen={chosen} actions={actions} />
        <Layers actions={actions} />
      </>
    );
  }

  private header(): VNode {
    const { actions_: actions } = this;
    const { chosen, history, playing } = this.shown_;
    const step = (word: string, count: number, label: string): string =>
      count > 0 ? `${word} ${label.charAt(0).toLowerCase()}${label.slice(1)}` : word;
    const { undo, undoLabel, redo, redoLabel } = history;
    return (
      <header>
        <h2>Build</h2>
        <div class="build-acts" role="group" aria-label="Edit">
          <Act label={playing ? 'Pause' : 'Play'} act={() => actions.togglePlay()}>
            <Icon name={playing ? 'pause' : 'play'} />
          </Act>
          <Act label={step('Undo', undo, undoLabel)} disabled={undo === 0} act={() => actions.undo()}>
            <BuildIcon name="undo" />
          </Act>
          <Act label={step('Redo', redo, redoLabel)} disabled={redo === 0} act={() => actions.undo(true)}>
            <BuildIcon name="redo" />
          </Act>
          <Act label="Duplicate" disabled={chosen.length === 0} act={() => actions.duplicate()}>
            <BuildIcon name="copy" />
          </Act>
          <Act label="Remove" disabled={chosen.length === 0} act={() => actions.remove()}>
            <BuildIcon name="remove" />
          </Act>
        </div>
        <button type="button" class="build-done" aria-label="End building" onClick={() => this.end()}>
          <Icon name="close" />
        </button>
      </header>
    );
  }
}
