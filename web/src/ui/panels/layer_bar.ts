// Switches for layers and overlays, the theme, and help.

import { OverlayKind } from '../../protocol/messages';
import { element, setAttribute, setPressed } from '../widgets/dom';
import { icon } from '../widgets/icons';
import type { StudioActions } from '../../model/studio_actions';
import { isLost } from '../../model/studio_state';
import { toolButton } from '../widgets/tool_button';
import { ToolbarFocus } from '../widgets/toolbar_focus';
import type { Layers } from '../../model/view_settings';
import type { StudioStore } from '../../model/studio_store';

const kLayers = [
  { layer: 'mesh', icon: 'mesh', label: 'Mesh', key: 'M', tip: 'The formation’s mesh and its controls' },
  { layer: 'places', icon: 'places', label: 'Places', key: 'L', tip: 'Where characters shall stand' },
  { layer: 'paths', icon: 'paths', label: 'Paths', key: 'T', tip: 'Drawn paths still ahead' },
] as const satisfies readonly { layer: keyof Layers; [key: string]: string }[];

const kOverlays = [
  {
    kind: OverlayKind.Field,
    icon: 'field',
    label: 'Field',
    key: 'V',
    tip: 'The field that bends the mesh round obstacles',
  },
  {
    kind: OverlayKind.Cost,
    icon: 'cost',
    label: 'Cost',
    key: 'C',
    tip: 'One character’s cost to its place: tap a character',
  },
  { kind: OverlayKind.Density, icon: 'density', label: 'Density', key: 'D', tip: 'How crowded the ground is' },
] as const;

export class LayerBar {
  readonly root = element('div', { class: 'layers panel', role: 'toolbar', 'aria-label': 'Layers' });

  constructor(store: StudioStore, actions: StudioActions) {
    for (const { layer, ...def } of kLayers) {
      const button = toolButton({ ...def, className: 'toggle', pressed: true, act: () => actions.toggleLayer(layer) });
      store.watch(['layers'], (state) => setPressed(button, state.layers[layer]));
      this.root.append(button);
    }
    for (const { kind, ...def } of kOverlays) {
      const button = toolButton({
        ...def,
        className: 'toggle',
        pressed: false,
        act: () => actions.toggleOverlay(kind),
      });
      store.watch(['overlay'], (state) => setPressed(button, state.overlay === kind));
      store.watch(['link', 'loaded'], (state) => (button.inert = isLost(state)));
      this.root.append(button);
    }
    const theme = toolButton({
      icon: 'moon',
      label: 'Dark',
      iconOnly: true,
      key: 'N',
      className: 'theme-button',
      act: () => actions.toggleTheme(),
    });
    store.watch(['theme'], (state) => {
      const dark = state.theme === 'dark';
      theme.replaceChild(icon(dark ? 'sun' : 'moon'), theme.firstElementChild!);
      setAttribute(theme, 'aria-label', dark ? 'Light colours' : 'Dark colours');
      setAttribute(theme, 'data-tip', dark ? 'Light colours' : 'Dark colours');
    });
    const help = toolButton({
      icon: 'help',
      label: 'Help',
      iconOnly: true,
      key: 'H',
      tip: 'All gestures and keys',
      className: 'help-button',
      act: () => actions.showHelp(true),
    });
    this.root.append(element('span', { class: 'divider' }), theme, help);
    new ToolbarFocus(this.root, store);
  }
}
