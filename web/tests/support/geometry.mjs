// Small geometry on frames.

export function points(pairs) {
  const list = [];
  for (let i = 0; i + 1 < pairs.length; i += 2) list.push({ x: pairs[i], y: pairs[i + 1] });
  return list;
}

export function mean(list) {
  const sum = list.reduce((s, p) => ({ x: s.x + p.x, y: s.y + p.y }), { x: 0, y: 0 });
  return { x: sum.x / list.length, y: sum.y / list.length };
}

export function distance(a, b) {
  return Math.hypot(a.x - b.x, a.y - b.y);
}

export function shifted(point, x, y) {
  return { x: point.x + x, y: point.y + y };
}

/** The vertex farthest along (x, y). */
export function extreme(list, x, y) {
  return list.reduce((best, p) => (p.x * x + p.y * y > best.x * x + best.y * y ? p : best));
}

/** The crowd's positions. */
export function crowd(frame) {
  return frame.x.map((x, i) => ({ x, y: frame.y[i] }));
}

export function toSegment(p, a, b) {
  const dx = b.x - a.x;
  const dy = b.y - a.y;
  const t = Math.min(1, Math.max(0, ((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy)));
  return Math.hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

export function percentile(values, share) {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.min(sorted.length - 1, Math.ceil(share * sorted.length) - 1)];
}

/** Largest change of a distance between two of the points, over that distance. */
export function distortion(before, after) {
  let most = 0;
  for (let i = 0; i < before.length; ++i) {
    for (let j = 0; j < i; ++j) {
      const was = distance(before[i], before[j]);
      if (was > 0.5) most = Math.max(most, Math.abs(distance(after[i], after[j]) - was) / was);
    }
  }
  return most;
}
