// Vectors, quaternions [x, y, z, w], convex hulls and symmetric matrices, as far as the conformance suite needs them.

export const add = (a, b) => a.map((x, k) => x + b[k]);
export const sub = (a, b) => a.map((x, k) => x - b[k]);
export const scaled = (a, s) => a.map((x) => x * s);
export const dot = (a, b) => a.reduce((sum, x, k) => sum + x * b[k], 0);
export const length = (a) => Math.sqrt(dot(a, a));
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
/// The x of x[0] a + x[1] b + x[2] c = d.
export function solved([a, b, c], d) {
  const determinant = dot(a, cross(b, c));
  return [dot(d, cross(b, c)), dot(a, cross(d, c)), dot(a, cross(b, d))].map((x) => x / determinant);
}

export const identity = [0, 0, 0, 1];
export const conjugate = ([x, y, z, w]) => [-x, -y, -z, w];
export function product([ax, ay, az, aw], [bx, by, bz, bw]) {
  return [aw * bx + ax * bw + ay * bz - az * by, aw * by - ax * bz + ay * bw + az * bx,
          aw * bz + ax * by - ay * bx + az * bw, aw * bw - ax * bx - ay * by - az * bz];
}
export function rotated(q, p) {
  const u = [q[0], q[1], q[2]];
  const t = scaled(cross(u, p), 2);
  return add(add(p, scaled(t, q[3])), cross(u, t));
}

/// The unit quaternion of a rotation matrix, whose columns are the axes.
export function quaternionOf(axes) {
  const m = (row, column) => axes[column][row];
  const [x, y, z, w] = [1 + m(0, 0) - m(1, 1) - m(2, 2), 1 - m(0, 0) + m(1, 1) - m(2, 2),
                        1 - m(0, 0) - m(1, 1) + m(2, 2), 1 + m(0, 0) + m(1, 1) + m(2, 2)];
  const largest = Math.max(x, y, z, w);
  let q;
  if (largest === w) q = [m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1), w];
  else if (largest === x) q = [x, m(0, 1) + m(1, 0), m(0, 2) + m(2, 0), m(2, 1) - m(1, 2)];
  else if (largest === y) q = [m(0, 1) + m(1, 0), y, m(1, 2) + m(2, 1), m(0, 2) - m(2, 0)];
  else q = [m(0, 2) + m(2, 0), m(1, 2) + m(2, 1), z, m(1, 0) - m(0, 1)];
  return scaled(q, 1 / Math.sqrt(q.reduce((sum, c) => sum + c * c, 0)));
}

/// The principal moments of a tensor, descending, and the rotation from their axes to the body's, by Jacobi's method.
export function principalOf(tensor) {
  const a = tensor.map((row) => [...row]);
  const v = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
  for (let sweep = 0; sweep < 30; ++sweep) {
    for (const [p, q] of [[0, 1], [0, 2], [1, 2]]) {
      if (Math.abs(a[p][q]) < 1e-18 * (Math.abs(a[p][p]) + Math.abs(a[q][q]))) continue;
      const angle = 0.5 * Math.atan2(2 * a[p][q], a[q][q] - a[p][p]);
      const [c, s] = [Math.cos(angle), Math.sin(angle)];
      for (let k = 0; k < 3; ++k) [a[k][p], a[k][q]] = [c * a[k][p] - s * a[k][q], s * a[k][p] + c * a[k][q]];
      for (let k = 0; k < 3; ++k) [a[p][k], a[q][k]] = [c * a[p][k] - s * a[q][k], s * a[p][k] + c * a[q][k]];
      for (let k = 0; k < 3; ++k) [v[k][p], v[k][q]] = [c * v[k][p] - s * v[k][q], s * v[k][p] + c * v[k][q]];
    }
  }
  const order = [0, 1, 2].sort((i, j) => a[j][j] - a[i][i]);
  const axes = order.map((k) => [v[0][k], v[1][k], v[2][k]]);
  if (dot(cross(axes[0], axes[1]), axes[2]) < 0) axes[2] = scaled(axes[2], -1);
  return {moments: order.map((k) => a[k][k]), rotation: quaternionOf(axes)};
}

/// The tensor with these principal moments in the axes of a rotation.
export function tensorOf({moments, rotation}) {
  const axes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map((axis) => rotated(rotation, axis));
  return [0, 1, 2].map((i) => [0, 1, 2].map((j) => axes.reduce((sum, r, k) => sum + moments[k] * r[i] * r[j], 0)));
}

/// The volume of a hull, m^3, and its centroid, by the tetrahedra of its faces with the first vertex.
export function solidOf({vertices, faces}) {
  let volume = 0;
  let centroid = [0, 0, 0];
  for (const face of faces) {
    for (let k = 2; k < face.length; ++k) {
      const [a, b, c] = [face[0], face[k - 1], face[k]].map((v) => sub(vertices[v], vertices[0]));
      const part = dot(a, cross(b, c)) / 6;
      volume += part;
      centroid = add(centroid, scaled(add(a, add(b, c)), part / 4));
    }
  }
  return {volume, centroid: add(vertices[0], scaled(centroid, 1 / volume))};
}

/// The point on three planes [nx, ny, nz, d]; undefined where they have none in common.
function meeting(a, b, c) {
  const [na, nb, nc] = [a, b, c].map((plane) => plane.slice(0, 3));
  const determinant = dot(na, cross(nb, nc));
  if (Math.abs(determinant) < 1e-9) return undefined;
  const sum = add(scaled(cross(nb, nc), a[3]), add(scaled(cross(nc, na), b[3]), scaled(cross(na, nb), c[3])));
  return scaled(sum, 1 / determinant);
}

/// A hull whose planes are moved inwards by d, m: all points where three of them meet and no other is before. Faces that
/// this leaves no area go.
export function inset(hull, d) {
  const planes = hull.planes.map(([x, y, z, offset]) => [x, y, z, offset - d]);
  const near = 1e-7;
  const vertices = [];
  for (let i = 0; i < planes.length; ++i) {
    for (let j = i + 1; j < planes.length; ++j) {
      for (let k = j + 1; k < planes.length; ++k) {
        const point = meeting(planes[i], planes[j], planes[k]);
        if (!point || planes.some((plane) => dot(plane.slice(0, 3), point) > plane[3] + near)) continue;
        if (vertices.every((other) => length(sub(other, point)) > 2 * near)) vertices.push(point);
      }
    }
  }
  const kept = [];
  const faces = [];
  for (const plane of planes) {
    const normal = plane.slice(0, 3);
    const on = vertices.map((_, v) => v).filter((v) => Math.abs(dot(normal, vertices[v]) - plane[3]) < 2 * near);
    if (on.length < 3) continue;
    const middle = scaled(on.reduce((sum, v) => add(sum, vertices[v]), [0, 0, 0]), 1 / on.length);
    const right = sub(vertices[on[0]], middle);
    const up = cross(normal, right);
    const angle = (v) => Math.atan2(dot(up, sub(vertices[v], middle)), dot(right, sub(vertices[v], middle)));
    faces.push(on.sort((v, w) => angle(v) - angle(w)));
    kept.push(plane);
  }
  return {vertices, faces, planes: kept};
}
