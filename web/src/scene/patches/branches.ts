// Branches that hang so low that one ducks: thin limbs and tufts of leaves one sees through, over a shaded floor.

import type { Vec2 } from '../../protocol/generated/commands';
import { addBlob, boxOf } from '../obstacles/obstacle_geometry';
import type { Palette } from '../drawing/palette';
import { addPlain, blended, type PatchParts, thrown } from './patch_parts';

/** Height where leaves begin: above ducking characters, below the heads of upright ones [m]. */
export const kLeavesFrom = 1.3;
/** Floor area per tuft [m²]. */
const kTuftArea = 0.8;

export function addBranches(parts: PatchParts, outline: readonly Vec2[], palette: Palette): void {
  const dark = palette.shadowKeeps < 0.65;
  addPlain(parts, outline, dark ? '#1A2A1D' : '#C9CFB7', palette.crown);
  const box = boxOf(outline);
  const c = Math.cos(box.angle),
    s = Math.sin(box.angle);
  const count = Math.max(4, Math.round((3.1 * box.length * box.width) / kTuftArea));
  for (let i = 0; i < count; ++i) {
    // Spread as seeds are in a sunflower, so that no two tufts coincide.
    const far = Math.sqrt((i + 0.5) / count) * 0.94;
    const turn = i * 2.39996 + box.x;
    const [u, v] = [far * Math.cos(turn) * box.length, far * Math.sin(turn) * box.width];
    const radius = 0.26 + 0.2 * thrown(i, box.x);
    const low = kLeavesFrom + 0.3 * thrown(i, box.y) + 0.25 * (1 - far);
    const at = [box.x + c * u - s * v, box.y + s * u + c * v, low + 0.6 * radius] as const;
    const colour = blended(palette.crown, i % 3 ? palette.trunk : palette.netFloor, 0.22 * thrown(i, 5));
    addBlob(parts.leaves, at, { radius, height: 0.6 * radius, colour, seed: i + box.x, rows: 3, sides: 6 });
    if (i % 3 === 0)
      parts.solid.limb([box.x + 0.2 * u, box.y + 0.2 * v, 2.2], [at[0], at[1], at[2]], 0.03, palette.trunk);
  }
}
