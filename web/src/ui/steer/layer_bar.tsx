// Switches for layers and overlays, the theme, and help.

import type { VNode } from 'preact';
import type { StudioActions } from '../../model/studio_actions';
import { isLost, type StudioState } from '../../model/studio_state';
import type { StudioStore } from '../../model/studio_store';
import type { Layers } from '../../model/view_settings';
import { OverlayKind } from '../../protocol/messages';
import { ToolButton } from '../widgets/buttons';
import { element } from '../widgets/dom';
import { drawPanel } from '../widgets/panel';
import { ToolbarFocus } from '../widgets/toolbar_focus';

const kLayers = [
  { layer: 'mesh', icon: 'mesh', label: 'Mesh', shortcut: 'M', tip: 'The formation’s mesh and its controls' },
  { layer: 'places', icon: 'places', label: 'Places', shortcut: 'L', tip: 'Where characters shall stand' },
  { layer: 'paths', icon: 'paths', label: 'Paths', shortcut: 'T', tip: 'Drawn paths still ahead' },
] as const satisfies readonly { layer: keyof Layers; [key: string]: string }[];

const kOverlays = [
  {
    kind: OverlayKind.Field,
    icon: 'field',
    label: 'Field',
    shortcut: 'V',
    tip: 'The field that bends the mesh round obstacles',
  },
  {
    kind: OverlayKind.Cost,
    icon: 'cost',
    label: 'Cost',
    shortcut: 'C',
    tip: 'One character’s cost to its place: tap a character',
  },
  { kind: OverlayKind.Density, icon: 'density', label: 'Density', shortcut: 'D', tip: 'How crowded the ground is' },
] as const;

interface Props {
  readonly state: StudioState;
  readonly actions: StudioActions;
}

function Switches({ state, actions }: Props): VNode {
  return (
    <>
      {kLayers.map(({ layer, ...def }) => (
        <ToolButton
          key={layer}
          {...def}
          class="toggle"
          pressed={state.layers[layer]}
          act={() => actions.toggleLayer(layer)}
        />
      ))}
      {kOverlays.map(({ kind, ...def }) => (
        <ToolButton
          key={kind}
          {...def}
          class="toggle"
          pressed={state.overlay === kind}
          inert={isLost(state)}
          act={() => actions.toggleOverlay(kind)}
        />
      ))}
    </>
  );
}

export class LayerBar {
  readonly root = element('div', { class: 'layers panel', role: 'toolbar', 'aria-label': 'Layers' });

  constructor(store: StudioStore, actions: StudioActions) {
    drawPanel(this.root, store, ['layers', 'overlay', 'link', 'loaded', 'theme'], (state) => {
      const dark = state.theme === 'dark';
      return (
        <>
          <Switches state={state} actions={actions} />
          <span class="divider" />
          <ToolButton
            icon={dark ? 'sun' : 'moon'}
            label={dark ? 'Light colours' : 'Dark colours'}
            iconOnly
            shortcut="N"
            class="theme-button"
            act={() => actions.toggleTheme()}
          />
          <ToolButton
            icon="help"
            label="Help"
            iconOnly
            shortcut="H"
            tip="All gestures and keys"
            class="help-button"
            act={() => actions.showHelp(true)}
          />
        </>
      );
    });
    new ToolbarFocus(this.root, store);
  }
}
