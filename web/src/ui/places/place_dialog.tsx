// The dialog of places: what is saved, templates, import, and saving.

import { Component, render, type VNode } from 'preact';
import { hasEngine } from '../../link/answers';
import { canShareLinks, copyLink } from '../../link/shared_link';
import { clockOf, type KeptPlace } from '../../model/place_files/kept_place';
import type { PlaceActions } from '../../model/place_files/place_actions';
import type { PlacesView } from '../../model/studio_state';
import { Banner } from '../widgets/banner';
import { Button } from '../widgets/buttons';
import { Field, Modal } from '../widgets/dialog';
import { element } from '../widgets/dom';
import { fileInput } from '../widgets/file_input';
import { Held } from '../widgets/held';
import { PlaceImport, type Import } from './place_import';
import { PlaceList, TemplateCards } from './place_list';

type Section = Exclude<PlacesView, 'none'>;

const kSections: readonly (readonly [Section, string])[] = [
  ['shelf', 'Saved'],
  ['new', 'New'],
  ['import', 'Import'],
  ['save', 'Save'],
];

/** Files that can be chosen; what they are is seen by what stands in them. */
const kAccept = '.json,.geojson,.map,.obj,.glb,.gltf,.bin,.png,.jpg,.take';

export interface PlacesShown {
  readonly view: PlacesView;
  readonly places: readonly KeptPlace[];
  /** What can be brought back. */
  readonly removed: KeptPlace | null;
  readonly importing: Import | null;
  /** What the present place is called. */
  readonly name: string;
  /** What went wrong; empty for nothing. */
  readonly said: string;
  /** What became of the present place. */
  readonly saved: string;
}

interface TabsProps {
  readonly view: Section;
  readonly choose: (section: Section) => void;
}

function Tabs({ view, choose }: TabsProps): VNode {
  const pressed = (event: KeyboardEvent): void => {
    const tabs = [...(event.currentTarget as HTMLElement).querySelectorAll('button')];
    const at = tabs.findIndex((tab) => tab === document.activeElement);
    const step = { ArrowRight: 1, ArrowLeft: tabs.length - 1 }[event.key];
    if (at < 0 || step === undefined) return;
    event.preventDefault();
    const next = tabs[(at + step) % tabs.length]!;
    next.click();
    next.focus();
  };
  return (
    <div class="place-tabs" role="tablist" aria-label="Places" onKeyDown={pressed}>
      {kSections.map(([section, label]) => (
        <button
          key={section}
          type="button"
          role="tab"
          id={`place-tab-${section}`}
          aria-controls={`place-${section}`}
          aria-selected={section === view}
          tabIndex={section === view ? 0 : -1}
          onClick={() => choose(section)}
        >
          {label}
        </button>
      ))}
    </div>
  );
}

interface SavingProps {
  readonly name: string;
  readonly saved: string;
  readonly say: (saved: string) => void;
  readonly actions: PlaceActions;
}

class Saving extends Component<SavingProps> {
  private form_: HTMLFormElement | null = null;

  override componentDidMount(): void {
    this.form_!.querySelector('input')!.select();
  }

  private with(act: (name: string) => void): void {
    const name = this.form_!.querySelector('input')!.value.trim();
    if (this.form_!.reportValidity() && name !== '') act(name);
  }

  /** On a site a link holds the place. */
  private share({ say, actions }: SavingProps): VNode | null {
    if (!hasEngine())
      return (
        <Button icon="link" class="soft place-share" act={() => this.with((name) => actions.sharePresent(name))}>
          Share…
        </Button>
      );
    if (!canShareLinks()) return null;
    return (
      <Button icon="link" act={() => void copyLink('place', 'scenario').then(say)}>
        Copy link
      </Button>
    );
  }

