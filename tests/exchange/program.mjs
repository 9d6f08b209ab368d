// Engines that are no modules of node: see programs/Measure.h.
import {spawnSync} from "node:child_process";
import {mkdtempSync, rmSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";
import {readPack, writeInset} from "./pack.mjs";

/// What a program, a path or the beginning of a command, reports of a pack; nothing where it is aborted.
export function report(program, pack, {of, lies}, argument) {
  const folder = mkdtempSync(join(tmpdir(), "rubble-exchange-"));
  try {
    let file = pack.path;
    if (readPack(file).inset !== pack.inset) {
      file = join(folder, "pack.json");
      writeInset(pack.path, file, pack.inset);
    }
    const [path, ...options] = [program].flat();
    const {status, stdout, stderr} = spawnSync(path, [...options, file, of, lies ? "lies" : "stands", argument]);
    if (status === 2) throw new Error(String(stderr));
    // Programs may print more before that line.
    return status === 0 ? JSON.parse(/^\{.*\}$/m.exec(stdout)[0]) : undefined;
  } finally {
    rmSync(folder, {recursive: true});
  }
}
