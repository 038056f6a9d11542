// What is said and chosen while somebody changes paths of a take.

import { kLeastReach, kMostReach } from '../../model/take_path';
import { element, setPressed, setText } from '../widgets/dom';
import { toolButton } from '../widgets/tool_button';

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
  private readonly words_ = element('p', { class: 'path-words', role: 'status' });
  private readonly reach_ = element('input', {
    type: 'number',
    min: kLeastReach,
    max: kMostReach,
    step: 0.5,
    'aria-label': 'Seconds before and after that the bend reaches',
  });
  private readonly group_: HTMLButtonElement;
  private readonly person_: HTMLButtonElement;
  private readonly back_: HTMLButtonElement;
  readonly root: HTMLElement;

  constructor(actions: PathActions) {
    this.group_ = toolButton({ label: 'Group', pressed: true, act: () => actions.setSingle(false) });
    this.person_ = toolButton({ label: 'Person', pressed: false, act: () => actions.setSingle(true) });
    this.back_ = toolButton({
      icon: 'undo',
      label: 'Take before',
      className: 'path-back',
      tip: 'Opens the take as it was before the last change',
      act: () => actions.goBack(),
    });
    const close = toolButton({
      icon: 'close',
      label: 'Leave the paths',
      iconOnly: true,
      className: 'path-close',
      key: 'Esc',
      act: () => actions.leavePaths(),
    });
    const step = (longer: boolean): HTMLButtonElement =>
      toolButton({
        label: longer ? '+' : '−',
        className: 'path-step',
        tip: longer ? 'The bend reaches farther' : 'The bend reaches less far',
        act: () => actions.setReach(nextReach(this.reach_.valueAsNumber, longer)),
      });
    this.reach_.addEventListener('change', () => {
      const wished = this.reach_.valueAsNumber;
      actions.setReach(Number.isFinite(wished) ? Math.min(kMostReach, Math.max(kLeastReach, wished)) : kLeastReach);
    });
    const [less, more] = [step(false), step(true)];
    less.setAttribute('aria-label', 'Less far');
    more.setAttribute('aria-label', 'Farther');
    this.root = element(
      'section',
      { class: 'path-bar panel', 'aria-label': 'Paths of the take', hidden: true },
      element('div', { class: 'path-whose', role: 'group', 'aria-label': 'Whose path' }, this.group_, this.person_),
      element(
        'div',
        { class: 'path-reach', role: 'group', 'aria-label': 'Reach' },
        element('span', { class: 'path-label' }, 'Reach'),
        less,
        this.reach_,
        element('span', {}, 's'),
        more,
      ),
      this.back_,
      close,
      this.words_,
    );
  }

  say(text: string): void {
    setText(this.words_, text);
  }

  get words(): string {
    return this.words_.textContent;
  }

  setReach(seconds: number): void {
    this.reach_.value = String(seconds);
  }

  setSingle(single: boolean): void {
    setPressed(this.group_, !single);
    setPressed(this.person_, single);
  }

  setBack(offered: boolean): void {
    this.back_.hidden = !offered;
  }
}
