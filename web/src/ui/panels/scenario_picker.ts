// Top left: the scenario's title, and a list of all with descriptions and counts, under the titles of their folders.

import type { ScenarioInfo } from '../../protocol/messages';
import { element, setText } from '../widgets/dom';
import { formatCount } from '../../model/formatters';
import { icon, logo, type IconName } from '../widgets/icons';
import { Popover } from '../widgets/popover';
import { groupScenarios, type ScenarioGroup } from '../../model/scenario_groups';
import type { StudioActions } from '../../model/studio_actions';
import type { PlacesView, StudioState } from '../../model/studio_state';
import type { StudioStore } from '../../model/studio_store';

const kPlaces: readonly (readonly [PlacesView, IconName, string])[] = [
  ['new', 'plus', 'New place…'],
  ['shelf', 'open', 'Saved places…'],
  ['import', 'place', 'Import a file…'],
  ['save', 'download', 'Save this place…'],
];

export class ScenarioPicker {
  private readonly title_ = element('span', { class: 'title' });
  private readonly button_ = element(
    'button',
    {
      type: 'button',
      class: 'scenario-button',
      'aria-haspopup': 'true',
      'data-tip': 'Choose a scenario',
    },
    logo(),
    this.title_,
    icon('chevron'),
  );
  private readonly list_ = element('div', { class: 'scenario-list panel', role: 'group', 'aria-label': 'Scenarios' });
  private readonly places_ = element('div', {
    class: 'scenario-places',
    role: 'group',
    'aria-label': 'Your own places',
  });
  readonly root = element('div', { class: 'scenario panel' }, this.button_, this.list_);
  private readonly popover_ = new Popover(this.button_, this.list_);

  constructor(
    store: StudioStore,
    private readonly actions_: StudioActions,
  ) {
    this.places_.append(...kPlaces.map((one) => this.placeItem(...one)));
    store.watch(['title'], (state) => {
      setText(this.title_, state.title || 'Muster');
      this.button_.setAttribute('aria-label', `Scenario: ${state.title || 'none'}`);
    });
    store.watch(['scenarios', 'scenario', 'credit'], (state) => this.fill(state));
  }

  private fill(state: StudioState): void {
    const groups = groupScenarios(state.scenarios).flatMap((group, index) => this.group(group, index, state.scenario));
    const credit = state.credit ? [element('p', { class: 'credit secondary' }, state.credit)] : [];
    this.list_.replaceChildren(...groups, ...credit, this.places_);
  }

  private group({ title, scenarios }: ScenarioGroup, index: number, current: string): HTMLElement[] {
    const items = scenarios.map((info) => this.item(info, info.name === current));
    if (!title) return items;
    const id = `scenario-group-${index}`;
    const heading = element('div', { class: 'scenario-heading', id }, title);
    return [element('div', { class: 'scenario-group', role: 'group', 'aria-labelledby': id }, heading, ...items)];
  }

  private placeItem(view: PlacesView, name: IconName, label: string): HTMLButtonElement {
    const item = element('button', { type: 'button', class: 'place-menu-item' }, icon(name), label);
    item.addEventListener('click', () => {
      this.popover_.close(true);
      this.actions_.showPlaces(view);
    });
    return item;
  }

  private item(info: ScenarioInfo, current: boolean): HTMLButtonElement {
    const item = element(
      'button',
      { type: 'button', class: 'scenario-item', 'aria-current': current ? 'true' : undefined },
      element('span', { class: 'scenario-name' }, info.title || info.name),
      element('span', { class: 'scenario-count secondary' }, formatCount(info.characters)),
      element('span', { class: 'scenario-about secondary' }, info.description),
    );
    item.addEventListener('click', () => {
      this.popover_.close(true);
      this.actions_.loadScenario(info.name);
    });
    return item;
  }
}
