// Switches for layers and overlays, the theme, and help.

import type { VNode } from 'preact';
import type { StudioActions } from '../../model/studio_actions';
import { isLost, type StudioState } from '../../model/studio_state';
import type { StudioStore } from '../../model/studio_store';
import type { Layers } from '../../model/view_settings';
import { OverlayKind } from '../../protocol/messages';
import { toolButton, ToolButton } from '../widgets/buttons';
import { element } from '../widgets/dom';
import { drawPanel } from '../widgets/panel';
import { ToolbarFocus } from '../widgets/toolbar_focus';

const kLayers = [
  {
    layer: 'mesh',
    icon: 'mesh',
    label: 'Mesh',
    shortcut: 'M',
    tip: 'The net of the formation that fingers bend, and where they hold it',
  },
  {
    layer: 'places',
    icon: 'places',
    label: 'Spots',
    shortcut: 'L',
    tip: 'Where each person of a formation shall stand',
  },
  {
    layer: 'paths',
    icon: 'paths',
    label: 'Paths',
    shortcut: 'T',
    tip: 'The ways that are still ahead, of fingers and of orders',
  },
] as const satisfies readonly { layer: keyof Layers; [key: string]: string }[];

const kOverlays = [
  {
    kind: OverlayKind.Field,
    icon: 'field',
    label: 'Push',
    shortcut: 'V',
    tip: 'How strongly obstacles push a formation away',
  },
  {
    kind: OverlayKind.Cost,
    icon: 'cost',
    label: 'Effort',
    shortcut: 'C',
    tip: 'How hard the way to one person’s spot is from anywhere: tap a person',
  },
  {
    kind: OverlayKind.Density,
    icon: 'density',
    label: 'Density',
    shortcut: 'D',
    tip: 'How many people stand on a square metre',
  },
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
          {toolButton(dark ? 'sun' : 'moon', dark ? 'Light colours' : 'Dark colours', () => actions.toggleTheme(), {
            iconOnly: true,
            shortcut: 'N',
            class: 'theme-button',
          })}
          {toolButton('help', 'Help', () => actions.showHelp(true), {
            iconOnly: true,
            shortcut: 'H',
            tip: 'All gestures and keys',
            class: 'help-button',
          })}
        </>
      );
    });
    new ToolbarFocus(this.root, store);
  }
}
