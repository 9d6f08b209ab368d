#include "core/geometry/hull/PolytopeTopology.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <set>

using namespace rubble;

class PolytopeTopologyTest : public QObject {
    Q_OBJECT
private slots:
    void everythingFollowsFromVerticesAndFaces() {
        const Polytope prism = extruded(Ring{{0, 0}, {4, 0}, {5, 2}, {2, 4}, {0, 3}}, -1.0, 2.0);
        const Polytope found = polytopeOf(prism.vertices, prism.faces).value();
        QVERIFY(!verifyPolytope(found));
        const auto sorted = [](const Polytope& polytope) {
            std::set<std::array<std::uint32_t, 2>> edges;
            for (auto [a, b] : polytope.edges) edges.insert({std::min(a, b), std::max(a, b)});
            return edges;
        };
        QVERIFY(sorted(found) == sorted(prism));
        QCOMPARE(found.edges.size(), prism.edges.size());
        for (std::size_t k = 0; k < prism.planes.size(); ++k) {
            QVERIFY(glm::distance(found.planes[k].normal, prism.planes[k].normal) < 1e-15);
            QVERIFY(std::abs(found.planes[k].offset - prism.planes[k].offset) < 1e-14);
        }
    }
    void wrongFacesGiveNothing() {
        const Polytope box = extruded(Ring{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 0.0, 1.0);
        std::vector<std::vector<std::uint32_t>> faces = box.faces;
        faces[0] = {0, 1};
        QVERIFY(!polytopeOf(box.vertices, faces));
        faces[0] = {0, 1, 99};
        QVERIFY(!polytopeOf(box.vertices, faces));
        faces[0] = {0, 1, 0};
        QVERIFY(!polytopeOf(box.vertices, faces));
    }
};

RUBBLE_TEST(PolytopeTopologyTest)
#include "PolytopeTopologyTest.moc"
