#include "core/structure/bonds/FragmentSilhouette.h"

#include "core/fracture/fragments/SolidFracture.h"
#include "core/fracture/solid/SolidCut.h"
#include "core/structure/bonds/Bond.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Fragments.h"
#include "tests/support/geometry/SolidShapes.h"

#include <QTest>

using namespace rubble;
using namespace rubble::test;

class FragmentSilhouetteTest : public QObject {
    Q_OBJECT
private slots:
    void extrudedFragmentsHaveTheirOutline() {
        const Bake halves = halvedSquare();
        const Fragment left = halves.fragment(0).solid;
        QVERIFY(silhouetteOf(left) == left.extruded()->outline());
        QCOMPARE(depthOf(left), 2.0);
    }
    void othersAreSeenAlongZ() {
        const TriangleMesh mesh = cubes({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}});
        const Fragments all = *solidFragments(*cutSolid(mesh, std::vector<Vec3>{{0.5, 0.5, 0.5}}));
        const Polygon silhouette = silhouetteOf(all[0]);
        QVERIFY(std::abs(area(silhouette) - 2.0) < 1e-9);
        QCOMPARE(silhouette.outer.size(), std::size_t{4});
        QVERIFY(signedArea(silhouette.outer) > 0.0);
        QVERIFY(std::abs(depthOf(all[0]) - 2.0) < 1e-9);
        const Bond anchor = paintedAnchor(all, 0);
        QVERIFY(std::abs(anchor.area - 2.0) < 1e-9);
        QVERIFY(std::abs(anchor.seedDistance - 1.0) < 1e-9);
        QVERIFY(!verifyBonds({&anchor, 1}, 1));
    }
    /// A bond for each common face, with its area, centroid and moments.
    void bondsOfMeshesAreTheirContacts() {
        const TriangleMesh mesh = torus(24, 16);
        const std::vector<Vec3> seeds = seedsInBox(mesh, 40, 3);
        const Fragments all = *solidFragments(*cutSolid(mesh, seeds));
        Seeds given;
        for (const Vec3& seed : seeds) {
            given.positions.emplace_back(seed);
            given.heights.push_back(seed.z);
        }
        const std::vector<Bond> bonds = bondsOf(all, given);
        QCOMPARE(verifyBonds(bonds, all.count()).value_or(""), std::string());
        double area = 0.0;
        for (const Bond& bond : bonds) {
            area += bond.area;
            const Vec3 first = seeds[all[bond.first].seed()], second = seeds[all[bond.second].seed()];
            if (all[bond.first].seed() == all[bond.second].seed()) continue;
            // Half way between the seeds, and the normal leads from one to the other.
            QVERIFY(glm::distance(bond.normal, glm::normalize(second - first)) < 1e-6);
            QVERIFY(std::abs(bond.seedDistance - glm::distance(first, second)) < 1e-6);
        }
        double sides = 0.0;
        for (std::uint32_t k = 0; k < all.count(); ++k) {
            for (const FragmentContact& contact : all[k].contacts()) sides += contact.area;
        }
        QVERIFY(std::abs(sides - 2.0 * area) < 1e-9);
    }
};

RUBBLE_TEST(FragmentSilhouetteTest)
#include "FragmentSilhouetteTest.moc"
