// Draws pictures of a crowd onto a canvas.

import { kEarthColour, kSkyColour, kSunColour } from '../../scene/drawing/daylight';
import type { Theme } from '../../model/view_settings';
import type { CrowdMoment } from '../play/crowd_moment';
import type { LoadedCrowd } from '../file/loaded_crowd';
import type { ViewCamera } from '../play/view_camera';
import { CrowdPart } from './crowd_part';
import { CannotDraw, makeProgram, type Gl, type Program } from './gl';
import { linear, playerPalette, type PlayerPalette } from './player_palette';
import { ScenePart } from './scene_part';
import * as shaders from './shaders';
import { ShadowMap } from './shadow_map';

export class Stage {
  /** False: without shadows and fine bodies, for browsers that draw without a graphics card. */
  fine = true;
  private readonly gl_: Gl;
  private readonly sceneProgram_: Program;
  private readonly bodyProgram_: Program;
  private readonly discProgram_: Program;
  private readonly sceneDepth_: Program;
  private readonly bodyDepth_: Program;
  private readonly scene_: ScenePart;
  private readonly crowd_: CrowdPart;
  private readonly shadow_: ShadowMap;
  private palette_: PlayerPalette;

  /** Throws CannotDraw where the browser cannot. */
  constructor(
    readonly canvas: HTMLCanvasElement,
    private readonly loaded_: LoadedCrowd,
    theme: Theme,
  ) {
    const gl = canvas.getContext('webgl2', { antialias: true, alpha: false, powerPreference: 'low-power' });
    if (!gl) throw new CannotDraw('this browser has no WebGL 2');
    this.gl_ = gl;
    const { kSceneAttributes, kBodyAttributes, kDepthFragment } = shaders;
    this.sceneProgram_ = makeProgram(gl, shaders.kSceneVertex, shaders.kSceneFragment, kSceneAttributes);
    this.bodyProgram_ = makeProgram(gl, shaders.kBodyVertex, shaders.kBodyFragment, kBodyAttributes);
    this.discProgram_ = makeProgram(gl, shaders.kDiscVertex, shaders.kDiscFragment, ['aAt', 'iPlace']);
    this.sceneDepth_ = makeProgram(gl, shaders.kSceneDepthVertex, kDepthFragment, kSceneAttributes);
    this.bodyDepth_ = makeProgram(gl, shaders.kBodyDepthVertex, kDepthFragment, kBodyAttributes);
    this.scene_ = new ScenePart(gl, loaded_.scene);
    this.crowd_ = new CrowdPart(gl, loaded_);
    this.shadow_ = new ShadowMap(gl);
    this.palette_ = playerPalette(theme);
    this.setTheme(theme);
  }

  get lost(): boolean {
    return this.gl_.isContextLost();
  }

  setTheme(theme: Theme): void {
    this.palette_ = playerPalette(theme);
    this.crowd_.setTheme(theme);
  }

  /** Draws one picture. `pixel`: device pixels per CSS pixel. */
  draw(moment: CrowdMoment, camera: ViewCamera, pixel: number): void {
    const gl = this.gl_;
    const { width, height } = this.canvas;
    this.crowd_.prepare(moment, camera, height / pixel, this.fine);
    gl.enable(gl.DEPTH_TEST);
    gl.enable(gl.CULL_FACE);
    gl.disable(gl.BLEND);
    gl.depthMask(true);
    if (this.fine) this.drawShadows(moment, camera);
    gl.viewport(0, 0, width, height);
    const background = this.palette_.outside;
    const [r, g, b] = [0, 1, 2].map((k) => encoded(background[k]!)) as [number, number, number];
    gl.clearColor(r, g, b, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    const view = camera.matrix();
    this.useScene(view, pixel);
    this.scene_.drawSolid(this.sceneProgram_, moment.things);
    this.drawDiscs(view);
    this.use(this.bodyProgram_, view);
    gl.uniform3fv(this.bodyProgram_.at('uTrousers'), this.palette_.trousers);
    this.crowd_.drawBodies(this.bodyProgram_);
    this.useScene(view, pixel);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
    gl.depthMask(false);
    this.scene_.drawSeeThrough(this.sceneProgram_, moment.things);
    gl.depthMask(true);
  }

  /** Gives the graphics card back what it holds; the canvas cannot be drawn on afterwards. */
  release(): void {
    this.gl_.getExtension('WEBGL_lose_context')?.loseContext();
  }

  private drawShadows(moment: CrowdMoment, camera: ViewCamera): void {
    const gl = this.gl_;
    this.shadow_.follow(camera, this.loaded_.head.box);
    this.shadow_.fill(() => {
      gl.useProgram(this.sceneDepth_.handle);
      gl.uniformMatrix4fv(this.sceneDepth_.at('uView'), false, this.shadow_.matrix);
      this.scene_.drawShadows(this.sceneDepth_, moment.things);
      gl.useProgram(this.bodyDepth_.handle);
      gl.uniformMatrix4fv(this.bodyDepth_.at('uView'), false, this.shadow_.matrix);
      this.crowd_.drawShadows(this.bodyDepth_);
    });
  }

  private drawDiscs(view: Float32Array): void {
    const gl = this.gl_;
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
    gl.depthMask(false);
    gl.useProgram(this.discProgram_.handle);
    gl.uniformMatrix4fv(this.discProgram_.at('uView'), false, view);
    gl.uniform1f(this.discProgram_.at('uStrength'), this.palette_.disc);
    this.crowd_.drawDiscs();
    gl.depthMask(true);
    gl.disable(gl.BLEND);
  }

  private use(program: Program, view: Float32Array): void {
    const gl = this.gl_;
    const { sun, sky } = this.palette_;
    // A matt surface sends back 1/pi of what falls on it.
    const set = (name: string, hex: string, strength: number): void =>
      gl.uniform3fv(
        program.at(name),
        linear(hex).map((part) => (part * strength) / Math.PI),
      );
    gl.useProgram(program.handle);
    gl.uniformMatrix4fv(program.at('uView'), false, view);
    set('uSun', kSunColour, sun);
    set('uSky', kSkyColour, sky);
    set('uEarth', kEarthColour, sky);
    gl.uniform1f(program.at('uShadows'), this.fine ? 1 : 0);
    gl.uniformMatrix4fv(program.at('uShadow'), false, this.shadow_.matrix);
    gl.activeTexture(gl.TEXTURE1);
    gl.bindTexture(gl.TEXTURE_2D, this.shadow_.texture);
    gl.uniform1i(program.at('uDepth'), 1);
    gl.activeTexture(gl.TEXTURE0);
  }

  private useScene(view: Float32Array, pixel: number): void {
    const gl = this.gl_;
    const [program, palette] = [this.sceneProgram_, this.palette_];
    this.use(program, view);
    gl.uniform4fv(program.at('uFinishes'), palette.finishes);
    gl.uniform4fv(program.at('uBox'), this.loaded_.head.box);
    gl.uniform3fv(program.at('uGround'), palette.ground);
    gl.uniform3fv(program.at('uOutside'), palette.outside);
    gl.uniform3fv(program.at('uFine'), palette.fine);
    gl.uniform3fv(program.at('uCoarse'), palette.coarse);
    gl.uniform3fv(program.at('uEdge'), palette.edge);
    gl.uniform1f(program.at('uKeeps'), palette.shadowKeeps);
    gl.uniform1f(program.at('uPixel'), pixel);
  }
}

function encoded(v: number): number {
  return v <= 0.0031308 ? v * 12.92 : 1.055 * v ** (1 / 2.4) - 0.055;
}
