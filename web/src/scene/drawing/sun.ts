// Light: a hemisphere and one sun, 52 degrees high from the far left of the opening view, with one shadow map.

import { DirectionalLight, Group, HemisphereLight, Vector3 } from 'three';
import type { CameraController } from '../camera/camera_controller';
import { kEarthColour, kSkyColour, kSunColour, kToSun } from './daylight';
import type { Palette } from './palette';
import type { Quality } from './quality';
import type { SceneBox } from '../../protocol/messages';

const kMapSize = 2048;
export class Sun {
  readonly group = new Group();
  private readonly sun_ = new DirectionalLight(kSunColour, 2.2);
  private readonly sky_ = new HemisphereLight(kSkyColour, kEarthColour, 1.3);
  private readonly toSun_ = new Vector3(...kToSun);
  private key_ = '';

  /** In light quality the sun throws no shadows. */
  constructor(quality: Quality) {
    this.sun_.castShadow = quality === 'full';
    this.sun_.shadow.mapSize.set(kMapSize, kMapSize);
    this.sun_.shadow.bias = -0.0004;
    this.sun_.shadow.normalBias = 0.02;
    this.sun_.shadow.radius = 2.5;
    this.sky_.position.set(0, 0, 1);
    this.group.add(this.sun_, this.sun_.target, this.sky_);
  }

  setPalette(palette: Palette): void {
    this.sun_.intensity = palette.sun;
    this.sky_.intensity = palette.sky;
  }

  /** Lays the shadow map over the ground in view, in steps, so that shadows do not shimmer while the camera moves. */
  follow(camera: CameraController, box: SceneBox): void {
    const corners = [
      [0, 0],
      [1, 0],
      [1, 1],
      [0, 1],
    ] as const;
    let minX = Infinity,
      minY = Infinity,
      maxX = -Infinity,
      maxY = -Infinity;
    for (const [u, v] of corners) {
      const at = camera.screenToGround({ x: u * camera.width, y: v * camera.height });
      if (!at) continue;
      const x = Math.min(box.max[0] + 12, Math.max(box.min[0] - 12, at.x));
      const y = Math.min(box.max[1] + 12, Math.max(box.min[1] - 12, at.y));
      minX = Math.min(minX, x);
      maxX = Math.max(maxX, x);
      minY = Math.min(minY, y);
      maxY = Math.max(maxY, y);
    }
    if (!(maxX > minX) || !(maxY > minY)) return;
    const reach = Math.max(8, Math.hypot(maxX - minX, maxY - minY) / 2 + 3);
    const radius = 1.18 ** Math.ceil(Math.log(reach) / Math.log(1.18));
    const texel = radius / 128;
    const x = Math.round((minX + maxX) / 2 / texel) * texel;
    const y = Math.round((minY + maxY) / 2 / texel) * texel;
    const key = `${x}:${y}:${radius}`;
    if (key === this.key_) return;
    this.key_ = key;
    this.place(x, y, radius);
  }

  private place(x: number, y: number, radius: number): void {
    const away = radius + 40;
    this.sun_.target.position.set(x, y, 0);
    this.sun_.position.copy(this.toSun_).multiplyScalar(away).add(this.sun_.target.position);
    const camera = this.sun_.shadow.camera;
    if (camera.right !== radius) {
      camera.left = -radius;
      camera.right = radius;
      camera.top = radius;
      camera.bottom = -radius;
      camera.near = 1;
      camera.far = 2 * away;
      camera.updateProjectionMatrix();
      this.sun_.shadow.normalBias = Math.min(0.12, 0.012 + radius * 0.0006);
    }
    this.sun_.target.updateMatrixWorld();
  }

  dispose(): void {
    this.sun_.dispose();
    this.sky_.dispose();
  }
}
