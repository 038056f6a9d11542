import { defineConfig } from 'vite';

// The player for other pages: one file without imports and exports, which works as a module, as a plain script, and written into a page.
export default defineConfig({
  publicDir: false,
  build: {
    outDir: 'dist/player',
    emptyOutDir: false,
    target: 'es2022',
    sourcemap: false,
    lib: { entry: 'src/player/index.ts', formats: ['iife'], name: 'musterPlayer', fileName: () => 'muster-player.js' },
  },
});
