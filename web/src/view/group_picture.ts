// Meshes and places of all groups as they lie in the newest frame.

import type { GroupMeshView, GroupView } from './frame_types';
import { type InstancedRings, kRing } from './instanced_rings';
import type { MeshLayer, ShownMesh } from './mesh_layer';
import { makeTopology, type MeshTopology } from './mesh_topology';
import type { MeshTarget } from './picker';

/** Places are rings of this radius [m]. */
const kPlaceRadius = 0.24;
const kPlaceAlpha = 0.5;

export class GroupPicture {
  /** By group id and version: the last few, since frames may be dropped. */
  private readonly topologies_ = new Map<string, MeshTopology>();
  private groups_: readonly GroupView[] = [];

  clear(): void {
    this.topologies_.clear();
    this.groups_ = [];
  }

  setMesh(mesh: GroupMeshView): void {
    this.topologies_.set(`${mesh.group}:${mesh.version}`, makeTopology(mesh));
    this.topologies_.delete(`${mesh.group}:${mesh.version - 3}`);
  }

  /** Takes the groups of the newest frame: the mesh is held by fingers and waits for no other frame. */
  update(groups: readonly GroupView[]): void {
    this.groups_ = groups;
  }

  /** The mesh of each group as shown; null where its shape has not come yet. */
  targets(): (MeshTarget | null)[] {
    return this.groups_.map((group) => {
      const topology = this.topologies_.get(`${group.id}:${group.meshVersion}`);
      return topology && group.vertices.length > 0 ? { topology, vertices: group.vertices } : null;
    });
  }

  /** Hands the meshes to their layer; `accents` are the groups' colours. */
  showMeshes(layer: MeshLayer, visible: boolean, accents: readonly string[]): void {
    const shown: ShownMesh[] = [];
    if (visible) {
      this.targets().forEach((target, index) => {
        if (target) shown.push({ ...target, colour: accents[index] ?? '#808080' });
      });
    }
    layer.update(shown);
  }

  /** Draws places as rings, and those to come dashed. */
  showPlaces(rings: InstancedRings, visible: boolean, accents: readonly string[],
             previews: ReadonlyMap<number, ArrayLike<number>>): void {
    const sets = visible ? this.groups_.map((group) => group.places) : [];
    let count = sets.reduce((sum, places) => sum + places.length / 2, 0);
    for (const places of previews.values()) count += places.length / 2;
    rings.begin(count);
    sets.forEach((places, index) => {
      rings.setTint(accents[index] ?? '#808080');
      const fit = this.groups_[index]?.fit;
      for (let i = 0; i + 1 < places.length; i += 2) {
        const fits = (fit?.[i / 2] ?? 1) !== 0;
        rings.add(places[i] ?? 0, places[i + 1] ?? 0, kPlaceRadius, fits ? kRing.whole : kRing.crossed, kPlaceAlpha);
      }
    });
    for (const [group, places] of previews) {
      rings.setTint(accents[group] ?? '#808080');
      for (let i = 0; i + 1 < places.length; i += 2) {
        rings.add(places[i] ?? 0, places[i + 1] ?? 0, kPlaceRadius, kRing.dashed, 0.95);
      }
    }
    rings.end();
  }
}
