/** Why a microphone cannot be heard, in words that say what to do. */

const BY_NAME: Readonly<Record<string, string>> = {
  NotAllowedError:
    "This page may not use the microphone. Allow it at the lock or camera sign in the address bar, then press Start again.",
  NotFoundError: "No microphone is plugged in. Plug one in, then press Start again.",
  OverconstrainedError: "The chosen microphone is not there any more. Choose another one, then press Start again.",
  NotReadableError:
    "The microphone is used by another program, or does not answer. Close that program, or plug it in anew.",
  AbortError: "The microphone stopped while it was opened. Press Start again.",
};

export function explainFailure(error: unknown): string {
  const { name, message } = error instanceof Error || error instanceof DOMException ? error : new Error(String(error));
  return BY_NAME[name] ?? `The microphone cannot be opened: ${message || name}.`;
}

/** Why this page can have no microphone at all; null where it can. */
export function explainMissing(
  { isSecureContext, mediaDevices }: { isSecureContext: boolean; mediaDevices: unknown },
  address: string,
): string | null {
  if (!isSecureContext)
    return (
      `A browser gives a microphone to a secure page only, and ${address} is none. ` +
      "Open this page on the machine of the show as http://localhost, or start the show with --https and open its https address."
    );
  return mediaDevices === undefined
    ? "This browser has no way to hear a microphone. Use a current Chrome, Edge, Firefox or Safari."
    : null;
}
