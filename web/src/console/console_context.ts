/** All that the elements of a page play with, which plays as a console does. */

import type { Bus } from "../link/bus";
import { type LinkHandlers, ShowLink } from "../link/show_link";
import { randomId } from "../ui/browser_storage";
import { FramePainter } from "../ui/frame_painter";
import { LongRequests } from "../ui/long_requests";
import { Thumbnails } from "../ui/thumbnails";
import { ConsoleName } from "./console_name";
import type { ConsoleContext } from "./controls/console_element";
import { ConsoleDevices } from "./devices/console_devices";
import { ConsoleLeases } from "./leases/console_leases";
import { seatToken } from "./leases/seat_token";
import { MappingCommands } from "./mappings/mapping_commands";
import { ConsoleSources } from "./mixer/console_sources";
import type { PageCast } from "./page_cast";
import { keepChoice } from "./scene/choice_storage";
import { FileImports } from "./show_file/file_imports";
import { LayoutStorage } from "./show_file/layout_storage";
import { OwnItems } from "./show_file/own_items";
import { keepUndo } from "./show_file/undo_storage";
import { ConsoleStore } from "./store/console_store";
import { PanicReturn } from "./store/panic_return";

/** What tells one page from another. */
export interface PageIdentity {
  /** A name for this page, so that its calls have their own ids. */
  readonly page: string;
  /** Who sits here: the same through a reload of the tab. */
  readonly seat: string;
  readonly bus: Bus;
  readonly name: ConsoleName;
  /** The layout that it opens with. */
  readonly layout: string;
}

/** The identity of a page that has just opened. */
export function newIdentity(bus: Bus, layout: string): PageIdentity {
  const name = new ConsoleName(
    () => localStorage,
    () => sessionStorage,
  );
  return { page: randomId(), seat: seatToken(() => sessionStorage, randomId), bus, name, layout };
}

/** A screen's keyboard would cover what is played: it comes where somebody asks for it. */
const FINGERS = matchMedia("(pointer: coarse)");

/** Makes all of it; `link` is there before any of it is used. */
export function openContext(link: () => ShowLink, { page, bus, name, layout }: PageIdentity): ConsoleContext {
  const clock = (): number => performance.now();
  const store = new ConsoleStore((message) => link().send(message), clock, page);
  store.bus = bus;
  keepUndo(store, () => sessionStorage);
  keepChoice(store, () => sessionStorage);
  const rename = (word: string): void => {
    name.write(word);
    link().introduce();
  };
  const layouts = new LayoutStorage(store, layout);
  const items = new OwnItems(store, clock, () => !FINGERS.matches);
  const requests = new LongRequests();
  requests.send = (message) => link().send(message);
  const imports = new FileImports(store, items, requests);
  const devices = new ConsoleDevices(store, (message) => link().send(message));
  const [painter, thumbnails, leases] = [new FramePainter(), new Thumbnails(), new ConsoleLeases(store)];
  const panicReturn = new PanicReturn(store);
  const sources = new ConsoleSources(store, (message) => link().send(message));
  const mappings = new MappingCommands(store);
  painter.add({ paint: () => store.flush() }); // first in each frame, so that what was drawn is what was sent
  return {
    store,
    painter,
    thumbnails,
    layouts,
    items,
    imports,
    devices,
    mappings,
    leases,
    panicReturn,
    sources,
    rename,
  };
}

/** The link of a page that plays. */
export function connectPage(
  { store }: ConsoleContext,
  cast: PageCast,
  { page, seat, bus, name }: PageIdentity,
): ShowLink {
  const handlers: LinkHandlers = {
    every: (message) => store.receive(message),
    welcome: (welcome) => {
      name.receive(welcome.name);
      cast.welcome(welcome.digest);
    },
    cast: () => void cast.renew(),
    connected: (up) => store.setOnline(up),
    revoked: () => location.reload(), // the server then asks for another token
    trip: (seconds) => store.receiveTrip(seconds * 1000),
  };
  return new ShowLink("console", handlers, name.read, page, seat, bus);
}