  override render(props: SavingProps): VNode {
    const { name, saved, actions } = props;
    return (
      <form
        class="place-section"
        ref={(made) => void (this.form_ = made)}
        onSubmit={(event) => {
          event.preventDefault();
          this.with((given) => actions.savePresent(given));
        }}
      >
        <Field label="Name">
          <input type="text" maxLength={80} autocomplete="off" required defaultValue={name} />
        </Field>
        <p class="secondary place-note">
          {hasEngine()
            ? 'The place is called so from now on, and is kept in this browser.'
            : 'The place is called so from now on, and stands in the list of places for all who direct here.'}
        </p>
        <div class="place-acts">
          {this.share(props)}
          <Button icon="download" act={() => this.with((given) => actions.downloadPresent(given))}>
            Download
          </Button>
          <Button type="submit" class="solid">
            Save
          </Button>
        </div>
        <p class="secondary place-note" role="status">
          {saved}
        </p>
      </form>
    );
  }
}

export class PlaceDialog {
  readonly root = element('div', { class: 'dialogs' });
  private readonly file_: HTMLInputElement;
  private shown_: PlacesShown = {
    view: 'none',
    places: [],
    removed: null,
    importing: null,
    name: '',
    said: '',
    saved: '',
  };

  constructor(
    private readonly actions_: PlaceActions,
    private readonly close_: () => void,
  ) {
    const label = 'Open or import a place';
    const chosen = (files: readonly File[]): void => actions_.openFiles(files);
    this.file_ = fileInput({ label, accept: kAccept, multiple: true, chosen });
  }

  get isOpen(): boolean {
    return this.shown_.view !== 'none';
  }

  show(change: Partial<PlacesShown>): void {
    this.shown_ = { ...this.shown_, ...change };
    render(this.content(this.shown_), this.root);
  }

  private content({ view, said, ...shown }: PlacesShown): VNode | null {
    if (view === 'none') return null;
    return (
      <Modal title="Places" class="help place-dialog" close={this.close_}>
        <Tabs view={view} choose={(section) => this.actions_.show(section)} />
        <p class="place-said" role="alert" hidden={said === ''}>
          {said}
        </p>
        {kSections.map(([section]) => (
          <div
            key={section}
            class="place-panel"
            role="tabpanel"
            id={`place-${section}`}
            aria-labelledby={`place-tab-${section}`}
            tabIndex={-1}
            hidden={section !== view}
          >
            {this.section(section, shown, section === view)}
          </div>
        ))}
        <Held make={() => this.file_} />
      </Modal>
    );
  }

  private section(section: Section, shown: Omit<PlacesShown, 'view' | 'said'>, open: boolean): VNode {
    const both = { actions: this.actions_, chooseFiles: () => this.file_.click() };
    const { places, removed, importing, name, saved } = shown;
    if (section === 'shelf') return <PlaceList {...both} places={places} removed={removed} />;
    if (section === 'new') return <TemplateCards actions={this.actions_} />;
    if (section === 'save')
      return (
        <Saving
          key={open}
          name={name}
          saved={saved}
          say={(text) => this.show({ saved: text })}
          actions={this.actions_}
        />
      );
    return (
      <div class="place-section">
        <Button icon="open" act={both.chooseFiles}>
          Choose a file…
        </Button>
        <p class="secondary place-note">
          Footprints of houses as GeoJSON, models as OBJ or glTF, grid maps (.map). Files may also be dropped on the
          page.
        </p>
        {importing && <PlaceImport key={importing.source} given={importing} actions={this.actions_} />}
      </div>
    );
  }
}

export interface KeptBannerProps {
  readonly place: KeptPlace;
  readonly open: () => void;
  readonly dismiss: () => void;
}

/** Offers a place that was kept while somebody edited, where the server has another one now. */
export function KeptBanner({ place, open, dismiss }: KeptBannerProps): VNode {
  return (
    <Banner icon="place" title={`Your place ‘${place.name}’ of ${clockOf(place.changed)} is kept`} text={place.facts}>
      <div class="banner-buttons">
        <Button act={dismiss}>Dismiss</Button>
        <Button class="solid" act={open}>
          Open
        </Button>
      </div>
    </Banner>
  );
}
