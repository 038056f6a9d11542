// What all in a group have in common, and where its classes stand.

import type { SceneGroupBody, SceneRole } from '../../protocol/scene';

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
export function classesOf(body: SceneGroupBody | null, roles: readonly SceneRole[]): number[] {
  const all = new Set(roles.map((role) => role.class));
  if (body?.class) all.add(body.class);
  return [...all].sort((a, b) => a - b);
}

/** Where the class stands, for people. */
export function areaOf(roles: readonly SceneRole[], unitClass: number): string {
  const role = roles.find((one) => one.class === unitClass);
  return role ? (kAreas[role.area] ?? role.area) : kAnywhere;
}

/** The roles once that class stands there; the others choose before and after it as they did. */
export function withArea(roles: readonly SceneRole[], unitClass: number, label: string): SceneRole[] {
  const area = Object.keys(kAreas).find((key) => kAreas[key] === label);
  if (!area) return roles.filter((one) => one.class !== unitClass);
  if (!roles.some((one) => one.class === unitClass)) return [...roles, { area, class: unitClass }];
  return roles.map((one) => (one.class === unitClass ? { ...one, area } : one));
}

/** Fields of a new group's definition that make it like this one. `usual`: what bodies are without any. */
export function likeGroup(
  body: SceneGroupBody,
  roles: readonly SceneRole[],
  usual: SceneGroupBody,
): Record<string, unknown> {
  const own = Object.entries(body).filter(([key, value]) => value !== usual[key as keyof SceneGroupBody]);
  return {
    ...(own.length > 0 ? { bodies: [Object.fromEntries(own)] } : {}),
    ...(roles.length > 0 ? { roles } : {}),
  };
}
