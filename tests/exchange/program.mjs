// Engines whose programs are in C++: see programs/Measure.h.
import {spawnSync} from "node:child_process";
import {mkdtempSync, rmSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";
import {readPack, writeInset} from "./pack.mjs";

/// What a program reports of a pack; nothing where it is aborted.
export function report(program, pack, {of, lies}, argument) {
  const folder = mkdtempSync(join(tmpdir(), "rubble-exchange-"));
  try {
    let file = pack.path;
    if (readPack(file).inset !== pack.inset) {
      file = join(folder, "pack.json");
      writeInset(pack.path, file, pack.inset);
    }
    const {status, stdout, stderr} = spawnSync(program, [file, of, lies ? "lies" : "stands", argument]);
    if (status === 2) throw new Error(String(stderr));
    return status === 0 ? JSON.parse(stdout) : undefined;
  } finally {
    rmSync(folder, {recursive: true});
  }
}
