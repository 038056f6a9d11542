// The button *Directors* and its list: who is there, what each holds and may direct, and an invitation.

import { Component, type VNode } from 'preact';
import { initialOf, type DirectorActions, type DirectorInfo, type Invitation } from '../../model/directors';
import { backText } from '../../model/shared_news';
import type { GroupInfo } from '../../model/studio_state';
import type { StudioStore } from '../../model/studio_store';
import { Icon } from '../widgets/buttons';
import { element } from '../widgets/dom';
import { Menu, MenuItem } from '../widgets/menu';
import { drawPanel } from '../widgets/panel';
import { QrPicture } from '../widgets/qr_picture';

/** So many faces stand on the button. */
const kFaces = 3;

function Face({ one }: { readonly one: DirectorInfo }): VNode {
  return (
    <span class="face" style={{ background: one.colour }} aria-hidden="true">
      {initialOf(one.name)}
    </span>
  );
}

/** Keys of a field are none of the studio's. */
function keepKeys(event: KeyboardEvent): void {
  if (event.key !== 'Escape') event.stopPropagation();
}

interface RowProps {
  readonly one: DirectorInfo;
  readonly groups: readonly GroupInfo[];
  readonly actions: DirectorActions;
}

/** What is being typed stays whatever comes meanwhile. */
class NameField extends Component<Omit<RowProps, 'groups'>> {
  private input_: HTMLInputElement | null = null;

  override componentDidMount(): void {
    this.input_!.value = this.props.one.name;
  }

  override componentDidUpdate(before: Omit<RowProps, 'groups'>): void {
    const { name } = this.props.one;
    if (name !== before.one.name && document.activeElement !== this.input_) this.input_!.value = name;
  }

  override render({ actions }: Omit<RowProps, 'groups'>): VNode {
    return (
      <input
        type="text"
        class="director-name"
        aria-label="Your name"
        maxLength={40}
        autocomplete="off"
        ref={(made) => void (this.input_ = made)}
        onKeyDown={(event) => {
          keepKeys(event);
          if (event.key === 'Enter') event.currentTarget.blur();
        }}
        onChange={({ currentTarget }) => actions.rename(currentTarget.value)}
      />
    );
  }
}

function holdsText({ holds, own }: DirectorInfo, groups: readonly GroupInfo[]): string {
  const names = groups.filter(({ id }) => holds.includes(id)).map(({ name }) => name);
  if (names.length > 0) return `holds ${names.join(', ')}`;
  return own ? 'you' : '';
}

function Row({ one, groups, actions }: RowProps): VNode {
  return (
    <li class="director">
      <Face one={one} />
      {one.own ? <NameField one={one} actions={actions} /> : <span class="director-name">{one.name}</span>}
      <span class="holds">{holdsText(one, groups)}</span>
      <select
        aria-label={`What ${one.own ? 'you' : one.name} may direct`}
        value={one.groups[0] ?? 0}
        onKeyDown={keepKeys}
        onChange={({ currentTarget }) => {
          actions.giveGroup(one.client, Number(currentTarget.value));
          currentTarget.blur();
        }}
      >
        <option value={0}>Everything</option>
        {groups.map(({ id, name }) => (
          <option key={id} value={id}>
            {name}
          </option>
        ))}
      </select>
    </li>
  );
}

interface InvitationProps {
  readonly invitation: Invitation;
  readonly actions: DirectorActions;
}

function Invite({ invitation: { links, code }, actions }: InvitationProps): VNode | null {
  const [link] = links;
  if (link === undefined) return null;
  return (
    <div class="invitation">
      <h2>Direct together</h2>
      <p>Scan this with another device in your network. Whoever has the link can direct.</p>
      <QrPicture rows={code} />
      <code>{link}</code>
      <button type="button" class="menu-item" onClick={() => actions.copyLink(link)}>
        <Icon name="link" />
        Copy the link
      </button>
    </div>
  );
}

export class DirectorsPanel {
  readonly root = element('div', { class: 'directors panel' });

  constructor(store: StudioStore, actions: DirectorActions) {
    store.watch(['directors', 'invitation', 'shared'], ({ directors, invitation, shared }) => {
      this.root.hidden = directors.length < 2 && invitation.links.length === 0 && shared.before === '';
    });
    drawPanel(this.root, store, ['directors', 'invitation', 'groups', 'shared', 'title'], (state) => {
      const { invitation, groups, shared } = state;
      // Who is alone needs no name.
      const directors = state.directors.length > 1 ? state.directors : [];
      const faces = (
        <span class="faces" aria-hidden="true">
          {directors.slice(0, kFaces).map((one) => (
            <Face key={one.client} one={one} />
          ))}
          {directors.length > kFaces && <span class="face more">+{directors.length - kFaces}</span>}
        </span>
      );
      const opener = {
        icon: 'directors',
        label: 'Directors',
        iconOnly: true,
        class: 'directors-button',
        tip: 'Who directs this world with you',
        children: faces,
      } as const;
      return (
        <Menu opener={opener} class="directors-panel" label="Directors" placement="bottom-end">
          {(close) => (
            <>
              <ul class="director-list" hidden={directors.length === 0}>
                {directors.map((one) => (
                  <Row key={one.client} one={one} groups={groups} actions={actions} />
                ))}
              </ul>
              {shared.before !== '' && (
                <MenuItem icon="undo" label={backText(state)} close={close} act={() => actions.goBack()} />
              )}
              <Invite invitation={invitation} actions={actions} />
            </>
          )}
        </Menu>
      );
    });
  }
}
