// Leaves out of three.js what the page never draws with: headsets, environment maps, materials other than its own. The page
// takes the sources of three.js, so that modules fall away, and shaders without comments and indents.

import { fileURLToPath } from 'node:url';
import type { Plugin } from 'vite';

const source = fileURLToPath(new URL('./node_modules/three/src/', import.meta.url));

const kNoMaps = (name: string): string =>
  `export class ${name} {
    get(texture) { return texture; }
    dispose() {}
  }`;

/** Modules that only headsets and environment maps need, and what the renderer asks of them. */
const kReplaced: Readonly<Record<string, string>> = {
  'renderers/webxr/WebXRManager.js': `
    import { EventDispatcher } from '${source}core/EventDispatcher.js';
    export class WebXRManager extends EventDispatcher {
      enabled = false;
      isPresenting = false;
      cameraAutoUpdate = false;
      getCamera() { return null; }
      hasDepthSensing() { return false; }
      getDepthSensingMesh() { return null; }
      getEnvironmentBlendMode() { return undefined; }
      setAnimationLoop() {}
      dispose() {}
    }`,
  'renderers/webgl/WebGLCubeMaps.js': kNoMaps('WebGLCubeMaps'),
  'renderers/webgl/WebGLCubeUVMaps.js': kNoMaps('WebGLCubeUVMaps'),
};

/** Shaders of materials that the page has none of, and the parts that only they include. */
const kUnusedShaders =
  /(ShaderLib\/(backgroundCube|cube|equirect|distanceRGBA|linedashed|meshmatcap|meshnormal|meshphong|meshphysical|meshtoon|points|sprite|vsm)|ShaderChunk\/(alphahash_|bsdfs|bumpmap_|clearcoat_|cube_uv_|displacementmap_|envmap_|gradientmap_|iridescence_|lights_phong_|lights_physical_|lights_toon_|lightmap_|metalnessmap_|morph|normalmap_|roughnessmap_|transmission_))\w*\.glsl\.js$/;

const withoutRemarks = (shader: string): string =>
  shader
    .replace(/\/\*[^]*?\*\//g, '')
    .replace(/[ \t]*\/\/.*$/gm, '')
    .replace(/^[ \t]+/gm, '')
    .replace(/\n{2,}/g, '\n');

export function leanThree(): Plugin {
  return {
    name: 'lean-three',
    apply: 'build',
    enforce: 'pre',
    config: () => ({ resolve: { alias: [{ find: /^three$/, replacement: `${source}Three.js` }] } }),
    load(id) {
      if (!id.startsWith(source)) return null;
      return kReplaced[id.slice(source.length)] ?? null;
    },
    transform(code, id) {
      if (!id.startsWith(source) || !id.endsWith('.glsl.js')) return null;
      const unused = kUnusedShaders.test(id);
      return code.replace(/`[^`]*`/g, (shader) => (unused ? '``' : withoutRemarks(shader)));
    },
  };
}
