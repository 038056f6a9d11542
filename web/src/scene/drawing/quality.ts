// Quality of the pictures: software renderers draw without multisampling and shadow maps.

export type Quality = 'full' | 'light';

const kSoftware = /llvmpipe|softpipe|swiftshader|software|basic render/i;

/** The quality that suits a renderer by its name. */
export function qualityOf(renderer: string): Quality {
  return kSoftware.test(renderer) ? 'light' : 'full';
}

/** `?quality=full` or `light` in the page's address decides; else the renderer's name. */
export function chooseQuality(search: string, renderer: () => string): Quality {
  const wanted = new URLSearchParams(search).get('quality');
  return wanted === 'full' || wanted === 'light' ? wanted : qualityOf(renderer());
}

/** The name of the renderer behind WebGL; empty where the browser hides it. */
export function rendererName(): string {
  const gl = document.createElement('canvas').getContext('webgl2');
  if (!gl) return '';
  const info = gl.getExtension('WEBGL_debug_renderer_info');
  const name: unknown = info ? gl.getParameter(info.UNMASKED_RENDERER_WEBGL) : '';
  gl.getExtension('WEBGL_lose_context')?.loseContext();
  return typeof name === 'string' ? name : '';
}
