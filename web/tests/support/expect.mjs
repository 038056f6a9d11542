// Assertions that say what was seen.

export function expect(truth, what) {
  if (!truth) throw new Error(what);
}

export function expectBetween(value, low, high, what) {
  expect(value >= low && value <= high, `${what}: ${value} is not between ${low} and ${high}`);
}
