/** The link of a page that has a microphone. */

import { ReconnectingSocket } from "../link/reconnecting_socket";
import type { FromMicrophone, ToMicrophone } from "./microphone_messages";
import { MICROPHONE_PATH } from "./microphone_messages";

/** What the page wants to hear. */
export interface LinkListener {
  /** The connection is open: the page says who it is. */
  greet(): void;
  received(message: ToMicrophone): void;
  connected(up: boolean): void;
  revoked(): void;
}

export class VoiceLink {
  readonly #socket: ReconnectingSocket<ToMicrophone, FromMicrophone>;

  constructor(listener: LinkListener) {
    this.#socket = new ReconnectingSocket<ToMicrophone, FromMicrophone>(MICROPHONE_PATH, {
      silence: 3,
      interval: 500,
      opened: () => {
        this.#socket.accept();
        listener.greet();
        listener.connected(true);
      },
      received: (message) => listener.received(message),
      lost: (wasUp) => wasUp && listener.connected(false),
      revoked: () => listener.revoked(),
      expects: () => this.#socket.up, // of a microphone that has begun something is told all the time
    });
  }

  send(message: FromMicrophone): boolean {
    return this.#socket.send(message);
  }
}
