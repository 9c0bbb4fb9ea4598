/** The words by which trackers and receivers are switched, as they stand after `--listen` and `--send`. */

/** A tracker's: its name, the port where it is not the usual one, and the phone or computer that is asked, if any. */
export function listenWord(name: string, port: number | null, usual: number | null, host: string): string {
  const behind = port === null || port === usual ? "" : `:${port}`;
  const at = host.trim();
  return `${name}${behind}${at === "" ? "" : `@${at}`}`;
}

/** A receiver's: the way, where it is, and whose face; the first character's where none is chosen. */
export function sendWord(way: string, host: string, port: number, character: string): string {
  return `${way}:${host.trim()}:${port}${character === "" ? "" : `=${character}`}`;
}
