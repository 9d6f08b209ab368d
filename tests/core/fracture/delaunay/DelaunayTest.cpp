// Tests core/fracture/delaunay/Delaunay.cpp and core/fracture/delaunay/InsertionRounds.cpp.
#include "core/fracture/delaunay/Delaunay.h"

#include "core/base/Random.h"
#include "core/base/math/Trigonometry.h"
#include "core/fracture/verify/VerifyDelaunay.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <limits>

using namespace rubble;

namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

Triangles trianglesOf(const std::vector<Vec2>& seeds) {
    const Result<Delaunay> delaunay = triangulate(seeds);
    return delaunay ? triangleList(*delaunay) : Triangles{};
}

std::string triangulationFault(const std::vector<Vec2>& seeds) {
    const Result<Delaunay> delaunay = triangulate(seeds);
    return delaunay ? verifyDelaunay(*delaunay, seeds).value_or("") : delaunay.error().message;
}

bool isSameTriangle(const Delaunay::Triangle& a, const Delaunay::Triangle& b) {
    return std::ranges::equal(a.corner, b.corner) && std::ranges::equal(a.twin, b.twin);
}

/// Enough seeds for parallel insertion: uniform, on a grid (cocircular everywhere), in distant clusters, on a circle,
/// and on a line with one beside it.
std::vector<std::vector<Vec2>> manySeeds() {
    constexpr std::size_t kCount = 50'000;
    Random random(3);
    std::vector<std::vector<Vec2>> sets(5);
    for (std::size_t i = 0; i < kCount; ++i) {
        const Vec2 point = {random.unit(), random.unit()};
        const double along = static_cast<double>(i) / kCount;
        sets[0].push_back(point);
        sets[1].push_back({static_cast<double>(i % 250), static_cast<double>(i / 250)});
        sets[2].push_back(1e-3 * point + Vec2{static_cast<double>(i % 7), static_cast<double>(i % 5)});
        sets[3].push_back({sine(6.0 * along), cosine(6.0 * along)});
        sets[4].push_back({along, 0.0});
    }
    sets[4].push_back({0.3, 0.1});
    sets[4].push_back({0.5, 0.0});  // a duplicate
    return sets;
}

}  // namespace

class DelaunayTest : public QObject {
    Q_OBJECT
private slots:
    void threeSitesGiveOneTriangle() { QCOMPARE(trianglesOf({{0, 0}, {0, 1}, {1, 0}}), (Triangles{{0, 2, 1}})); }
    void cocircularSitesConnectToTheLowestIndex() {
        QCOMPARE(trianglesOf({{0, 0}, {1, 0}, {1, 1}, {0, 1}}), (Triangles{{0, 1, 2}, {0, 2, 3}}));
        QCOMPARE(trianglesOf({{1, 0}, {0, 0}, {0, 1}, {1, 1}}), (Triangles{{0, 2, 1}, {0, 3, 2}}));
    }
    void flatTriangleIsKept() {
        QCOMPARE(trianglesOf({{0.1, 0.5}, {0.5, 0.5000001}, {0.9, 0.5}}), (Triangles{{0, 2, 1}}));
    }
    void collinearSitesHaveNoTriangles() {
        const std::vector<Vec2> seeds = {{3, 3}, {1, 1}, {0, 0}, {2, 2}};
        QCOMPARE(trianglesOf(seeds), Triangles{});
        QCOMPARE(triangulationFault(seeds), std::string());
        QCOMPARE(triangulate(seeds)->triangles.size(), std::size_t{6});
    }
    void zeroOneAndTwoSeedsAreValid() {
        QCOMPARE(triangulationFault({}), std::string());
        QCOMPARE(triangulationFault({{1, 2}}), std::string());
        QCOMPARE(triangulationFault({{1, 2}, {3, 4}}), std::string());
    }
    void ofEqualSeedsTheFirstIsKept() {
        const Result<Delaunay> delaunay = triangulate(std::vector<Vec2>{{1, 1}, {0, 0}, {1, 1}, {0, 1}, {1, 1}});
        QCOMPARE(delaunay->duplicates, (std::vector<std::array<std::uint32_t, 2>>{{2, 0}, {4, 0}}));
        QCOMPARE(triangleList(*delaunay), (Triangles{{0, 3, 1}}));
    }
    void invalidCoordinatesAreRejectedWithTheirSeed() {
        QCOMPARE(triangulationFault({{0, 0}, {1, std::numeric_limits<double>::quiet_NaN()}}),
                 std::string("Seed 1 has a coordinate that is not finite: nan."));
        QCOMPARE(triangulate(std::vector<Vec2>{{1e300, 0}}).error().code, ErrorCode::BadInput);
    }
    void resultDoesNotDependOnThreadCount() {
        for (const std::vector<Vec2>& seeds : manySeeds()) {
            const Result<Delaunay> one = triangulate(seeds, {.threads = 1}), three = triangulate(seeds, {.threads = 3});
            QCOMPARE(verifyDelaunay(*one, seeds).value_or(""), std::string());
            QVERIFY(one->seedOf == three->seedOf && one->duplicates == three->duplicates);
            QVERIFY(std::ranges::equal(one->triangles, three->triangles, isSameTriangle));
        }
    }
    void cancellationStops() {
        std::vector<Vec2> seeds;
        Random random(1);
        for (int i = 0; i < 10000; ++i) seeds.push_back({random.unit(), random.unit()});
        TaskContext task;
        task.cancel.cancel();
        QCOMPARE(triangulate(seeds, task).error().code, ErrorCode::Cancelled);
    }
    void trianglesDoNotDependOnSeedOrder() {
        // The same lattice points far away, and scaled: the ties are the same, the order of insertion is not.
        Random random(8);
        std::vector<Vec2> seeds, moved;
        for (int i = 0; i < 400; ++i) {
            seeds.push_back({static_cast<double>(random.below(30)), static_cast<double>(random.below(30))});
            moved.push_back(Vec2{-seeds.back().y, seeds.back().x} * 8.0 +
                            Vec2{1000, 500});  // rotated: same orientation
        }
        QCOMPARE(trianglesOf(seeds), trianglesOf(moved));
    }
    void randomInputsVerify() {
        const std::uint64_t seed = 11;
        Random random(seed);
        for (int round = 0; round < 600; ++round) {
            std::vector<Vec2> seeds;
            const std::uint64_t count = 1 + random.below(round % 20 == 0 ? 2000 : 40);
            for (std::uint64_t i = 0; i < count; ++i) {
                const double a = static_cast<double>(random.below(9)), b = static_cast<double>(random.below(9));
                switch (round % 5) {
                    case 0: seeds.push_back({random.unit(), random.unit()}); break;
                    case 1: seeds.push_back({a, b}); break;
                    case 2: seeds.push_back({random.unit(), 1e-3 * random.unit()}); break;
                    case 3: seeds.push_back({0.5 + a * 0x1p-53, 0.5 + b * 0x1p-53}); break;
                    case 4: seeds.push_back({1e6 + 1e-6 * a, -1e6 + 1e-6 * b}); break;
                }
            }
            const std::string fault = triangulationFault(seeds);
            QVERIFY2(fault.empty(), qPrintable(QString("seed %1, round %2: ").arg(seed).arg(round) + fault.c_str()));
        }
    }
};

RUBBLE_TEST(DelaunayTest)
#include "DelaunayTest.moc"
