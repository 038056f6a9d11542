import { loadMuster } from './node_modules/muster-engine/dist/index.js';
import { play } from './plain.js';

self.onmessage = async ({ data: { wasm, files, runs } }) => {
  self.postMessage(play(await loadMuster({ wasm }), files, runs));
};
