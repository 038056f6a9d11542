/** All rows of JuPedSim's file, table by table, by an SQLite as sql.js gives it. */
export function jupedsimRows(sqlite, bytes) {
  const base = new sqlite.Database(bytes);
  const tables = ['metadata', 'geometry', 'frame_data', 'trajectory_data'];
  const rows = tables.map((name) => base.exec(`SELECT * FROM ${name} ORDER BY 1, 2`)[0].values);
  base.close();
  return rows;
}
