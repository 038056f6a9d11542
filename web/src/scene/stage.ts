// The three.js side of the view: renderer, light, and the layers that fill the scene.

import { Color, Group, PCFSoftShadowMap, PerspectiveCamera, Scene, Vector3, WebGLRenderer } from 'three';
import type { SceneryModel } from '../model/place_files/scenery';
import type { SceneBox } from '../protocol/messages';
import type { SceneFacts } from '../protocol/scene';
import type { CameraController } from './camera/camera_controller';
import { CrowdLayer } from './crowd/crowd_layer';
import type { FieldRaster } from './ground/field_raster';
import { GpuPace } from './gpu_pace';
import { GroundLayer } from './ground/ground_layer';
import { PlaceLayer } from './marks/place_layer';
import { MeshLayer } from './marks/mesh_layer';
import type { Palette } from './drawing/palette';
import { PlainGroundLayer } from './ground/plain_ground_layer';
import type { Quality } from './drawing/quality';
import type { ShadeUniforms } from './drawing/shade';
import { Sun } from './drawing/sun';
import type { Backdrop } from './studio_scene';
import type { ViewStats } from './picture_stats';
import { EnvironmentLayer } from './environment_layer';
import { SceneryLayer } from './scenery/scenery_layer';

/** Most device px per CSS px. */
const kMaxPixelRatio = 2;

/** Number of characters whose whole poses the page requests. */
const kWholePoses = 150;

const kNoBox: SceneBox = { min: [-16, -16], max: [16, 16] };

export class Stage {
  readonly crowd: CrowdLayer;
  readonly meshes = new MeshLayer();
  readonly places = new PlaceLayer();
  readonly environment: EnvironmentLayer;
  private readonly scenery_: SceneryLayer;
  private shown_: { readonly scene: SceneFacts; readonly palette: Palette } | null = null;
  private readonly ground_: GroundLayer;
  /** In light quality, where no field is painted on the ground. */
  private readonly plain_: PlainGroundLayer | null;
  private readonly sun_: Sun;
  private readonly renderer_: WebGLRenderer;
  private readonly scene_ = new Scene();
  /** All but people and light. */
  private readonly around_ = new Group();
  private backdrop_: Backdrop | null = null;
  private outside_ = new Color();
  private readonly eye_ = new PerspectiveCamera(24, 1, 1, 1000);
  private readonly shade_: ShadeUniforms = {
    uShadowKeeps: { value: 0.7 },
    uHatch: { value: new Color() },
  };
  private readonly floatLinear_: boolean;
  private box_ = kNoBox;
  private ratio_ = 1;
  /** Only where drawing is slow. */
  private readonly pace_: GpuPace | null;
  private maxRatio_ = kMaxPixelRatio;

  constructor(canvas: HTMLCanvasElement, quality: Quality) {
    const full = quality === 'full';
    this.crowd = new CrowdLayer(quality);
    this.sun_ = new Sun(quality);
    // Nothing shines through the scene, so the page need not blend it: three.js would ask for a canvas with alpha.
    const context = canvas.getContext('webgl2', {
      alpha: false,
      antialias: full,
      stencil: true,
      powerPreference: 'high-performance',
    });
    if (!context) throw new Error('This browser draws no WebGL 2.');
    this.renderer_ = new WebGLRenderer({ canvas, context, stencil: true });
    this.renderer_.shadowMap.enabled = full;
    this.renderer_.shadowMap.type = PCFSoftShadowMap;
    this.pace_ = full ? null : new GpuPace(context);
    this.plain_ = full ? null : new PlainGroundLayer();
    if (!full) this.maxRatio_ = 1;
    this.renderer_.info.autoReset = false;
    this.floatLinear_ = this.renderer_.extensions.has('OES_texture_float_linear');
    this.ground_ = new GroundLayer(this.shade_);
    this.ground_.mesh.visible = full;
    this.environment = new EnvironmentLayer(this.shade_);
    this.scenery_ = new SceneryLayer(this.shade_);
    this.eye_.up.set(0, 0, 1);
    this.around_.add(
      this.ground_.mesh,
      this.environment.group,
      this.scenery_.group,
      this.meshes.group,
      this.places.mesh,
    );
    if (this.plain_) this.around_.add(this.plain_.group);
    this.scene_.add(this.sun_.group, this.around_, this.crowd.group);
  }

  /** Device px per CSS px now. */
  get pixelRatio(): number {
    return this.ratio_;
  }

