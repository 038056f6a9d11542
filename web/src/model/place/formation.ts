// Formations as scenes have them.

import type { Vec2 } from '../../protocol/generated/commands';
import type { SceneShape } from '../../protocol/scene';
import type { FormationWords } from '../sequence';

/** The formation of a scene: its outline is a list of corners there, or one with holes. */
export function formationOf(shape: SceneShape): FormationWords {
  const { outline, ...rest } = shape as FormationWords & { readonly outline?: unknown };
  if (!Array.isArray(outline)) return shape as FormationWords;
  return { ...rest, outline: { outline: outline as readonly Vec2[] } };
}
