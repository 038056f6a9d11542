// The dialog in which a formation is changed, saved with a name, or taken from a picture, before the crowd moves.

import { Component, type VNode } from 'preact';
import type { GroundPoint } from '../../model/plane';
import { kMostLetters, removeShape, savedShapes, saveShape, type SavedShape } from '../../model/saved_shapes';
import { forCount, loosened, turned, type OwnShape } from '../../model/shape_edit';
import { Button, Icon } from '../widgets/buttons';
import { Dialog, Field } from '../widgets/dialog';
import { fileInput } from '../widgets/file_input';
import { Held } from '../widgets/held';
import { PlaceDots } from '../widgets/place_dots';
import { activeGroup, Ends, inMetres, kGap, leave, type ShapeDialogProps } from './dialog_ends';
import { picturePlaces } from './picture_shape';

const kTurn = Math.PI / 8;
const kLooser = 1.15;
const storage = (): Storage => window.localStorage;

const kChanges: readonly (readonly [string, (shape: OwnShape) => OwnShape])[] = [
  ['Turn left', (shape) => turned(shape, kTurn)],
  ['Turn right', (shape) => turned(shape, -kTurn)],
  ['Closer', (shape) => loosened(shape, 1 / kLooser)],
  ['Looser', (shape) => loosened(shape, kLooser)],
];

interface Edited {
  readonly shape: OwnShape | null;
  readonly title: string;
  readonly note: string;
}

/** What lies on the ground to be looked at; the dialog goes on with it. */
let tried: Edited | null = null;

/** As they look from behind the group: ahead is up. */
const seenFromBehind = (places: readonly GroundPoint[]): GroundPoint[] => places.map(({ x, y }) => ({ x: -y, y: x }));

export class OwnShapeDialog extends Component<ShapeDialogProps, Edited> {
  private name_: HTMLInputElement | null = null;
  private readonly file_ = fileInput({
    label: 'Picture',
    accept: 'image/*,.svg',
    chosen: ([file]) => void this.read(file!),
  });
  override state: Edited = this.opened();

  private opened(): Edited {
    if (tried?.shape && this.props.state.trying) return { ...tried, note: '' };
    const group = activeGroup(this.props.state);
    const note = group ? `${group.name}: ${group.count} people.` : 'There is no group.';
    return { shape: this.props.shapes.shape(), title: '', note };
  }

  override componentDidMount(): void {
    const picture = this.props.shapes.takePicture();
    if (picture) void this.read(picture);
    this.props.shapes.lookAt(this.state.shape);
  }

  private show(edited: Partial<Edited>): void {
    this.setState(edited);
    if (edited.shape) this.props.shapes.lookAt(edited.shape);
  }

  /** What is dark in a picture, or drawn in an SVG file, becomes the formation; it stands as the visitor sees it. */
  private async read(file: File): Promise<void> {
    const count = activeGroup(this.props.state)?.count ?? 0;
    const read = await picturePlaces(file, count);
    if ('why' in read) return this.show({ note: read.why });
    const title = file.name.replace(/\.\w+$/, '').slice(0, kMostLetters);
    if (this.name_) this.name_.value = title;
    const shape = this.props.shapes.asSeen(inMetres(read.places, read.gap, kGap), kGap);
    this.show({ title, shape, note: `From “${file.name}”.` });
  }

  private save(): void {
    const name = this.name_?.value.trim() ?? '';
    const { shape } = this.state;
    if (!shape) return;
    if (name === '') {
      this.show({ note: 'A formation that is saved needs a name.' });
      return this.name_?.focus();
    }
    const kept = saveShape(storage, { name, ...shape });
    this.show({ title: name, note: kept ? `“${name}” is saved in this browser.` : 'This browser has no room for it.' });
  }

  private take(saved: SavedShape): void {
    if (this.name_) this.name_.value = saved.name;
    const shape = forCount(saved, activeGroup(this.props.state)?.count ?? 0);
    this.show({ shape, title: saved.name, note: '' });
  }

  private remove({ name }: SavedShape): void {
    removeShape(storage, name);
    this.show({ note: `“${name}” is removed.` });
  }

  private tools(): VNode {
    const mirror = ['Mirror', (shape: OwnShape) => this.props.shapes.mirrored(shape)] as const;
    return (
      <div class="shape-tools" role="group" aria-label="Changes">
        {[mirror, ...kChanges].map(([label, change]) => (
          <Button key={label} act={() => this.state.shape && this.show({ shape: change(this.state.shape), note: '' })}>
            {label}
          </Button>
        ))}
        <Button icon="open" act={() => this.file_.click()}>
          Picture…
        </Button>
        <Button act={() => this.props.actions.openDialog('qr')}>QR code…</Button>
        <Held make={() => this.file_} />
      </div>
    );
  }

  private naming(): VNode {
    return (
      <div class="shape-naming">
        <Field label="Name">
          <input
            type="text"
            maxLength={kMostLetters}
            autocomplete="off"
            ref={(made) => void (this.name_ = made)}
            onKeyDown={(event) => {
              if (event.key !== 'Enter') return;
              event.preventDefault();
              this.save();
            }}
          />
        </Field>
        <Button class="soft shape-save" act={() => this.save()}>
          Save
        </Button>
      </div>
    );
  }

  private saved(): VNode {
    const radius = this.props.state.bodyRadius;
    return (
      <ul class="shape-saved" aria-label="Saved formations">
        {savedShapes(storage)
          .reverse()
          .map((shape) => (
            <li key={shape.name}>
              <button type="button" class="shape-saved-take" onClick={() => this.take(shape)}>
                <PlaceDots places={seenFromBehind(shape.places)} radius={radius} width={56} height={40} />
                <span>{shape.name}</span>
              </button>
              <button
                type="button"
                class="shape-saved-remove"
                aria-label={`Remove ${shape.name}`}
                onClick={() => this.remove(shape)}
              >
                <Icon name="close" />
              </button>
            </li>
          ))}
      </ul>
    );
  }

  override render(props: ShapeDialogProps, { shape, title, note }: Edited): VNode {
    const { shapes, state } = props;
    tried = { shape, title, note };
    const metres = shape ? `Neighbours stand ${shape.spacing.toFixed(2)} m apart.` : '';
    const submit = (): boolean => {
      if (shape) shapes.takeShape(shape, title || 'another formation');
      return shape !== null;
    };
    const seen = shape ? shapes.seen(shape) : [];
    return (
      <Dialog title="Change the formation" close={() => leave(this.props)} submit={submit}>
        <PlaceDots
          class="shape-preview shape-preview-tall"
          places={seen}
          radius={state.bodyRadius}
          width={340}
          height={200}
        />
        {this.tools()}
        <p class="secondary shape-note" role="status">
          {[note, metres].filter((one) => one !== '').join(' ')}
        </p>
        {this.naming()}
        {this.saved()}
        <Ends {...props} title={title || 'Changed formation'} dialog="shape" shape={shape} />
      </Dialog>
    );
  }
}