  resize(width: number, height: number): void {
    this.ratio_ = Math.min(window.devicePixelRatio || 1, this.maxRatio_);
    this.renderer_.setPixelRatio(this.ratio_);
    this.renderer_.setSize(width, height, false);
    const [w, h] = [width * this.ratio_, height * this.ratio_];
    this.environment.setSize(w, h, this.ratio_);
    this.meshes.setSize(w, h, this.ratio_);
    this.places.setPixelRatio(this.ratio_);
    this.ground_.setPixelRatio(this.ratio_);
    this.plain_?.setSize(w, h, this.ratio_);
  }

  setPalette(palette: Palette): void {
    this.ground_.setPalette(palette);
    this.plain_?.setPalette(palette);
    this.sun_.setPalette(palette);
    this.shade_.uShadowKeeps.value = palette.shadowKeeps;
    this.shade_.uHatch.value.set(palette.roofHatch);
    this.outside_ = new Color(palette.groundOutside);
    this.showBackdrop();
  }

  /** Puts something behind the crowd; null takes it away. */
  setBackdrop(backdrop: Backdrop | null): void {
    for (const object of this.backdrop_?.objects ?? []) this.scene_.remove(object);
    this.backdrop_?.dispose();
    this.backdrop_ = backdrop;
    for (const object of backdrop?.objects ?? []) this.scene_.add(object);
    this.environment.solidAlways = backdrop !== null;
    this.showBackdrop();
  }

  private showBackdrop(): void {
    this.scene_.background = this.backdrop_?.colour ?? this.outside_;
    this.around_.visible = !this.backdrop_?.peopleOnly;
    this.crowd.setShadows(this.backdrop_?.shadows ?? true);
  }

  setScene(scene: SceneFacts, palette: Palette): void {
    this.box_ = scene.box;
    this.ground_.setBox(scene.box);
    this.plain_?.setBox(scene.box);
    this.shown_ = { scene, palette };
    this.environment.build(this.scenery_.without(scene), palette);
  }

  /** Imported models, in place of the obstacles that they came to. */
  setScenery(models: readonly SceneryModel[]): void {
    this.scenery_.set(models);
    if (this.shown_) this.setScene(this.shown_.scene, this.shown_.palette);
  }

  setField(picture: FieldRaster | null): void {
    this.ground_.setField(picture, this.floatLinear_);
    if (!this.plain_) return;
    this.ground_.mesh.visible = picture !== null;
    this.plain_.group.visible = picture === null;
  }

  /** Whole poses that this quality shows. */
  get wholePoses(): number {
    return this.pace_ ? 0 : kWholePoses;
  }

  /** True where `GpuPace` spaces the pictures, as software renders them. */
  get paced(): boolean {
    return this.pace_ !== null;
  }

  /** True while the last picture is still being drawn and another would only wait behind it; see GpuPace. */
  busy(urgent: boolean): boolean {
    return this.pace_?.busy(performance.now(), urgent) ?? false;
  }

  /** Draws the scene as the camera sees it and counts what that took. */
  render(camera: CameraController, stats: ViewStats): void {
    const { eye, forward, up } = camera.basis();
    this.eye_.fov = (camera.fieldOfView * 180) / Math.PI;
    this.eye_.aspect = camera.width / camera.height;
    this.eye_.near = Math.max(0.3, camera.pose.distance * 0.12);
    this.eye_.far = camera.pose.distance * 14 + 400;
    this.eye_.position.set(eye[0], eye[1], eye[2]);
    this.eye_.up.set(up[0], up[1], up[2]);
    this.eye_.lookAt(new Vector3(eye[0] + forward[0], eye[1] + forward[1], eye[2] + forward[2]));
    this.eye_.updateProjectionMatrix();
    this.sun_.follow(camera, this.box_);
    this.plain_?.setScale(camera.pixelsPerMetre());
    this.renderer_.info.reset();
    this.renderer_.render(this.scene_, this.eye_);
    stats.drawCalls = this.renderer_.info.render.calls;
    stats.triangles = this.renderer_.info.render.triangles;
    this.pace_?.sent(performance.now());
  }

  dispose(): void {
    for (const part of [this.crowd, this.meshes, this.places, this.environment, this.scenery_, this.ground_, this.sun_])
      part.dispose();
    this.plain_?.dispose();
    this.renderer_.dispose();
  }
}
