// The crowd on the graphics card: poses as a texture, bodies by kind and level of detail, and a soft shade under each.

import { lookOf, sizeOf } from '../../scene/crowd/look';
import type { Theme } from '../../model/view_settings';
import type { CrowdMoment } from '../play/crowd_moment';
import type { LoadedCrowd } from '../file/loaded_crowd';
import { kJointFloats, PoseBank } from '../play/pose_bank';
import type { ViewCamera } from '../play/view_camera';
import { addInstances, BodyPart, kInstanceFloats } from './body_part';
import { addAttribute, makeTexture, type Gl, type Program } from './gl';
import { shirtColour } from './player_palette';

/** Poses side by side in the texture. */
const kWidth = 2048;
/** Bodies are fine where a metre takes so many pixels, for so many of them. */
const kFinePixels = 15;
const kMostFine = 300;
/** Who is so far outside of the picture is not drawn: shares of half of it. */
const kMargin = 1.25;

export class CrowdPart {
  private readonly bank_: PoseBank;
  private readonly parts_: readonly ({
    readonly fine: BodyPart;
    readonly coarse: BodyPart;
    readonly thrown: BodyPart;
  } | null)[];
  private readonly texels_: number;
  private readonly across_: number;
  private readonly bones_: Float32Array;
  private readonly texture_: WebGLTexture;
  private readonly discs_: { vertices: WebGLVertexArrayObject; buffer: WebGLBuffer; data: Float32Array; count: number };
  private readonly instance_ = new Float32Array(kInstanceFloats);
  private shirts_: readonly Float32Array[] = [];

  constructor(
    private readonly gl_: Gl,
    private readonly loaded_: LoadedCrowd,
  ) {
    const { figures, clips, head } = loaded_;
    const most = Math.max(1, head.most);
    this.bank_ = new PoseBank(figures.skeleton, clips);
    this.parts_ = figures.bodies.map(
      (body) =>
        body && {
          fine: new BodyPart(gl_, body.fine, Math.min(most, kMostFine)),
          coarse: new BodyPart(gl_, body.coarse, most),
          thrown: new BodyPart(gl_, body.coarse, most),
        },
    );
    this.texels_ = (kJointFloats / 4) * this.bank_.joints;
    this.across_ = Math.floor(kWidth / this.texels_);
    const rows = Math.ceil(most / this.across_);
    this.bones_ = new Float32Array(4 * kWidth * rows);
    this.texture_ = makeTexture(gl_, gl_.RGBA32F, kWidth, rows);
    this.discs_ = this.makeDiscs(most);
  }

  setTheme(theme: Theme): void {
    this.shirts_ = this.loaded_.head.colours.map((colour) => shirtColour(theme, colour));
  }

  /** Prepares a picture of that height [px]. `fine`: with fine bodies for those who are near. */
  prepare(moment: CrowdMoment, camera: ViewCamera, height: number, fine: boolean): void {
    for (const part of this.parts_) for (const one of part ? [part.fine, part.coarse, part.thrown] : []) one.count = 0;
    this.discs_.count = 0;
    const view = camera.matrix();
    const pixels = height / (2 * camera.slope);
    let left = fine ? kMostFine : 0;
    for (let i = 0; i < moment.count; ++i) {
      const part = this.parts_[this.loaded_.crowd.people[moment.who[i]!]!.body];
      if (!part) continue;
      const [x, y] = [moment.x[i]!, moment.y[i]!];
      const away = view[3]! * x + view[7]! * y + view[11]! + view[15]!;
      const across = Math.abs(view[0]! * x + view[4]! * y + view[12]!);
      const along = Math.abs(view[1]! * x + view[5]! * y + view[9]! + view[13]!);
      this.fill(moment, i);
      part.thrown.add(this.instance_);
      if (away <= 0 || across > kMargin * away + 2 || along > kMargin * away + 2) continue;
      this.discs_.data.set(this.instance_, kInstanceFloats * this.discs_.count++);
      const near = left > 0 && pixels / away >= kFinePixels;
      if (near) --left;
      (near ? part.fine : part.coarse).add(this.instance_);
    }
    this.send(moment.count);
  }

  drawBodies(program: Program): void {
    this.bind(program);
    for (const part of this.parts_) {
      part?.fine.draw();
      part?.coarse.draw();
    }
  }

  drawShadows(program: Program): void {
    this.bind(program);
    for (const part of this.parts_) part?.thrown.draw();
  }

  drawDiscs(): void {
    const gl = this.gl_;
    gl.bindVertexArray(this.discs_.vertices);
    gl.drawArraysInstanced(gl.TRIANGLE_FAN, 0, 4, this.discs_.count);
    gl.bindVertexArray(null);
  }

  private bind(program: Program): void {
    const gl = this.gl_;
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, this.texture_);
    gl.uniform1i(program.at('uBones'), 0);
    gl.uniform1i(program.at('uAcross'), this.across_);
    gl.uniform1i(program.at('uTexels'), this.texels_);
  }

  private fill(moment: CrowdMoment, i: number): void {
    const person = this.loaded_.crowd.people[moment.who[i]!]!;
    const look = lookOf(person.id);
    const shirt = this.shirts_[moment.colour[i]!];
    const out = this.instance_;
    out[0] = moment.x[i]!;
    out[1] = moment.y[i]!;
    out[2] = moment.yaw[i]!;
    out[3] = sizeOf(person.id) * person.scale;
    if (shirt) out.set(shirt, 4);
    out[7] = i;
    out[8] = look.skin;
    out[9] = look.hair;
    const at = 4 * (kWidth * Math.floor(i / this.across_) + this.texels_ * (i % this.across_));
    const { clip, time, fromClip, fromTime, fade } = moment;
    this.bank_.write(clip[i]!, time[i]!, fromClip[i]!, fromTime[i]!, fade[i]!, this.bones_, at);
  }

  private send(count: number): void {
    const gl = this.gl_;
    for (const part of this.parts_) for (const one of part ? [part.fine, part.coarse, part.thrown] : []) one.send();
    gl.bindBuffer(gl.ARRAY_BUFFER, this.discs_.buffer);
    gl.bufferSubData(gl.ARRAY_BUFFER, 0, this.discs_.data, 0, kInstanceFloats * this.discs_.count);
    gl.bindTexture(gl.TEXTURE_2D, this.texture_);
    const rows = Math.ceil(count / this.across_);
    if (rows > 0) gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, kWidth, rows, gl.RGBA, gl.FLOAT, this.bones_);
  }

  private makeDiscs(most: number): CrowdPart['discs_'] {
    const gl = this.gl_;
    const vertices = gl.createVertexArray();
    gl.bindVertexArray(vertices);
    addAttribute(gl, { index: 0, size: 2, data: Float32Array.of(-1, -1, 1, -1, 1, 1, -1, 1) });
    const data = new Float32Array(kInstanceFloats * most);
    const buffer = addInstances(gl, 1, data.byteLength);
    gl.bindVertexArray(null);
    return { vertices, buffer, data, count: 0 };
  }
}
