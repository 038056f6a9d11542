// The environment: obstacles, patches, areas, items and checkpoints.

import {
  type BufferGeometry,
  Group,
  InstancedMesh,
  Matrix4,
  Mesh,
  type MeshLambertMaterial,
  type Material,
  type ShaderMaterial,
} from 'three';
import type { Vec2 } from '../protocol/generated/commands';
import type { SceneObstacle, ScenePatch } from '../protocol/messages';
import { isMoving, type SceneFacts } from '../protocol/scene';
import { mix, mixAngle } from './drawing/blend';
import type { CameraController } from './camera/camera_controller';
import { FatLines } from './drawing/fat_lines';
import type { MovingView } from '../model/frame_view';
import { centroid, circlePoints, GeometryBuilder } from './drawing/geometry_builder';
import { addCar, addObstacle, type EdgeLine, lookOfObstacle, outlineOf } from './obstacles/obstacle_geometry';
import { BuildingLayer } from './obstacles/building_layer';
import { outerEdges } from './obstacles/outer_edges';
import { kOpeningOrder, openingMaterial } from './drawing/openings';
import { addArea } from './patches/area_shapes';
import { addPatch } from './patches/patch_geometry';
import { emptyParts, type PatchParts, type TintedLine } from './patches/patch_parts';
import type { Palette } from './drawing/palette';
import { bodyMaterial, floorMaterial, seeThroughMaterial, type ShadeUniforms } from './drawing/shade';
import { type Standing, TreeLayer } from './obstacles/tree_layer';

/** A thing that moves: its parts hang on a group that turns about `centre`. */
interface MovingThing {
  readonly group: Group;
  readonly centre: Vec2;
}

function shifted(points: readonly Vec2[], centre: Vec2): Vec2[] {
  return points.map((p) => [p[0] - centre[0], p[1] - centre[1]] as const);
}

const kNobody: Standing = { someoneNear: () => false };

export class EnvironmentLayer {
  readonly group = new Group();
  private readonly body_: MeshLambertMaterial;
  private readonly floor_: ShaderMaterial;
  private readonly opening_ = openingMaterial();
  private readonly water_: MeshLambertMaterial;
  private readonly leaves_: MeshLambertMaterial;
  private readonly moving_ = new Map<string, MovingThing>();
  private readonly trees_ = new TreeLayer();
  private readonly buildings_: BuildingLayer;
  private lines_: FatLines[] = [];
  private items_: InstancedMesh | null = null;
  private itemCount_ = 0;
  private collectedKey_ = '';
  private scene_: SceneFacts | null = null;
  private solidAlways_ = false;
  private size_ = { width: 1, height: 1, ratio: 1 };

  constructor(shade: ShadeUniforms) {
    this.buildings_ = new BuildingLayer(shade);
    this.body_ = bodyMaterial(shade, false);
    this.floor_ = floorMaterial(shade);
    this.water_ = seeThroughMaterial(0.6);
    this.leaves_ = Object.assign(seeThroughMaterial(0.36), { depthWrite: true });
  }

  /** Builds everything anew in the palette's colours. */
  build(scene: SceneFacts, palette: Palette): void {
    this.clear();
    this.scene_ = scene;
    this.buildStillObstacles(scene, palette);
    this.trees_.build(
      scene.obstacles.filter((one) => !isMoving(one) && lookOfObstacle(one) === 'tree'),
      palette,
      this.body_,
    );
    this.group.add(this.trees_.group);
    for (const obstacle of scene.obstacles) if (isMoving(obstacle)) this.buildMovingObstacle(obstacle, palette);
    this.buildStillPatches(scene, palette);
    for (const patch of scene.patches) if (isMoving(patch)) this.buildMovingPatch(patch, scene, palette);
    this.buildItems(scene, palette);
    this.setSize(this.size_.width, this.size_.height, this.size_.ratio);
  }

  setSize(width: number, height: number, ratio: number): void {
    this.size_ = { width, height, ratio };
    for (const lines of this.lines_) lines.setSize(width, height, ratio);
  }

  /** Floors of patches are hidden while a field is painted on the ground. */
  set floorsVisible(visible: boolean) {
    this.floor_.visible = visible;
    this.opening_.visible = visible;
  }

