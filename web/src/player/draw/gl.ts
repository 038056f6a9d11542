// Programs, buffers and textures of WebGL 2.

export type Gl = WebGL2RenderingContext;

/** Thrown where this browser or its graphics card cannot draw. */
export class CannotDraw extends Error {}

/** A program and its uniforms by name. */
export interface Program {
  readonly handle: WebGLProgram;
  readonly at: (name: string) => WebGLUniformLocation | null;
}

const kHead = '#version 300 es\nprecision highp float;\nprecision highp int;\n';

export function makeProgram(gl: Gl, vertex: string, fragment: string, attributes: readonly string[]): Program {
  const handle = gl.createProgram();
  for (const [type, text] of [
    [gl.VERTEX_SHADER, vertex],
    [gl.FRAGMENT_SHADER, fragment],
  ] as const) {
    const shader = gl.createShader(type);
    if (!shader) throw new CannotDraw('the graphics card gives no shader');
    gl.shaderSource(shader, kHead + text);
    gl.compileShader(shader);
    gl.attachShader(handle, shader);
    gl.deleteShader(shader);
  }
  attributes.forEach((name, index) => gl.bindAttribLocation(handle, index, name));
  gl.linkProgram(handle);
  if (!gl.getProgramParameter(handle, gl.LINK_STATUS) && !gl.isContextLost()) {
    const said = (gl.getAttachedShaders(handle) ?? []).map((shader) => gl.getShaderInfoLog(shader)).join(' ');
    throw new CannotDraw(`the graphics card refuses a shader: ${said} ${gl.getProgramInfoLog(handle) ?? ''}`);
  }
  const places = new Map<string, WebGLUniformLocation | null>();
  const at = (name: string): WebGLUniformLocation | null => {
    if (!places.has(name)) places.set(name, gl.getUniformLocation(handle, name));
    return places.get(name)!;
  };
  return { handle, at };
}

/** An attribute: index, numbers per vertex, what they are. */
export interface Attribute {
  readonly index: number;
  readonly size: number;
  readonly data: Float32Array | Uint8Array;
  /** Whole numbers 0 to 255 as shares of 1. */
  readonly shares?: boolean;
  readonly integer?: boolean;
}

/** Makes a buffer and lets an attribute of the bound vertex array read it. */
export function addAttribute(gl: Gl, { index, size, data, shares, integer }: Attribute): WebGLBuffer {
  const buffer = gl.createBuffer();
  gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
  gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
  gl.enableVertexAttribArray(index);
  const type = data instanceof Float32Array ? gl.FLOAT : gl.UNSIGNED_BYTE;
  if (integer) gl.vertexAttribIPointer(index, size, type, 0, 0);
  else gl.vertexAttribPointer(index, size, type, shares ?? false, 0, 0);
  return buffer;
}

/** A texture whose texels are read one by one. */
export function makeTexture(gl: Gl, format: GLenum, width: number, height: number): WebGLTexture {
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texStorage2D(gl.TEXTURE_2D, 1, format, width, height);
  for (const side of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, side, gl.NEAREST);
  for (const side of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, side, gl.CLAMP_TO_EDGE);
  return texture;
}
