// The list of messages in docs/protocol.md, between two marks.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { page, server } from './messages.mjs';
import { root } from './read.mjs';

const kPath = 'docs/protocol.md';
const kFirst = '<!-- Made by schema/generate.mjs from schema/messages.txt: change these, not this list. -->\n';
const kLast = '<!-- End of the list. -->';

const rows = (title, entries) =>
  [
    `| | ${title} | |`,
    '|---|---|---|',
    ...entries.map(({ number, name, fields, sentence }) => `| ${number} | \`${name}\` ${fields.map((field) => field.name).join(', ')} | ${sentence} |`),
  ].join('\n');

/** The text with its list made anew. */
function withList(text) {
  const from = text.indexOf(kFirst);
  const to = text.indexOf(kLast);
  if (from < 0 || to < from) throw new Error(`${kPath} has no marks of the list of messages`);
  return `${text.slice(0, from)}${kFirst}\n${rows('from the page', page)}\n\n${rows('from the server', server)}\n\n${text.slice(to)}`;
}

export const documentationFiles = () => ({ [kPath]: withList(readFileSync(join(root, kPath), 'utf8')) });
