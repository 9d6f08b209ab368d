// Tests core/geometry/hull/Polytope.cpp and core/geometry/hull/VerifyPolytope.cpp.
#include "core/geometry/hull/MassProperties.h"
#include "core/geometry/hull/Polytope.h"
#include "core/geometry/search/Box3.h"
#include "tests/support/ProcessorTime.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace rubble;

namespace {

const Ring kUnitSquare{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}};

Polytope unitCube() { return extruded(kUnitSquare, 0.0, 1.0); }

std::string faultOf(const Polytope& polytope) { return verifyPolytope(polytope).value_or(""); }

Ring polygonOf(int corners) {
    Ring ring;
    for (int k = 0; k < corners; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / corners;
        ring.push_back({std::cos(angle), std::sin(angle)});
    }
    return ring;
}

}  // namespace

class PolytopeTest : public QObject {
    Q_OBJECT
private slots:
    void trianglePrismHasTheDocumentedOrder() {
        const Polytope prism = extruded(Ring{{0.0, 0.0}, {4.0, 0.0}, {0.0, 3.0}}, -1.0, 1.0);
        const Polytope expected{
            {{0, 0, 1}, {4, 0, 1}, {0, 3, 1}, {0, 0, -1}, {4, 0, -1}, {0, 3, -1}},
            {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}},
            {{0, 1, 2}, {5, 4, 3}, {0, 3, 4, 1}, {1, 4, 5, 2}, {2, 5, 3, 0}},
            {{{0, 0, 1}, 1}, {{0, 0, -1}, 1}, {{0, -1, 0}, 0}, {{0.6, 0.8, 0}, 2.4}, {{-1, 0, 0}, 0}}};
        QVERIFY(prism.vertices == expected.vertices);
        QVERIFY(prism.edges == expected.edges);
        QVERIFY(prism.faces == expected.faces);
        for (std::size_t i = 0; i < 5; ++i) {
            QVERIFY(glm::distance(prism.planes[i].normal, expected.planes[i].normal) < 1e-15);
            QVERIFY(std::abs(prism.planes[i].offset - expected.planes[i].offset) < 1e-15);
        }
        QCOMPARE(faultOf(prism), "");
    }
    void collinearCornersAreRemoved() {
        const Ring ring{{0.5, 0.0}, {1.0, 0.0}, {1.0, 0.25}, {1.0, 0.5}, {1.0, 1.0}, {0.0, 1.0}, {0.0, 0.0}};
        const Polytope prism = extruded(ring, 0.0, 1.0);
        QCOMPARE(prism.faces.size(), std::size_t{6});
        QVERIFY(prism.vertices[0] == Vec3(1.0, 0.0, 1.0));  // starts at the first remaining corner
        QVERIFY(prism.vertices[3] == Vec3(0.0, 0.0, 1.0));
        QCOMPARE(faultOf(prism), "");
    }
    void cornerOneUlpOffTheLineIsKept() {
        const double below = -0x1p-60;  // outwards: the corner is strictly convex, by one ulp
        QCOMPARE(extruded(Ring{{0, 0}, {0.5, below}, {1, 0}, {1, 1}, {0, 1}}, 0.0, 1.0).faces.size(), std::size_t{7});
        QCOMPARE(extruded(Ring{{0, 0}, {0.5, -below}, {1, 0}, {1, 1}, {0, 1}}, 0.0, 1.0).faces.size(), std::size_t{6});
    }
    void repeatedCornersAreRemoved() {
        const Ring ring{{0, 0}, {0, 0}, {1, 0}, {1, 1}, {1, 1}, {0, 1}, {0, 0}};
        QVERIFY(extruded(ring, 0.0, 1.0) == unitCube());
    }
    void signedEdgesFollowTheFaces() {
        const Polytope cube = unitCube();
        const auto loops = signedEdgeLoops(cube);
        QCOMPARE(loops.size(), cube.faces.size());
        int balance[12] = {};
        for (const auto& loop : loops) {
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const SignedEdge here = loop[i];
                const SignedEdge next = loop[(i + 1) % loop.size()];
                QCOMPARE(cube.edges[here.edge][here.sign > 0 ? 1 : 0], cube.edges[next.edge][next.sign > 0 ? 0 : 1]);
                balance[here.edge] += here.sign;
            }
        }
        for (const int sum : balance) QCOMPARE(sum, 0);  // each edge once in each direction
    }
    void signedEdgeLoopsStartAtANonCollinearCorner() {
        Polytope cube = unitCube();
        // A collinear vertex on the front's first edge, as an external polytope may have.
        cube.vertices.push_back({0.5, 0.0, 1.0});
        cube.edges[0] = {0, 8};
        cube.edges.push_back({8, 1});
        cube.faces[0] = {0, 8, 1, 2, 3};
        cube.faces[2] = {0, 4, 5, 1, 8};
        QCOMPARE(faultOf(cube), "");
        const auto loops = signedEdgeLoops(cube);
        QCOMPARE(loops[0][0].edge, 12u);  // starts at vertex 8, since 0-8 and 8-1 are collinear
        QCOMPARE(loops[0][1].edge, 1u);
    }
    void translatedMovesPlanes() {
        const Polytope moved = translated(unitCube(), {2.0, 3.0, 5.0});
        QVERIFY(moved.vertices[0] == Vec3(2.0, 3.0, 6.0));
        QCOMPARE(moved.planes[0].offset, 6.0);
        QCOMPARE(moved.planes[1].offset, -5.0);
        QCOMPARE(faultOf(moved), "");
    }
    void placedTurnsThenMoves() {
        const double half = std::sqrt(0.5);
        const Polytope turned = placed(unitCube(), {{2.0, 3.0, 5.0}, {half, 0.0, 0.0, half}});  // 90° about z
        QCOMPARE(faultOf(turned), "");
        Box3 before, after;
        for (const Vec3& vertex : unitCube().vertices) before.include(vertex);
        for (const Vec3& vertex : turned.vertices) after.include(vertex);
        QVERIFY(glm::distance(after.min, Vec3(2.0 - before.max.y, 3.0 + before.min.x, 5.0 + before.min.z)) < 1e-12);
        QVERIFY(glm::distance(after.max, Vec3(2.0 - before.min.y, 3.0 + before.max.x, 5.0 + before.max.z)) < 1e-12);
    }
    /// A vertex in front of a face is found among many, the first of several.
    void facesOfLargePrismsAreChecked() {
        Polytope prism = extruded(polygonOf(500), 0.0, 1.0);
        QCOMPARE(faultOf(prism), "");
        prism.vertices[321] *= 1.0 + 1e-6;
        const std::string fault = faultOf(prism);
        QVERIFY2(!fault.empty(), fault.c_str());
        prism = extruded(polygonOf(500), 0.0, 1.0);
        std::swap(prism.planes[0], prism.planes[1]);
        QVERIFY(!faultOf(prism).empty());
    }
    /// Linear: 4. By all pairs of faces and vertices: 16.
    void checkOfLargePrismsTakesNearlyLinearTime() {
        const auto time = [](int corners, int repeats) {
            const Polytope prism = extruded(polygonOf(corners), 0.0, 1.0);
            const double start = test::processorTime();
            for (int k = 0; k < repeats; ++k) {
                if (!faultOf(prism).empty()) qFatal("The prism is valid.");
            }
            return (test::processorTime() - start) / repeats;
        };
        const double small = time(4000, 8), large = time(16'000, 2);
        QVERIFY2(large < 9.0 * small, qPrintable(QString("%1 ms, %2 ms").arg(small).arg(large)));
    }
    void farPrismsAreValid() { QCOMPARE(faultOf(translated(unitCube(), {1e6, -1e6, 1e6})), ""); }
    void everyFaultIsReported_data() {
        QTest::addColumn<int>("fault");
        QTest::addColumn<QString>("message");
        const char* messages[] = {
            "There are fewer than four vertices.",
            "6 faces have 5 planes.",
            "Vertex 2 is not finite.",
            "Edge 3 does not have two valid vertices.",
            "Face 1 has fewer than three corners.",
            "Face 0 refers to vertex 8, which does not exist.",
            "Edge 0-1 is used twice in the same direction.",
            "Edge 0-3 is listed twice.",
            "Edge 0-2 does not have two faces.",
            "Edge 0-1 is not listed.",
            "The Euler number is 3 instead of 2.",
            "Face 0 has a normal whose length is not 1.",
            "Face 0 is not counter-clockwise about its normal.",
            "Face 1 is not planar: vertex 6 is off its plane.",
            "Face 0 faces inward or is not convex: vertex 4 is in front of it.",
        };
        for (int i = 0; i < 15; ++i) QTest::addRow("%d", i) << i << QString(messages[i]);
    }
    void everyFaultIsReported() {
        QFETCH(int, fault);
        QFETCH(QString, message);
        Polytope cube = unitCube();
        switch (fault) {
            case 0: cube.vertices.resize(3); break;
            case 1: cube.planes.pop_back(); break;
            case 2: cube.vertices[2].x = std::nan(""); break;
            case 3: cube.edges[3] = {3, 3}; break;
            case 4: cube.faces[1].resize(2); break;
            case 5: cube.faces[0][1] = 8; break;
            case 6: cube.faces[1] = {0, 1, 2, 3}; break;
            case 7:
                cube.edges[2] = {0, 3};
                cube.edges[3] = {0, 3};
                break;
            case 8: cube.edges[0] = {0, 2}; break;
            case 9: cube.edges.erase(cube.edges.begin()); break;
            case 10: cube.vertices.push_back({0.5, 0.5, 0.5}); break;
            case 11: cube.planes[0].normal *= 2.0; break;
            case 12: cube.planes[0].normal *= -1.0; break;
            case 13: cube.vertices[6].z += 1e-6; break;
            case 14:
                for (std::vector<std::uint32_t>& face : cube.faces) std::reverse(face.begin(), face.end());
                for (Plane& plane : cube.planes) plane = {-plane.normal, -plane.offset};
                break;
            default: QFAIL("no such fault");
        }
        QCOMPARE(QString::fromStdString(faultOf(cube)), message);
    }
};

RUBBLE_TEST(PolytopeTest)
#include "PolytopeTest.moc"
