// What was left out of a file, told in one sentence.

export type Reason = 'crosses' | 'flat' | 'numbers' | 'above' | 'below' | 'other' | 'many' | 'outside';

/** How many were left out, by reason. */
export type LeftOut = Partial<Record<Reason, number>>;

/** Of one, and of several. */
const kWhy: Readonly<Record<Reason, readonly [one: string, several: string]>> = {
  crosses: ['crosses itself', 'cross themselves'],
  flat: ['encloses no ground', 'enclose no ground'],
  numbers: ['has corners that are no numbers', 'have corners that are no numbers'],
  above: ['hangs above people’s heads', 'hang above people’s heads'],
  below: ['lies below the ground', 'lie below the ground'],
  other: ['is no building, wall or water', 'are no buildings, walls or waters'],
  many: ['is one more than the 20,000 that a place holds', 'are more than the 20,000 that a place holds'],
  outside: ['lies outside the place', 'lie outside the place'],
};

export function count(left: LeftOut, reason: Reason, more = 1): void {
  if (more > 0) left[reason] = (left[reason] ?? 0) + more;
}

const figure = (value: number): string => value.toLocaleString('en');

/** "3 of 812 outlines were left out: they cross themselves."; empty where nothing was. */
export function leftOutText(left: LeftOut, total: number, what = 'outlines'): string {
  const reasons = Object.entries(left).filter(([, number]) => number > 0) as [Reason, number][];
  const all = reasons.reduce((sum, [, number]) => sum + number, 0);
  const [first] = reasons;
  if (!first) return '';
  const head = `${figure(all)} of ${figure(total)} ${what} ${all === 1 ? 'was' : 'were'} left out`;
  if (reasons.length === 1) return `${head}: ${all === 1 ? `it ${kWhy[first[0]][0]}` : `they ${kWhy[first[0]][1]}`}.`;
  const parts = reasons.map(([reason, number]) => `${figure(number)} ${kWhy[reason][number === 1 ? 0 : 1]}`);
  return `${head}: ${parts.join(', ')}.`;
}
