/** Devices on a page: what the show says of them, and those at this browser, wired to the page's link and frames. */

import type { FromClient } from "../../link/messages";
import type { DeviceMessage } from "../../link/show_link";
import type { FramePainter } from "../../ui/frame_painter";
import { type Browser, BrowserDevices, thisBrowser } from "./browser_devices";
import { type DeviceHost, DeviceStore } from "./device_store";

export class ConsoleDevices {
  readonly store: DeviceStore;
  readonly browser: BrowserDevices;

  /** `send` takes a message to the show; `id` names this page. */
  constructor(host: DeviceHost, send: (message: FromClient) => void, id: string, browser: Browser = thisBrowser()) {
    this.store = new DeviceStore(host, send, id);
    this.browser = new BrowserDevices(browser, send, id);
    host.listen("link", () => {
      this.store.setOnline(host.online);
      this.browser.setOnline(host.online);
    });
  }

  /** Hears what this browser has, each frame of the page. */
  start(painter: FramePainter): void {
    painter.add({ paint: () => this.browser.look() });
    document.addEventListener("visibilitychange", () => this.browser.hide(document.hidden));
    void this.browser.start();
  }

  receive(message: DeviceMessage): void {
    if (message.type === "device_bytes") this.browser.receiveBytes(message.device, message.data);
    else this.store.receive(message);
    if (message.type === "devices") this.browser.receive(message.devices);
  }

  /** A message was rejected; whether it was one of devices. */
  receiveRefused(reason: string, id: string): boolean {
    return this.browser.receiveRefused(reason, id) || this.store.receiveRefused(reason, id);
  }
}
