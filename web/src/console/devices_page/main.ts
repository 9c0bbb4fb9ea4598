/** The devices page: connects the show to the store, and the store to the page. */

import { showAccess } from "../../access/access_banner";
import { missingRole, readAccess } from "../../access/page_access";
import { Library } from "../../link/assets";
import { type LinkHandlers, ShowLink } from "../../link/show_link";
import { randomId } from "../../ui/browser_storage";
import { onFileDrop } from "../../ui/file_import";
import { FramePainter } from "../../ui/frame_painter";
import { ConsoleName } from "../console_name";
import { ConsoleDevices } from "../devices/console_devices";
import { seatToken } from "../leases/seat_token";
import { MappingCommands } from "../mappings/mapping_commands";
import { keepUndo } from "../show_file/undo_storage";
import { ConsoleStore } from "../store/console_store";
import { DevicesPage } from "./devices_page";

const PAGE = randomId();
/** Who sits here: whom the console of the same tab was for. */
const SEAT = seatToken(() => sessionStorage, randomId);

const ownName = new ConsoleName(
  () => localStorage,
  () => sessionStorage,
);

/** The link of a page whose devices play as a console's do. */
function connect(store: ConsoleStore): ShowLink {
  const handlers: LinkHandlers = {
    every: (message) => store.receive(message),
    welcome: ({ name }) => ownName.receive(name),
    cast: () => void Library.open().then(({ manifest }) => store.setManifest(manifest)),
    connected: (up) => store.setOnline(up),
    revoked: () => location.reload(), // the server then asks for another token
  };
  return new ShowLink("console", handlers, ownName.read, PAGE, SEAT);
}

async function start(): Promise<void> {
  const store = new ConsoleStore(
    (message) => link.send(message),
    () => performance.now(),
    PAGE,
  );
  keepUndo(store, () => sessionStorage);
  const devices = new ConsoleDevices(store, (message) => link.send(message));
  const link = connect(store);
  const painter = new FramePainter();
  painter.add({ paint: () => store.flush() });
  const page = new DevicesPage();
  page.context = { store, devices, mappings: new MappingCommands(store), painter };
  document.body.append(page);
  void readAccess().then((access) => showAccess(missingRole(access, "operate", "playing by devices")));
  painter.start();
  devices.start(painter);
  store.setManifest((await Library.open()).manifest);
}

onFileDrop(); // a file that slips from a hand must not take the page's place
void start();
