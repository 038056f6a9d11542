// SQLite files for exports (src/io/export/sql_file.h), by a module that is loaded for them only.

import initSqlJs, { type Database, type SqlJsStatic, type Statement } from 'sql.js';
import kModule from 'sql.js/dist/sql-wasm-browser.wasm?url';
import type { SqlWriter } from 'muster-engine/studio';

/** Writes one file at a time. Functions answer 1, or 0 where SQLite failed, and keep its words. */
export class SqlFiles implements SqlWriter {
  trouble = '';
  private base_: Database | null = null;
  private readonly prepared_ = new Map<string, Statement>();
  private values_: (number | string)[] = [];

  constructor(private readonly library_: SqlJsStatic) {}

  open(): number {
    return this.tried(() => {
      this.prepared_.clear();
      this.base_ = new this.library_.Database();
    });
  }

  execute(statements: string): number {
    return this.tried(() => this.opened.run(statements));
  }

  bind(value: number | string): void {
    this.values_.push(value);
  }

  run(statement: string): number {
    const values = this.values_;
    this.values_ = [];
    return this.tried(() => {
      const prepared = this.prepared_.get(statement) ?? this.opened.prepare(statement);
      this.prepared_.set(statement, prepared);
      prepared.run(values);
    });
  }

  close(): Uint8Array | null {
    let bytes: Uint8Array | null = null;
    this.tried(() => {
      bytes = this.opened.export();
      this.opened.close();
      this.base_ = null;
    });
    return bytes;
  }

  private get opened(): Database {
    if (!this.base_) throw new Error('no file is open');
    return this.base_;
  }

  private tried(action: () => void): number {
    try {
      action();
      return 1;
    } catch (error) {
      this.trouble = error instanceof Error ? error.message : String(error);
      return 0;
    }
  }
}

export async function loadSqlFiles(): Promise<SqlFiles> {
  return new SqlFiles(await initSqlJs({ locateFile: () => kModule }));
}
