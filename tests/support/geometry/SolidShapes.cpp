#include "tests/support/geometry/SolidShapes.h"

#include "core/base/math/Trigonometry.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace rubble::test {
namespace {

using Cell = std::array<int, 3>;
using Tetrahedron = std::array<Cell, 4>;
constexpr double kTurn = 6.283185307179586;

/// The six tetrahedra of each cube of a grid.
std::vector<Tetrahedron> gridTetrahedra(const Cell& count) {
    std::vector<Tetrahedron> all;
    for (int x = 0; x < count[0]; ++x) {
        for (int y = 0; y < count[1]; ++y) {
            for (int z = 0; z < count[2]; ++z) {
                std::array<int, 3> axes = {0, 1, 2};
                do {
                    Tetrahedron tetrahedron;
                    Cell corner = {x, y, z};
                    tetrahedron[0] = corner;
                    for (int k = 0; k < 3; ++k) {
                        ++corner[axes[k]];
                        tetrahedron[k + 1] = corner;
                    }
                    all.push_back(tetrahedron);
                } while (std::next_permutation(axes.begin(), axes.end()));
            }
        }
    }
    return all;
}

int sharedCorners(const Tetrahedron& a, const Tetrahedron& b) {
    return static_cast<int>(
        std::ranges::count_if(a, [&](const Cell& c) { return std::ranges::find(b, c) != b.end(); }));
}

/// Appends the boundary of tetrahedra, with points of its own; false if an edge has more than two triangles.
bool appendBoundary(const std::vector<Tetrahedron>& all, const std::set<std::size_t>& some, TriangleMesh& mesh) {
    std::map<Cell, std::uint32_t> numbers;
    const auto numberOf = [&](const Cell& c) {
        const auto [it, isNew] = numbers.try_emplace(c, static_cast<std::uint32_t>(mesh.points.size()));
        if (isNew) mesh.points.push_back(Vec3(c[0], c[1], c[2]));
        return it->second;
    };
    std::map<std::set<std::uint32_t>, std::vector<std::array<std::uint32_t, 3>>> faces;
    for (const std::size_t t : some) {
        std::array<std::uint32_t, 4> v{};
        for (int k = 0; k < 4; ++k) v[k] = numberOf(all[t][k]);
        const auto point = [&](int k) { return mesh.points[v[k]]; };
        if (glm::dot(point(1) - point(0), glm::cross(point(2) - point(0), point(3) - point(0))) < 0.0)
            std::swap(v[2], v[3]);
        for (const auto& [a, b, c] : {std::array{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}) {
            faces[{v[a], v[b], v[c]}].push_back({v[a], v[b], v[c]});
        }
    }
    std::map<std::array<std::uint32_t, 2>, int> edges;
    bool isManifold = true;
    for (const auto& [corners, sides] : faces) {
        if (sides.size() != 1) continue;
        mesh.triangles.push_back(sides[0]);
        for (int k = 0; k < 3; ++k) isManifold = ++edges[{sides[0][k], sides[0][(k + 1) % 3]}] == 1 && isManifold;
    }
    return isManifold;
}

}  // namespace

TriangleMesh bumpySphere(int n) {
    TriangleMesh mesh;
    const auto point = [](double polar, double round) {
        const double s = sine(polar);
        const double radius = 1.0 + 0.12 * sine(5.0 * polar) * sine(4.0 * round) + 0.05 * sine(9.0 * round) * s * s;
        return radius * Vec3(s * cosine(round), s * sine(round), cosine(polar));
    };
    mesh.points.push_back(point(0.0, 0.0));
    for (int i = 1; i < n; ++i) {
        for (int k = 0; k < n; ++k) mesh.points.push_back(point(kTurn / 2.0 * i / n, kTurn * k / n));
    }
    mesh.points.push_back(point(kTurn / 2.0, 0.0));
    const auto number = [n](int i, int k) { return static_cast<std::uint32_t>(1 + (i - 1) * n + k % n); };
    const std::uint32_t last = static_cast<std::uint32_t>(mesh.points.size()) - 1;
    for (int k = 0; k < n; ++k) {
        mesh.triangles.push_back({0, number(1, k), number(1, k + 1)});
        mesh.triangles.push_back({last, number(n - 1, k + 1), number(n - 1, k)});
        for (int i = 1; i < n - 1; ++i) {
            mesh.triangles.push_back({number(i, k), number(i + 1, k), number(i + 1, k + 1)});
            mesh.triangles.push_back({number(i, k), number(i + 1, k + 1), number(i, k + 1)});
        }
    }
    return mesh;
}

TriangleMesh torus(int around, int along) {
    TriangleMesh mesh;
    for (int i = 0; i < around; ++i) {
        for (int k = 0; k < along; ++k) {
            const double u = kTurn * i / around, v = kTurn * k / along;
            const double radius = 1.0 + 0.4 * cosine(v);
            mesh.points.push_back({radius * cosine(u), radius * sine(u), 0.4 * sine(v)});
        }
    }
    const auto number = [=](int i, int k) { return static_cast<std::uint32_t>(i % around * along + k % along); };
    for (int i = 0; i < around; ++i) {
        for (int k = 0; k < along; ++k) {
            mesh.triangles.push_back({number(i, k), number(i + 1, k), number(i + 1, k + 1)});
            mesh.triangles.push_back({number(i, k), number(i + 1, k + 1), number(i, k + 1)});
        }
    }
    return mesh;
}

TriangleMesh cubes(const std::set<Cell>& filled) {
    TriangleMesh mesh;
    std::map<Cell, std::uint32_t> numbers;
    const auto numberOf = [&](const Cell& c) {
        const auto [it, isNew] = numbers.try_emplace(c, static_cast<std::uint32_t>(mesh.points.size()));
        if (isNew) mesh.points.push_back(Vec3(c[0], c[1], c[2]));
        return it->second;
    };
    for (const Cell& cell : filled) {
        for (int axis = 0; axis < 3; ++axis) {
            for (const int side : {0, 1}) {
                Cell next = cell;
                next[axis] += side == 0 ? -1 : 1;
                if (filled.contains(next)) continue;
                const auto corner = [&](int right, int up) {
                    Cell c = cell;
                    c[axis] += side, c[(axis + 1) % 3] += right, c[(axis + 2) % 3] += up;
                    return numberOf(c);
                };
                const std::uint32_t a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
                const auto add = [&](std::uint32_t p, std::uint32_t q, std::uint32_t r) {
                    mesh.triangles.push_back(side == 1 ? std::array{p, q, r} : std::array{p, r, q});
                };
                add(a, b, c);
                add(a, c, d);
            }
        }
    }
    return mesh;
}

TriangleMesh mengerSponge(int level) {
    std::vector<Cell> filled = {{0, 0, 0}};
    for (int scale = 1, k = 0; k < level; ++k, scale *= 3) {
        std::vector<Cell> all;
        for (int part = 0; part < 27; ++part) {
            const Cell at = {part % 3, part / 3 % 3, part / 9};
            if (std::ranges::count(at, 1) > 1) continue;
            for (const Cell& cell : filled) {
                all.push_back({cell[0] + scale * at[0], cell[1] + scale * at[1], cell[2] + scale * at[2]});
            }
        }
        filled = std::move(all);
    }
    return cubes({filled.begin(), filled.end()});
}

TriangleMesh transformed(TriangleMesh mesh, const Mat3& matrix, Vec3 offset) {
    for (Vec3& point : mesh.points) point = matrix * point + offset;
    return mesh;
}

TriangleMesh together(TriangleMesh a, const TriangleMesh& b) {
    const std::uint32_t first = static_cast<std::uint32_t>(a.points.size());
    a.points.insert(a.points.end(), b.points.begin(), b.points.end());
    for (const auto& [p, q, r] : b.triangles) a.triangles.push_back({p + first, q + first, r + first});
    return a;
}

TriangleMesh insideOut(TriangleMesh mesh) {
    for (std::array<std::uint32_t, 3>& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
    return mesh;
}

std::vector<Vec3> seedsInBox(const TriangleMesh& mesh, int count, std::uint64_t seed) {
    const Box3 box = boundsOf(mesh);
    Random random(seed);
    std::vector<Vec3> seeds;
    for (int k = 0; k < count; ++k) {
        const double x = random.between(box.min.x, box.max.x), y = random.between(box.min.y, box.max.y);
        seeds.push_back({x, y, random.between(box.min.z, box.max.z)});
    }
    return seeds;
}

TriangleMesh randomLatticeMesh(Random& random, bool canTouch) {
    const auto below = [&](int count) { return static_cast<int>(random.below(static_cast<std::uint64_t>(count))); };
    const int x = 1 + below(3), y = 1 + below(3), z = 1 + below(2);
    const std::vector<Tetrahedron> all = gridTetrahedra({x, y, z});
    std::set<std::size_t> some = {random.below(all.size())}, others;
    const std::size_t wanted = 1 + random.below(all.size());
    for (int tries = 0; some.size() < wanted && tries < 400; ++tries) {
        const std::size_t next = random.below(all.size());
        const bool isBeside =
            std::ranges::any_of(some, [&](std::size_t t) { return sharedCorners(all[t], all[next]) == 3; });
        if (isBeside || below(20) == 0) some.insert(next);
    }
    TriangleMesh mesh;
    if (!appendBoundary(all, some, mesh)) return {};
    if (canTouch && below(2) == 0) {
        for (std::size_t t = 0; t < all.size(); ++t) {
            if (!some.contains(t) && below(2) == 0) others.insert(t);
        }
        if (!others.empty() && !appendBoundary(all, others, mesh)) return {};
    }
    return mesh;
}

}  // namespace rubble::test
