import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vitest/config';
import { leanThree } from './lean_three';
import { plainFont } from './plain_font';

// The page is served by `muster studio` at its root. `npm run dev` hands the WebSocket on to a server on port 8080.
export default defineConfig({
  base: './',
  build: {
    outDir: 'dist',
    target: 'es2022',
    sourcemap: false,
    chunkSizeWarningLimit: 900,
    rollupOptions: { input: 'index.html' },
  },
  plugins: [leanThree(), plainFont()],
  worker: { format: 'es' },
  // The package of bindings/javascript, from its sources.
  resolve: {
    alias: {
      'muster-engine/studio': fileURLToPath(new URL('../bindings/javascript/src/studio/index.ts', import.meta.url)),
    },
  },
  server: { proxy: { '/ws': { target: 'ws://127.0.0.1:8080', ws: true } } },
  test: {
    // Tests that need a document say so: `// @vitest-environment jsdom`.
    environment: 'node',
    // No test asserts a time; a busy machine may take long.
    testTimeout: 60000,
    include: ['src/**/*.test.ts'],
  },
});
