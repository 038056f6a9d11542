// The library of formations; a press changes the active group.

import { Component, type VNode } from 'preact';
import type { StudioActions } from '../../model/studio_actions';
import type { StudioState } from '../../model/studio_state';
import type { StudioStore } from '../../model/studio_store';
import { element } from '../widgets/dom';
import { FormationIcon, GroupMark } from '../widgets/group_icons';
import { accentVariable } from '../widgets/group_marks';
import { holdWithFinger } from '../widgets/held_button';
import { lookFirst } from '../widgets/look_first';
import { drawPanel } from '../widgets/panel';
import { ToolbarFocus } from '../widgets/toolbar_focus';

export interface FormationChoice {
  readonly name: string;
  readonly label: string;
  /** What it opens instead of taking up a shape of the library. */
  readonly opens?: 'text' | 'draw' | 'shape';
}

/** The first eight answer to the keys 1 to 8. */
export const kFormations: readonly FormationChoice[] = [
  { name: 'square', label: 'Square' },
  { name: 'line', label: 'Line' },
  { name: 'column', label: 'Column' },
  { name: 'wedge', label: 'Wedge' },
  { name: 'ring', label: 'Ring' },
  { name: 'circle', label: 'Circle' },
  { name: 'crescent', label: 'Crescent' },
  { name: 'pacman', label: 'Pacman' },
  { name: 'text', label: 'Text', opens: 'text' },
  { name: 'draw', label: 'Draw', opens: 'draw' },
  { name: 'more', label: 'More', opens: 'shape' },
];

const kTips = {
  text: 'Words as a formation',
  draw: 'Draw an outline on the ground as a formation; hold it and draw with another finger',
  shape: 'Mirror, turn, loosen, save; a picture or a QR code as a formation',
} as const;
/** What the server calls shapes that are no part of the library. */
const kOwnShapes: Readonly<Record<string, string>> = { outline: 'draw', points: 'more' };

interface TileProps {
  readonly choice: FormationChoice;
  readonly shortcut: string | undefined;
  readonly pressed: boolean;
  readonly actions: StudioActions;
}

class Tile extends Component<TileProps> {
  private button_: HTMLButtonElement | null = null;

  /** Shapes of the library are shown on the ground first; Draw is in hand while a finger holds it. */
  override componentDidMount(): void {
    const { choice, actions } = this.props;
    const button = this.button_!;
    if (choice.opens === 'draw') holdWithFinger(button, (held, lost) => actions.holdDraw(held, lost));
    if (!choice.opens)
      lookFirst(button, {
        look: () => actions.lookAtFormation(choice.name),
        leave: () => actions.lookAtFormation(null),
        take: () => this.chosen(),
      });
    button.addEventListener('click', () => this.chosen());
  }

  private chosen(): void {
    const { choice, actions } = this.props;
    if (choice.opens === 'draw') actions.toggleDraw();
    else if (choice.opens) actions.openDialog(choice.opens);
    else actions.setFormation(choice.name);
  }

  override render({ choice, shortcut, pressed }: TileProps): VNode {
    const { name, label, opens } = choice;
    return (
      <button
        type="button"
        class="formation"
        aria-pressed={pressed}
        aria-haspopup={opens && opens !== 'draw' ? 'dialog' : undefined}
        aria-keyshortcuts={shortcut}
        data-key={shortcut}
        data-tip={opens ? kTips[opens] : label}
        data-opens={opens}
        ref={(made) => void (this.button_ = made)}
      >
        <FormationIcon name={name} />
        <span class="label">{label}</span>
      </button>
    );
  }
}

function shortcutOf({ opens }: FormationChoice, index: number): string | undefined {
  if (index < 8) return String(index + 1);
  return opens === 'draw' ? '9' : undefined;
}

/** The name of the choice that is pressed. */
function shownOf({ groups, active, tool }: StudioState): string | undefined {
  if (tool === 'draw') return 'draw';
  const formation = groups[active]?.formation;
  return kOwnShapes[formation ?? ''] ?? formation;
}

/** Where tiles are scrolled, the pressed one is in sight. */
function reveal(list: HTMLElement): void {
  const box = list.querySelector('[aria-pressed="true"]')?.getBoundingClientRect();
  const scroller = list.scrollWidth > list.clientWidth ? list : list.parentElement!;
  const room = scroller.getBoundingClientRect();
  if (!box || box.width === 0) return;
  scroller.scrollLeft += Math.max(0, box.right - room.right) - Math.max(0, room.left - box.left);
  scroller.scrollTop += Math.max(0, box.bottom - room.bottom) - Math.max(0, room.top - box.top);
}

export class FormationPanel {
  readonly root = element('section', { class: 'formations panel', 'aria-label': 'Formation' });

  constructor(store: StudioStore, actions: StudioActions) {
    drawPanel(this.root, store, ['groups', 'active', 'tool'], (state) => {
      const group = state.groups[state.active];
      this.root.style.setProperty('--accent', accentVariable(group?.colour ?? 0));
      return (
        <>
          <div class="formation-heading secondary">
            <span class="formation-mark">
              <GroupMark colour={group?.colour ?? 0} />
            </span>
            Formation
          </div>
          <div class="formation-list" role="toolbar" aria-label={group ? `Formations of ${group.name}` : 'Formations'}>
            {kFormations.map((choice, i) => (
              <Tile
                key={choice.name}
                choice={choice}
                shortcut={shortcutOf(choice, i)}
                pressed={shownOf(state) === choice.name}
                actions={actions}
              />
            ))}
          </div>
        </>
      );
    });
    const list = this.root.querySelector<HTMLElement>('.formation-list')!;
    new ToolbarFocus(list, store);
    let seen = '';
    store.watch(['groups', 'active', 'tool', 'layout'], (state) => {
      const shown = `${shownOf(state)} ${state.layout}`;
      if (shown !== seen) requestAnimationFrame(() => reveal(list));
      seen = shown;
    });
  }
}
