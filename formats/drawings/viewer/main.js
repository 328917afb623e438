// The page of `ar3d view`: shows what it holds.
import {showPages} from "./page.js";

showPages();
