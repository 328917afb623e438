// Writes play.html: the viewer's modules and three.js, the page's own, and the program as deflated WebAssembly.
//   node apps/play/page.mjs CORE.js CORE.wasm PAGE
// Scripts and style are named by their hashes in the content security policy; nothing else runs, nothing is asked for.
import {createHash} from "node:crypto";
import {readFileSync, writeFileSync} from "node:fs";
import {dirname, join} from "node:path";
import {fileURLToPath} from "node:url";
import {deflateSync} from "node:zlib";

const [core, wasm, page] = process.argv.slice(2);
const here = dirname(fileURLToPath(import.meta.url)), viewer = join(here, "..", "..", "formats", "drawings", "viewer");
const textOf = (folder, name) => readFileSync(join(folder, name), "utf8");
// As ar3d_joined (tools/cmake/embed.cmake): modules of one script share their names.
const moduleOf = (folder, name) =>
  textOf(folder, name).replace(/\nimport \{[^}]*\} from [^;]*;/g, "").replace(/\nexport /g, "\n");
const [, modules] = textOf(viewer, "embed_viewer.cmake").match(/set\(viewer_modules ([^)]*)\)/);

const three = "\n" + textOf(viewer, "three/three.min.js");
const script = "\n" + modules.split(" ").map(name => moduleOf(viewer, name)).join("") +
  ["given.js", "play.js"].map(name => moduleOf(here, name)).join("");
const style = "\n" + textOf(viewer, "page.css") + textOf(here, "play.css");
const data = {core: readFileSync(core, "utf8"), worker: textOf(here, "worker.js"),
  program: deflateSync(readFileSync(wasm), {level: 9}).toString("base64")};
for (const text of [three, script, ...Object.values(data)]) if (/<\/script/i.test(text)) throw new Error("a script ends itself");

const hashOf = text => `'sha256-${createHash("sha256").update(text).digest("base64")}'`;
const policy = `default-src 'none'; script-src ${hashOf(three)} ${hashOf(script)} 'wasm-unsafe-eval'; worker-src blob:; ` +
  `style-src ${hashOf(style)}; img-src data: blob:; form-action 'none'; base-uri 'none'`;
writeFileSync(page, `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="generator" content="ar3d play">
<meta http-equiv="Content-Security-Policy" content="${policy}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>ar3d: draw a graph in 3D, and prove it</title>
<style>${style}</style>
</head>
<body>
${textOf(viewer, "page.html")}${textOf(here, "play.html")}${Object.entries(data).map(([id, text]) =>
  `<script type="text/plain" id="${id}">${text}</script>\n`).join("")}<script>${three}</script>
<script>${script}</script>
</body>
</html>
`);
