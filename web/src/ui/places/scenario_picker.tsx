// Top left: the scenario's title, and a list of all with descriptions and counts, under the titles of their folders.

import type { VNode } from 'preact';
import { formatCount } from '../../model/formatters';
import { groupScenarios, type ScenarioGroup } from '../../model/scenario_groups';
import type { StudioActions } from '../../model/studio_actions';
import type { PlacesView } from '../../model/studio_state';
import type { StudioStore } from '../../model/studio_store';
import type { ScenarioInfo } from '../../protocol/messages';
import { Icon, Logo } from '../widgets/buttons';
import { element } from '../widgets/dom';
import type { IconName } from '../widgets/icons';
import { Menu, MenuItem } from '../widgets/menu';
import { drawPanel } from '../widgets/panel';

const kPlaces: readonly (readonly [PlacesView, IconName, string])[] = [
  ['new', 'plus', 'New place…'],
  ['shelf', 'open', 'Saved places…'],
  ['import', 'place', 'Import a file…'],
  ['save', 'download', 'Save this place…'],
];

interface ItemProps {
  readonly info: ScenarioInfo;
  readonly current: boolean;
  readonly chosen: () => void;
}

function Item({ info, current, chosen }: ItemProps): VNode {
  return (
    <button type="button" class="scenario-item" aria-current={current ? 'true' : undefined} onClick={chosen}>
      <span class="scenario-name">{info.title || info.name}</span>
      <span class="scenario-count secondary">{formatCount(info.characters)}</span>
      <span class="scenario-about secondary">{info.description}</span>
    </button>
  );
}

interface GroupProps {
  readonly group: ScenarioGroup;
  readonly id: string;
  readonly current: string;
  readonly choose: (name: string) => void;
}

function Group({ group: { title, scenarios }, id, current, choose }: GroupProps): VNode {
  const items = scenarios.map((info) => (
    <Item key={info.name} info={info} current={info.name === current} chosen={() => choose(info.name)} />
  ));
  if (!title) return <>{items}</>;
  return (
    <div class="scenario-group" role="group" aria-labelledby={id}>
      <div class="scenario-heading" id={id}>
        {title}
      </div>
      {items}
    </div>
  );
}

export class ScenarioPicker {
  readonly root = element('div', { class: 'scenario panel' });

  constructor(store: StudioStore, actions: StudioActions) {
    drawPanel(this.root, store, ['title', 'scenarios', 'scenario', 'credit'], (state) => {
      const opener = {
        label: `Place: ${state.title || 'none'}`,
        word: state.title || 'Muster',
        wordClass: 'title',
        class: 'scenario-button',
        tip: 'Chooses a place to direct in',
        before: <Logo />,
        children: <Icon name="chevron" />,
      };
      return (
        <Menu opener={opener} class="scenario-list" label="Places">
          {(close) => {
            const choose = (name: string): void => {
              close();
              actions.loadScenario(name);
            };
            return (
              <>
                <div class="scenario-scroll">
                  {groupScenarios(state.scenarios).map((group, i) => (
                    <Group key={i} group={group} id={`scenario-group-${i}`} current={state.scenario} choose={choose} />
                  ))}
                  {state.credit && <p class="credit secondary">{state.credit}</p>}
                </div>
                <div class="scenario-places" role="group" aria-label="Your own places">
                  {kPlaces.map(([view, icon, label]) => (
                    <MenuItem
                      key={view}
                      icon={icon}
                      label={label}
                      class="place-menu-item"
                      close={close}
                      act={() => actions.showPlaces(view)}
                    />
                  ))}
                </div>
              </>
            );
          }}
        </Menu>
      );
    });
  }
}
