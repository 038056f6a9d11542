import { spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { kTemplates } from './templates';

const program = process.env['MUSTER'] ?? join(import.meta.dirname, '../../../../build/release/muster');
const isBuilt = existsSync(program);

describe('templates', () => {
  it.each(kTemplates)('$name has people in its box and a name of its own', ({ name, make }) => {
    const { box, groups, name: own } = make();
    expect(own).toBe(name);
    const [[left, bottom], [right, top]] = box!;
    for (const { position } of groups!) {
      expect(position![0] > left && position![0] < right).toBe(true);
      expect(position![1] > bottom && position![1] < top).toBe(true);
    }
    expect(new Set(kTemplates.map((one) => one.name)).size).toBe(kTemplates.length);
  });

  // Without the program, which the tests of the whole repository build, there is nothing to ask.
  it.skipIf(!isBuilt).each(kTemplates)('$name is good by “muster check”', ({ make }) => {
    const folder = mkdtempSync(join(tmpdir(), 'muster-template-'));
    const file = join(folder, 'place.json');
    writeFileSync(file, JSON.stringify(make()));
    const { status, stdout, stderr } = spawnSync(program, ['check', file], { encoding: 'utf8' });
    rmSync(folder, { recursive: true });
    expect(`${stdout}${stderr}`).not.toMatch(/warn/i);
    expect(status).toBe(0);
  });
});
