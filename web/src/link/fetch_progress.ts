/** What is being fetched, and how much of it has come: for whoever shows progress. */

/** One address that is, or was, being fetched. */
export interface Download {
  readonly address: string;
  /** Bytes that have come, and that will have come; undefined: the server has not said. */
  received: number;
  total: number | undefined;
  ended: boolean;
}

/** Downloads that are remembered: a show goes on for days. */
const MOST = 400;

/** The latest downloads since the page began; tells its listeners of every change. */
export class Downloads {
  readonly all: Download[] = [];
  readonly #listeners = new Set<() => void>();

  /** Calls `changed` whenever bytes come; returns what ends that. */
  listen(changed: () => void): () => void {
    this.#listeners.add(changed);
    return () => this.#listeners.delete(changed);
  }

  /** Fetches an address by `ask` and notes what comes; rejects as `ask` does, or when the rest does not come. */
  async follow(address: string, ask: () => Promise<Response>): Promise<{ response: Response; bytes: Uint8Array }> {
    const download: Download = { address, received: 0, total: undefined, ended: false };
    this.all.push(download);
    if (this.all.length > MOST) this.#forget();
    this.#tell();
    try {
      const response = await ask();
      download.total = lengthOf(response);
      return { response, bytes: await this.#read(response, download) };
    } finally {
      download.ended = true;
      this.#tell();
    }
  }

  async #read({ body }: Response, download: Download): Promise<Uint8Array> {
    const chunks: Uint8Array[] = [];
    const reader = body?.getReader();
    for (let part = await reader?.read(); part !== undefined && !part.done; part = await reader?.read()) {
      chunks.push(part.value);
      download.received += part.value.length;
      this.#tell();
    }
    return joined(chunks, download.received);
  }

  #forget(): void {
    const oldest = this.all.findIndex(({ ended }) => ended);
    if (oldest >= 0) this.all.splice(oldest, 1);
  }

  #tell(): void {
    for (const changed of this.#listeners) changed();
  }
}

/** The bytes that a response says it has; packed ones come as more than that. */
function lengthOf({ headers }: Response): number | undefined {
  const said = headers.get("content-length");
  return said === null || headers.has("content-encoding") ? undefined : Number(said);
}

function joined(chunks: readonly Uint8Array[], length: number): Uint8Array {
  const whole = new Uint8Array(length);
  let at = 0;
  for (const chunk of chunks) {
    whole.set(chunk, at);
    at += chunk.length;
  }
  return whole;
}

/** The downloads of this page. */
export const downloads = new Downloads();
