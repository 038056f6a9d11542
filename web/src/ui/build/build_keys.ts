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
  patch: 'h',
  stairs: 't',
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

export class BuildKeys {
  constructor(
    private readonly desk_: BuildActions,
    private readonly open_: () => boolean,
  ) {
    window.addEventListener('keydown', (event) => this.pressed(event), { capture: true });
  }

  private pressed(event: KeyboardEvent): void {
    const { target } = event;
    if (!this.open_() || event.altKey) return;
    if (target instanceof HTMLElement && target.closest('input, textarea, select, dialog')) return;
    const command = event.ctrlKey || event.metaKey;
    if (!command && target instanceof HTMLElement && target.closest('[role="radiogroup"]')) return;
    const done = command ? this.command(event) : this.key(event);
    if (!done) return;
    event.preventDefault();
    event.stopImmediatePropagation();
  }

  private command({ key, shiftKey }: KeyboardEvent): boolean {
    const acts: Readonly<Record<string, () => void>> = {
      z: () => this.desk_.undo(shiftKey),
      y: () => this.desk_.undo(true),
      c: () => this.desk_.copy(),
      v: () => this.desk_.paste(),
      d: () => this.desk_.duplicate(),
      a: () => this.desk_.chooseAll(),
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
      this.desk_.nudge(arrow[0] * step, arrow[1] * step);
      return true;
    }
    if (key === 'Escape') return (this.desk_.leave(), true);
    if (key === 'Delete' || key === 'Backspace') return (this.desk_.remove(), true);
    if (key === 'Enter' && !(target instanceof HTMLButtonElement)) return (this.desk_.finishPolygon(), true);
    const tool = shiftKey ? undefined : kBuildTools.find((one) => kToolKeys[one] === key.toLowerCase());
    if (tool) this.desk_.setTool(tool);
    return tool !== undefined;
  }
}
