import { expect, it, vi } from 'vitest';
import { FatLines } from '../drawing/fat_lines';
import { MeshLayer } from './mesh_layer';
import { makeTopology } from './mesh_topology';

/** Two triangles of a square, cut along one diagonal or the other. */
function square(group: number, version: number, flipped = false) {
  const triangles = flipped ? [0, 1, 3, 1, 2, 3] : [0, 1, 2, 0, 2, 3];
  return makeTopology({ group, version, formation: '', triangles, boundary: [4, 0, 1, 2, 3] });
}

it('builds lines anew for another mesh of the same version and size, not where vertices move', () => {
  const layer = new MeshLayer();
  const reserve = vi.spyOn(FatLines.prototype, 'reserve');
  const first = square(1, 2);
  const at = (x: number) => [x, 0, x + 1, 0, x + 1, 1, x, 1];
  layer.update([{ topology: first, vertices: at(0), colour: '#112233' }]);
  const built = reserve.mock.calls.length;
  expect(built).toBeGreaterThan(0);
  layer.update([{ topology: first, vertices: at(3), colour: '#112233' }]);
  expect(reserve.mock.calls.length).toBe(built);
  layer.update([{ topology: square(2, 2, true), vertices: at(3), colour: '#112233' }]);
  expect(reserve.mock.calls.length).toBe(2 * built);
  layer.update([{ topology: square(2, 2, true), vertices: at(3), colour: '#445566' }]);
  expect(reserve.mock.calls.length).toBe(3 * built);
  reserve.mockRestore();
  layer.dispose();
});
