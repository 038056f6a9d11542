// SQLite files, as exports for JuPedSim are, by an SQLite that the caller has loaded (src/files/export/sql_file.h).

interface SqlStatement {
  run(values: (number | string)[]): unknown;
}

interface SqlBase {
  run(statements: string): unknown;
  prepare(statement: string): SqlStatement;
  export(): Uint8Array;
  close(): void;
}

/** What is used of an SQLite for JavaScript; the package sql.js gives it: `await initSqlJs()`. */
export interface SqlLibrary {
  // eslint-disable-next-line @typescript-eslint/naming-convention -- A class of theirs.
  readonly Database: new () => SqlBase;
}

/** Writes one file at a time. Functions answer 1, or 0 where SQLite failed, and keep its words. */
export class SqlFiles {
  trouble = '';
  private base_: SqlBase | null = null;
  private readonly prepared_ = new Map<string, SqlStatement>();
  private values_: (number | string)[] = [];

  constructor(private readonly library_: SqlLibrary) {}

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

  private get opened(): SqlBase {
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
