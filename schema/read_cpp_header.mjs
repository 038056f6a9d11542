// Reads the structs of the C++ headers of definitions, until these are declared here. The headers are formatted by clang-format,
// so a few patterns are enough; what they do not fit is refused.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { root } from './read.mjs';

const kField = /^((?:std::)?\w+(?:::\w+)*(?:<.+>)?) (\w+)(?: = (.+)|(\{.*\}))?$/;
/** What a struct may hold beside fields. */
const kPassedOver = /^(template|static|friend|using|explicit|constexpr|public:|private:)|\)( const)?( noexcept)?( \{|;)/;

const depthOf = (code) => (code.match(/\{/g) ?? []).length - (code.match(/\}/g) ?? []).length;

/** A line as its code, the comment before a declaration, and that behind one. */
function parts(raw) {
  const line = raw.trim();
  if (line.startsWith('///<')) return { code: '', ahead: '', behind: line.slice(4) };
  if (line.startsWith('///')) return { code: '', ahead: line.slice(3), behind: '' };
  const [code, behind = ''] = line.split('///<');
  return { code: (behind === '' ? code.split('//')[0] : code).trim(), ahead: '', behind };
}

const tidy = (text) => text.replace(/\s+/g, ' ').trim();

function structOf(lines, header, name, doc) {
  const struct = { name, doc: tidy(doc), fields: [] };
  let [code, ahead, behind] = ['', '', ''];
  for (;;) {
    const next = parts(lines.shift());
    if (next.code === '};' && code === '') return struct;
    if (next.code === '') {
      const last = struct.fields.at(-1);
      if (next.behind !== '' && last && code === '') last.doc = tidy(`${last.doc} ${next.behind}`);
      else if (next.behind !== '') behind += next.behind;
      else if (next.ahead !== '') ahead += ` ${next.ahead}`;
      continue;
    }
    code = `${code} ${next.code}`.trim();
    behind += next.behind;
    if (kPassedOver.test(code.endsWith(';') ? code.split(' = ')[0] : code)) {
      skipBlock(lines, code);
    } else if (!code.endsWith(';')) {
      continue;
    } else {
      const match = kField.exec(code.slice(0, -1));
      if (!match) throw new Error(`include/muster/${header}.h: found "${code}", expected a field or a function of one block`);
      struct.fields.push({ type: match[1], name: match[2], initial: match[3] ?? match[4] ?? '', doc: tidy(`${ahead} ${behind}`) });
    }
    [code, ahead, behind] = ['', '', ''];
  }
}

/** Passes over the rest of a function that begins with `code`. */
function skipBlock(lines, code) {
  let depth = depthOf(code);
  let isOpen = code.includes('{');
  let last = code;
  while (depth > 0 || (!isOpen && !last.endsWith(';'))) {
    last = parts(lines.shift()).code;
    isOpen ||= last.includes('{');
    depth += depthOf(last);
  }
}

/** The structs that stand in the namespace itself, in their order: {name, doc, fields: [{type, name, initial, doc}]}. */
export function readCppHeader(header) {
  const lines = readFileSync(join(root, `include/muster/${header}.h`), 'utf8').split('\n');
  const found = [];
  let doc = '';
  while (lines.length > 0) {
    const raw = lines.shift();
    const { code, ahead } = parts(raw);
    if (ahead !== '' && !raw.startsWith(' ')) {
      doc += ahead;
      continue;
    }
    const [, name] = raw.match(/^struct (\w+) \{$/) ?? [];
    if (name !== undefined) found.push(structOf(lines, header, name, doc));
    doc = '';
  }
  return found;
}
