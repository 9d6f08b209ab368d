// Tests core/fracture/solid/Tetrahedralization.cpp, core/fracture/solid/HilbertCurve3.cpp and
// core/fracture/solid/SolidDiagram.cpp.
#include "core/fracture/solid/Tetrahedralization.h"

#include "core/base/Random.h"
#include "core/fracture/solid/HilbertCurve3.h"
#include "core/fracture/solid/SolidDiagram.h"
#include "core/geometry/predicates/Predicates.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <algorithm>
#include <set>

using namespace rubble;

namespace {

using Tetrahedron = Tetrahedralization::Tetrahedron;

Tetrahedralization triangulationOf(const std::vector<Vec3>& seeds) {
    Result<Tetrahedralization> result = tetrahedralized(seeds);
    return result ? std::move(*result) : Tetrahedralization{};
}

/// Why it is no Delaunay triangulation of the whole region of the far sites.
std::string faultOf(const Tetrahedralization& result) {
    const auto point = [&](std::uint32_t site) { return result.sites[site]; };
    const auto ranked = [&](std::uint32_t site) { return RankedSite{result.sites[site], result.seedOf[site]}; };
    double volume = 0.0;
    for (std::uint32_t t = 0; t < result.tetrahedra.size(); ++t) {
        const auto& [a, b, c, d] = result.tetrahedra[t].corner;
        if (orient3d(point(a), point(b), point(c), point(d)) <= 0) return "not positive";
        volume += std::abs(glm::dot(point(b) - point(a), glm::cross(point(c) - point(a), point(d) - point(a))));
        for (int k = 0; k < 4; ++k) {
            const std::uint32_t other = result.tetrahedra[t].neighbour[k];
            if (other == kNone) continue;
            const Tetrahedron& neighbour = result.tetrahedra[other];
            const auto back = std::ranges::find(neighbour.neighbour, t);
            if (back == neighbour.neighbour.end()) return "not linked back";
            const std::uint32_t opposite = neighbour.corner[back - neighbour.neighbour.begin()];
            if (solid_signs::inSphere(ranked(a), ranked(b), ranked(c), ranked(d), ranked(opposite)) > 0) {
                return "not Delaunay";
            }
        }
    }
    const std::uint32_t far = result.siteCount();
    const double whole = std::abs(
        glm::dot(point(far + 1) - point(far), glm::cross(point(far + 2) - point(far), point(far + 3) - point(far))));
    return std::abs(volume - whole) < 1e-9 * whole ? "" : "does not fill its region";
}

std::vector<Vec3> randomSeeds(int kind, int count, std::uint64_t seed) {
    Random random(seed);
    std::vector<Vec3> seeds;
    const auto coordinate = [&] { return static_cast<double>(random.below(std::uint64_t{1} << 40)); };
    for (int k = 0; k < count; ++k) {
        const double x = coordinate(), y = coordinate(), z = coordinate();
        const Vec3 tied = glm::floor(Vec3(x, y, z) * (5.0 / kLatticeSteps)) * 0x1p37;
        switch (kind) {
            case 0: seeds.push_back({x, y, z}); break;
            case 1: seeds.push_back(tied); break;             // of a grid, most of them several times
            case 2: seeds.push_back({x, y, 7.0}); break;      // coplanar
            case 3: seeds.push_back({x, x, x}); break;        // collinear
            default: seeds.push_back({tied.x, tied.y, 0.0});  // of a plane's grid
        }
    }
    return seeds;
}

/// The tetrahedra as seeds.
std::set<std::set<std::uint32_t>> tetrahedraOf(const Tetrahedralization& result) {
    std::set<std::set<std::uint32_t>> all;
    for (const Tetrahedron& tetrahedron : result.tetrahedra) {
        std::set<std::uint32_t> seeds;
        for (const std::uint32_t corner : tetrahedron.corner) seeds.insert(result.seedOf[corner]);
        all.insert(seeds);
    }
    return all;
}

}  // namespace

