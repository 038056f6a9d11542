import { defineConfig } from 'vite';

export default defineConfig({
  base: './',
  // Vite's development server would move the package's file away from its muster.wasm.
  optimizeDeps: { exclude: ['muster-engine'] },
  build: { target: 'es2022' },
});
