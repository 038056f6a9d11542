// Runs of the study, clicked and touched through; what is stored of them; their replay.
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { readCsv } from '../support/csv.mjs';
import { expect } from '../support/expect.mjs';
import { runProgram, startStudy } from '../support/server.mjs';
import { kSizes } from '../support/studio_page.mjs';
import { kStage, StudyPerson } from '../support/study_person.mjs';
import { serious } from './look.mjs';

/** Serves the study on a database of its own while `work` runs. */
async function withStudy(work) {
  const folder = mkdtempSync(join(tmpdir(), 'muster-study-'));
  const db = join(folder, 'study.db');
  const run = ['run', '--db', db, '--mouse', 'mouse-full-free', '--crowd', '16', '--test', '--port', '18680'];
  const server = await startStudy(...run);
  try {
    await work({ server, db, folder });
  } finally {
    await server.stop();
    rmSync(folder, { recursive: true, force: true });
  }
}

function exported(db, folder) {
  const out = join(folder, 'csv');
  const { status, stderr } = runProgram('study', 'export', '--db', db, '-o', out);
  expect(status === 0, `the export fails: ${stderr}`);
  return {
    runs: readCsv(join(out, 'runs.csv')),
    trials: readCsv(join(out, 'trials.csv')),
    inputs: readCsv(join(out, 'inputs.csv')),
    answers: readCsv(join(out, 'answers.csv')),
  };
}

/** A form at the size of a phone, checked and shown. */
async function onPhone(person, name) {
  await person.page.setViewportSize(kSizes.phone);
  await serious(person, `${name} on a phone`);
  const { scrollWidth, width } = await person.page.evaluate(() => ({
    scrollWidth: document.querySelector('.study-page').scrollWidth,
    width: innerWidth,
  }));
  expect(scrollWidth <= width, `${name} is ${scrollWidth} px wide on a phone of ${width}`);
  await person.page.screenshot({
    path: new URL(`../../test-results/study-${name}-phone.png`, import.meta.url).pathname,
  });
  await person.page.setViewportSize(kSizes[person.size]);
}

/** A touch trial that is played to some items, with a reload in its middle. */
async function playByTouch(person) {
  await person.dragToItem();
  await person.untilCollected(1);
  await person.shot('touch');
  const before = (await person.frame()).time;
  await person.page.reload();
  await person.untilStage(kStage.paused);
  await person.shot('paused');
  await person.wait(700);
  await person.press(person.page.locator('.study-next'), true);
  await person.untilStage(kStage.trial);
  await person.until('the trial to go on', (t) => globalThis.__muster.frame?.time > t, before);
  const after = (await person.frame()).time;
  expect(after < before + 2, `the clock waited for the reload: ${before} s before, ${after} s after`);
  const had = (await person.frame()).collected.filter(Boolean).length;
  expect(had >= 1, 'items that were collected before the reload stay collected');
  await person.dragToItem();
  await person.untilCollected(had + 1);
}

async function playByMouse(person) {
  await person.sendToItem();
  await person.untilCollected(1);
  await person.shot('mouse');
}

export async function wholeRun(browser, size) {
  await withStudy(async ({ server, db, folder }) => {
    const person = await StudyPerson.open(browser, server.url, { size });
    const forms = [];
    const played = new Set();
    for (let i = 0; i < 60; ++i) {
      await person.until('a stage', () => globalThis.__muster?.study && document.querySelector('.study-card') !== null);
      const state = await person.state();
      if (state.stage === kStage.thanks) break;
      if (state.stage === kStage.form) {
        const title = await person.form();
        if (forms.length < 2 || /Workload – Touch|Impression – Touch/.test(title)) {
          await serious(person, title);
          await onPhone(person, `form-${forms.length}`);
          await person.shot(`form-${forms.length}`);
        }
        forms.push(await person.answerForm({ byFinger: forms.length > 2 && forms.length < 8 }));
        continue;
      }
      if (!played.has(`${state.touch} ready`)) {
        played.add(`${state.touch} ready`);
        await serious(person, 'card before a trial');
        await person.shot(state.touch ? 'ready-touch' : 'ready-mouse');
      }
      const { touch, practice } = await person.start(state.touch);
      if (practice) await (touch ? person.dragToItem() : person.sendToItem());
      else if (!played.has(touch)) {
        played.add(touch);
        await (touch ? playByTouch(person) : playByMouse(person));
      }
      await person.end(touch);
    }
    await person.shot('thanks');
    expect((await person.state()).stage === kStage.thanks, 'the run goes to thanks');
    expect(person.errors.length === 0, `the page complained: ${person.errors.join('; ')}`);
    await person.close();
    await server.stop();
    checkStored(db, folder, forms);
  });
}

