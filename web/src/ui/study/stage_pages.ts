// What stands between the trials: what comes next, a pause, the end.

import { StudyStage, TrialEnd, type StudyState } from '../../protocol/messages';
import { formatClock } from '../../model/formatters';
import { element } from '../widgets/dom';
import { howTo } from './how_to';

/** How the last trial went, in one sentence; empty for none. */
export function endText({ ended, seconds, collected, items }: StudyState): string {
  const time = formatClock(seconds);
  switch (ended) {
    case TrialEnd.Done:
      return `All items collected in ${time}.`;
    case TrialEnd.TimeOver:
      return `The time is over: ${collected} of ${items} items collected.`;
    case TrialEnd.GivenUp:
      return `Given up after ${time}, with ${collected} items collected.`;
    case TrialEnd.Practised:
      return 'The practice is over.';
    case TrialEnd.None:
      return '';
  }
}

function card(title: string, ...children: HTMLElement[]): HTMLElement {
  const heading = element('h1', { tabindex: -1 }, title);
  return element('section', { class: 'study-card panel' }, heading, ...children);
}

function words(text: string, className = 'study-text'): HTMLElement {
  return element('p', { class: className }, text);
}

function buttons(...list: (readonly [string, string, () => void])[]): HTMLElement {
  const made = list.map(([label, className, act]) => {
    const button = element('button', { type: 'button', class: className }, label);
    button.addEventListener('click', () => {
      button.disabled = true;
      act();
    });
    return button;
  });
  return element('div', { class: 'study-buttons' }, ...made);
}

const kNoTouch =
  'This part is done with fingers, and this screen takes no touches. Tell whoever runs the study, and go on at a touch screen.';

/** The next trial waits. */
export function readyPage(state: StudyState, start: () => void): HTMLElement {
  const last = endText(state);
  const device = state.touch ? 'Use your fingers on the screen.' : 'Use the mouse.';
  const title = state.practice ? `Practice: ${state.schemeTitle}` : state.environment;
  const parts: HTMLElement[] = [];
  const cannot = state.touch && navigator.maxTouchPoints === 0;
  if (cannot) parts.push(words(kNoTouch, 'study-warning'));
  if (last !== '') parts.push(words(last, 'study-last secondary'));
  parts.push(
    words(
      state.practice
        ? `Collect the golden hexagons: lead the crowd so that somebody touches each. Try the control for ${Math.round(state.least)} seconds to ${Math.round(state.limit / 60)} minutes; nothing counts yet.`
        : `${state.environmentText} Lead the crowd so that somebody touches each of the ${state.items} golden hexagons, as fast as you can.`,
    ),
    element(
      'div',
      { class: 'study-control' },
      element('strong', {}, state.practice ? device : `${state.schemeTitle}. ${device}`),
      howTo(state.scheme),
    ),
    words(
      `Part ${state.trial} of ${state.trials}. Rest as long as you like; the clock runs from the moment you start.`,
      'secondary',
    ),
    buttons(
      cannot
        ? ['Start all the same', 'soft study-next', start]
        : [state.practice ? 'Start the practice' : 'Start', 'solid study-next', start],
    ),
  );
  return card(title, ...parts);
}

/** The page was lost during a trial. */
export function pausedPage(goOn: () => void): HTMLElement {
  return card(
    'Paused',
    words('The connection was lost for a moment. The crowd and the clock have waited; nothing is lost.'),
    buttons(['Go on', 'solid study-next', goOn]),
  );
}

/** The run is over; `next` begins one with the next person. */
export function endPage(state: StudyState, next: () => void): HTMLElement {
  const thanks = state.stage === StudyStage.Thanks;
  return card(
    thanks ? 'Thank you' : 'Stopped',
    words(
      thanks
        ? 'That was all. Your answers and inputs are stored.'
        : 'Thank you for the time you took. What you did until now is kept and marked as broken off.',
    ),
    words(`Run ${state.run}${state.test ? ', a test of the page' : ''}.`, 'secondary'),
    buttons(['Next person', 'soft study-next', next]),
  );
}

/** Another window has taken the run over. */
export function elsewherePage(takeOver: () => void): HTMLElement {
  return card(
    'This run goes on in another window',
    words('A run is shown in one window at a time. You may bring it back here.'),
    buttons(['Go on here', 'solid study-next', takeOver]),
  );
}

/** Before anything came from the server. */
export function waitingPage(): HTMLElement {
  return card('Muster', words('Waiting for the server of the study…'));
}
