// How long to wait before the next attempt to reach the server.

const kFirstMs = 500;
const kLongestMs = 5000;

/** Delay before attempt `attempt` (from 1) [ms]: doubles from half a second up to five seconds. */
export function backoffMs(attempt: number): number {
  const doublings = Math.max(0, Math.min(attempt - 1, 16));
  return Math.min(kFirstMs * 2 ** doublings, kLongestMs);
}
