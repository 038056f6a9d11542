// @vitest-environment jsdom
import { expect, it } from 'vitest';
import { cleanSvg } from './clean_svg';

const kNames = 'xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink"';
const clean = (inside: string, attributes = ''): string =>
  cleanSvg(`<svg ${kNames} viewBox="0 0 9 9" ${attributes}>${inside}</svg>`)?.outerHTML ?? 'none';

it('keeps shapes, their looks and what they share', () => {
  const shapes =
    '<defs><g id="a"><path d="M0 0L9 9" stroke="red" style="fill:none"/></g></defs><use href="#a"/><style>.b{fill:#000}</style><circle class="b" r="3"/>';
  const text = clean(shapes);
  for (const part of ['d="M0 0L9 9"', 'stroke="red"', 'fill:none', '#a', '.b{fill:#000}', 'class="b"', 'viewBox'])
    expect(text).toContain(part);
});

it('lets in nothing that runs or loads', () => {
  const text = clean(
    `<script>x()</script><image href="http://a.b/c.png"/><foreignObject><p/></foreignObject><a href="javascript:x()"/>
     <use xlink:href="http://a.b/c.svg#d"/><path d="M0 0" onclick="x()" fill="url(http://a.b/c)" style="background:url(x)"/>
     <style>@import 'http://a.b/c.css';</style><animate attributeName="href"/><set/>`,
    'onload="x()"',
  );
  for (const part of [
    'script',
    'http://a.b',
    'foreignObject',
    'javascript',
    'onclick',
    'onload',
    'url(',
    'import',
    'animate',
    '<set',
  ])
    expect(text).not.toContain(part);
  expect(text).toContain('d="M0 0"');
});

it('takes no other text', () => {
  expect(cleanSvg('no drawing')).toBeNull();
  expect(cleanSvg('<html xmlns="http://www.w3.org/1999/xhtml"/>')).toBeNull();
  expect(cleanSvg('<svg xmlns="http://www.w3.org/2000/svg"><path</svg>')).toBeNull();
});
