// The menu of objectives against a running world: what is chosen is what the world then makes least.
import { expect } from '../support/expect.mjs';

/** Menu entry, and the world's parameters once it is chosen (the exponent is left alone by the longest walk). */
const kChoices = [
  ['Nobody far', { 'plan.objective': 1 }],
  ['Least walking', { 'plan.objective': 0, 'plan.exponent': 1 }],
  ['Even walks', { 'plan.objective': 0, 'plan.exponent': 2 }],
  ['Nobody far', { 'plan.objective': 1, 'plan.exponent': 2 }],
  ['Even walks', { 'plan.objective': 0, 'plan.exponent': 2 }],
];

const parameters = (studio) =>
  studio.page.evaluate(() =>
    Object.fromEntries(globalThis.__muster.state.parameters.map(({ name, value }) => [name, value])),
  );

export async function objectives(studio) {
  const menu = studio.page.locator('select.objective');
  expect(!(await menu.isVisible()), 'words come first, figures on request');
  await studio.page.locator('.readout .plain').click();
  const chosen = () => menu.evaluate((select) => select.selectedOptions[0]?.textContent ?? '');
  const before = await parameters(studio);
  expect(before['plan.objective'] === 0 && before['plan.exponent'] === 2, `the default: ${JSON.stringify(before)}`);
  expect((await chosen()) === 'Even walks', `the menu tells the default: ${await chosen()}`);
  for (const [label, wanted] of kChoices) {
    await menu.selectOption({ label });
    await studio.eventually(async () => {
      const now = await parameters(studio);
      for (const [name, value] of Object.entries(wanted))
        expect(now[name] === value, `${label}: ${name} is ${now[name]}, expected ${value}`);
    });
    const { step } = await studio.frame();
    await studio.until('ten steps', (from) => globalThis.__muster.frame.step > from + 10, step);
    expect((await chosen()) === label, `the menu still says ${label}: ${await chosen()}`);
    const refusals = await studio.page.locator('.notice:is([data-level="error"], [data-level="warning"])').count();
    expect(refusals === 0, `${label} is not refused`);
  }
}
