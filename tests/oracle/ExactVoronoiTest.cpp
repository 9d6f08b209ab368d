#include "tests/oracle/ExactVoronoi.h"

#include "tests/oracle/FractureCases.h"
#include "tests/support/TestProgram.h"
#include "tests/support/files/JsonCases.h"

#include <QTest>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

using namespace rubble;
using namespace rubble::oracle;

namespace {

double shoelace(const Ring& ring) {
    double area = 0.0;
    for (std::size_t k = 2; k < ring.size(); ++k) area += 0.5 * cross(ring[k - 1] - ring[0], ring[k] - ring[0]);
    return area;
}

}  // namespace

/// The oracle itself, on cases with known results.
class ExactVoronoiTest : public QObject {
    Q_OBJECT
private slots:
    void counterexamplesHaveTheKnownCells() {
        const auto cases = test::counterexamples();
        QCOMPARE(cases.size(), std::size_t{18});
        for (const auto& example : cases) {
            const auto cells = exactCells(example.outline, example.seeds, 0.0);
            for (std::size_t seed = 0; seed < cells.size(); ++seed) {
                QVERIFY2(std::abs(cells[seed].area / example.areas[seed] - 1.0) < 1e-12, example.name.c_str());
                std::vector<std::uint32_t> neighbours;
                for (const auto& [other, length] : cells[seed].shared) neighbours.push_back(other);
                QVERIFY2(neighbours == example.neighbours[seed], example.name.c_str());
            }
        }
    }
    void disconnectedCellHasTwoPieces() {
        // A U, 3 x 3 with a notch from (1, 1) to (2, 3): the upper seed's cell is the two arms above y = 1.
        const Polygon outline{{{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}}, {}};
        const auto cells = exactCells(outline, std::vector<Vec2>{{1.5, 0.5}, {1.5, 1.5}}, 0.0);
        QCOMPARE(cells[0].area, 3.0);
        QCOMPARE(cells[0].minPieces, 1u);
        QCOMPARE(cells[1].area, 4.0);
        QCOMPARE(cells[1].minPieces, 2u);
        QCOMPARE(cells[1].maxPieces, 2u);
        QVERIFY(glm::distance(cells[1].centroid, Vec2(1.5, 2.0)) < 1e-15);
        // They are neighbours along the feet of both arms, not along the bottom of the notch.
        QCOMPARE(cells[0].shared.size(), std::size_t{1});
        QCOMPARE(cells[0].shared[0].second, 2.0);
    }
    void holesAreSubtractedAndDuplicatesIgnored() {
        const Polygon outline{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{1, 1}, {1, 3}, {3, 3}, {3, 1}}}};
        const auto cells = exactCells(outline, std::vector<Vec2>{{1, 2}, {3, 2}, {1, 2}}, 0.0);
        QCOMPARE(cells[0].area, 6.0);
        QCOMPARE(cells[0].shared[0].second, 2.0);
        QCOMPARE(cells[2].area, 0.0);
        QCOMPARE(cells[2].sameAs, 0u);
    }
    void seedsOneUlpApartAreDistinct() {
        const Polygon outline{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {}};
        const double next = std::nextafter(0.5, 1.0);
        const auto cells = exactCells(outline, std::vector<Vec2>{{0.5, 0.5}, {next, 0.5}, {0.75, 0.5}}, 0.0);
        QCOMPARE(cells[0].area, 0.5);  // to x = 0.5 + 2^-54, which rounds to 0.5
        QCOMPARE(cells[1].area, 0.125);
        QCOMPARE(cells[2].area, 0.375);
    }
    void cellsFillTheOutlineAndNeighboursAreMutual() {
        for (std::uint64_t number = 0; number < 400; ++number) {
            const FractureCase input = fractureCase(number);
            const auto cells = exactCells(input.outline, input.seeds, 0.0);
            double sum = 0.0;
            for (std::uint32_t seed = 0; seed < cells.size(); ++seed) {
                sum += cells[seed].area;
                QCOMPARE(cells[seed].minPieces, cells[seed].maxPieces);
                for (const auto& [other, length] : cells[seed].shared) {
                    const auto& back = cells[other].shared;
                    const auto entry = std::find_if(back.begin(), back.end(), [&](auto& s) { return s.first == seed; });
                    QVERIFY2(entry != back.end(), input.family.c_str());
                    QVERIFY2(std::abs(entry->second - length) <= 1e-11 * length, input.family.c_str());
                }
            }
            double whole = shoelace(input.outline.outer);
            for (const Ring& hole : input.outline.holes) whole += shoelace(hole);
            QVERIFY2(std::abs(sum / whole - 1.0) < 1e-11, input.family.c_str());
        }
    }
    void seedsWithoutCellHaveNoArea() {
        const Polygon outline{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {}};
        const auto cells = exactCells(outline, std::vector<Vec2>{{0.5, 0.5}, {9.0, 0.5}, {-0.25, 0.5}}, 0.0);
        QCOMPARE(cells[1].area, 0.0);
        QCOMPARE(cells[2].area, 0.125);
    }
};

RUBBLE_TEST(ExactVoronoiTest)
#include "ExactVoronoiTest.moc"
