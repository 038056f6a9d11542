// Imported models, drawn as they stand: one flat shaded mesh for each.

import { BufferAttribute, BufferGeometry, DoubleSide, Group, Mesh, type MeshLambertMaterial } from 'three';
import { shownBy, type SceneryModel } from '../../model/place_files/scenery';
import { isMoving, type SceneFacts } from '../../protocol/scene';
import { bodyMaterial, type ShadeUniforms } from '../drawing/shade';

/** Floors of models lie so far above the ground, or the two would flicker [m]. */
const kLift = 0.02;

function geometryOf({ positions, colours }: SceneryModel): BufferGeometry {
  const corners = positions.length / 3;
  const perCorner = new Uint8Array(3 * corners);
  for (let i = 0; i < corners; ++i)
    for (let k = 0; k < 3; ++k) perCorner[3 * i + k] = colours[3 * Math.floor(i / 3) + k]!;
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  geometry.setAttribute('color', new BufferAttribute(perCorner, 3, true));
  // Without an index each triangle has normals of its own.
  geometry.computeVertexNormals();
  return geometry;
}

export class SceneryLayer {
  readonly group = new Group();
  private readonly material_: MeshLambertMaterial;
  private models_: readonly SceneryModel[] = [];

  constructor(shade: ShadeUniforms) {
    this.material_ = bodyMaterial(shade, false);
    this.material_.side = DoubleSide;
  }

  set(models: readonly SceneryModel[]): void {
    this.clear();
    for (const model of models) {
      const mesh = new Mesh(geometryOf(model), this.material_);
      mesh.position.z = kLift;
      mesh.castShadow = true;
      mesh.receiveShadow = true;
      this.group.add(mesh);
    }
    this.models_ = models;
  }

  /** The scene without the obstacles that a model shows. */
  without(scene: SceneFacts): SceneFacts {
    if (this.models_.length === 0) return scene;
    const isShown = shownBy(this.models_);
    return { ...scene, obstacles: scene.obstacles.filter((one) => isMoving(one) || !isShown(one)) };
  }

  dispose(): void {
    this.clear();
    this.material_.dispose();
  }

  private clear(): void {
    for (const child of this.group.children)
      if (child instanceof Mesh) (child as Mesh<BufferGeometry>).geometry.dispose();
    this.group.clear();
  }
}
