import {fileURLToPath} from "node:url";
import {report} from "../program.mjs";

export const program = "Godot";
const margin = "its margin of 40 mm on each side of hulls is more than the gap between them";
const friction = "it has Bullet's one direction of friction, in which stacks slide apart";
const digits = [1e-5, "it prints six digits"];
export const settings = [
  {name: "defaults", argument: "0.04",
   looser: {mass: digits, pose: digits, swap: [10, margin], standing: [10, margin], drift: [10, margin]}},
  {name: "margin 0.02 mm", argument: "0.00002",
   looser: {mass: digits, pose: digits, standing: [10, friction], drift: [10, friction]}},
];
export const slow = ["pane", "terraces"];

export async function start(load, path) {
  const project = fileURLToPath(new URL("../godot", import.meta.url));
  const command = [path, "--path", project, "--fixed-fps", "60", "-s", "measure.gd"];
  return {version: "3.2.3", report: (pack, one, setting) => report(command, pack, one, setting.argument)};
}
