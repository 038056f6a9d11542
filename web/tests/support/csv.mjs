// Reads the tables that `muster study export` writes.
import { readFileSync } from 'node:fs';

/** Rows of a CSV file by their header; quoted fields may hold commas and line ends. */
export function readCsv(path) {
  const rows = [[]];
  const pattern = /("(?:[^"]|"")*"|[^,\r\n]*)(,|\r?\n|$)/g;
  for (const [whole, field, end] of readFileSync(path, 'utf8').matchAll(pattern)) {
    if (whole === '') break;
    rows[rows.length - 1].push(field.startsWith('"') ? field.slice(1, -1).replaceAll('""', '"') : field);
    if (end !== ',') rows.push([]);
  }
  const [header, ...body] = rows.filter((row) => row.length > 1);
  return body.map((row) => Object.fromEntries(header.map((name, i) => [name, row[i]])));
}
