// three.js draws exports with baked finishes as our 3D view draws the assets: node beside.mjs PROGRAM FOLDER PLACE, where
// PROGRAM is BakedPictures, which writes into FOLDER. Both see the same sky, key light and camera, with the same tone
// mapping, without shadows and occlusion. Prints the mean differences on surfaces; the pictures are in FOLDER/pictures.
import {spawn, spawnSync} from "node:child_process";
import {existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync} from "node:fs";
import {createServer} from "node:http";
import {tmpdir} from "node:os";
import {extname, join, normalize} from "node:path";
import {fileURLToPath} from "node:url";
import {installed, skip} from "./packages.mjs";

/// The most that pictures may differ in the mean, of 255: normals whose green points down exceed all of these.
const kMaxDifference = {wall: 6, block: 3.4, board: 4.5, stone: 3};
const kMinCovered = 0.5;  // of the pixels of a picture's surfaces, that are compared
const kTypes = {".js": "text/javascript", ".html": "text/html", ".json": "application/json", ".png": "image/png"};

const [program, folder, place] = process.argv.slice(2);
const {folder: three} = installed(place, "three");
const browser = ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"].find(existsSync);
if (!browser) skip("chromium is not installed; tools/setup test installs it");
const drawing = spawnSync(program, [folder], {stdio: "inherit"});
if (drawing.status === 77) skip("there is no OpenGL");
if (drawing.status !== 0) process.exit(1);

const roots = {"/three/": three, "/files/": folder};
function fileAt(url) {
  if (url === "/") return fileURLToPath(new URL("beside.html", import.meta.url));
  const root = Object.keys(roots).find((one) => url.startsWith(one));
  const path = root && normalize(url.slice(root.length));
  return root && !path.startsWith("..") ? join(roots[root], path) : undefined;
}

let finish;
const finished = new Promise((resolve) => { finish = resolve; });
async function bodyOf(request) {
  const parts = [];
  for await (const part of request) parts.push(part);
  return Buffer.concat(parts);
}
const server = createServer(async (request, response) => {
  const url = decodeURIComponent(request.url);
  if (request.method === "POST") {
    const body = await bodyOf(request);
    response.end();
    if (url === "/results") finish(JSON.parse(body));
    else writeFileSync(join(folder, "pictures", `${url.slice("/picture/".length)}-theirs.png`), body);
    return;
  }
  const path = fileAt(url);
  if (url === "/assets") response.end(JSON.stringify(Object.keys(kMaxDifference)));
  else if (!path || !existsSync(path)) response.writeHead(404).end();
  else response.writeHead(200, {"Content-Type": kTypes[extname(path)] ?? "application/octet-stream"}).end(readFileSync(path));
});
await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));

const profile = mkdtempSync(join(tmpdir(), "rubble-beside-"));
const chromium = spawn(browser, [
  "--headless=new", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--no-first-run",
  "--disable-extensions", `--user-data-dir=${profile}`, `http://127.0.0.1:${server.address().port}/`], {stdio: "ignore"});
chromium.once("exit", (code) => finish({error: `chromium ended with ${code}`}));
const timer = setTimeout(() => finish({error: "chromium took too long"}), 200_000);
const {error, version, assets} = await finished;
clearTimeout(timer);
chromium.removeAllListeners("exit");
const ended = new Promise((resolve) => chromium.once("exit", resolve));
if (chromium.exitCode === null && chromium.kill()) await ended;
server.close();
rmSync(profile, {recursive: true, force: true, maxRetries: 5});
if (error) {
  console.log(`FAULT: ${error}`);
  process.exit(1);
}
let faults = 0;
for (const [name, most] of Object.entries(kMaxDifference)) {
  const {difference, brighter, pixels, covered} = assets[name];
  console.log(`three.js r${version}: ${name}: mean difference ${difference.toFixed(2)}, brighter by ` +
              `${brighter.toFixed(2)} of 255, on ${pixels} of ${covered} pixels`);
  if (difference < most && pixels > kMinCovered * covered) continue;
  ++faults;
  console.log(`  FAULT: ${most} is the most, on half of the pixels at least`);
}
process.exit(faults > 0 ? 1 : 0);
