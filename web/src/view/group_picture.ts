// Meshes and places of all groups as they lie between two frames.

import { mixNumbers } from './blend';
import type { FrameBlend } from './frame_timeline';
import type { GroupMeshView, GroupView } from './frame_types';
import { type InstancedRings, kRing } from './instanced_rings';
import type { MeshLayer, ShownMesh } from './mesh_layer';
import { makeTopology, type MeshTopology } from './mesh_topology';
import type { MeshTarget } from './picker';

/** Places are rings of this radius [m]. */
const kPlaceRadius = 0.24;
const kPlaceAlpha = 0.5;

export class GroupPicture {
  /** By group id and version: the last few, since the display runs behind. */
  private readonly topologies_ = new Map<string, MeshTopology>();
  private readonly vertices_: Float32Array[] = [];
  private readonly places_: Float32Array[] = [];
  private groups_: readonly GroupView[] = [];

  clear(): void {
    this.topologies_.clear();
    this.groups_ = [];
  }

  setMesh(mesh: GroupMeshView): void {
    this.topologies_.set(`${mesh.group}:${mesh.version}`, makeTopology(mesh));
    this.topologies_.delete(`${mesh.group}:${mesh.version - 3}`);
  }

  /** Moves to a moment between two frames. */
  update(blend: FrameBlend): void {
    this.groups_ = blend.to.groups;
    blend.to.groups.forEach((group, index) => {
      const before = blend.from.groups[index];
      const same = before !== undefined && before.id === group.id && before.meshVersion === group.meshVersion;
      const from = same ? before : group;
      this.vertices_[index] = mixNumbers(from.vertices, group.vertices, blend.alpha, this.vertices_[index] ?? kEmpty);
      this.places_[index] = mixNumbers(from.places, group.places, blend.alpha, this.places_[index] ?? kEmpty);
    });
  }

  /** The mesh of each group as shown; null where its shape has not come yet. */
  targets(): (MeshTarget | null)[] {
    return this.groups_.map((group, index) => {
      const topology = this.topologies_.get(`${group.id}:${group.meshVersion}`);
      const vertices = this.vertices_[index];
      return topology && vertices && vertices.length > 0 ? { topology, vertices } : null;
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
    const sets = visible ? this.groups_.map((_, index) => this.places_[index] ?? kEmpty) : [];
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

const kEmpty = new Float32Array(0);
