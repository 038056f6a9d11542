// @vitest-environment jsdom
import { expect, it } from 'vitest';
import { kPlaces } from '../../model/panel_places';
import { element } from './dom';
import { PanelLayout } from './panel_layout';

it('keeps the focus in a field while a neighbour comes, and while panels change places', () => {
  const page = element('div', {});
  document.body.replaceChildren(page);
  const layout = PanelLayout.of(page);
  const [field, panel] = [element('input', {}), element('section', {})];
  panel.append(field);
  layout.add('words', panel);
  field.focus();
  const area = Object.values(kPlaces.desktop).find((names) => names.includes('words'))!;
  for (const name of area) if (name !== 'words') layout.add(name, element('section', {}));
  expect(document.activeElement).toBe(field);
  layout.show('phone');
  expect(document.activeElement).toBe(field);
});