function checkStored(db, folder, forms) {
  expect(forms.length === 13, `thirteen forms are answered, not ${forms.length}: ${forms.join(', ')}`);
  const { runs, trials, inputs, answers } = exported(db, folder);
  expect(runs.length === 1 && runs[0].kind === 'test', `one run, a test: ${JSON.stringify(runs)}`);
  expect(runs[0].state === 'complete', `it is complete: ${runs[0].state}`);
  expect(trials.length === 10, `ten trials: ${trials.length}`);
  const counted = trials.filter(({ practice }) => practice === '0');
  expect(new Set(counted.map(({ environment }) => environment)).size === 4, 'four environments');
  const collected = counted.filter((trial) => Number(trial.collected) > 0);
  const schemes = new Set(collected.map(({ scheme }) => scheme));
  expect(schemes.size === 2, `both controls collected items: ${[...schemes].join(', ')}`);
  const device = (of) => new Set(inputs.filter(({ trial }) => of.includes(trial)).map((row) => row.device));
  const ofScheme = (name) => trials.filter(({ scheme }) => scheme === name).map(({ trial }) => trial);
  expect([...device(ofScheme('touch'))].sort().join() === ',touch', 'touch was done by fingers alone');
  expect([...device(ofScheme('mouse-full-free'))].sort().join() === ',mouse', 'the mouse alone did the other');
  expect(answers.filter(({ instrument }) => instrument === 'sus').length === 20, 'SUS is answered for both controls');
  const reasons = answers.find(({ item }) => item === 'reasons');
  expect(reasons?.text === 'It was at hand; "quoted", with a comma.', `reasons come through: ${reasons?.text}`);
  for (const { trial, hash } of trials) {
    const { status, stdout } = runProgram('study', 'replay', '--db', db, '--trial', trial, '--json');
    const replay = JSON.parse(stdout);
    expect(status === 0 && replay.reproduced, `trial ${trial} is reproduced: ${stdout}`);
    expect(replay.hash === hash, `trial ${trial} has the stored hash ${hash}, not ${replay.hash}`);
  }
  const report = runProgram('study', 'report', '--db', db, '-o', join(folder, 'report'));
  expect(report.status === 0, `the report is written: ${report.stderr}`);
  const rows = JSON.parse(readFileSync(join(folder, 'report/results.json'), 'utf8'));
  expect(rows.length === 0, `a test never counts as a person: ${JSON.stringify(rows)}`);
}

/** Answers forms up to the first trial. */
async function toFirstTrial(person) {
  await person.form();
  await person.answerForm();
  await person.answerForm();
  await person.untilStage(kStage.ready);
}

export async function brokenRuns(browser, size) {
  await withStudy(async ({ server, db, folder }) => {
    const first = await StudyPerson.open(browser, server.url, { size });
    const second = await StudyPerson.open(browser, server.url, { size });
    await Promise.all([toFirstTrial(first), toFirstTrial(second)]);
    const runs = [(await first.state()).run, (await second.state()).run];
    expect(runs[0] !== runs[1], `two windows are two runs: ${runs.join(', ')}`);
    await first.start(true);
    await second.start(true);
    await first.dragToItem();
    const still = await second.frame();
    await first.untilCollected(1);
    const later = await second.frame();
    const moved = Math.max(...still.x.map((x, i) => Math.hypot(x - later.x[i], still.y[i] - later.y[i])));
    expect(moved < 0.3, `the other crowd stands: ${moved} m`);
    // A mouse in a trial for fingers does nothing, and says so.
    await second.page.mouse.click(700, 500);
    expect(/fingers/.test(await second.page.locator('.study-toast').textContent()), 'the page asks for fingers');
    // The same run in another window: the first one is told.
    const token = new URL(second.page.url()).hash;
    const third = await StudyPerson.open(browser, `${server.url}${token}`, { size });
    await third.untilStage(kStage.paused);
    await second.untilStage(kStage.elsewhere);
    expect((await third.state()).run === runs[1], 'it is the same run');
    await serious(second, 'card of a run that went elsewhere');
    // One person stops.
    await third.page.locator('.study-stop').click();
    await third.shot('stop');
    await serious(third, 'question whether to stop');
    await third.page.locator('.study-dialog .solid').click();
    await third.untilStage(kStage.brokenOff);
    await third.shot('stopped');
    for (const person of [first, second, third]) {
      expect(person.errors.length === 0, `the page complained: ${person.errors.join('; ')}`);
      await person.close();
    }
    await server.stop();
    const stored = exported(db, folder);
    expect(stored.runs.map(({ state }) => state).join() === 'broken-off,broken-off', JSON.stringify(stored.runs));
    expect(stored.trials.map(({ state }) => state).join() === 'broken-off,broken-off', JSON.stringify(stored.trials));
    expect(Number(stored.trials[0].collected) >= 1, 'the items of the trial that was cut off are kept');
  });
}

