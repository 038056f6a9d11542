// How long one play of a clip lasts.

/** [s] */
export function clipDuration(clip: {
  readonly poses: number;
  readonly rate: number;
  readonly cyclic: boolean;
}): number {
  return (clip.cyclic ? clip.poses : Math.max(1, clip.poses - 1)) / clip.rate;
}
