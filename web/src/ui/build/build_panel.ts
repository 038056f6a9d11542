// The panel of whoever builds: tools, what new things are like, what is chosen, layers, and the way back.

import { kBuildTools, type BuildTool, type DrawingOptions } from '../../model/place/drawing';
import { groupChoices } from '../../model/place/areas';
import { kThingKinds, type Thing, type ThingKind } from '../../model/place/things';
import type { HistoryFacts } from '../../model/studio_state';
import type { SceneFacts } from '../../protocol/scene';
import { element, setPressed, setText } from '../widgets/dom';
import { icon } from '../widgets/icons';
import { kShapes, type BuildActions } from './build_actions';
import { ChosenFields } from './chosen_fields';
import { buildIcon } from '../widgets/build_icons';
import { kToolKeys } from './build_keys';
import { numberField, selectField } from '../widgets/fields';

const kLabels: Record<BuildTool, string> = {
  select: 'Select',
  box: 'Box',
  disc: 'Disc',
  polygon: 'Polygon',
  wall: 'Wall',
  patch: 'Patch',
  stairs: 'Stairs',
  route: 'Route',
  exit: 'Exit',
  source: 'Source',
  waiting: 'Waiting',
  item: 'Item',
  checkpoint: 'Checkpoint',
  people: 'People',
};

const kHints: Record<BuildTool, string> = {
  select: 'Tap a thing, or drag a box round several.',
  box: 'Drag from corner to corner.',
  disc: 'Drag from the middle.',
  polygon: 'Tap corners; tap the first again to end.',
  wall: 'Drag along the wall.',
  patch: 'Drag from corner to corner.',
  stairs: 'Drag from the foot to the top.',
  route: 'Draw from an obstacle: it moves there and back. From an exit: people queue along the line.',
  exit: 'Drag from corner to corner: who is told to leave leaves there.',
  source: 'Drag from corner to corner: people come there.',
  waiting: 'Drag from corner to corner: who is told to wait stands there.',
  item: 'Tap where it shall lie.',
  checkpoint: 'Drag from the middle: who passes changes the formation.',
  people: 'Drag from where they stand to where they face.',
};

type SetOptions = (change: Partial<DrawingOptions>) => void;
type OptionMakers = Partial<Record<BuildTool, () => HTMLElement[]>>;

const kRate = { min: 0, max: 1000, unit: '1/s' };
const kNewGroup = 'A new group';

const kLayers: Record<ThingKind, string> = {
  obstacle: 'Obstacles',
  patch: 'Patches',
  area: 'Exits and sources',
  item: 'Items',
  checkpoint: 'Checkpoints',
  group: 'People',
};

export class BuildPanel {
  readonly root = element('section', { class: 'build-panel panel', 'aria-label': 'Build' });
  private readonly tools_ = new Map<BuildTool, HTMLButtonElement>();
  private readonly hint_ = element('p', { class: 'secondary build-hint', role: 'status' });
  private readonly options_ = element('div', { class: 'build-fields' });
  private readonly fields_: ChosenFields;
  private readonly play_ = element('button', { type: 'button', 'aria-label': 'Play', 'data-tip': 'Play' });
  private readonly undo_ = this.act('undo', 'Undo', () => this.actions_.undo());
  private readonly redo_ = this.act('redo', 'Redo', () => this.actions_.undo(true));
  private readonly remove_ = this.act('remove', 'Remove', () => this.actions_.remove());
  private readonly copy_ = this.act('copy', 'Duplicate', () => this.actions_.duplicate());

  constructor(private readonly actions_: BuildActions) {
    this.fields_ = new ChosenFields(actions_);
    const palette = element('div', { class: 'build-tools', role: 'toolbar', 'aria-label': 'What to build' });
    for (const tool of kBuildTools) palette.append(this.toolButton(tool));
    const done = element(
      'button',
      { type: 'button', class: 'build-done', 'aria-label': 'End building' },
      icon('close'),
    );
    done.addEventListener('click', () => this.end());
    this.play_.append(icon('play'));
    this.play_.addEventListener('click', () => this.actions_.togglePlay());
    const acts = element(
      'div',
      { class: 'build-acts', role: 'group', 'aria-label': 'Edit' },
      this.play_,
      this.undo_,
      this.redo_,
      this.copy_,
      this.remove_,
    );
    this.root.append(
      element('header', {}, element('h2', {}, 'Build'), acts, done),
      palette,
      this.hint_,
      this.options_,
      this.fields_.root,
      this.layers(),
    );
    this.setHistory({ undo: 0, undoLabel: '', redo: 0, redoLabel: '' });
    this.setChosen([], null);
  }

  focus(): void {
    this.tools_.get('select')?.focus();
  }

  setPlaying(playing: boolean): void {
    this.play_.replaceChildren(icon(playing ? 'pause' : 'play'));
    const label = playing ? 'Pause' : 'Play';
    this.play_.setAttribute('aria-label', label);
    this.play_.setAttribute('data-tip', label);
  }

  say(text: string): void {
    setText(this.hint_, text);
  }

  /** Ends building whatever is being drawn. */
  private end(): void {
    this.actions_.setTool('select');
    for (let k = 0; k < 3; ++k) this.actions_.leave();
  }

  private act(name: 'undo' | 'redo' | 'remove' | 'copy', label: string, act: () => void): HTMLButtonElement {
    const button = element('button', { type: 'button', 'aria-label': label, 'data-tip': label }, buildIcon(name));
    button.addEventListener('click', act);
    return button;
  }

