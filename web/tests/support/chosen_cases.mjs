// Which cases of the browser run, and in which order.

/** The runs that the words of a command line ask for, of cases [name, test, sizes, options]. Those that share a page follow each
 * other at the end. */
export function chosenCases(cases, words) {
  const at = words.indexOf('--only');
  const stats = words.includes('--stats');
  const only = at > 0 ? words[at + 1] : stats ? 'stats: ' : '';
  const everything = stats || words.includes('--all');
  const sizesNow = (sizes, { release, everySize }) => {
    if (everything || everySize) return sizes;
    return release ? [] : sizes.slice(0, 1);
  };
  const all = cases
    .filter(([name]) => name.includes(only))
    .flatMap(([name, test, sizes, options]) => sizesNow(sizes, options).map((size) => ({ name, test, size, options })));
  const key = ({ size, options }) => `${options.touch === false ? 1 : 0} ${size}`;
  const together = all.filter(({ options }) => options.shared).sort((a, b) => key(a).localeCompare(key(b)));
  return [...all.filter(({ options }) => !options.shared), ...together];
}
