// What shows a new group before it is put down is loaded when one is in hand first.

import type { NewGroup } from '../../model/shape_actions';
import type { GhostHost, GroupGhost } from './group_ghost';

export type Ghost = Pick<GroupGhost, 'show' | 'hide'>;

/** Shows nothing until it is loaded. */
export function lazyGhost(host: GhostHost, group: NewGroup): Ghost {
  let ghost: GroupGhost | null = null;
  let gone = false;
  import('./group_ghost').then(
    (loaded) => void (gone || (ghost = new loaded.GroupGhost(host, group))),
    // Without it the group can be put down all the same.
    () => undefined,
  );
  return {
    show: (at, frame) => ghost?.show(at, frame),
    hide: () => {
      gone = true;
      ghost?.hide();
    },
  };
}
