/** The camera page: a performer's face, found in the browser, plays characters of the show. */

import { showAccess } from "../access/access_banner";
import { missingRole, readAccess } from "../access/page_access";
import { CameraPage } from "./camera_page";
import { guestName } from "./guest_name";
import warmUpFace from "./landmarks/warm_up_face.jpg?no-inline";
import { CameraSession } from "./session/camera_session";

async function start(): Promise<void> {
  const worker = new Worker(new URL("./landmarks/landmark_worker.ts", import.meta.url), { name: "landmarks" });
  const page = new CameraPage();
  page.session = new CameraSession(
    worker,
    localStorage,
    () => page.changed(),
    (found) => page.draw(found),
    () => location.reload(), // the server then asks for another token
  );
  document.body.append(page);
  void readAccess().then((access) => showAccess(missingRole(access, "operate", "playing by a camera")));
  const face = await (await fetch(warmUpFace)).blob();
  await page.session.start(await createImageBitmap(face), guestName(Math.random));
}

void start();
