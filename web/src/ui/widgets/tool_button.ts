// A button with icon, label, tooltip and key.

import { element } from './dom';
import { icon, type IconName } from './icons';

export interface ToolButtonDef {
  readonly icon?: IconName;
  /** Its name; also written out unless `iconOnly`. */
  readonly label: string;
  readonly iconOnly?: boolean;
  /** A sentence for the tooltip; the label where absent. */
  readonly tip?: string;
  /** As the help shows it. */
  readonly key?: string;
  readonly className?: string;
  readonly pressed?: boolean;
  readonly act?: () => void;
}

/** A label that layouts may hide while it still names the button. */
function labelOf(def: ToolButtonDef): HTMLElement {
  return element('span', { class: def.iconOnly ? 'unseen' : 'label' }, def.label);
}

export function toolButton(def: ToolButtonDef): HTMLButtonElement {
  const button = element('button', {
    type: 'button',
    class: def.className,
    'aria-label': def.label,
    'aria-pressed': def.pressed === undefined ? undefined : String(def.pressed),
    'aria-keyshortcuts': def.key,
    'data-tip': def.tip ?? def.label,
    'data-key': def.key,
  });
  if (def.icon) button.append(icon(def.icon));
  button.append(labelOf(def));
  const { act } = def;
  if (act) button.addEventListener('click', () => act());
  return button;
}
