// How generated code is laid out: as clang-format would, so that it reads like the rest.

export const kWidth = 110;

/** Breaks a text into lines of at most `width` characters. */
export function wrap(text, width) {
  const lines = [];
  let line = '';
  for (const word of text.split(' ')) {
    if (line !== '' && line.length + 1 + word.length > width) {
      lines.push(line);
      line = '';
    }
    line += line === '' ? word : ` ${word}`;
  }
  return [...lines, line];
}

/** A comment before a declaration. */
export function docComment(sentence, indent = '') {
  return wrap(sentence, kWidth - indent.length - 4).map((line) => `${indent}/// ${line}`);
}

/** Declarations with comments behind them, in one column. A comment that is too long goes on below itself. */
export function aligned(rows, indent = '    ') {
  const column = Math.max(...rows.map(({ code }) => code.length)) + 2;
  return rows.flatMap(({ code, about }) => {
    const lines = wrap(about, kWidth - indent.length - column - 5);
    return lines.map((line, at) => `${indent}${(at === 0 ? code : '').padEnd(column)}///< ${line}`);
  });
}

/** Words in parentheses after `head`, broken where the line is full; `close` ends the last one. */
export function call(head, words, close, indent) {
  const hang = ' '.repeat(indent.length + head.length);
  const lines = [];
  let line = indent + head;
  words.forEach((word, at) => {
    const piece = word + (at + 1 < words.length ? ',' : close);
    const first = line.length === indent.length + head.length || line === hang;
    if (!first && line.length + 1 + piece.length > kWidth) {
      lines.push(line);
      line = hang + piece;
    } else {
      line += first ? piece : ` ${piece}`;
    }
  });
  return [...lines, line];
}

/** "touches" -> "touch", "bodies" -> "body", "ids" -> "id"; "people" stays. */
export function singular(name) {
  if (name.endsWith('ies')) return `${name.slice(0, -3)}y`;
  if (name.endsWith('ches')) return name.slice(0, -2);
  return name.endsWith('s') ? name.slice(0, -1) : name;
}

export const lowerFirst = (name) => name[0].toLowerCase() + name.slice(1);
/** "TouchDown" -> "TOUCH_DOWN". */
export const upperWords = (name) => name.replace(/(?<!^)([A-Z])/g, '_$1').toUpperCase();
/** The sentence, with the unit before its first stop or semicolon. */
export const withUnit = ({ sentence, unit }) => (unit === '' ? sentence : sentence.replace(/[.;](?=\s|$)/, (stop) => ` [${unit}]${stop}`));

/** Entries of a list, each on its line, so that a new one changes one line. */
export const listed = (words, close) => [...words.map((word) => `    ${word},`), close].join('\n');

/** A text as a literal of C++. */
export const quoted = (text) => `"${text.replace(/"/g, '\\"')}"`;

/** Declarations with comments behind them, or before them where they take more than one line. */
export function rowsOf(rows, indent = '    ') {
  const isLong = ({ code, about }) => code.length + about.length + indent.length + 7 > kWidth;
  const column = Math.max(0, ...rows.filter((row) => !isLong(row)).map(({ code }) => code.length));
  const lines = [];
  let short = [];
  const flush = () => {
    if (short.length > 0) lines.push(...aligned(short, indent));
    short = [];
  };
  for (const row of rows) {
    if (!isLong({ ...row, code: row.code.padEnd(column) })) {
      short.push(row);
      continue;
    }
    flush();
    lines.push(...docComment(row.about, indent), `${indent}${row.code}`);
  }
  flush();
  return lines;
}

const kLimits = { 200000: 'kMaxCharacters', 10000: 'kMaxCorners' };
/** A bound by the name that the engine has for it. */
export const limit = (text) => kLimits[text] ?? text;
/** The same for a number with a point. */
export const real = (text) => (text in kLimits ? kLimits[text] : /[.e]/.test(text) ? text : `${text}.0`);

/** The member of C that says whether there is a value. */
export const hasOf = (name) => `has${name[0].toUpperCase()}${name.slice(1)}`;
