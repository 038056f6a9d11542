// The sun's view of the ground that is seen: how far its light gets.

import type { Triple, ViewCamera } from '../play/view_camera';
import { CannotDraw, type Gl } from './gl';
import { kToSun } from '../../scene/drawing/daylight';

const kSize = 2048;
/** Around the ground with something on it [m]. */
const kMargin = 6;
const kStep = 1.18;

export class ShadowMap {
  readonly texture: WebGLTexture;
  matrix: Float32Array = new Float32Array(16);
  private readonly target_: WebGLFramebuffer;

  constructor(private readonly gl_: Gl) {
    this.texture = gl_.createTexture();
    gl_.bindTexture(gl_.TEXTURE_2D, this.texture);
    gl_.texStorage2D(gl_.TEXTURE_2D, 1, gl_.DEPTH_COMPONENT24, kSize, kSize);
    for (const side of [gl_.TEXTURE_MIN_FILTER, gl_.TEXTURE_MAG_FILTER])
      gl_.texParameteri(gl_.TEXTURE_2D, side, gl_.LINEAR);
    for (const side of [gl_.TEXTURE_WRAP_S, gl_.TEXTURE_WRAP_T])
      gl_.texParameteri(gl_.TEXTURE_2D, side, gl_.CLAMP_TO_EDGE);
    gl_.texParameteri(gl_.TEXTURE_2D, gl_.TEXTURE_COMPARE_MODE, gl_.COMPARE_REF_TO_TEXTURE);
    this.target_ = gl_.createFramebuffer();
    gl_.bindFramebuffer(gl_.FRAMEBUFFER, this.target_);
    gl_.framebufferTexture2D(gl_.FRAMEBUFFER, gl_.DEPTH_ATTACHMENT, gl_.TEXTURE_2D, this.texture, 0);
    const whole = gl_.checkFramebufferStatus(gl_.FRAMEBUFFER) === gl_.FRAMEBUFFER_COMPLETE || gl_.isContextLost();
    gl_.bindFramebuffer(gl_.FRAMEBUFFER, null);
    if (!whole) throw new CannotDraw('the graphics card draws no shadows');
  }

  /** Lays the map over what is in view, in steps, so that shadows do not shimmer while the camera moves. */
  follow(camera: ViewCamera, [left, near, right, far]: readonly [number, number, number, number]): void {
    const seen = [-1, 1].flatMap((x) => [-1, 1].map((y) => camera.ground(x, y)));
    const xs = seen.map((p) => Math.min(right + kMargin, Math.max(left - kMargin, p?.[0] ?? camera.target[0])));
    const ys = seen.map((p) => Math.min(far + kMargin, Math.max(near - kMargin, p?.[1] ?? camera.target[1])));
    const [minX, maxX, minY, maxY] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
    const reach = Math.max(6, Math.hypot(maxX - minX, maxY - minY) / 2 + 2);
    const radius = kStep ** Math.ceil(Math.log(reach) / Math.log(kStep));
    const texel = radius / 128;
    const x = Math.round((minX + maxX) / 2 / texel) * texel;
    const y = Math.round((minY + maxY) / 2 / texel) * texel;
    this.matrix = sunMatrix(x, y, radius);
  }

  /** Draws depths by `draw`. */
  fill(draw: () => void): void {
    const gl = this.gl_;
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.target_);
    gl.viewport(0, 0, kSize, kSize);
    gl.clear(gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.POLYGON_OFFSET_FILL);
    gl.polygonOffset(1.5, 3);
    draw();
    gl.disable(gl.POLYGON_OFFSET_FILL);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  }
}

/** A parallel view from the sun onto a circle of ground. */
function sunMatrix(x: number, y: number, radius: number): Float32Array {
  const [sx, sy, sz] = kToSun;
  const flat = Math.hypot(sx, sy);
  const right: Triple = [-sy / flat, sx / flat, 0];
  const up: Triple = [-sz * right[1], sz * right[0], sx * right[1] - sy * right[0]];
  const depth = radius + 30;
  const m = new Float32Array(16);
  for (let k = 0; k < 3; ++k) {
    m[4 * k] = right[k]! / radius;
    m[4 * k + 1] = up[k]! / radius;
    m[4 * k + 2] = -kToSun[k]! / depth;
  }
  m[12] = -(right[0] * x + right[1] * y) / radius;
  m[13] = -(up[0] * x + up[1] * y) / radius;
  m[14] = (sx * x + sy * y) / depth;
  m[15] = 1;
  return m;
}
