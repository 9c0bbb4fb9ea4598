/** The entry point of the page that compares two runs. */

import { onFileDrop } from "../../ui/file_import";
import { RunsPage } from "./runs_page";

onFileDrop(); // a file that slips from a hand must not take the page's place
document.body.append(new RunsPage());
