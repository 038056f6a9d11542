// Keys while somebody builds. They come before those of the studio.

import { kBuildTools, type BuildTool } from '../../model/place/drawing';
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

const kArrows: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};
const kNudge = { short: 0.1, long: 1 };

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
    const arrow = kArrows[key];
    const onButton = target instanceof HTMLElement && target.closest('[role="toolbar"]') !== null;
    if (arrow && !onButton) {
      const step = shiftKey ? kNudge.long : kNudge.short;
      this.actions_.nudge(arrow[0] * step, arrow[1] * step);
      return true;
    }
    if (key === 'Escape') return (this.actions_.leave(), true);
    if (key === 'Delete' || key === 'Backspace') return (this.actions_.remove(), true);
    if (key === 'Enter' && !(target instanceof HTMLButtonElement)) return (this.actions_.finishPolygon(), true);
    const tool = shiftKey ? undefined : kBuildTools.find((one) => kToolKeys[one] === key.toLowerCase());
    if (tool) this.actions_.setTool(tool);
    return tool !== undefined;
  }
}
