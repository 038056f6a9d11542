// The clock of the page and its worker.

/** Page clock [s]: since the epoch, finer than Date. */
export function pageClock(eventTime: number = performance.now()): number {
  return (performance.timeOrigin + eventTime) / 1000;
}
