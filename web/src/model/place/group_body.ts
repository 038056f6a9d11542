// What all in a group have in common, and where its classes stand.

import type { RoleDef } from '../../protocol/generated/commands';
import { kRoleAreaWords } from '../../protocol/generated/words';
import type { GroupBody } from '../../protocol/messages';

/** Parts of a formation, as events name them and as people read them. */
export const kAreas: Readonly<Record<string, string>> = {
  front: 'Front',
  rear: 'Rear',
  rim: 'Rim',
  centre: 'Centre',
  leftFlank: 'Left flank',
  rightFlank: 'Right flank',
  flanks: 'Flanks',
};
export const kAnywhere = 'Anywhere';

/** Classes that have a place: those that roles name, and that of the whole group. */
export function classesOf(body: GroupBody | null, roles: readonly RoleDef[]): number[] {
  const all = new Set(roles.map((role) => role.unitClass));
  if (body?.unitClass) all.add(body.unitClass);
  return [...all].sort((a, b) => a - b);
}

/** Where the class stands, for people. */
export function areaOf(roles: readonly RoleDef[], unitClass: number): string {
  const role = roles.find((one) => one.unitClass === unitClass);
  return role ? (kAreas[role.area] ?? role.area) : kAnywhere;
}

/** The roles once that class stands there; the others choose before and after it as they did. */
export function withArea(roles: readonly RoleDef[], unitClass: number, label: string): RoleDef[] {
  const area = kRoleAreaWords.find((word) => kAreas[word] === label);
  if (!area) return roles.filter((one) => one.unitClass !== unitClass);
  if (!roles.some((one) => one.unitClass === unitClass)) return [...roles, { area, unitClass }];
  return roles.map((one) => (one.unitClass === unitClass ? { ...one, area } : one));
}
