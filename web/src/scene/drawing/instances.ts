// Geometries drawn many times at once.

import type { BufferGeometry } from 'three';

/** Call where attributes of instances are replaced: three.js keeps the count of instances that it first saw, and their
 * buffers, until the geometry goes. */
export function forgetInstances(geometry: BufferGeometry): void {
  geometry.dispose();
}
