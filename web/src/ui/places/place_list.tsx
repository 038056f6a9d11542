// The browser's shelf of places, the newest first, and places to begin with.

import { Component, type VNode } from 'preact';
import { formatAge } from '../../model/take_facts';
import { placeTitle, type KeptPlace } from '../../model/place_files/kept_place';
import type { PlaceActions } from '../../model/place_files/place_actions';
import { drawingOf, factsOf } from '../../model/place_files/place_drawing';
import { kTemplates } from '../../model/place_files/templates';
import { Button, Icon, toolButton } from '../widgets/buttons';
import { UndoRow } from '../widgets/undo_row';
import { PlacePicture } from './place_picture';

class KeptPicture extends Component<{ readonly picture: Blob }> {
  private readonly address_ = URL.createObjectURL(this.props.picture);

  override componentWillUnmount(): void {
    URL.revokeObjectURL(this.address_);
  }

  override render(): VNode {
    return <img src={this.address_} alt="" width={128} height={72} />;
  }
}

interface ItemProps {
  readonly place: KeptPlace;
  readonly actions: PlaceActions;
}

interface Renaming {
  /** What has the focus again afterwards. */
  readonly opener: HTMLElement | null;
}

class Item extends Component<ItemProps, Renaming> {
  override state: Renaming = { opener: null };

  private readonly opened = (made: HTMLInputElement | null): void => {
    made?.focus();
    made?.select();
  };

  private leave(): void {
    this.state.opener?.focus();
    this.setState({ opener: null });
  }

  private renamed(event: Event): void {
    event.preventDefault();
    const { place, actions } = this.props;
    const wanted = (event.currentTarget as HTMLElement).querySelector('input')!.value.trim();
    if (wanted === '') return;
    this.leave();
    if (wanted !== place.name || place.auto) actions.renamePlace(place, wanted);
  }

  private renaming({ name }: KeptPlace): VNode {
    const pressed = (event: KeyboardEvent): void => {
      if (event.key !== 'Escape') return;
      event.preventDefault();
      event.stopPropagation();
      this.leave();
    };
    return (
      <form class="place-rename" onSubmit={(event) => this.renamed(event)} onKeyDown={pressed}>
        <input type="text" maxLength={80} defaultValue={name} aria-label="Name" required ref={this.opened} />
        <Button type="submit">Rename</Button>
      </form>
    );
  }

  override render({ place, actions }: ItemProps, { opener }: Renaming): VNode {
    const title = placeTitle(place);
    const about = [place.facts, formatAge(place.changed, Date.now() / 1000)].filter((one) => one !== '');
    return (
      <li class="place-item">
        <button
          type="button"
          class="shelf-item-open"
          aria-label={`Open ${title}`}
          onClick={() => actions.openPlace(place)}
        >
          {place.picture ? (
            <KeptPicture key={place.changed} picture={place.picture} />
          ) : (
            <span class="shelf-no-picture">
              <Icon name="empty" size={24} />
            </span>
          )}
          <span class="shelf-words">
            <strong>{title}</strong>
            <span class="secondary">{about.join(' · ')}</span>
          </span>
        </button>
        <span class="place-tools">
          {toolButton(
            'rename',
            `Rename ${title}`,
            ({ currentTarget }) => this.setState({ opener: currentTarget as HTMLElement }),
            { iconOnly: true },
          )}
          {toolButton('copy', `Duplicate ${title}`, () => actions.duplicatePlace(place), { iconOnly: true })}
          {toolButton('download', `Download ${title}`, () => actions.downloadPlace(place), { iconOnly: true })}
          {toolButton('close', `Remove ${title}`, () => actions.removePlace(place), { iconOnly: true })}
        </span>
        {opener && this.renaming(place)}
      </li>
    );
  }
}

export interface PlaceListProps {
  readonly places: readonly KeptPlace[];
  /** What can be brought back. */
  readonly removed: KeptPlace | null;
  readonly actions: PlaceActions;
  readonly chooseFiles: () => void;
}

export function PlaceList({ places, removed, actions, chooseFiles }: PlaceListProps): VNode {
  let first: HTMLElement | null = null;
  const back = (): void => {
    first?.querySelector<HTMLElement>('.place-open-file')?.focus();
    actions.restorePlace();
  };
  return (
    <div class="place-section" ref={(made) => void (first = made)}>
      <Button icon="open" class="soft place-open-file" act={chooseFiles}>
        Open a file…
      </Button>
      {removed && <UndoRow key={removed.id} title={placeTitle(removed)} back={back} />}
      <ul class="place-list" aria-label="Saved places">
        {places.map((place) => (
          <Item key={place.id} place={place} actions={actions} />
        ))}
      </ul>
      <p class="secondary place-note" hidden={places.length > 0}>
        Nothing is saved yet. A place that you save is kept in this browser.
      </p>
    </div>
  );
}

/** Places to begin with, as cards. */
export function TemplateCards({ actions }: { readonly actions: PlaceActions }): VNode {
  return (
    <div class="place-section">
      <ul class="place-cards" aria-label="Templates">
        {kTemplates.map((template) => {
          const place = template.make();
          return (
            <li key={template.name}>
              <button type="button" class="place-card" onClick={() => actions.openTemplate(template)}>
                <span class="place-card-picture">
                  <PlacePicture drawing={drawingOf(place)} />
                </span>
                <strong>{template.name}</strong>
                <span class="secondary place-card-about">{place.description}</span>
                <span class="secondary place-card-facts">{factsOf(place)}</span>
              </button>
            </li>
          );
        })}
      </ul>
    </div>
  );
}
