// Tests core/asset/bake/MeshHullCache.cpp.
#include "core/asset/bake/MeshHullCache.h"

#include "core/asset/bake/PrismHulls.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/SolidShapes.h"

#include <QTest>

using namespace rubble;
using namespace rubble::test;

namespace {

/// A box that is `length` cubes long.
std::shared_ptr<const ClosedMesh> boxOf(int length) {
    std::set<std::array<int, 3>> filled;
    for (int x = 0; x < length; ++x) filled.insert({x, 0, 0});
    return *closedMesh(cubes(filled));
}

}  // namespace

class MeshHullCacheTest : public QObject {
    Q_OBJECT
private slots:
    void hullsOfEqualMeshesAreMadeOnce() {
        MeshHullCache cache;
        const MeshHullCache::Hulls first = *cache.hullsOf(*boxOf(1)), other = *cache.hullsOf(*boxOf(2));
        QVERIFY(first != other && *first != *other);
        QCOMPARE(*cache.hullsOf(*boxOf(1)), first);
    }
    void theMeshAskedForLeastRecentlyIsDropped() {
        MeshHullCache cache;
        const MeshHullCache::Hulls first = *cache.hullsOf(*boxOf(1)), second = *cache.hullsOf(*boxOf(2));
        for (int length = 3; length <= static_cast<int>(MeshHullCache::kMaxMeshes); ++length)
            QVERIFY(cache.hullsOf(*boxOf(length)));
        QCOMPARE(*cache.hullsOf(*boxOf(1)), first);
        QVERIFY(cache.hullsOf(*boxOf(MeshHullCache::kMaxMeshes + 1)));
        QCOMPARE(*cache.hullsOf(*boxOf(1)), first);
        QVERIFY(*cache.hullsOf(*boxOf(2)) != second);
    }
    void whatWasCancelledIsMadeAgain() {
        MeshHullCache cache;
        TaskContext task;
        task.cancel.cancel();
        const auto mesh = *closedMesh(bumpySphere(130));
        QVERIFY(!cache.hullsOf(*mesh, task));
        QVERIFY(cache.hullsOf(*mesh));
    }
    void hullsAreMovedToTheOrigin() {
        const auto mesh = boxOf(1);
        const Vec3 offset(1.0, -2.0, 3.0);
        const auto hulls = meshHulls(*mesh), moved = meshHulls(*mesh, offset);
        QVERIFY(hulls && moved);
        QCOMPARE(moved->size(), hulls->size());
        for (std::size_t k = 0; k < hulls->size(); ++k) QVERIFY((*moved)[k] == translated((*hulls)[k], -offset));
    }
};

RUBBLE_TEST(MeshHullCacheTest)
#include "MeshHullCacheTest.moc"
