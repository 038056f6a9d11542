// SQLite for the page, which is loaded for exports that need it only.

import initSqlJs from 'sql.js';
import kModule from 'sql.js/dist/sql-wasm-browser.wasm?url';
import { SqlFiles } from 'muster-engine/studio';

export async function loadSqlite(): Promise<SqlFiles> {
  return new SqlFiles(await initSqlJs({ locateFile: () => kModule }));
}
