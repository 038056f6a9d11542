// The style of a player, inside of it. Pages set the custom properties, or style the parts.

export const kStyle = `
:host {
  --_ink: var(--muster-ink, #171b20); --_panel: var(--muster-panel, #ffffff); --_line: var(--muster-line, #17202a1f);
  --_accent: var(--muster-accent, #1d5fd1); --_back: var(--muster-background, #dad5cc);
  display: block; position: relative; aspect-ratio: 16 / 9; overflow: hidden; container-type: inline-size;
  background: var(--_back); color: var(--_ink); font: 500 13px/1.35 var(--muster-font, Inter, system-ui, sans-serif);
  border-radius: var(--muster-radius, 12px); contain: content;
}
@media (max-width: 480px) { :host { aspect-ratio: 4 / 3; } }
:host([hidden]) { display: none; }
:host(:fullscreen) { aspect-ratio: auto; border-radius: 0; width: 100vw; height: 100vh; }
.root { position: absolute; inset: 0; color-scheme: light; }
.root[data-theme='dark'] {
  --_ink: var(--muster-ink, #eef1f4); --_panel: var(--muster-panel, #1f2429); --_line: var(--muster-line, #eef1f426);
  --_accent: var(--muster-accent, #74a9ff); --_back: var(--muster-background, #1b2025);
  color: var(--_ink); background: var(--_back); color-scheme: dark;
}
.view { position: absolute; inset: 0; touch-action: pan-y; outline: none; }
.view[data-orbit] { cursor: grab; }
.view[data-orbit]:active { cursor: grabbing; }
:host(:fullscreen) .view { touch-action: none; }
.view:focus-visible::after {
  content: ''; position: absolute; inset: 2px; border: 2px solid var(--_accent); border-radius: inherit; pointer-events: none;
}
canvas, .poster { position: absolute; inset: 0; width: 100%; height: 100%; display: block; }
.poster { object-fit: cover; pointer-events: none; }
.bar {
  position: absolute; left: 12px; right: 12px; bottom: 12px; height: 48px; padding: 0 4px; display: flex; align-items: center;
  gap: 4px; background: color-mix(in srgb, var(--_panel) 94%, transparent); border: 1px solid var(--_line); border-radius: 16px;
  box-shadow: 0 4px 16px #0000001f; transition: opacity 0.25s; max-width: 720px; margin: 0 auto;
}
.bar[data-away] { opacity: 0; }
.bar[data-away]:focus-within { opacity: 1; }
button {
  all: unset; box-sizing: border-box; flex: none; width: 44px; height: 44px; display: grid; place-items: center;
  border-radius: 12px; cursor: pointer; color: var(--_ink);
}
button:hover { background: color-mix(in srgb, var(--_ink) 8%, transparent); }
button:focus-visible, input:focus-visible { outline: 2px solid var(--_accent); outline-offset: -2px; }
svg { width: 20px; height: 20px; fill: none; stroke: currentColor; stroke-width: 1.6; stroke-linecap: round; stroke-linejoin: round; }
input {
  flex: 1; min-width: 40px; height: 44px; margin: 0 8px 0 4px; appearance: none; background: none; cursor: pointer;
  border-radius: 12px; touch-action: none;
}
input::-webkit-slider-runnable-track {
  height: 4px; border-radius: 2px;
  background: linear-gradient(to right, var(--_accent) var(--share, 0%), color-mix(in srgb, var(--_ink) 22%, transparent) 0);
}
input::-moz-range-track { height: 4px; border-radius: 2px; background: color-mix(in srgb, var(--_ink) 22%, transparent); }
input::-moz-range-progress { height: 4px; border-radius: 2px; background: var(--_accent); }
input::-webkit-slider-thumb { appearance: none; width: 16px; height: 16px; margin-top: -6px; border-radius: 50%; background: var(--_accent); }
input::-moz-range-thumb { width: 16px; height: 16px; border: 0; border-radius: 50%; background: var(--_accent); }
.time { flex: none; font-variant-numeric: tabular-nums; white-space: nowrap; padding-right: 4px; }
.start {
  position: absolute; left: 50%; top: 50%; width: 72px; height: 72px; margin: -36px; border-radius: 50%;
  background: color-mix(in srgb, var(--_panel) 94%, transparent); border: 1px solid var(--_line); box-shadow: 0 4px 16px #0000001f;
}
.start:hover { background: var(--_panel); }
.start svg { width: 30px; height: 30px; }
.message {
  position: absolute; inset: 0; display: grid; place-items: center; text-align: center; padding: 24px; margin: 0;
  background: var(--_back); font-size: 15px; overflow-wrap: anywhere; overflow: auto;
}
[hidden] { display: none !important; }
@container (max-width: 420px) {
  .bar { left: 6px; right: 6px; bottom: 6px; }
  .start { width: 60px; height: 60px; margin: -30px; }
}
@media (prefers-reduced-motion: reduce) { .bar { transition: none; } }
@media (forced-colors: active) { .bar, .start { border: 1px solid; } }
`;
