// How large a pixel of this display is: an outline on the page is made as high as a bank card.

import { Component, type VNode } from 'preact';

/** The short side of a bank card (ISO/IEC 7810, ID-1) [mm]. */
const kCard = 53.98;
const kLong = 85.6;
const kLeast = 120;
const kMost = 430;
/** On a display of 96 dpi. */
const kUsual = 204;

/** Size of a pixel for an outline of that height [mm]. */
export function pixelSize(height: number): number {
  return Math.round((kCard / height) * 1e4) / 1e4;
}

export class PixelField extends Component<{ readonly name: string }, { readonly height: number }> {
  override state = { height: kUsual };

  override render({ name }: { readonly name: string }, { height }: { readonly height: number }): VNode {
    const width = `min(100%, ${Math.round((height * kLong) / kCard)}px)`;
    return (
      <div class="study-field">
        <label for="study-card">How large is this screen?</label>
        <p class="secondary">
          Hold a bank card against the screen and move the slider until the outline is as high as the card’s short side.
        </p>
        <input
          type="range"
          id="study-card"
          name={name}
          min={kLeast}
          max={kMost}
          step={1}
          value={height}
          onInput={({ currentTarget }) => this.setState({ height: currentTarget.valueAsNumber })}
        />
        <div class="study-card-outline" aria-hidden="true" style={{ height: `${height}px`, width }}>
          Bank card
        </div>
      </div>
    );
  }
}
