// Keys while somebody builds. They come before those of the studio.

import { kBuildTools, type BuildTool } from '../../model/place/drawing';
import type { ArrowKey } from '../../tools/keyboard_steering';
import type { BuildActions } from './build_actions';

/** One letter for each tool. */
export const kToolKeys: Record<BuildTool, string> = {
  select: 'v',
  box: 'r',
  disc: 'o',
  polygon: 'p',
  wall: 'w',
  door: 'd',
  gate: 'j',
  hedge: 'h',
  water: 'u',
  net: 'n',
  branches: 'b',
  stairs: 't',
  car: 'c',
  route: 'm',
  exit: 'x',
  source: 's',
  waiting: 'a',
  item: 'i',
  checkpoint: 'k',
  people: 'g',
};

const kArrows: readonly string[] = ['ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown'];
/** What is chosen turns by so much [rad]. */
const kTurns: Readonly<Record<string, number>> = { ',': Math.PI / 12, '.': -Math.PI / 12 };

/** Where letters are written, or chosen by. */
const kTyping = 'input:not([type="checkbox"]), textarea, select, dialog';

export class BuildKeys {
  constructor(
    private readonly actions_: BuildActions,
    private readonly open_: () => boolean,
  ) {
    window.addEventListener('keydown', (event) => this.pressed(event), { capture: true });
  }

  private pressed(event: KeyboardEvent): void {
    const { target } = event;
    if (!this.open_() || event.altKey) return;
    if (target instanceof HTMLElement && target.closest(kTyping)) return;
    const command = event.ctrlKey || event.metaKey;
    if (!command && target instanceof HTMLElement && target.closest('[role="radiogroup"]')) return;
    const done = command ? this.command(event) : this.key(event);
    if (!done) return;
    event.preventDefault();
    event.stopImmediatePropagation();
  }

  private command({ key, shiftKey }: KeyboardEvent): boolean {
    const acts: Readonly<Record<string, () => void>> = {
      z: () => this.actions_.undo(shiftKey),
      y: () => this.actions_.undo(true),
      c: () => this.actions_.copy(),
      v: () => this.actions_.paste(),
      d: () => this.actions_.duplicate(),
      a: () => this.actions_.chooseAll(),
    };
    const act = acts[key.toLowerCase()];
    act?.();
    return act !== undefined;
  }

  private key({ key, shiftKey, target }: KeyboardEvent): boolean {
    const onButton = target instanceof HTMLElement && target.closest('[role="toolbar"]') !== null;
    if (kArrows.includes(key) && !onButton) return (this.actions_.arrow(key as ArrowKey, shiftKey), true);
    if (kTurns[key]) return (this.actions_.turnChosen(kTurns[key]), true);
    if (key === 'Escape') return (this.actions_.leave(), true);
    if (key === 'Delete' || key === 'Backspace') return (this.actions_.remove(), true);
    if (key === 'Enter' && !(target instanceof HTMLButtonElement)) return (this.actions_.enter(shiftKey), true);
    const tool = shiftKey ? undefined : kBuildTools.find((one) => kToolKeys[one] === key.toLowerCase());
    if (!tool) return false;
    this.actions_.setTool(tool);
    this.actions_.toGround();
    return true;
  }
}
