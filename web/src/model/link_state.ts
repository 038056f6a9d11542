// The connection to the server as the page shows it.

/** Where the connection stands. */
export type LinkState =
  | { readonly phase: 'connecting' }
  | { readonly phase: 'open' }
  /** `retryAt` by Date.now() [ms]. */
  | { readonly phase: 'lost'; readonly attempt: number; readonly retryAt: number };
