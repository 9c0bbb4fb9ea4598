/** The microphone of this browser: opened, heard in a worklet, closed. */

import { explainFailure, explainMissing } from "./capture_failure";
import captureUrl from "./capture_worklet.ts?worker&url";
import type { MicrophoneSettings } from "./microphone_settings";

/** A microphone to choose. */
export interface Device {
  readonly id: string;
  readonly label: string;
}

/** What is heard, and what became of the device. */
export interface Listener {
  heard(samples: Int16Array): void;
  /** The device is gone, in words. */
  ended(reason: string): void;
}

const ENDED = "The microphone was unplugged, or the browser took it away. Press Start to hear it again.";

export class MicrophoneCapture {
  #context: AudioContext | null = null;
  #stream: MediaStream | null = null;

  constructor(private readonly listener: Listener) {}

  get isOpen(): boolean {
    return this.#context !== null;
  }

  /** The name of the device that is heard. */
  get label(): string {
    return this.#stream?.getAudioTracks()[0]?.label ?? "";
  }

  /** Opens it; returns why it could not be opened, null where it is. */
  async open({ device, cleaning }: MicrophoneSettings): Promise<string | null> {
    this.close();
    const missing = explainMissing({ isSecureContext, mediaDevices: navigator.mediaDevices }, location.origin);
    if (missing !== null) return missing;
    try {
      const wanted = { ...cleaning, ...(device === "" ? {} : { deviceId: { exact: device } }), channelCount: 1 };
      this.#stream = await navigator.mediaDevices.getUserMedia({ audio: wanted });
      await this.#listen(this.#stream);
      return null;
    } catch (error) {
      this.close();
      return explainFailure(error);
    }
  }

  close(): void {
    for (const track of this.#stream?.getTracks() ?? []) {
      track.onended = null;
      track.stop();
    }
    void this.#context?.close();
    this.#stream = this.#context = null;
  }

  async #listen(stream: MediaStream): Promise<void> {
    const context = new AudioContext({ latencyHint: "interactive" });
    this.#context = context;
    await context.audioWorklet.addModule(captureUrl);
    const node = new AudioWorkletNode(context, "capture");
    node.port.onmessage = ({ data }: MessageEvent<Int16Array>) => this.listener.heard(data);
    context.createMediaStreamSource(stream).connect(node).connect(context.destination); // what leads nowhere is not run
    await context.resume();
    for (const track of stream.getAudioTracks())
      track.onended = () => {
        this.close();
        this.listener.ended(ENDED);
      };
  }
}

/** The microphones that there are; their names are known once one was allowed. */
export async function listDevices(): Promise<Device[]> {
  const all = (await navigator.mediaDevices?.enumerateDevices().catch(() => [])) ?? [];
  const inputs = all.filter(({ kind, deviceId }) => kind === "audioinput" && deviceId !== "");
  return inputs.map(({ deviceId, label }, at) => ({ id: deviceId, label: label || `Microphone ${at + 1}` }));
}
