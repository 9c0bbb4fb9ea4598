/** The camera page: a performer's face, found in the browser, plays characters of the show. */

import { showAccess } from "../access/access_banner";
import { missingRole, readAccess } from "../access/page_access";
import { openLandmarkWorker, warmUpPicture } from "../face_mesh/landmark_client";
import { onFileDrop } from "../ui/file_import";
import { CameraPage } from "./camera_page";
import { guestName } from "./guest_name";
import { CameraSession } from "./session/camera_session";

async function start(): Promise<void> {
  const page = new CameraPage();
  page.session = new CameraSession(
    openLandmarkWorker(),
    localStorage,
    () => page.changed(),
    (landmarks) => page.draw(landmarks),
    () => location.reload(), // the server then asks for another token
  );
  document.body.append(page);
  void readAccess().then((access) => showAccess(missingRole(access, "operate", "playing by a camera")));
  await page.session.start(warmUpPicture(), guestName(Math.random));
}

onFileDrop(); // a file that slips from a hand must not take the page's place
void start();
