// About how much room formations take, in spacings.

/** Ahead and aside, for so many people. */
export const kGroupRoom: Readonly<Record<string, (count: number) => readonly [number, number]>> = {
  square: (count) => [Math.sqrt(count), Math.sqrt(count)],
  line: (count) => [2, count / 2],
  column: (count) => [count / 2, 2],
  wedge: (count) => [Math.sqrt(count), 1.6 * Math.sqrt(count)],
  ring: (count) => [count / Math.PI, count / Math.PI],
  circle: (count) => [1.13 * Math.sqrt(count), 1.13 * Math.sqrt(count)],
};
