import { expect, it } from 'vitest';
import { gltfTrouble, plainReason, sentenceOf } from './file_trouble';

it('tells why a glTF file cannot be read, and keeps what is inside to itself', () => {
  const internal = [
    new TypeError("Cannot read properties of undefined (reading 'name')"),
    new RangeError('Invalid DataView length 12'),
    new Error('THREE.GLTFLoader: JSON content not found.'),
    'odd',
  ];
  for (const error of internal) expect(gltfTrouble(error)).toBe('it is no whole glTF file');
  expect(gltfTrouble(new Error('THREE.GLTFLoader: No DRACOLoader instance provided.'))).toContain('Draco');
  expect(gltfTrouble(new Error('THREE.GLTFLoader: Unsupported asset. glTF versions >=2.0 are supported.'))).toContain(
    'glTF 1',
  );
});

it('passes sentences on, and nothing from inside', () => {
  expect(sentenceOf(new Error('There is no knee'), 'Damaged.')).toBe('There is no knee.');
  expect(sentenceOf(new TypeError('x is not a function'), 'Damaged.')).toBe('Damaged.');
  expect(sentenceOf('text', 'Damaged.')).toBe('Damaged.');
});

it('takes name and root from the reason of a server', () => {
  expect(plainReason('q.json: $: found no "format", expected one.')).toBe('found no "format", expected one');
  expect(plainReason('q.json: $.groups[0].count: found -5, expected 1 to 20000')).toBe(
    'groups[0].count: found -5, expected 1 to 20000',
  );
  expect(plainReason('take: found no take, expected one to begin with MUSTAKE')).toBe('it is no take');
  expect(plainReason('too many directors')).toBe('too many directors');
});
