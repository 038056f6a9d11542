// Holes in the ground: they mark the stencil, and the ground is not drawn there.

import { AlwaysStencilFunc, type Material, MeshBasicMaterial, NotEqualStencilFunc, ReplaceStencilOp } from 'three';

const kMark = 1;
/** Before everything else. */
export const kOpeningOrder = -20;

/** Paints nothing but the mark. */
export function openingMaterial(): MeshBasicMaterial {
  return new MeshBasicMaterial({
    colorWrite: false,
    depthWrite: false,
    depthTest: false,
    stencilWrite: true,
    stencilRef: kMark,
    stencilFunc: AlwaysStencilFunc,
    stencilZPass: ReplaceStencilOp,
  });
}

/** The material is left out where the ground opens. */
export function leaveOutOpenings<M extends Material>(material: M): M {
  material.stencilWrite = true;
  material.stencilRef = kMark;
  material.stencilFunc = NotEqualStencilFunc;
  return material;
}