  /** Moves obstacles and patches to a moment between two frames. */
  move(from: readonly MovingView[], to: readonly MovingView[], alpha: number): void {
    to.forEach((one, i) => {
      const thing = this.moving_.get(`${one.kind}:${one.id}`);
      if (!thing) return;
      const earlier = from[i];
      const before = earlier && earlier.id === one.id && earlier.kind === one.kind ? earlier : one;
      // An obstacle whose path starts again jumps back; that is not interpolated.
      const jump = Math.hypot(one.x - before.x, one.y - before.y) > 2;
      const t = jump ? 1 : alpha;
      thing.group.position.set(thing.centre[0] + mix(before.x, one.x, t), thing.centre[1] + mix(before.y, one.y, t), 0);
      thing.group.rotation.z = mixAngle(before.angle, one.angle, t);
    });
  }

  /** Opacity of each still obstacle that is no tree, 0 to 1. */
  get solid(): readonly number[] {
    return this.buildings_.solid;
  }

  /** Nothing turns transparent, from now on. */
  set solidAlways(on: boolean) {
    this.solidAlways_ = on;
    if (on) for (const layer of [this.trees_, this.buildings_]) layer.solidify();
  }

  /** Makes crowns and buildings transparent that hide characters; true while they change. */
  reveal(crowd: Standing, camera: CameraController): boolean {
    const people = this.solidAlways_ ? kNobody : crowd;
    const trees = this.trees_.reveal(people, camera);
    return this.buildings_.reveal(people, camera) || trees;
  }

  /** Hides items that are gone; `collected` holds 1 per item gone. */
  setCollected(collected: ArrayLike<number>): void {
    const mesh = this.items_;
    const scene = this.scene_;
    if (!mesh || !scene) return;
    const key = Array.from(collected).join('');
    if (key === this.collectedKey_) return;
    this.collectedKey_ = key;
    const matrix = new Matrix4();
    for (let i = 0; i < this.itemCount_; ++i) {
      const item = scene.items[i];
      if (!item) continue;
      const size = collected[i] ? 0 : Math.max(0.22, Math.min(0.4, item.radius * 0.7));
      matrix.makeScale(size, size, size).setPosition(item.position[0], item.position[1], 0.55);
      mesh.setMatrixAt(i, matrix);
    }
    mesh.instanceMatrix.needsUpdate = true;
  }

  dispose(): void {
    this.clear();
    this.trees_.dispose();
    this.buildings_.dispose();
    for (const material of [this.body_, this.floor_, this.opening_, this.water_, this.leaves_]) material.dispose();
  }

  private clear(): void {
    this.trees_.clear();
    this.buildings_.clear();
    this.group.traverse((object) => {
      if (object instanceof Mesh) (object as Mesh<BufferGeometry>).geometry.dispose();
      // Instances of trees and items have buffers of their own.
      if (object instanceof InstancedMesh) object.dispose();
    });
    for (const lines of this.lines_) lines.dispose();
    this.items_ = null;
    this.collectedKey_ = '';
    this.lines_ = [];
    this.moving_.clear();
    this.group.clear();
  }

  private addMesh(parent: Group, builder: GeometryBuilder, material: Material, order: number, casts: boolean): void {
    if (builder.triangleCount === 0) return;
    const mesh = new Mesh(builder.build(), material);
    mesh.castShadow = casts;
    mesh.receiveShadow = true;
    mesh.renderOrder = order;
    parent.add(mesh);
  }

  private addLines(parent: Group, list: readonly TintedLine[], width: number, dash: number): void {
    if (list.length === 0) return;
    const lines = new FatLines({ width, dash, renderOrder: 2 });
    lines.reserve(list.length);
    list.forEach(({ line: [a, b], colour, alpha }, i) => {
      lines.setLine(i, a[0], a[1], a[2], b[0], b[1], b[2]);
      lines.setTint(i, colour, alpha);
    });
    lines.flush(true);
    this.lines_.push(lines);
    parent.add(lines.mesh);
  }

  private buildStillObstacles(scene: SceneFacts, palette: Palette): void {
    const builder = new GeometryBuilder();
    const edges: EdgeLine[] = [];
    const still = scene.obstacles.filter((one) => !isMoving(one) && lookOfObstacle(one) !== 'tree');
    const ends: number[] = [];
    for (const obstacle of still) {
      if (lookOfObstacle(obstacle) === 'car') this.addVehicle(builder, obstacle, outlineOf(obstacle), palette);
      else edges.push(...addObstacle(builder, obstacle, palette));
      ends.push(builder.triangleCount);
    }
    this.buildings_.build(builder, still, ends, palette.thinGlow);
    this.group.add(this.buildings_.group);
    const lines = outerEdges(edges).map((line) => ({ line, colour: palette.obstacleEdge, alpha: 0.8 }));
    this.addLines(this.group, lines, 1, 0);
  }

