// Dialogs of the whole page: the help, and the choice of a control scheme.

import type { VNode } from 'preact';
import type { StudioActions } from '../../model/studio_actions';
import type { StudioState } from '../../model/studio_state';
import type { StudioStore } from '../../model/studio_store';
import type { Shortcut } from '../../tools/shortcuts';
import { Modal } from '../widgets/dialog';
import { element } from '../widgets/dom';
import { drawPanel } from '../widgets/panel';
import { HelpBody } from './help_body';

const kOwn = {
  name: '',
  title: 'The studio’s own',
  description: 'Fingers, mouse and keys as the help tells.',
} as const;

interface SchemesProps {
  readonly state: StudioState;
  readonly actions: StudioActions;
}

function Schemes({ state: { schemes, scheme }, actions }: SchemesProps): VNode {
  return (
    <Modal title="Control" class="help schemes" closes="Close the list" close={() => actions.showSchemes(false)}>
      <div class="scheme-list" role="radiogroup" aria-labelledby="schemes-title">
        {[kOwn, ...schemes].map(({ name, title, description }) => (
          <label key={name} class="scheme-row">
            <input
              type="radio"
              name="scheme"
              value={name}
              checked={name === scheme}
              autofocus={name === scheme}
              onChange={() => actions.chooseScheme(name)}
            />
            <span class="scheme-words">
              <strong>{title}</strong>
              <span class="secondary">{description}</span>
            </span>
          </label>
        ))}
      </div>
    </Modal>
  );
}

/** Draws the one that is open. */
export function pageDialogs(store: StudioStore, actions: StudioActions, shortcuts: readonly Shortcut[]): HTMLElement {
  const root = element('div', { class: 'dialogs' });
  drawPanel(root, store, ['help', 'schemesOpen', 'scheme'], (state) => (
    <>
      {state.help && (
        <Modal
          title="Gestures and keys"
          class="help help-keys"
          closes="Close help"
          close={() => actions.showHelp(false)}
        >
          <HelpBody shortcuts={shortcuts} />
        </Modal>
      )}
      {state.schemesOpen && <Schemes state={state} actions={actions} />}
    </>
  ));
  return root;
}
