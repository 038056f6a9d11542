// A link to a place or a take on this studio, with its QR code, and who can open it.

import { Component, render, type VNode } from 'preact';
import { localLink, type LocalLink, type SharedThing } from '../../link/local_link';
import { Button } from '../widgets/buttons';
import { Modal } from '../widgets/dialog';
import { element } from '../widgets/dom';
import { QrPicture } from '../widgets/qr_picture';
import '../styles/share.css';

const kOthers = 'Everybody in your network can open it, as long as this studio runs.';
const kOnlyHere =
  'Only this computer can open this link. For others in your network, start the studio with “muster studio --lan”.';
const kSite = 'By your site it opens for everybody, also without this studio: it holds everything.';

/** Pages of other addresses than this machine's own may copy what is selected only. */
async function copy(field: HTMLInputElement): Promise<boolean> {
  field.select();
  try {
    await navigator.clipboard.writeText(field.value);
    return true;
  } catch {
    return document.execCommand('copy');
  }
}

interface ShareProps {
  readonly thing: SharedThing;
  readonly found: LocalLink;
  readonly close: () => void;
}

class ShareDialog extends Component<ShareProps, { readonly said: string }> {
  override state = { said: '' };

  private row(label: string, link: string): VNode {
    let field: HTMLInputElement | null = null;
    const pressed = async (): Promise<void> => {
      if (!field) return;
      const done = await copy(field);
      this.setState({ said: done ? 'Link copied.' : 'The link is selected: copy it with Ctrl+C.' });
    };
    return (
      <div class="share-row">
        <input type="text" readonly value={link} aria-label={label} ref={(made) => void (field = made)} />
        <Button icon="link" class="solid" act={() => void pressed()}>
          Copy link
        </Button>
      </div>
    );
  }

  override render({ thing, found: { link, here, site, code }, close }: ShareProps): VNode {
    return (
      <Modal title={`Share “${thing.title}”`} class="help share-dialog" close={close}>
        <div class="share-body">
          {this.row('Link', link)}
          <p class="secondary">{here ? kOnlyHere : kOthers}</p>
          {code.length > 0 && !here && <QrPicture rows={code} />}
          {site !== '' && this.row('Link to your site', site)}
          {site !== '' && <p class="secondary">{kSite}</p>}
          {code.length > 0 && here && <QrPicture rows={code} />}
          <p class="share-said" role="status">
            {this.state.said}
          </p>
        </div>
      </Modal>
    );
  }
}

/** Throws a sentence where there is no link. */
export async function showShare(thing: SharedThing): Promise<void> {
  const found = await localLink(thing);
  const root = element('div', { class: 'dialogs' });
  document.body.append(root);
  const close = (): void => {
    render(null, root);
    root.remove();
  };
  render(<ShareDialog thing={thing} found={found} close={close} />, root);
}
