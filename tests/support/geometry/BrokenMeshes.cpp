#include "tests/support/geometry/BrokenMeshes.h"

#include "core/base/math/Trigonometry.h"

#include <algorithm>

namespace rubble::test {
namespace {

constexpr double kFullAngle = 6.283185307179586;

}  // namespace

TriangleMesh sheet(int n, int m) {
    TriangleMesh mesh;
    for (int k = 0; k <= m; ++k) {
        for (int i = 0; i <= n; ++i) mesh.points.push_back({double(i) / n, double(k) / m, 0.0});
    }
    const auto number = [n](int i, int k) { return static_cast<std::uint32_t>(k * (n + 1) + i); };
    for (int k = 0; k < m; ++k) {
        for (int i = 0; i < n; ++i) {
            mesh.triangles.push_back({number(i, k), number(i + 1, k), number(i + 1, k + 1)});
            mesh.triangles.push_back({number(i, k), number(i + 1, k + 1), number(i, k + 1)});
        }
    }
    return mesh;
}

TriangleMesh moebiusStrip(int n) {
    TriangleMesh mesh;
    for (int i = 0; i < n; ++i) {
        const double angle = kFullAngle * i / n;
        for (const double side : {-0.3, 0.3}) {
            const double radius = 1.0 + side * cosine(angle / 2.0);
            mesh.points.push_back({radius * cosine(angle), radius * sine(angle), side * sine(angle / 2.0)});
        }
    }
    const auto number = [n](int i, int side) {
        return static_cast<std::uint32_t>(2 * (i % n) + (i < n ? side : 1 - side));
    };
    for (int i = 0; i < n; ++i) {
        mesh.triangles.push_back({number(i, 0), number(i + 1, 0), number(i + 1, 1)});
        mesh.triangles.push_back({number(i, 0), number(i + 1, 1), number(i, 1)});
    }
    return mesh;
}

TriangleMesh kleinBottle(int n) {
    TriangleMesh mesh;
    for (int i = 0; i < n; ++i) {
        for (int k = 0; k < n; ++k) {
            const double u = kFullAngle * i / n, v = kFullAngle * k / n;
            const double across = cosine(u / 2.0) * sine(v) - sine(u / 2.0) * sine(2.0 * v);
            const double up = sine(u / 2.0) * sine(v) + cosine(u / 2.0) * sine(2.0 * v);
            mesh.points.push_back({(3.0 + across) * cosine(u), (3.0 + across) * sine(u), up});
        }
    }
    const auto number = [n](int i, int k) {
        const int around = i < n ? k % n : (n - k % n) % n;
        return static_cast<std::uint32_t>(i % n * n + around);
    };
    for (int i = 0; i < n; ++i) {
        for (int k = 0; k < n; ++k) {
            mesh.triangles.push_back({number(i, k), number(i + 1, k), number(i + 1, k + 1)});
            mesh.triangles.push_back({number(i, k), number(i + 1, k + 1), number(i, k + 1)});
        }
    }
    return mesh;
}

TriangleMesh projectivePlane() {
    return {
        {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 2}, {2, 1, 1}},
        {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1}, {1, 2, 4}, {2, 3, 5}, {3, 4, 1}, {4, 5, 2}, {5, 1, 3}}};
}

TriangleMesh box(Vec3 low, Vec3 high) {
    TriangleMesh mesh;
    for (int k = 0; k < 8; ++k)
        mesh.points.push_back({k & 1 ? high.x : low.x, k & 2 ? high.y : low.y, k & 4 ? high.z : low.z});
    mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return mesh;
}

TriangleMesh unitBox() { return box(Vec3(0.0), Vec3(1.0)); }
TriangleMesh boxAt(double x, double y, double z, double size) { return box({x, y, z}, {x + size, y + size, z + size}); }

TriangleMesh without(TriangleMesh mesh, const std::vector<std::uint32_t>& triangles) {
    TriangleMesh rest{mesh.points, {}};
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        if (std::ranges::find(triangles, t) == triangles.end()) rest.triangles.push_back(mesh.triangles[t]);
    }
    return rest;
}

TriangleMesh with(TriangleMesh mesh, const std::vector<Vec3>& points,
                  const std::vector<std::array<std::uint32_t, 3>>& triangles) {
    mesh.points.insert(mesh.points.end(), points.begin(), points.end());
    mesh.triangles.insert(mesh.triangles.end(), triangles.begin(), triangles.end());
    return mesh;
}

TriangleMesh moved(TriangleMesh mesh, std::uint32_t point, Vec3 place) {
    mesh.points[point] = place;
    return mesh;
}

TriangleMesh unshared(const TriangleMesh& mesh) {
    TriangleMesh result;
    for (const auto& triangle : mesh.triangles) {
        const auto first = static_cast<std::uint32_t>(result.points.size());
        for (const std::uint32_t corner : triangle) result.points.push_back(mesh.points[corner]);
        result.triangles.push_back({first, first + 1, first + 2});
    }
    return result;
}

TriangleMesh tetrahedron(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
    return {{a, b, c, d}, {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}};
}

int windingNumber(const TriangleMesh& mesh, Vec3 p) {
    int number = 0;
    for (const auto& [ia, ib, ic] : mesh.triangles) {
        const Vec3 a = mesh.points[ia], b = mesh.points[ib], c = mesh.points[ic];
        const auto area = [&](Vec3 u, Vec3 v) { return (u.x - p.x) * (v.y - p.y) - (u.y - p.y) * (v.x - p.x); };
        const double ab = area(a, b), bc = area(b, c), ca = area(c, a);
        if (!(ab > 0 && bc > 0 && ca > 0) && !(ab < 0 && bc < 0 && ca < 0)) continue;
        if ((ab * c.z + bc * a.z + ca * b.z) / (ab + bc + ca) > p.z) number += ab > 0 ? 1 : -1;
    }
    return number;
}

}  // namespace rubble::test
