// Marks of groups and icons of formations, in panels.

import type { VNode } from 'preact';
import { formationIcon } from './formation_icons';
import { groupMark } from './group_marks';
import { Held } from './held';

export function GroupMark({ colour }: { readonly colour: number }): VNode {
  return <Held key={colour} make={() => groupMark(colour)} />;
}

export function FormationIcon({ name }: { readonly name: string }): VNode {
  return <Held key={name} make={() => formationIcon(name)} />;
}
