// The dialog of places: what is saved, templates, import, and saving.

import { hasEngine } from '../../link/answers';
import { canShareLinks, copyLink } from '../../link/shared_link';
import type { KeptPlace } from '../../model/place_files/kept_place';
import type { PlaceActions } from '../../model/place_files/place_actions';
import type { PlacesView } from '../../model/studio_state';
import { element, setAttribute, setText } from '../widgets/dom';
import { icon } from '../widgets/icons';
import { field } from '../widgets/dialog_parts';
import { PlaceImport } from './place_import';
import { PlaceList } from './place_list';
import { templateCards } from './place_templates';

type Section = Exclude<PlacesView, 'none'>;

const kSections: readonly (readonly [Section, string])[] = [
  ['shelf', 'Saved'],
  ['new', 'New'],
  ['import', 'Import'],
  ['save', 'Save'],
];

/** Files that can be chosen; what they are is seen by what stands in them. */
const kAccept = '.json,.geojson,.map,.obj,.glb,.gltf,.bin,.png,.jpg,.take';

export class PlaceDialog {
  private readonly tabs_ = new Map<Section, HTMLButtonElement>();
  private readonly panels_ = new Map<Section, HTMLElement>();
  private readonly said_ = element('p', { class: 'place-said', role: 'alert', hidden: true });
  private readonly name_ = element('input', { type: 'text', maxlength: 80, autocomplete: 'off', required: true });
  private readonly saved_ = element('p', { class: 'secondary place-note', role: 'status' });
  private readonly file_ = element('input', {
    type: 'file',
    multiple: true,
    accept: kAccept,
    hidden: true,
    'aria-label': 'Open or import a place',
    tabindex: -1,
  });
  readonly list: PlaceList;
  readonly import: PlaceImport;
  readonly root: HTMLDialogElement;

  constructor(
    private readonly actions_: PlaceActions,
    closed: () => void,
  ) {
    const choose = (): void => this.file_.click();
    this.list = new PlaceList(actions_, choose);
    this.import = new PlaceImport(actions_, choose);
    const sections = [this.list.root, templateCards(actions_), this.import.root, this.saving()];
    kSections.forEach(([section], i) => this.panels_.set(section, this.panel(section, sections[i]!)));
    const close = element('button', { type: 'button', 'aria-label': 'Close' }, icon('close'));
    this.root = element(
      'dialog',
      { class: 'help place-dialog', 'aria-labelledby': 'place-title' },
      element('header', {}, element('h2', { id: 'place-title' }, 'Places'), close),
      this.tabs(),
      this.said_,
      ...this.panels_.values(),
      this.file_,
    );
    close.addEventListener('click', () => this.root.close());
    this.root.addEventListener('close', closed);
    this.root.addEventListener('click', (event) => event.target === this.root && this.root.close());
    this.file_.addEventListener('change', () => {
      const files = [...(this.file_.files ?? [])];
      this.file_.value = '';
      if (files.length > 0) actions_.openFiles(files);
    });
  }

  show(view: Section): void {
    if (!this.root.open) this.root.showModal();
    this.say('');
    for (const [section, tab] of this.tabs_) {
      setAttribute(tab, 'aria-selected', String(section === view));
      tab.tabIndex = section === view ? 0 : -1;
      this.panels_.get(section)!.hidden = section !== view;
    }
    if (view === 'save') this.name_.select();
  }

  setName(name: string): void {
    this.name_.value = name;
    setText(this.saved_, '');
  }

  setPlaces(places: readonly KeptPlace[]): void {
    this.list.set(places);
  }

  /** What went wrong; empty for nothing. */
  say(text: string): void {
    setText(this.said_, text);
    this.said_.hidden = text === '';
  }

  saySaved(text: string): void {
    setText(this.saved_, text);
  }

  private panel(section: Section, content: HTMLElement): HTMLElement {
    return element(
      'div',
      {
        class: 'place-panel',
        role: 'tabpanel',
        id: `place-${section}`,
        'aria-labelledby': `place-tab-${section}`,
        tabindex: -1,
      },
      content,
    );
  }

  private tabs(): HTMLElement {
    const bar = element('div', { class: 'place-tabs', role: 'tablist', 'aria-label': 'Places' });
    for (const [section, label] of kSections) {
      const tab = element(
        'button',
        { type: 'button', role: 'tab', id: `place-tab-${section}`, 'aria-controls': `place-${section}` },
        label,
      );
      tab.addEventListener('click', () => this.actions_.show(section));
      this.tabs_.set(section, tab);
      bar.append(tab);
    }
    bar.addEventListener('keydown', (event) => {
      const all = [...this.tabs_.values()];
      const at = all.indexOf(document.activeElement as HTMLButtonElement);
      const step = { ArrowRight: 1, ArrowLeft: all.length - 1 }[event.key];
      if (at < 0 || step === undefined) return;
      event.preventDefault();
      const next = all[(at + step) % all.length]!;
      next.click();
      next.focus();
    });
    return bar;
  }

  /** A link that holds the place, on a site. */
  private siteButton(): HTMLElement {
    const share = element('button', { type: 'button', class: 'soft' }, icon('link'), 'Copy link');
    share.addEventListener('click', () => void copyLink('place', 'scenario').then((said) => this.saySaved(said)));
    return share;
  }

  private shareButtons(share: HTMLElement): HTMLElement[] {
    if (!hasEngine()) return [share];
    return canShareLinks() ? [this.siteButton()] : [];
  }

  private saving(): HTMLElement {
    const save = element('button', { type: 'submit', class: 'solid' }, 'Save');
    const download = element('button', { type: 'button', class: 'soft' }, icon('download'), 'Download');
    const share = element('button', { type: 'button', class: 'soft place-share' }, icon('link'), 'Share…');
    const form = element(
      'form',
      { class: 'place-section' },
      field('Name', this.name_),
      element(
        'p',
        { class: 'secondary place-note' },
        hasEngine()
          ? 'The place is called so from now on, and is kept in this browser.'
          : 'The place is called so from now on, and stands in the list of places for all who direct here.',
      ),
      element('div', { class: 'place-acts' }, ...this.shareButtons(share), download, save),
      this.saved_,
    );
    const name = (): string => this.name_.value.trim();
    form.addEventListener('submit', (event) => {
      event.preventDefault();
      if (name() !== '') this.actions_.savePresent(name());
    });
    share.addEventListener('click', () => form.reportValidity() && this.actions_.sharePresent(name()));
    download.addEventListener('click', () => form.reportValidity() && this.actions_.downloadPresent(name()));
    return form;
  }
}
