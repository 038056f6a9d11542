// What the dialogs of formations share: how many people are there and needed, what is said of the ground, and their last row.

import type { VNode } from 'preact';
import type { GroundPoint } from '../../model/plane';
import type { OwnShape } from '../../model/shape_edit';
import type { ShapeActions } from '../../model/shape_actions';
import type { StudioActions } from '../../model/studio_actions';
import type { DialogName, GroupInfo, StudioState } from '../../model/studio_state';
import { Button } from '../widgets/buttons';

export interface ShapeDialogProps {
  readonly state: StudioState;
  readonly shapes: ShapeActions;
  readonly actions: Pick<StudioActions, 'openDialog' | 'toggleTop' | 'frameGroup'>;
}

/** Neighbours stand so far apart in pictures, and in words [m]. */
export const kGap = 0.9;
export const kWordGap = 0.75;

export const activeGroup = ({ groups, active }: StudioState): GroupInfo | undefined => groups[active];

/** A dialog has closed: what it showed goes, unless it lies on the ground now. */
export function leave({ state, shapes, actions }: ShapeDialogProps): void {
  if (!state.trying) shapes.lookAt(null);
  actions.openDialog('none');
}

/** Places of any unit, with neighbours `gap` apart, as they stand in metres. */
export function inMetres(places: readonly GroundPoint[], gap: number, metres: number): GroundPoint[] {
  const scale = metres / Math.max(gap, 1e-9);
  return places.map(({ x, y }) => ({ x: scale * x, y: scale * y }));
}

export interface MorePeopleProps {
  /** What needs them. */
  readonly title: string;
  readonly needs: number;
  readonly group: GroupInfo | undefined;
  readonly shapes: ShapeActions;
}

/** "MUSTER needs about 90 people", and a button that adds them. */
export function MorePeople({ title, needs, group, shapes }: MorePeopleProps): VNode | null {
  const more = needs - (group?.count ?? 0);
  if (!group || needs <= 0 || more <= 0) return null;
  return (
    <div class="shape-more">
      <span>{`${title} needs about ${needs} people.`}</span>
      <Button act={() => shapes.setPeople(needs)}>{`Add ${more}`}</Button>
    </div>
  );
}

/** How many of the places can be reached. */
export function GroundWords({ state: { stand } }: Pick<ShapeDialogProps, 'state'>): VNode | null {
  if (!stand) return null;
  return <p class={`secondary shape-ground${stand.warns ? ' warns' : ''}`}>{`${stand.text}.`}</p>;
}

export interface EndsProps extends ShapeDialogProps {
  readonly title: string;
  readonly dialog: DialogName;
  readonly shape: OwnShape | null;
}

/** A look on the ground, or taking it up at once. */
export function Ends({ state, shapes, shape, title, dialog }: EndsProps): VNode {
  return (
    <>
      <GroundWords state={state} />
      <div class="shape-ends">
        <Button disabled={!shape} act={() => shape && shapes.tryOut({ title, dialog, shape })}>
          Try on the ground
        </Button>
        <Button type="submit" class="solid" disabled={!shape}>
          Use it
        </Button>
      </div>
    </>
  );
}