class TetrahedralizationTest : public QObject {
    Q_OBJECT
private slots:
    void anySitesAreTriangulated() {
        for (int kind = 0; kind < 5; ++kind) {
            for (const int count : {0, 1, 2, 3, 4, 10, 100, 1000}) {
                const Tetrahedralization result = triangulationOf(randomSeeds(kind, count, 10 * kind + count));
                const std::string fault = faultOf(result);
                QVERIFY2(fault.empty(),
                         qPrintable(QString::asprintf("kind %d, %d seeds: %s", kind, count, fault.c_str())));
                QCOMPARE(result.siteCount() + result.duplicates.size(), std::size_t(count));
            }
        }
    }
    void ofEqualSeedsTheFirstIsKept() {
        const Tetrahedralization result = triangulationOf({{5, 5, 5}, {1, 2, 3}, {5, 5, 5}, {1, 2, 3}, {5, 5, 5}});
        QCOMPARE(result.siteCount(), 2u);
        const std::vector<std::array<std::uint32_t, 2>> expected = {{2, 0}, {3, 1}, {4, 0}};
        QCOMPARE(result.duplicates, expected);
    }
    /// Ties depend on the numbers of seeds alone, not on where they are inserted: a grid and a part of it, moved and
    /// mirrored, which the curve visits in another order.
    void tiesDoNotDependOnTheOrderOfInsertion() {
        for (std::uint64_t seed = 0; seed < 50; ++seed) {
            std::vector<Vec3> seeds = randomSeeds(1, 40, seed), mirrored;
            for (Vec3& s : seeds) s = kLatticeSteps / 2.0 + s / 64.0;  // far sites are in no sphere of theirs
            for (const Vec3 s : seeds) mirrored.push_back({s.y, s.z, kLatticeSteps - s.x});
            const auto inner = [&](const std::vector<Vec3>& all) {
                std::set<std::set<std::uint32_t>> tetrahedra = tetrahedraOf(triangulationOf(all));
                std::erase_if(tetrahedra, [&](const auto& t) { return *t.rbegin() >= all.size(); });
                return tetrahedra;
            };
            QVERIFY2(inner(seeds) == inner(mirrored), qPrintable(QString::number(seed)));
        }
    }
    void cancels() {
        TaskContext task;
        task.cancel.cancel();
        const Result<Tetrahedralization> result = tetrahedralized(randomSeeds(0, 10, 1), task);
        QVERIFY(!result && result.error().code == ErrorCode::Cancelled);
    }
    void curveKeepsEqualPointsTogetherAndNeighboursNear() {
        const std::vector<Vec3> points = randomSeeds(0, 20'000, 3);
        const UninitializedVector<std::uint32_t> order = hilbertOrder(points);
        QCOMPARE(std::set<std::uint32_t>(order.begin(), order.end()).size(), points.size());
        double length = 0.0, random = 0.0;
        for (std::size_t k = 1; k < order.size(); ++k) {
            length += glm::length(points[order[k]] - points[order[k - 1]]);
            random += glm::length(points[k] - points[k - 1]);
        }
        QVERIFY(length < 0.1 * random);
        const UninitializedVector<std::uint32_t> equal = hilbertOrder(std::vector<Vec3>(5, Vec3(1.0)));
        QVERIFY(std::ranges::is_sorted(equal));
    }
    void diagramIsTheDualOfTheTriangulation() {
        const SolidDiagram diagram(triangulationOf(randomSeeds(0, 300, 4)));
        for (std::uint32_t facet = 0; facet < diagram.facets().size(); ++facet) {
            const auto& [a, b] = diagram.facets()[facet];
            QVERIFY(a < b);
            QCOMPARE(diagram.facetOf(a, b), facet);
            QCOMPARE(diagram.facetOf(b, a), facet);
        }
        for (std::uint32_t e = 0; e < diagram.edges().size(); ++e) {
            const SolidDiagram::Edge& edge = diagram.edges()[e];
            QCOMPARE(diagram.edgeOf(edge.site[2], edge.site[0], edge.site[1]), e);
            // The fourth site of the corner where the edge ends is on the side that it points to.
            const auto point = [&](std::uint32_t site) { return diagram.site(site).point; };
            const Vec3 along =
                glm::cross(point(edge.site[1]) - point(edge.site[0]), point(edge.site[2]) - point(edge.site[0]));
            for (const std::uint32_t corner : diagram.sites().tetrahedra[edge.to].corner) {
                if (std::ranges::find(edge.site, corner) != edge.site.end()) continue;
                QVERIFY(glm::dot(diagram.sites().sites[corner] - point(edge.site[0]), along) > 0.0);
            }
        }
    }
    void cellsAreThoseOfTheNearestSites() {
        for (const int kind : {0, 1}) {
            const std::vector<Vec3> seeds = randomSeeds(kind, 200, 5);
            const SolidDiagram diagram(triangulationOf(seeds));
            for (const Vec3 point : randomSeeds(kind, 500, 6)) {
                std::uint32_t nearest = 0;
                for (std::uint32_t k = 1; k < seeds.size(); ++k) {
                    const Vec3 a = seeds[k] - point, b = seeds[nearest] - point;
                    if (glm::dot(a, a) < glm::dot(b, b)) nearest = k;  // the lowest of several
                }
                const std::uint32_t cell = diagram.cellOf(point, diagram.siteCount() / 2);
                const Vec3 found = diagram.site(cell).point - point, best = seeds[nearest] - point;
                QVERIFY(std::abs(glm::length(found) - glm::length(best)) <= 1e-9 * kLatticeSteps);
                if (kind == 1) QCOMPARE(diagram.sites().seedOf[cell], nearest);
            }
        }
    }
};

RUBBLE_TEST(TetrahedralizationTest)
#include "TetrahedralizationTest.moc"
