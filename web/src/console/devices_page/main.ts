/** The devices page: connects the show to the store, and the store to the page. */

import { showAccess } from "../../access/access_banner";
import { missingRole, readAccess } from "../../access/page_access";
import { Library } from "../../link/assets";
import { ShowLink } from "../../link/show_link";
import { FramePainter } from "../../ui/frame_painter";
import { ConsoleName } from "../console_name";
import { ConsoleDevices } from "../devices/console_devices";
import { randomToken, seatToken } from "../leases/seat_token";
import { keepUndo } from "../show_file/undo_storage";
import { ConsoleStore } from "../store/console_store";
import { DevicesPage } from "./devices_page";

const PAGE = randomToken();
/** Who sits here: whom the console of the same tab was for. */
const SEAT = seatToken(() => sessionStorage, randomToken);

const ownName = new ConsoleName(
  () => localStorage,
  () => sessionStorage,
);

/** The link of a page whose devices play as a console's do. */
function connect(store: ConsoleStore, devices: () => ConsoleDevices): ShowLink {
  const renew = (): void => void Library.open().then(({ manifest }) => store.setManifest(manifest));
  return new ShowLink(
    "console",
    {
      welcome: ({ name, show }) => {
        store.receiveShow(show);
        ownName.receive(name);
      },
      cast: renew,
      state: (state) => store.receiveState(state),
      hands: (hands) => store.receiveHands(hands),
      refused: (reason, id) => devices().receiveRefused(reason, id) || store.receiveRefused(reason, id),
      devices: (message) => devices().receive(message),
      connected: (up) => store.setOnline(up),
      revoked: () => location.reload(), // the server then asks for another token
    },
    ownName.read,
    PAGE,
    SEAT,
  );
}

async function start(): Promise<void> {
  const store = new ConsoleStore(
    (message) => link.send(message),
    () => performance.now(),
    PAGE,
  );
  keepUndo(store, () => sessionStorage);
  const devices = new ConsoleDevices(store, (message) => link.send(message), PAGE);
  const link = connect(store, () => devices);
  const painter = new FramePainter();
  painter.add({ paint: () => store.flush() });
  const page = new DevicesPage();
  page.context = { store, devices, painter };
  document.body.append(page);
  void readAccess().then((access) => showAccess(missingRole(access, "operate", "playing by devices")));
  painter.start();
  devices.start(painter);
  store.setManifest((await Library.open()).manifest);
}

void start();
