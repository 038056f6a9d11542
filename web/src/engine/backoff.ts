// How long to wait before the next attempt to reach the server.

const FIRST_MS = 500;
const LONGEST_MS = 5000;

/** Delay before attempt `attempt` (from 1) [ms]: doubles from half a second up to five seconds. */
export function backoffMs(attempt: number): number {
  const doublings = Math.max(0, Math.min(attempt - 1, 16));
  return Math.min(FIRST_MS * 2 ** doublings, LONGEST_MS);
}
