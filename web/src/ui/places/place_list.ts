// The browser's shelf of places, the newest first.

import { formatAge } from '../../model/take_facts';
import { placeTitle, type KeptPlace } from '../../model/place_files/kept_place';
import type { PlaceActions } from '../../model/place_files/place_actions';
import { element } from '../widgets/dom';
import { icon, type IconName } from '../widgets/icons';
import { toolButton } from '../widgets/tool_button';

export class PlaceList {
  private readonly list_ = element('ul', { class: 'place-list', 'aria-label': 'Saved places' });
  private readonly undo_ = element('div', { class: 'shelf-undo', hidden: true });
  private readonly empty_ = element(
    'p',
    { class: 'secondary place-note' },
    'Nothing is saved yet. A place that you save is kept in this browser.',
  );
  readonly root = element('div', { class: 'place-section' });
  private pictures_: string[] = [];

  constructor(
    private readonly actions_: PlaceActions,
    chooseFiles: () => void,
    private readonly now_: () => number = () => Date.now() / 1000,
  ) {
    const open = element('button', { type: 'button', class: 'soft place-open-file' }, icon('open'), 'Open a file…');
    open.addEventListener('click', chooseFiles);
    this.root.append(open, this.undo_, this.list_, this.empty_);
  }

  set(places: readonly KeptPlace[]): void {
    for (const address of this.pictures_) URL.revokeObjectURL(address);
    this.pictures_ = [];
    this.empty_.hidden = places.length > 0;
    const focused = (document.activeElement as HTMLElement | null)?.dataset['key'];
    this.list_.replaceChildren(...places.map((place) => this.item(place)));
    if (focused) this.list_.querySelector<HTMLElement>(`[data-key="${CSS.escape(focused)}"]`)?.focus();
  }

  /** After a place was removed. */
  offerUndo(place: KeptPlace): void {
    const back = element('button', { type: 'button', class: 'soft' }, icon('undo'), 'Bring it back');
    back.addEventListener('click', () => {
      this.undo_.hidden = true;
      this.root.querySelector<HTMLElement>('button')?.focus();
      this.actions_.restorePlace();
    });
    this.undo_.replaceChildren(element('span', {}, `“${placeTitle(place)}” is removed.`), back);
    this.undo_.hidden = false;
    back.focus();
  }

  forgetUndo(): void {
    this.undo_.hidden = true;
  }

  private picture({ picture }: KeptPlace): HTMLElement {
    if (!picture) return element('span', { class: 'shelf-no-picture' }, icon('empty', 24));
    const address = URL.createObjectURL(picture);
    this.pictures_.push(address);
    return element('img', { src: address, alt: '', width: 128, height: 72 });
  }

  private item(place: KeptPlace): HTMLElement {
    const title = placeTitle(place);
    const about = [place.facts, formatAge(place.changed, this.now_())].filter((one) => one !== '').join(' · ');
    const words = element(
      'span',
      { class: 'shelf-words' },
      element('strong', {}, title),
      element('span', { class: 'secondary' }, about),
    );
    const main = element(
      'button',
      { type: 'button', class: 'shelf-item-open', 'aria-label': `Open ${title}`, 'data-key': `open ${place.id}` },
      this.picture(place),
      words,
    );
    main.addEventListener('click', () => this.actions_.openPlace(place));
    const item = element('li', { class: 'place-item' }, main);
    const tool = (name: IconName, label: string, act: () => void): HTMLElement => {
      const button = toolButton({ icon: name, label: `${label} ${title}`, iconOnly: true, act });
      button.dataset['key'] = `${name} ${place.id}`;
      return button;
    };
    item.append(
      element(
        'span',
        { class: 'place-tools' },
        tool('rename', 'Rename', () => this.askName(item, place)),
        tool('copy', 'Duplicate', () => this.actions_.duplicatePlace(place)),
        tool('download', 'Download', () => this.actions_.downloadPlace(place)),
        tool('close', 'Remove', () => this.actions_.removePlace(place)),
      ),
    );
    return item;
  }

  private askName(item: HTMLElement, place: KeptPlace): void {
    const name = element('input', {
      type: 'text',
      maxlength: 80,
      value: place.name,
      'aria-label': 'Name',
      required: true,
    });
    const done = element('button', { type: 'submit', class: 'soft' }, 'Rename');
    const form = element('form', { class: 'place-rename' }, name, done);
    const leave = (): void => {
      form.remove();
      item.querySelector<HTMLElement>(`[data-key="${CSS.escape(`rename ${place.id}`)}"]`)?.focus();
    };
    form.addEventListener('submit', (event) => {
      event.preventDefault();
      const wanted = name.value.trim();
      if (wanted === '') return;
      leave();
      if (wanted !== place.name || place.auto) this.actions_.renamePlace(place, wanted);
    });
    form.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape') return;
      event.preventDefault();
      event.stopPropagation();
      leave();
    });
    item.querySelector('.place-rename')?.remove();
    item.append(form);
    name.select();
  }
}