  private toolButton(tool: BuildTool): HTMLButtonElement {
    const button = element(
      'button',
      {
        type: 'button',
        class: 'build-tool',
        'aria-pressed': 'false',
        'aria-keyshortcuts': kToolKeys[tool].toUpperCase(),
        'data-tip': kHints[tool],
        'data-key': kToolKeys[tool].toUpperCase(),
      },
      buildIcon(tool),
      element('span', {}, kLabels[tool]),
    );
    button.addEventListener('click', () => this.actions_.setTool(tool));
    this.tools_.set(tool, button);
    return button;
  }

  private layers(): HTMLElement {
    const snaps = element('input', { type: 'checkbox', checked: true });
    snaps.addEventListener('change', () => this.actions_.setSnaps(snaps.checked));
    const rows = kThingKinds.map((kind) => {
      const box = (what: 'hidden' | 'locked', label: string): HTMLElement => {
        const input = element('input', { type: 'checkbox', 'aria-label': `${label} ${kLayers[kind].toLowerCase()}` });
        input.addEventListener('change', () => this.actions_.toggleLayer(kind, what, input.checked));
        return element('label', {}, input, label);
      };
      return element('li', {}, element('span', {}, kLayers[kind]), box('hidden', 'Hide'), box('locked', 'Lock'));
    });
    return element(
      'details',
      { class: 'build-layers' },
      element('summary', {}, 'Layers and grid'),
      element('label', { class: 'build-snap' }, snaps, 'Snap to grid and corners'),
      element('ul', {}, ...rows),
    );
  }

  setTool(tool: BuildTool, scene: SceneFacts | null): void {
    for (const [name, button] of this.tools_) setPressed(button, name === tool);
    setText(this.hint_, kHints[tool]);
    this.options_.replaceChildren(...this.optionsOf(tool, scene));
  }

  private optionsOf(tool: BuildTool, scene: SceneFacts | null): HTMLElement[] {
    const { actions_: actions } = this;
    const set = (change: Partial<DrawingOptions>): void => {
      actions.options = { ...actions.options, ...change };
    };
    const makers = {
      ...this.plainOptions(actions.options, scene, set),
      ...this.areaOptions(actions.options, scene, set),
    };
    return makers[tool]?.() ?? [];
  }

  private plainOptions(options: DrawingOptions, scene: SceneFacts | null, set: SetOptions): OptionMakers {
    const height = (): HTMLElement =>
      numberField('Height', options.height, { min: 0.1, max: 100, unit: 'm' }, (value) => set({ height: value }));
    const shape = (): HTMLElement =>
      selectField('Formation', kShapes, options.formation, (value) => set({ formation: value }));
    const width = (): HTMLElement =>
      numberField('Width', options.width, { min: 0.05, max: 20, unit: 'm' }, (value) => set({ width: value }));
    const clips = scene?.clips.map(({ name }) => name) ?? [];
    return {
      box: () => [height()],
      disc: () => [height()],
      polygon: () => [height()],
      wall: () => [width(), height()],
      patch: () => [
        selectField('Motion', clips, clips[options.motion] ?? '', (value) => set({ motion: clips.indexOf(value) })),
      ],
      route: () => [
        numberField('Speed', options.speed, { min: 0.1, max: 20, unit: 'm/s' }, (value) => set({ speed: value })),
      ],
      checkpoint: () => [shape()],
      people: () => [
        numberField('People', options.count, { min: 1, max: 5000, whole: true }, (value) => set({ count: value })),
        numberField('Spacing', options.spacing, { min: 0.3, max: 20, unit: 'm' }, (value) => set({ spacing: value })),
        shape(),
      ],
    };
  }

  private areaOptions(options: DrawingOptions, scene: SceneFacts | null, set: SetOptions): OptionMakers {
    const speed = (label: string, key: 'speedUp' | 'speedDown'): HTMLElement =>
      numberField(label, options[key], { min: 0.01, max: 100, unit: '×' }, (value) => set({ [key]: value }));
    return {
      stairs: () => [
        numberField('Width', options.stairsWidth, { min: 0.3, max: 100, unit: 'm' }, (value) =>
          set({ stairsWidth: value }),
        ),
        speed('Speed up', 'speedUp'),
        speed('Speed down', 'speedDown'),
      ],
      exit: () => [numberField('At most, 0: all', options.exitRate, kRate, (value) => set({ exitRate: value }))],
      source: () => [
        numberField('People', options.sourceRate, kRate, (value) => set({ sourceRate: value })),
        this.joins(scene, options.sourceGroup, (group) => set({ sourceGroup: group })),
      ],
    };
  }

  /** Whom the people of a new source join. */
  private joins(scene: SceneFacts | null, group: number, changed: (group: number) => void): HTMLElement {
    const choices = [{ id: 0, word: kNewGroup }, ...groupChoices(scene)];
    const words = choices.map(({ word }) => word);
    const shown = choices.find(({ id }) => id === group)?.word ?? kNewGroup;
    return selectField('Join', words, shown, (word) => changed(choices.find((one) => one.word === word)?.id ?? 0));
  }

  setChosen(chosen: readonly Thing[], scene: SceneFacts | null): void {
    for (const button of [this.remove_, this.copy_]) button.disabled = chosen.length === 0;
    this.fields_.show(chosen, scene);
  }

  setHistory({ undo, undoLabel, redo, redoLabel }: HistoryFacts): void {
    const show = (button: HTMLButtonElement, word: string, count: number, label: string): void => {
      button.disabled = count === 0;
      const text = count > 0 ? `${word} ${label.charAt(0).toLowerCase()}${label.slice(1)}` : word;
      button.setAttribute('aria-label', text);
      button.setAttribute('data-tip', text);
    };
    show(this.undo_, 'Undo', undo, undoLabel);
    show(this.redo_, 'Redo', redo, redoLabel);
  }
}
