// Engines that are no modules of node: see programs/Measure.h.
import {spawnSync} from "node:child_process";

/// What a program, a path or the beginning of a command, reports of a pack; nothing where it is aborted.
export function report(program, pack, {of, lies}, argument) {
  const [path, ...options] = [program].flat();
  const {status, stdout, stderr} = spawnSync(path, [...options, pack.path, of, lies ? "lies" : "stands", argument]);
  if (status === 2) throw new Error(String(stderr));
  // Programs may print more before that line.
  return status === 0 ? JSON.parse(/^\{.*\}$/m.exec(stdout)[0]) : undefined;
}
