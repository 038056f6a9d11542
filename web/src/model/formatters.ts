// Figures as the panels write them.

/** A record's clock: "0:14.2". */
export function formatClock(seconds: number): string {
  const tenths = Math.max(0, Math.floor(seconds * 10 + 1e-4));
  const minutes = Math.floor(tenths / 600);
  const rest = tenths - minutes * 600;
  return `${minutes}:${String(Math.floor(rest / 10)).padStart(2, '0')}.${rest % 10}`;
}

/** Milliseconds with one decimal below 100. */
export function formatMs(ms: number): string {
  if (!Number.isFinite(ms)) return '–';
  return ms < 99.95 ? ms.toFixed(1) : String(Math.round(ms));
}

/** Two decimals below 10, one below 100: figures keep their width. */
export function formatFigure(value: number): string {
  if (!Number.isFinite(value)) return '–';
  const size = Math.abs(value);
  if (size < 9.995) return value.toFixed(2);
  return size < 99.95 ? value.toFixed(1) : String(Math.round(value));
}

/** 1 decimal, for lengths and costs in the legend. */
export function formatLength(value: number): string {
  return Number.isFinite(value) ? value.toFixed(1) : '–';
}

/** Thousands apart by a thin space: "10 000". */
export function formatCount(count: number): string {
  return String(Math.round(count)).replace(/\B(?=(\d{3})+$)/g, '\u2009');
}

/** "1×", "0.5×". */
export function formatSpeed(factor: number): string {
  return `${Number(factor.toFixed(2))}×`;
}

/** The largest of 1, 2, 5 times a power of ten that takes at most `px`. */
export function scaleBarMetres(pixelsPerMetre: number, px: number): number {
  const most = px / Math.max(pixelsPerMetre, 1e-6);
  const power = 10 ** Math.floor(Math.log10(most));
  const factor = [5, 2, 1].find((one) => one * power <= most * (1 + 1e-9)) ?? 1;
  return factor * power;
}
