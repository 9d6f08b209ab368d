#include "core/fracture/cuts/PlanarFaces.h"

#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

namespace {

void addSquare(PlanarGraph& graph, Vec2 low, double size) {
    const auto first = static_cast<std::uint32_t>(graph.points.size());
    for (const Vec2 corner : {Vec2(0.0, 0.0), Vec2(size, 0.0), Vec2(size, size), Vec2(0.0, size)})
        graph.points.push_back(low + corner);
    for (std::uint32_t k = 0; k < 4; ++k)
        graph.edges.push_back({.from = first + k, .to = first + (k + 1) % 4, .group = 1, .line = 0});
}

/// A square with side · side squares in it, each of which has another one in it.
PlanarGraph nestedSquares(std::uint32_t side) {
    PlanarGraph graph;
    addSquare(graph, {-1.0, -1.0}, side + 2.0);
    for (std::uint32_t k = 0; k < side * side; ++k) {
        const Vec2 low(k % side, k / side);
        addSquare(graph, low, 0.75);
        addSquare(graph, low + Vec2(0.25, 0.25), 0.25);
    }
    return graph;
}

}  // namespace

class PlanarFacesTest : public QObject {
    Q_OBJECT
private slots:
    void componentsAreHolesOfTheFaceAroundThem_data() {
        QTest::addColumn<int>("side");
        for (const int side : {1, 2, 3, 40}) QTest::addRow("%d squares a side", side) << side;
    }
    void componentsAreHolesOfTheFaceAroundThem() {
        QFETCH(int, side);
        const auto squares = static_cast<std::uint32_t>(side * side);
        const Result<std::optional<PlanarFaces>> found = facesOf(nestedSquares(static_cast<std::uint32_t>(side)), {});
        QVERIFY(found.hasValue() && found->has_value());
        const PlanarFaces& faces = **found;
        QCOMPARE(faces.count(), 2u + 2u * squares);
        std::uint32_t around = 0;
        for (std::uint32_t face = 0; face < faces.count(); ++face) {
            const std::uint32_t rings = faces.ringsBegin[face + 1] - faces.ringsBegin[face];
            const std::uint32_t square = faces.origin(faces.rings[faces.ringsBegin[face]]) / 4;
            if (face == 0) {
                QCOMPARE(rings, 1u);  // the large square
            } else if (square == 0) {
                QCOMPARE(rings, 1u + squares);
                ++around;
            } else if (square % 2 == 1) {
                QCOMPARE(rings, 2u);
                QCOMPARE(faces.origin(faces.rings[faces.ringsBegin[face] + 1]) / 4, square + 1);
            } else {
                QCOMPARE(rings, 1u);
            }
        }
        QCOMPARE(around, 1u);
    }
};

RUBBLE_TEST(PlanarFacesTest)
#include "PlanarFacesTest.moc"
