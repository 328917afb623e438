"use strict";
// The program in a Web Worker: takes requests one after the other. ar3dCore is what emscripten makes. The page sends
// the compiled module, so that a cancelled worker is soon replaced.
self.onmessage = async ({data: module}) => {
  const core = await ar3dCore({
    instantiateWasm(imports, done) {
      WebAssembly.instantiate(module, imports).then(instance => done(instance, module));
      return {};
    },
  });
  self.onmessage = ({data: {request, text}}) => {
    const bytes = new TextEncoder().encode(JSON.stringify(request) + "\n" + text);
    const place = core._malloc(bytes.length) >>> 0;
    core.HEAPU8.set(bytes, place);
    const answer = JSON.parse(core.UTF8ToString(core._ar3d_answer(place, bytes.length)));
    core._free(place);
    const from = core._ar3d_bytes() >>> 0;
    const made = core.HEAPU8.slice(from, from + (core._ar3d_size() >>> 0));
    self.postMessage({answer, made}, [made.buffer]);
  };
  self.postMessage("ready");
};
