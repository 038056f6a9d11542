// Classes of characters: their colours, told apart by lightness as well as by hue, and how many of them a group has.

/** Helmets of the classes from 1 on; they repeat. Black and white first, as these differ most whatever one sees. */
export const kClassColours: readonly string[] = [
  '#FFD400',
  '#FFFFFF',
  '#23C4F0',
  '#FF7A9C',
  '#101418',
  '#7BE04A',
  '#B06BFF',
];

/** The colour of a class; empty for class 0, which has none. */
export function classColour(unitClass: number): string {
  return unitClass > 0 ? kClassColours[(unitClass - 1) % kClassColours.length]! : '';
}

/** A class and how many are of it. */
export interface ClassCount {
  readonly unitClass: number;
  readonly count: number;
}

/** Per group, the classes of its members, ascending; those of none are left out. */
export function countClasses(
  group: ArrayLike<number>,
  unitClass: ArrayLike<number>,
  groups: number,
): readonly (readonly ClassCount[])[] {
  const counts = Array.from({ length: groups }, () => new Map<number, number>());
  for (let i = 0; i < unitClass.length; ++i) {
    const of = unitClass[i]!;
    const into = counts[group[i] ?? -1];
    if (of > 0 && into) into.set(of, (into.get(of) ?? 0) + 1);
  }
  return counts.map((one) =>
    [...one].sort(([a], [b]) => a - b).map(([of, count]): ClassCount => ({ unitClass: of, count })),
  );
}