/** A screen without touch: the card before a part by fingers says so, and one can start all the same. */
export async function withoutTouch(browser, size) {
  await withStudy(async ({ server }) => {
    for (const colorScheme of ['light', 'dark']) {
      const person = await StudyPerson.open(browser, server.url, { size, colorScheme, touch: false });
      await toFirstTrial(person);
      expect((await person.state()).touch, 'the first part is done with fingers');
      const { page } = person;
      const warning = page.locator('.study-card .study-warning');
      expect(/this screen takes no touches/.test(await warning.textContent()), 'the card says what is missing');
      await person.shot(`no-touch-${colorScheme}`);
      await serious(person, 'card where there is no touch');
      const box = await page.getByRole('button', { name: 'Start all the same', exact: true }).boundingBox();
      const { height } = page.viewportSize();
      expect(box.y + box.height <= height, `the button is in sight: it ends at ${box.y + box.height} of ${height}`);
      await page.getByRole('button', { name: 'Start all the same', exact: true }).click();
      await person.untilStage(kStage.trial);
      expect(person.errors.length === 0, `the page complained: ${person.errors.join('; ')}`);
      await person.close();
    }
  });
}

export async function look(browser, size) {
  await withStudy(async ({ server, db }) => {
    for (const colorScheme of ['light', 'dark']) {
      const person = await StudyPerson.open(browser, server.url, { size, colorScheme });
      await person.form();
      await serious(person, 'consent');
      await person.shot(`consent-${colorScheme}`);
      await person.answerForm();
      await person.shot(`before-${colorScheme}`);
      await serious(person, 'questions before');
      // What is missing is said beside the question.
      await person.page.locator('.study-next').click();
      expect((await person.page.locator('[data-missing]').count()) > 0, 'unanswered questions are marked');
      await serious(person, 'questions that are missing');
      await person.answerForm();
      await person.untilStage(kStage.ready);
      await person.shot(`ready-${colorScheme}`);
      await serious(person, 'card before the practice');
      await person.start(true);
      await person.dragToItem();
      await person.untilCollected(1);
      await person.shot(`trial-${colorScheme}`);
      await serious(person, 'trial');
      const seen = await person.page.evaluate(() => {
        const { view } = globalThis.__muster;
        const bar = document.querySelector('.study-bar:not([hidden])').getBoundingClientRect().bottom;
        const corners = [
          [-20, -11.25],
          [20, 11.25],
        ].map(([x, y]) => view.worldToScreen({ x, y }));
        return corners.every(({ x, y }) => x >= 0 && x <= innerWidth && y >= bar && y <= innerHeight);
      });
      expect(seen, 'all of the ground is seen below the bar');
      expect(person.errors.length === 0, `the page complained: ${person.errors.join('; ')}`);
      await person.close();
    }
    await server.stop();
    const replayed = await startStudy('replay', '--db', db, '--trial', '1', '--studio', '--port', '18690');
    try {
      const watcher = await StudyPerson.open(browser, replayed.url, { size });
      await watcher.untilStage(kStage.replay);
      const button = (name) => watcher.page.getByRole('button', { name, exact: true });
      await watcher.until('some way', () => globalThis.__muster.frame?.time > 1);
      await button('Pause').click();
      await watcher.until('the pause', () => globalThis.__muster.frame.playing === false);
      await button('8×').click();
      await watcher.until('the speed', () => globalThis.__muster.frame.speed === 8);
      await watcher.shot('replay');
      await serious(watcher, 'replay');
      await button('Play').click();
      await watcher.untilCollected(1);
      await watcher.until('the end', () => !globalThis.__muster.frame.playing, null, 30000);
      const told = await watcher.page.locator('.study-toast').textContent();
      expect(/stored one/.test(told), `the replay tells of its hash: ${told}`);
      await watcher.close();
    } finally {
      await replayed.stop();
    }
  });
}
