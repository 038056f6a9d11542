// Meshes and places of all groups in the newest frame, and which of them the layers show already.

import { hasNoPlaces } from '../../model/goals';
import type { GroupMeshView, GroupView } from '../../model/frame_view';
import { type PlaceLayer, kRing } from './place_layer';
import type { MeshLayer, ShownMesh } from './mesh_layer';
import { makeTopology, type MeshTopology } from './mesh_topology';

const kPlaceAlpha = 0.5;
const kComingAlpha = 0.95;
/** New places are dashed for this long: a formation appears before the crowd has taken it [ms]. */
const kComing = 600;

/** Which formation a group was last seen in, and since when [ms]. */
interface Formed {
  readonly version: number;
  readonly since: number;
}

/** What a layer shows. */
interface Shown {
  readonly groups: readonly GroupView[];
  readonly key: string;
}

function isSame(a: Shown | null, b: Shown): boolean {
  return a !== null && a.groups === b.groups && a.key === b.key;
}

export class GroupState {
  /** By group id and version: the last few, since frames may be dropped. */
  private readonly topologies_ = new Map<string, MeshTopology>();
  private readonly formed_ = new Map<number, Formed>();
  private groups_: readonly GroupView[] = [];
  /** Grows with each mesh that comes. */
  private meshes_ = 0;
  /** What the layers show now; nothing is uploaded twice. */
  private shownMeshes_: Shown | null = null;
  private shownPlaces_: Shown | null = null;

  clear(): void {
    this.topologies_.clear();
    this.formed_.clear();
    this.groups_ = [];
  }

  setMesh(mesh: GroupMeshView): void {
    this.meshes_ += 1;
    this.topologies_.set(`${mesh.group}:${mesh.version}`, makeTopology(mesh));
    this.topologies_.delete(`${mesh.group}:${mesh.version - 3}`);
  }

  /** Takes the groups of the newest frame. Meshes are not interpolated, as they follow fingers. */
  update(groups: readonly GroupView[]): void {
    this.groups_ = groups;
  }

  /** Hands the meshes to their layer, less those whose shape has not come yet; `accents` are the groups' colours. */
  showMeshes(layer: MeshLayer, visible: boolean, accents: readonly string[]): void {
    const wanted = { groups: this.groups_, key: `${visible}:${layer.insideSeen}:${this.meshes_}:${accents.join()}` };
    if (isSame(this.shownMeshes_, wanted)) return;
    this.shownMeshes_ = wanted;
    const shown: ShownMesh[] = [];
    this.groups_.forEach((group, index) => {
      const topology = this.topologies_.get(`${group.id}:${group.meshVersion}`);
      if (!visible || !topology || group.vertices.length === 0 || hasNoPlaces(group)) return;
      shown.push({ topology, vertices: group.vertices, colour: accents[index] ?? '#808080' });
    });
    layer.update(shown);
  }

  /** Draws places as rings: dashed while a formation is new, crossed where a character does not fit. */
  showPlaces(rings: PlaceLayer, visible: boolean, accents: readonly string[], now: number): void {
    const coming = this.groups_.map((group) => this.isComing(group, now));
    const wanted = { groups: this.groups_, key: `${visible}:${coming.join()}:${accents.join()}` };
    if (isSame(this.shownPlaces_, wanted)) return;
    this.shownPlaces_ = wanted;
    rings.begin(visible ? this.groups_.reduce((sum, group) => sum + group.places.length / 2, 0) : 0);
    if (visible) {
      this.groups_.forEach((group, index) => {
        if (hasNoPlaces(group)) return;
        const { places, fit } = group;
        rings.setTint(accents[index] ?? '#808080');
        const [standing, alpha] = coming[index] ? [kRing.dashed, kComingAlpha] : [kRing.whole, kPlaceAlpha];
        for (let i = 0; i + 1 < places.length; i += 2) {
          const fits = (fit[i / 2] ?? 1) !== 0;
          rings.add(places[i] ?? 0, places[i + 1] ?? 0, fits ? standing : kRing.crossed, alpha);
        }
      });
    }
    rings.end();
  }

  /** True for a while after a group took another formation or count; its first one stands at once. */
  private isComing(group: GroupView, now: number): boolean {
    const known = this.formed_.get(group.id);
    if (known?.version === group.meshVersion) return now - known.since < kComing;
    // A lower version is a world that began anew.
    const changed = known !== undefined && group.meshVersion > known.version;
    this.formed_.set(group.id, { version: group.meshVersion, since: changed ? now : -Infinity });
    return changed;
  }
}
