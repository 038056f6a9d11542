import { execFileSync, spawnSync } from 'node:child_process';
import { mkdtempSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import initSqlJs, { type SqlJsStatic } from 'sql.js';
import { beforeAll, describe, expect, it } from 'vitest';
import { SqlFiles } from 'muster-engine/studio';

let library: SqlJsStatic;

beforeAll(async () => {
  const dist = createRequire(import.meta.url).resolve('sql.js/dist/sql-wasm-browser.wasm');
  library = await initSqlJs({ locateFile: () => dist });
});

const kPython = spawnSync('python3', ['-c', 'import sqlite3']).status === 0;

/** A file with a table of every type, as exports write it. */
function written(): Uint8Array {
  const files = new SqlFiles(library);
  expect(files.open()).toBe(1);
  expect(files.execute('BEGIN; CREATE TABLE t(whole INTEGER NOT NULL, real REAL NOT NULL, words TEXT);')).toBe(1);
  for (const [whole, real, words] of [
    ['9007199254740993', 0.1, "it's"],
    ['-4', 3, 'é'],
  ] as const) {
    files.bind(whole);
    files.bind(real);
    files.bind(words);
    expect(files.run('INSERT INTO t VALUES(?, ?, ?)')).toBe(1);
  }
  expect(files.execute('COMMIT;')).toBe(1);
  const bytes = files.close();
  expect(bytes).not.toBeNull();
  return bytes ?? new Uint8Array();
}

describe('SQLite files of exports', () => {
  it.skipIf(!kPython)('hold what was written, for another SQLite', () => {
    const path = join(mkdtempSync(join(tmpdir(), 'muster-sql-')), 'a.sqlite');
    writeFileSync(path, written());
    const script =
      'import sqlite3, sys; b = sqlite3.connect(sys.argv[1]); ' +
      'print(b.execute("PRAGMA integrity_check").fetchone()[0]); ' +
      'print([(w, r.hex(), t, k) for w, r, t, k in b.execute("SELECT whole, real, words, typeof(real) FROM t")])';
    expect(execFileSync('python3', ['-c', script, path], { encoding: 'utf8' })).toBe(
      "ok\n[(9007199254740993, '0x1.999999999999ap-4', \"it's\", 'real'), (-4, '0x1.8000000000000p+1', 'é', 'real')]\n",
    );
  });

  it('say what is wrong, and go on', () => {
    const files = new SqlFiles(library);
    expect(files.execute('SELECT 1')).toBe(0);
    expect(files.trouble).toBe('no file is open');
    expect(files.close()).toBeNull();
    files.open();
    expect(files.execute('CREATE TABLE t(')).toBe(0);
    expect(files.trouble).toContain('incomplete input');
    files.execute('CREATE TABLE t(a INTEGER NOT NULL)');
    files.bind('x');
    files.bind(2);
    expect(files.run('INSERT INTO t VALUES(?)')).toBe(0);
    files.bind(1);
    expect(files.run('INSERT INTO t VALUES(?)')).toBe(1);
    expect(files.close()?.length).toBeGreaterThan(0);
  });
});
