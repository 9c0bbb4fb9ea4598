/** The console page: connects the show to the store, and the store to the page. */

import { missingRole, readAccess } from "../access/page_access";
import { Library } from "../link/assets";
import { readBus } from "../link/bus";
import { type LinkHandlers, ShowLink } from "../link/show_link";
import { randomId } from "../ui/browser_storage";
import { FramePainter } from "../ui/frame_painter";
import { LongRequests } from "../ui/long_requests";
import { loadPortraits } from "../ui/portraits";
import { ShowNoticesView } from "../ui/show_notices_view";
import { Thumbnails } from "../ui/thumbnails";
import { WakeLock } from "../ui/wake_lock";
import { ConsoleName } from "./console_name";
import { ConsolePage } from "./console_page";
import type { ConsoleContext } from "./controls/console_element";
import { ConsoleDevices } from "./devices/console_devices";
import { ConsoleLeases } from "./leases/console_leases";
import { seatToken } from "./leases/seat_token";
import { MappingCommands } from "./mappings/mapping_commands";
import { ConsoleSources } from "./mixer/console_sources";
import { showPreviewBar } from "./panels/preview_bar";
import { keepChoice } from "./scene/choice_storage";
import { FileImports } from "./show_file/file_imports";
import { LayoutStorage, layoutName } from "./show_file/layout_storage";
import { OwnItems } from "./show_file/own_items";
import { keepUndo } from "./show_file/undo_storage";
import { ConsoleStore } from "./store/console_store";
import { PanicReturn } from "./store/panic_return";
import { openThumbnails } from "./thumbnail_drawing";

/** A name for this console, so that its calls have their own ids. */
const PAGE = randomId();
/** Who sits here: the same through a reload of the tab. */
const SEAT = seatToken(() => sessionStorage, randomId);

const BUS = readBus(location.search);

/** A screen's keyboard would cover what is played: it comes where somebody asks for it. */
const FINGERS = matchMedia("(pointer: coarse)");

const ownName = new ConsoleName(
  () => localStorage,
  () => sessionStorage,
);
/** What the page has fetched of the cast; none before the server has answered. */
let library: Library | null = null;
/** It may be another than was fetched: the server said so meanwhile. */
let stale = false;

/** The cast is another: takes it in and goes on; a page of another built-in cast must begin anew. */
async function recast(store: ConsoleStore): Promise<void> {
  stale = library === null;
  if (library === null) return;
  if (!(await library.renew())) location.reload();
  else if (library.manifest !== store.manifest) store.setManifest(library.manifest);
}

function connect({ store }: ConsoleContext): ShowLink {
  const handlers: LinkHandlers = {
    every: (message) => store.receive(message),
    welcome: ({ digest, name }) => {
      ownName.receive(name);
      if (store.manifest !== null && store.manifest.digest !== digest) void recast(store);
    },
    cast: () => void recast(store),
    connected: (up) => store.setOnline(up),
    revoked: () => location.reload(), // the server then asks for another token
    trip: (seconds) => store.receiveTrip(seconds * 1000),
  };
  return new ShowLink("console", handlers, ownName.read, PAGE, SEAT, BUS);
}

/** All that the page's elements play with; `link` is there before any of it is used. */
function contextOf(link: () => ShowLink): ConsoleContext {
  const clock = (): number => performance.now();
  const store = new ConsoleStore((message) => link().send(message), clock, PAGE);
  store.bus = BUS;
  keepUndo(store, () => sessionStorage);
  keepChoice(store, () => sessionStorage);
  const rename = (name: string): void => {
    ownName.write(name);
    link().introduce();
  };
  const layouts = new LayoutStorage(store, layoutName(location.search));
  const items = new OwnItems(store, clock, () => !FINGERS.matches);
  const requests = new LongRequests();
  requests.send = (message) => link().send(message);
  const imports = new FileImports(store, items, requests);
  const devices = new ConsoleDevices(store, (message) => link().send(message));
  const [painter, thumbnails, leases] = [new FramePainter(), new Thumbnails(), new ConsoleLeases(store)];
  const panicReturn = new PanicReturn(store);
  const sources = new ConsoleSources(store, (message) => link().send(message));
  const mappings = new MappingCommands(store);
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

async function start(): Promise<void> {
  const shown = new ShowNoticesView();
  shown.classList.add("in-place");
  const context = contextOf(() => link);
  const link: ShowLink = connect(context);
  const { store } = context;
  store.hear("notices", ({ notices }) => shown.notices.receive(notices));
  shown.addEventListener("change", () => store.tell("crew"));
  context.painter.add({ paint: () => context.store.flush() }); // first in each frame, so that what was drawn is what was sent
  const page = new ConsolePage();
  page.context = context;
  page.notices = shown;
  shown.openLog = () => page.show("log");
  document.body.append(page);
  showPreviewBar(store);
  void readAccess().then((access) => {
    page.restrict(missingRole(access, "operate", "playing"));
    context.leases.barred = missingRole(access, "admin", "switching leases on or off");
  });
  context.painter.start();
  context.devices.start(context.painter);
  void loadPortraits().then((portraits) => context.thumbnails.give(portraits));
  new WakeLock(); // a tablet's screen stays on
  library = await Library.open();
  await context.layouts.open();
  store.setManifest(library.manifest);
  if (stale) void recast(context.store);
  await page.open(library);
  openThumbnails(library).then(
    (draw) => context.thumbnails.open(draw),
    (error: unknown) => console.warn("No thumbnails:", error), // names and hot keys are enough to play
  );
}

void start();
