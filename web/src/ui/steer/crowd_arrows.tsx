// At the edge of the view: an arrow to each group that is off screen; a press brings it into view.

import type { StudioActions } from '../../model/studio_actions';
import type { StudioStore } from '../../model/studio_store';
import { Icon } from '../widgets/buttons';
import { element } from '../widgets/dom';
import { GroupMark } from '../widgets/group_icons';
import { accentVariable } from '../widgets/group_marks';
import { drawPanel } from '../widgets/panel';

export class CrowdArrows {
  readonly root = element('div', { class: 'crowd-arrows' });

  constructor(store: StudioStore, actions: StudioActions) {
    drawPanel(this.root, store, ['arrows', 'groups'], ({ arrows, groups }) =>
      arrows.map(({ id, index, x, y, angle }) => {
        const group = groups[index];
        return (
          group && (
            <button
              key={id}
              type="button"
              class="crowd-arrow panel"
              aria-label={`${group.name} is off screen: show it`}
              data-tip={`${group.name} is there`}
              style={{
                transform: `translate(${x - 24}px, ${y - 24}px)`,
                '--direction': `${angle}rad`,
                '--accent': accentVariable(group.colour),
              }}
              onClick={() => actions.frameGroup(groups.findIndex((one) => one.id === id))}
            >
              <GroupMark colour={group.colour} />
              <span class="crowd-arrow-point">
                <Icon name="arrow" />
              </span>
            </button>
          )
        );
      }),
    );
  }
}
