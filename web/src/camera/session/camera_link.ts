/** The camera page's link to the show: landmarks and wishes out, what the show makes of them in. */

import { ReconnectingSocket } from "../../link/reconnecting_socket";
import { CAMERA_PATH, CAMERA_VERSION, type CameraStatus, type FromCamera, type ToCamera } from "./camera_messages";

/** What the page is told. */
export interface CameraLinkListener {
  status(status: CameraStatus): void;
  refused(reason: string): void;
  displaced(): void;
  connected(up: boolean): void;
  revoked(): void;
}

/** A refusal from the relay of `omote track` says why the show cannot be reached. */
const SILENCE = 5;
const LOOK_MS = 500;

/** One performer at a time; says again who performs when the link comes back. */
export class CameraLink {
  #socket: ReconnectingSocket<ToCamera, FromCamera> | null = null;
  #name = "";

  constructor(private readonly listener: CameraLinkListener) {}

  /** Plays as this performer from now on; "" for nobody. */
  perform(name: string): void {
    this.#name = name;
    if (name === "") this.close();
    else if (this.#socket === null) this.#open();
    else this.#greet();
  }

  /** The name changed at the show: nothing is to be said, but by the next link. */
  rename(name: string): void {
    this.#name = name;
  }

  /** Sends a wish; false where there is no link. */
  send(message: FromCamera): boolean {
    return this.#socket?.send(message) ?? false;
  }

  /** Sends a frame of landmarks; one for which there is no link is dropped. */
  sendFrame(frame: ArrayBuffer): void {
    if (this.#socket?.up) this.#socket.sendBytes(frame);
  }

  /** Ends the link; its source ends with it. */
  close(): void {
    this.#socket?.close();
    this.#socket = null;
  }

  #open(): void {
    this.#socket = new ReconnectingSocket<ToCamera, FromCamera>(CAMERA_PATH, {
      silence: SILENCE,
      interval: LOOK_MS,
      opened: () => this.#greet(),
      received: (message) => this.#receive(message),
      lost: () => this.listener.connected(false),
      revoked: () => this.listener.revoked(),
      expects: () => this.#socket?.up ?? false,
    });
  }

  #greet(): void {
    this.#socket?.send({ type: "perform", version: CAMERA_VERSION, name: this.#name });
  }

  #receive(message: ToCamera): void {
    if (message.type === "camera_status") {
      if (!this.#socket?.up) {
        this.#socket?.accept();
        this.listener.connected(true);
      }
      this.listener.status(message);
    } else if (message.type === "camera_refused") {
      this.listener.refused(message.reason);
    } else {
      this.close();
      this.listener.displaced();
    }
  }
}
