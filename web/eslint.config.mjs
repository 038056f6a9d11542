// Lint rules of the page. Layout of the code is Prettier's business: no rule here is about it.
import { dirname, relative, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import js from '@eslint/js';
import importX from 'eslint-plugin-import-x';
import tseslint from 'typescript-eslint';

const source = fileURLToPath(new URL('src', import.meta.url));

/** What schema/generate.mjs writes. */
const kGenerated = ['src/protocol/generated/*.ts'];

/** The layers of src, lowest first. A file imports from its own layer and from those before it. */
const kLayers = [
  'protocol',
  'model',
  'link',
  'scene/camera',
  'scene/drawing',
  'scene/crowd/bodies',
  'scene/crowd/clips',
  'scene/crowd/own_character',
  'scene/crowd',
  'scene/ground',
  'scene/obstacles',
  'scene/patches',
  'scene/scenery',
  'scene/marks',
  'scene',
  'tools',
  'ui/styles',
  'ui/widgets',
  'ui/steer',
  'ui/orders',
  'ui/formations',
  'ui/directors',
  'ui/places',
  'ui/measures',
  'ui/build',
  'ui/takes',
  'ui/app',
  'ui/study',
  'player/file',
  'player/play',
  'player/draw',
  'player',
  '',
];

/** The layer of a file: the deepest folder of the list that holds it; null outside of src. */
function layerOf(file) {
  const path = relative(source, file).replaceAll('\\', '/');
  if (path.startsWith('..')) return null;
  const holders = kLayers.filter((layer) => layer === '' || path.startsWith(`${layer}/`));
  return holders.reduce((deepest, layer) => (layer.length > deepest.length ? layer : deepest));
}

const noImportUpward = {
  meta: {
    type: 'problem',
    docs: { description: 'Forbids imports from a higher layer.' },
    schema: [],
    messages: {
      upward: '{{from}} must not import from {{to}}, which lies above it (see kLayers in eslint.config.mjs).',
    },
  },
  create(context) {
    const check = (node) => {
      const target = node.source?.value;
      if (typeof target !== 'string' || !target.startsWith('.')) return;
      const from = layerOf(context.filename);
      const to = layerOf(resolve(dirname(context.filename), target));
      if (to === null || kLayers.indexOf(to) <= kLayers.indexOf(from)) return;
      context.report({ node, messageId: 'upward', data: { from, to } });
    };
    return {
      ImportDeclaration: check,
      ImportExpression: check,
      ExportNamedDeclaration: check,
      ExportAllDeclaration: check,
    };
  },
};

/** Naming of the page: types PascalCase, functions and variables camelCase, private fields trailing_, constants kName. */
const kConstants = {
  selector: 'variable',
  modifiers: ['const', 'global'],
  types: ['boolean', 'string', 'number', 'array'],
  format: ['PascalCase'],
  prefix: ['k'],
};
const kNaming = [
  { selector: 'default', format: ['camelCase'] },
  { selector: 'import', format: null },
  { selector: 'typeLike', format: ['PascalCase'] },
  { selector: 'enumMember', format: ['PascalCase'] },
  { selector: 'typeParameter', format: ['PascalCase'] },
  { selector: 'variable', format: ['camelCase'] },
  { selector: 'parameter', format: ['camelCase'], leadingUnderscore: 'allow' },
  {
    selector: ['classProperty', 'parameterProperty'],
    modifiers: ['private'],
    format: ['camelCase'],
    trailingUnderscore: 'require',
  },
  { selector: ['objectLiteralProperty', 'objectLiteralMethod', 'typeProperty'], format: null },
];

export default tseslint.config(
  { ignores: ['dist/', 'node_modules/', 'test-results/', ...kGenerated] },
  js.configs.recommended,
  {
    files: ['src/**/*.{ts,tsx}', 'vite*.config.ts'],
    extends: [tseslint.configs.recommendedTypeChecked],
    languageOptions: { parserOptions: { projectService: true, tsconfigRootDir: import.meta.dirname } },
    plugins: { 'import-x': importX, page: { rules: { 'no-import-upward': noImportUpward } } },
    settings: {
      'import-x/resolver': { node: { extensions: ['.ts', '.tsx', '.mjs', '.js'] } },
      'import-x/extensions': ['.ts', '.tsx'],
    },
    rules: {
      '@typescript-eslint/naming-convention': ['error', ...kNaming, kConstants],
      '@typescript-eslint/consistent-type-imports': ['error', { fixStyle: 'inline-type-imports' }],
      '@typescript-eslint/explicit-module-boundary-types': 'error',
      '@typescript-eslint/switch-exhaustiveness-check': 'error',
      eqeqeq: 'error',
      'import-x/no-cycle': 'error',
      'import-x/no-duplicates': 'error',
      'import-x/no-default-export': 'error',
      'page/no-import-upward': 'error',
      'max-lines': ['error', 400],
      'max-lines-per-function': ['error', { max: 60, skipBlankLines: true, skipComments: true }],
      complexity: ['error', 15],
    },
  },
  {
    // A component is named as a type is.
    files: ['src/**/*.tsx'],
    rules: {
      '@typescript-eslint/naming-convention': [
        'error',
        ...kNaming,
        { selector: 'function', format: ['camelCase', 'PascalCase'] },
        kConstants,
      ],
    },
  },
  {
    // Fixtures of a test read as its words.
    files: ['src/**/*.test.ts'],
    rules: {
      'max-lines-per-function': 'off',
      '@typescript-eslint/naming-convention': ['error', ...kNaming],
      '@typescript-eslint/require-await': 'off',
    },
  },
  { files: ['vite*.config.ts'], rules: { 'import-x/no-default-export': 'off' } },
  {
    files: ['tests/**/*.mjs', 'eslint.config.mjs'],
    languageOptions: {
      ecmaVersion: 'latest',
      sourceType: 'module',
      // Cases send functions into the page, so names of Node and of the browser stand side by side.
      globals: Object.fromEntries(
        [
          'process',
          'console',
          'Buffer',
          'URL',
          'fetch',
          'setTimeout',
          'clearTimeout',
          'setInterval',
          'clearInterval',
          'performance',
          'globalThis',
          'atob',
          'DataTransfer',
          'DragEvent',
          'File',
          'document',
          'innerWidth',
          'innerHeight',
          'localStorage',
          'createImageBitmap',
          'ArrayBuffer',
          'OffscreenCanvas',
          'Function',
          'requestAnimationFrame',
          'getComputedStyle',
        ].map((name) => [name, 'readonly']),
      ),
    },
    rules: { eqeqeq: 'error', 'max-lines': ['error', 400] },
  },
);
