#include "core/base/Random.h"
#include "core/fracture/cuts/CutSet.h"
#include "core/fracture/pattern/PatternCuts.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

#include <algorithm>

using namespace rubble;

class SlicesTest : public QObject {
    Q_OBJECT
private slots:
    /// Compares the cell index with a count of the cuts, one by one.
    void cellIndexCountsTheCutsBeforeAPoint() {
        Random random(5);
        int counted = 0;
        for (int run = 0; run < 300; ++run) {
            Slices slices{.cuts = 1 + static_cast<std::uint32_t>(random.unit() * 40)};
            slices.angle = (2.0 * random.unit() - 1.0) * 3.0;
            slices.offsetVariation = run % 3 == 0 ? 1.0 : random.unit();
            slices.angleVariation = run % 2 == 0 ? 0.0 : 0.7 * random.unit();
            const Pattern pattern{{{.id = 1, .randomSeed = static_cast<std::uint64_t>(run), .parameters = slices}}};
            const Vec2 corner(100.0 * random.unit(), -50.0 * random.unit());
            const Polygon outline{rectangle(corner, corner + Vec2(1.0, 0.1 + 2.0 * random.unit())), {}};
            const Result<CutSet> cuts = cutsOf(pattern, outline);
            QVERIFY(cuts);
            // A cut outside the outline has no length and hence no direction.
            if (std::ranges::any_of(
                    cuts->edges, [&](const CutEdge& edge) { return cuts->points[edge.from] == cuts->points[edge.to]; }))
                continue;
            ++counted;
            const CutLayer& layer = cuts->layers.at(0);
            const Box2 box = boundsOf(outline.outer);
            for (int k = 0; k < 200; ++k) {
                const Vec2 point = box.min + Vec2(random.unit(), random.unit()) * box.size();
                std::uint32_t before = 0;
                for (const CutEdge& edge : cuts->edges) {
                    const Vec2 from = cuts->points[edge.from], to = cuts->points[edge.to];
                    before += cross(to - from, point - from) < 0.0;
                }
                QVERIFY2(layer.cellAt(point) == before, qPrintable(QString("run %1, point %2").arg(run).arg(k)));
            }
        }
        QVERIFY2(counted > 200, qPrintable(QString::number(counted)));
    }
};

RUBBLE_TEST(SlicesTest)
#include "SlicesTest.moc"
