// A link to a place or a take on this studio, with its QR code, and who can open it.

import { render, type VNode } from 'preact';
import { localLink, type LocalLink, type SharedThing } from '../../link/local_link';
import { Icon } from '../widgets/buttons';
import { element } from '../widgets/dom';
import { Held } from '../widgets/held';
import { qrPicture } from '../widgets/qr_picture';
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

class ShareDialog {
  readonly root = element('dialog', { class: 'help share-dialog', 'aria-labelledby': 'share-title' });
  private said_ = '';

  constructor(
    private readonly thing_: SharedThing,
    private readonly found_: LocalLink,
  ) {
    this.root.addEventListener('close', () => this.root.remove());
    this.root.addEventListener('click', (event) => event.target === this.root && this.root.close());
    this.draw();
  }

  private row(label: string, link: string): VNode {
    let field: HTMLInputElement | null = null;
    const pressed = (): void => {
      if (!field) return;
      void copy(field).then((done) => {
        this.said_ = done ? 'Link copied.' : 'The link is selected: copy it with Ctrl+C.';
        this.draw();
      });
    };
    return (
      <div class="share-row">
        <input type="text" readonly value={link} aria-label={label} ref={(made) => void (field = made)} />
        <button type="button" class="solid" onClick={pressed}>
          <Icon name="link" />
          Copy link
        </button>
      </div>
    );
  }

  private draw(): void {
    const { link, here, site, code } = this.found_;
    render(
      <>
        <header>
          <h2 id="share-title">{`Share “${this.thing_.title}”`}</h2>
          <button type="button" aria-label="Close" onClick={() => this.root.close()}>
            <Icon name="close" />
          </button>
        </header>
        <div class="share-body">
          {this.row('Link', link)}
          <p class="secondary">{here ? kOnlyHere : kOthers}</p>
          {code.length > 0 && !here && <Held key="code" make={() => qrPicture(code)} />}
          {site !== '' && this.row('Link to your site', site)}
          {site !== '' && <p class="secondary">{kSite}</p>}
          {code.length > 0 && here && <Held key="code" make={() => qrPicture(code)} />}
          <p class="share-said" role="status">
            {this.said_}
          </p>
        </div>
      </>,
      this.root,
    );
  }
}

/** Throws a sentence where there is no link. */
export async function showShare(thing: SharedThing): Promise<void> {
  const dialog = new ShareDialog(thing, await localLink(thing));
  document.body.append(dialog.root);
  dialog.root.showModal();
}
