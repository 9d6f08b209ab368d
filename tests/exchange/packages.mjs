// Packages of npm that tests/exchange loads.
import {existsSync, readFileSync} from "node:fs";
import {createRequire} from "node:module";
import {join, resolve} from "node:path";
import {pathToFileURL} from "node:url";

/// Ends the test as skipped.
export function skip(reason) {
  console.log(`skipped: ${reason}`);
  process.exit(77);
}

/// An installed package: its folder and what its package.json says. `place`: the folder with node_modules. The large
/// ones are optional dependencies.
export function installed(place, name) {
  const folder = join(place, "node_modules", name);
  if (!existsSync(join(folder, "package.json"))) skip(`${name} is not installed; tools/setup test, or all for large ones, installs it`);
  return {folder, ...JSON.parse(readFileSync(join(folder, "package.json"), "utf8"))};
}

/// Imports a module of a package from there.
export function loaderFrom(place) {
  const {resolve: find} = createRequire(join(resolve(place), "package.json"));
  return (name) => import(pathToFileURL(find(name)).href);
}

/// Starts a package whose build is for browsers and refuses node: it must find a window, and no process, until it is
/// ready. Where it fetches a file, it gets `bytes`.
export async function asInBrowser(start, bytes) {
  const {process, fetch} = globalThis;
  globalThis.window = globalThis;
  globalThis.process = undefined;
  if (bytes) globalThis.fetch = async () => new Response(bytes, {headers: {"Content-Type": "application/wasm"}});
  try {
    return await start();
  } finally {
    Object.assign(globalThis, {process, fetch});
    delete globalThis.window;
  }
}