  private thing(kind: number, id: number, centre: Vec2): Group {
    const group = new Group();
    group.position.set(centre[0], centre[1], 0);
    this.moving_.set(`${kind}:${id}`, { group, centre });
    this.group.add(group);
    return group;
  }

  private buildMovingObstacle(obstacle: SceneObstacle, palette: Palette): void {
    const outline = outlineOf(obstacle);
    const centre = obstacle.polygon.length === 0 ? obstacle.centre : centroid(outline);
    const group = this.thing(0, obstacle.id, centre);
    const builder = new GeometryBuilder();
    const local = shifted(outline, centre);
    if (lookOfObstacle(obstacle) === 'car') {
      this.addVehicle(builder, obstacle, local, palette);
    } else {
      const still: SceneObstacle = { ...obstacle, polygon: local };
      const edges = addObstacle(builder, still, palette);
      this.addLines(
        group,
        edges.map((line) => ({ line, colour: palette.obstacleEdge, alpha: 0.8 })),
        1,
        0,
      );
    }
    this.addMesh(group, builder, this.body_, 0, true);
  }

  private addVehicle(
    builder: GeometryBuilder,
    obstacle: SceneObstacle,
    outline: readonly Vec2[],
    palette: Palette,
  ): void {
    const bodies = palette.carBodies;
    addCar(builder, outline, obstacle.height, bodies[obstacle.id % bodies.length] ?? '#888888', palette);
  }

  private buildStillPatches(scene: SceneFacts, palette: Palette): void {
    const parts = emptyParts();
    for (const patch of scene.patches) {
      if (!isMoving(patch)) addPatch(parts, patch, scene.clips[patch.motion]?.name ?? '', palette);
    }
    for (const area of scene.areas) addArea(parts, area, palette);
    for (const checkpoint of scene.checkpoints) {
      const circle = circlePoints(checkpoint.position[0], checkpoint.position[1], checkpoint.radius, 40);
      circle.forEach((a, i) => {
        const b = circle[(i + 1) % circle.length] as Vec2;
        parts.rim.push({
          line: [
            [a[0], a[1], 0.012],
            [b[0], b[1], 0.012],
          ],
          colour: palette.ink2,
          alpha: 0.7,
        });
      });
    }
    this.addParts(this.group, parts);
  }

  private buildMovingPatch(patch: ScenePatch, scene: SceneFacts, palette: Palette): void {
    const centre = centroid(patch.polygon);
    const parts = emptyParts();
    const local = { ...patch, polygon: shifted(patch.polygon, centre) };
    addPatch(parts, local, scene.clips[patch.motion]?.name ?? '', palette);
    this.addParts(this.thing(1, patch.id, centre), parts);
  }

  private addParts(parent: Group, parts: PatchParts): void {
    this.addMesh(parent, parts.floor, this.floor_, 1, false);
    this.addMesh(parent, parts.opening, this.opening_, kOpeningOrder, false);
    this.addMesh(parent, parts.solid, this.body_, 0, true);
    this.addMesh(parent, parts.water, this.water_, 1, false);
    this.addMesh(parent, parts.leaves, this.leaves_, 4, true);
    this.addLines(parent, parts.rim, 1.5, 0.5);
    this.addLines(parent, parts.lines, 1.25, 0);
  }

  private buildItems(scene: SceneFacts, palette: Palette): void {
    this.itemCount_ = scene.items.length;
    if (this.itemCount_ === 0) return;
    const builder = new GeometryBuilder();
    builder.frustum(0, 0, -1, 0, 0.001, 0.8, 6, palette.item, palette.item);
    builder.frustum(0, 0, 0, 1, 0.8, 0.001, 6, palette.item, palette.item);
    this.items_ = new InstancedMesh(builder.build(), this.body_, this.itemCount_);
    this.items_.castShadow = true;
    this.items_.frustumCulled = false;
    this.group.add(this.items_);
    this.setCollected([]);
  }
}
