// A form of the study: its questions, and a button that sends all answers at once.

import type { AnswerFrame, StudyForm } from '../../protocol/messages';
import { element } from '../widgets/dom';
import { fieldOf, missingText } from './fields';

/** The page of a form; `send` gets the answers once all that are needed are there. */
export function formPage(form: StudyForm, send: (answers: AnswerFrame[]) => void): HTMLElement {
  const fields = form.questions.map((question) => ({ question, field: fieldOf(question) }));
  const about = form.schemeTitle === '' ? form.title : `${form.title} – ${form.schemeTitle}`;
  const root = element('form', { class: 'study-card panel', novalidate: true }, element('h1', { tabindex: -1 }, about));
  if (form.text !== '') root.append(element('p', { class: 'study-text' }, form.text));
  root.append(...fields.map(({ field }) => field.root));
  if (form.source !== '') root.append(element('p', { class: 'study-source secondary' }, `Source: ${form.source}`));
  const button = element('button', { type: 'submit', class: 'solid study-next' }, 'Continue');
  root.append(element('div', { class: 'study-buttons' }, button));
  root.addEventListener('submit', (event) => {
    event.preventDefault();
    const given = fields.map(({ question, field }) => ({ question, field, answer: field.answer() }));
    for (const { question, field, answer } of given)
      field.complain(answer === null && question.needed ? missingText(question) : '');
    const missing = given.find(({ question, answer }) => answer === null && question.needed);
    if (missing) return missing.field.focus();
    button.disabled = true;
    send(given.flatMap(({ answer }) => answer ?? []));
  });
  return root;
}
