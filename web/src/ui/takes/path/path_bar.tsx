// What is said and chosen while somebody changes paths of a take.

import { render, type VNode } from 'preact';
import { kLeastReach, kMostReach } from '../../../model/take_path';
import { ToolButton } from '../../widgets/buttons';
import { element } from '../../widgets/dom';
import type { PeopleEditor } from './people_editor';
import { PeopleTools, type PeopleState } from './people_panel';

export interface PathActions {
  setReach(seconds: number): void;
  /** Paths of single people instead of groups. */
  setSingle(single: boolean): void;
  /** Opens the take before the last change. */
  goBack(): void;
  leavePaths(): void;
}

const kSteps: readonly number[] = [0.5, 1, 1.5, 2, 3, 4, 6, 8, 12, 20, 30, 60];

/** The next reach that the buttons offer. */
export function nextReach(seconds: number, longer: boolean): number {
  const next = longer
    ? kSteps.find((one) => one > seconds + 1e-9)
    : [...kSteps].reverse().find((one) => one < seconds - 1e-9);
  return next ?? (longer ? kMostReach : kLeastReach);
}

export class PathBar {
  readonly root = element('section', { class: 'path-bar panel', 'aria-label': 'Paths of the take', hidden: true });
  private words_ = '';
  private reach_ = kLeastReach;
  private single_ = false;
  private back_ = false;
  private people_: { readonly state: PeopleState; readonly editor: PeopleEditor } | null = null;

  constructor(private readonly actions_: PathActions) {
    this.draw();
  }

  say(text: string): void {
    this.words_ = text;
    this.draw();
  }

  get words(): string {
    return this.words_;
  }

  setReach(seconds: number): void {
    this.reach_ = seconds;
    this.draw();
  }

  setSingle(single: boolean): void {
    this.single_ = single;
    this.draw();
  }

  setPeople(state: PeopleState, editor: PeopleEditor): void {
    this.people_ = { state, editor };
    if (this.single_) this.draw();
  }

  setBack(offered: boolean): void {
    this.back_ = offered;
    this.draw();
  }

  private draw(): void {
    const { actions_: actions } = this;
    render(
      <>
        <div class="path-whose" role="group" aria-label="Whose path">
          <ToolButton label="Group" pressed={!this.single_} act={() => actions.setSingle(false)} />
          <ToolButton label="Person" pressed={this.single_} act={() => actions.setSingle(true)} />
        </div>
        {this.single_ ? this.people_ && <PeopleTools {...this.people_} /> : this.reach()}
        <ToolButton
          icon="undo"
          label="Take before"
          class="path-back"
          hidden={!this.back_ || this.single_}
          tip="Opens the take as it was before the last change"
          act={() => actions.goBack()}
        />
        <ToolButton
          icon="close"
          label="Leave the paths"
          iconOnly
          class="path-close"
          shortcut="Esc"
          act={() => actions.leavePaths()}
        />
        <p class="path-words" role="status">
          {this.words_}
        </p>
      </>,
      this.root,
    );
  }

  private reach(): VNode {
    const { actions_: actions, reach_: reach } = this;
    const set = (wished: number): void => {
      const within = Math.min(kMostReach, Math.max(kLeastReach, wished));
      actions.setReach(Number.isFinite(wished) ? within : kLeastReach);
    };
    const step = (longer: boolean): VNode => (
      <ToolButton
        label={longer ? 'Farther' : 'Less far'}
        word={longer ? '+' : '−'}
        class="path-step"
        tip={longer ? 'The bend reaches farther' : 'The bend reaches less far'}
        act={() => actions.setReach(nextReach(reach, longer))}
      />
    );
    return (
      <div class="path-reach" role="group" aria-label="How much of the path bends">
        <span class="path-label">Bends</span>
        {step(false)}
        <input
          type="number"
          min={kLeastReach}
          max={kMostReach}
          step={0.5}
          aria-label="Seconds before and after that the bend reaches"
          value={reach}
          onChange={({ currentTarget }) => set(currentTarget.valueAsNumber)}
        />
        <span>s</span>
        {step(true)}
      </div>
    );
  }
}
