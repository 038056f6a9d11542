// The button *Directors* and its list: who is there, what each holds and may direct, and an invitation.

import type { StudioStore } from '../../model/studio_store';
import { initialOf, type DirectorActions, type DirectorInfo, type Invitation } from '../../model/directors';
import type { GroupInfo, StudioState } from '../../model/studio_state';
import { element, setText } from '../widgets/dom';
import { icon } from '../widgets/icons';
import { Popover } from '../widgets/popover';
import { qrPicture } from '../widgets/qr_picture';
import { toolButton } from '../widgets/tool_button';

/** So many faces stand on the button. */
const kFaces = 3;

export class DirectorsPanel {
  private readonly button_ = toolButton({
    icon: 'directors',
    label: 'Directors',
    iconOnly: true,
    className: 'directors-button',
    tip: 'Who directs this world with you',
  });
  private readonly faces_ = element('span', { class: 'faces', 'aria-hidden': 'true' });
  private readonly list_ = element('ul', { class: 'director-list' });
  private readonly invitation_ = element('div', { class: 'invitation' });
  private readonly panel_ = element(
    'div',
    { class: 'directors-panel panel', role: 'group', 'aria-label': 'Directors' },
    this.list_,
    this.invitation_,
  );
  readonly root = element('div', { class: 'directors panel' }, this.button_, this.panel_);

  constructor(
    store: StudioStore,
    private readonly actions_: DirectorActions,
  ) {
    this.button_.append(this.faces_);
    new Popover(this.button_, this.panel_, 'bottom-end');
    store.watch(['directors', 'invitation', 'groups'], (state) => this.show(state));
  }

  private show({ directors, invitation, groups }: StudioState): void {
    this.root.hidden = directors.length < 2 && invitation.links.length === 0;
    this.faces_.replaceChildren(...directors.slice(0, kFaces).map(face));
    if (directors.length > kFaces)
      this.faces_.append(element('span', { class: 'face more' }, `+${directors.length - kFaces}`));
    // The name or choice that is being edited keeps its focus: its row is only brought up to date.
    const rows = new Map([...this.list_.children].map((row) => [(row as HTMLElement).dataset['client'], row]));
    this.list_.replaceChildren(
      ...directors.map((one) => {
        const old = rows.get(String(one.client)) as HTMLElement | undefined;
        const key = rowKey(one, groups);
        if (old && (old.dataset['key'] === key || old.contains(document.activeElement))) {
          setText(old.querySelector('.holds')!, holdsText(one, groups));
          return old;
        }
        return this.row(one, groups, key);
      }),
    );
    this.showInvitation(invitation);
  }

  private row(one: DirectorInfo, groups: readonly GroupInfo[], key: string): HTMLElement {
    const name = one.own ? this.nameField(one) : element('span', { class: 'director-name' }, one.name);
    return element(
      'li',
      { class: 'director', 'data-client': one.client, 'data-key': key },
      face(one),
      name,
      element('span', { class: 'holds' }, holdsText(one, groups)),
      this.choice(one, groups),
    );
  }

  private nameField(one: DirectorInfo): HTMLInputElement {
    const field = element('input', {
      type: 'text',
      class: 'director-name',
      'aria-label': 'Your name',
      maxlength: 40,
      value: one.name,
      autocomplete: 'off',
    });
    field.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape') event.stopPropagation();
      if (event.key === 'Enter') field.blur();
    });
    field.addEventListener('change', () => this.actions_.rename(field.value));
    return field;
  }

  private choice(one: DirectorInfo, groups: readonly GroupInfo[]): HTMLSelectElement {
    const option = (value: number, text: string): HTMLOptionElement =>
      element('option', { value, selected: (one.groups[0] ?? 0) === value }, text);
    const select = element(
      'select',
      { 'aria-label': `What ${one.own ? 'you' : one.name} may direct` },
      option(0, 'Everything'),
      ...groups.map(({ id, name }) => option(id, name)),
    );
    select.addEventListener('keydown', (event) => event.key !== 'Escape' && event.stopPropagation());
    select.addEventListener('change', () => {
      this.actions_.giveGroup(one.client, Number(select.value));
      select.blur();
    });
    return select;
  }

  private showInvitation({ links, code }: Invitation): void {
    if (this.invitation_.dataset['links'] === links.join(' ')) return;
    this.invitation_.dataset['links'] = links.join(' ');
    const [link] = links;
    this.invitation_.hidden = link === undefined;
    if (link === undefined) return;
    const copy = element('button', { type: 'button', class: 'menu-item' }, icon('link'), 'Copy the link');
    copy.addEventListener('click', () => this.actions_.copyLink(link));
    this.invitation_.replaceChildren(
      element('h2', {}, 'Direct together'),
      element('p', {}, 'Scan this with another device in your network. Whoever has the link can direct.'),
      qrPicture(code),
      element('code', {}, link),
      copy,
    );
  }
}

function face(one: DirectorInfo): HTMLElement {
  return element(
    'span',
    { class: 'face', style: `background: ${one.colour}`, 'aria-hidden': 'true' },
    initialOf(one.name),
  );
}

function holdsText({ holds, own }: DirectorInfo, groups: readonly GroupInfo[]): string {
  const names = groups.filter(({ id }) => holds.includes(id)).map(({ name }) => name);
  if (names.length > 0) return `holds ${names.join(', ')}`;
  return own ? 'you' : '';
}

/** Equal keys make equal rows, but for what is held. */
function rowKey({ name, colour, own, groups: given }: DirectorInfo, groups: readonly GroupInfo[]): string {
  return JSON.stringify([name, colour, own, given, groups.map(({ id, name: called }) => [id, called])]);
}
