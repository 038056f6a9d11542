// Who answers the page's requests: the server over HTTP, or the engine beside the page.

/** `path` is relative to the page: "takes", "scenario?name=market". */
export type Ask = (path: string, init?: RequestInit) => Promise<Response>;

let answering: Ask | null = null;

/** From now on the engine answers; null brings the server back. */
export function answerBy(engine: Ask | null): void {
  answering = engine;
}

/** True where the engine answers. */
export function hasEngine(): boolean {
  return answering !== null;
}

let own = 0;

/** From now on the server calls us by this number. */
export function setOwnNumber(client: number): void {
  own = client;
}

/** The path of a request by which all see something else: the others are told who it was. */
export function byUs(path: string): string {
  if (own === 0) return path;
  return `${path}${path.includes('?') ? '&' : '?'}by=${own}`;
}

export function ask(path: string, init: RequestInit = {}): Promise<Response> {
  return answering ? answering(path, init) : fetch(path, init);
}

/** Shows the picture at an address of ours. */
export function showPicture(image: HTMLImageElement, address: string): void {
  if (image.dataset['address'] === address) return;
  image.dataset['address'] = address;
  if (!answering) {
    image.src = address;
    return;
  }
  void urlOf(address).then((url) => {
    if (image.dataset['address'] !== address) return URL.revokeObjectURL(url);
    image.addEventListener('load', () => URL.revokeObjectURL(url), { once: true });
    image.src = url;
  }, ignore);
}

/** Saves what lies at an address of ours. */
export async function save(address: string, fileName: string): Promise<void> {
  if (!answering || address.startsWith('blob:')) return download(address, fileName);
  const url = await urlOf(address);
  download(url, fileName);
  setTimeout(() => URL.revokeObjectURL(url), kKeepMs);
}

/** Saves what the page has made. */
export function saveBlob(blob: Blob, fileName: string): void {
  const url = URL.createObjectURL(blob);
  download(url, fileName);
  setTimeout(() => URL.revokeObjectURL(url), kKeepMs);
}

/** A file stays this long, for the browser to save it. */
const kKeepMs = 60000;

async function urlOf(address: string): Promise<string> {
  const answer = await ask(address);
  if (!answer.ok) throw new Error(await answer.text());
  return URL.createObjectURL(await answer.blob());
}

function download(url: string, fileName: string): void {
  const link = document.createElement('a');
  link.href = url;
  link.download = fileName;
  link.click();
}

/** A picture that is gone is not shown. */
function ignore(): void {}
