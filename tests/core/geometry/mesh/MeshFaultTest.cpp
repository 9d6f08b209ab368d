// Tests that core/geometry/mesh/MeshVerdict.cpp finds what is wrong with meshes.
#include "core/geometry/mesh/MeshVerdict.h"

#include "core/base/math/Trigonometry.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/BrokenMeshes.h"
#include "tests/support/geometry/SolidShapes.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>

using namespace rubble;
using namespace rubble::test;

namespace {

using Kind = MeshFindingKind;

/// A mesh with the fault that is expected: its kind, count and place.
struct BrokenMesh {
    const char* name;
    TriangleMesh mesh;
    Kind kind;
    std::size_t count;
    Vec3 place;
};

TriangleMesh withoutTriangles(TriangleMesh mesh) {
    mesh.triangles.clear();
    return mesh;
}
TriangleMesh doubled(const TriangleMesh& mesh) {
    TriangleMesh result = insideOut(mesh);
    result.triangles.insert(result.triangles.end(), mesh.triangles.begin(), mesh.triangles.end());
    return result;
}
/// A closed sheet of no thickness: two sheets of n × n quads that share the points of their boundary only.
TriangleMesh pillow(int n) {
    TriangleMesh mesh = sheet(n, n);
    const auto count = static_cast<std::uint32_t>(mesh.points.size()), row = static_cast<std::uint32_t>(n) + 1;
    const auto below = [=](std::uint32_t p) {
        const std::uint32_t i = p % row, k = p / row;
        return i == 0 || k == 0 || i + 1 == row || k + 1 == row ? p : p + count;
    };
    const TriangleMesh upper = mesh;
    mesh.points.insert(mesh.points.end(), upper.points.begin(), upper.points.end());
    for (std::size_t t = 0; t < upper.triangles.size(); t += 2) {
        const auto [a, b, c] = upper.triangles[t];
        const std::uint32_t d = upper.triangles[t + 1][2];
        mesh.triangles.push_back({below(a), below(d), below(b)});  // the other diagonal
        mesh.triangles.push_back({below(b), below(d), below(c)});
    }
    return mesh;
}

std::vector<BrokenMesh> uselessNumbers() {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN(),
                     kInfinity = std::numeric_limits<double>::infinity();
    return {
        {"nothing", {}, Kind::NoTriangles, 0, {}},
        {"points only", withoutTriangles(unitBox()), Kind::NoTriangles, 0, {}},
        {"unknown point", with(unitBox(), {}, {{0, 1, 8}}), Kind::UnknownPoint, 1, {}},
        {"two unknown points", with(unitBox(), {}, {{0, 1, 8}, {9, 1, 2}}), Kind::UnknownPoint, 2, {}},
        {"not a number", moved(unitBox(), 7, {kNan, 1, 1}), Kind::NotFinite, 6, {}},
        {"infinite", moved(unitBox(), 1, {1, -kInfinity, 1}), Kind::NotFinite, 4, {}},
        {"too large", moved(unitBox(), 1, {1, 0, 1e30}), Kind::NotFinite, 4, {}},
    };
}

std::vector<BrokenMesh> openMeshes() {
    TriangleMesh tube = without(unitBox(), {0, 1, 2, 3});
    TriangleMesh boxes = unitBox();
    for (int k = 1; k < 11; ++k)
        boxes = together(boxes, k == 7 ? without(boxAt(0.5 * k, 0, 0), {2, 3}) : boxAt(0.5 * k, 0, 0));
    const TriangleMesh village = together(tube, together(transformed(sheet(1, 1), Mat3(0.6), {0.0, 0.0, 1.2}),
                                                         transformed(sheet(1, 1), Mat3(0.6), {0.4, 0.4, 1.2})));
    const TriangleMesh standing =
        transformed(sheet(1, 1), Mat3(Vec3(1, 0, 0), Vec3(0, 0, 1), Vec3(0, -1, 0)), {0, 0.5, -0.5});
    // The edge from (0, 0, 1) to (1, 0, 1) is two edges for the front.
    const TriangleMesh junction = with(without(unitBox(), {5, 4}), {{0.5, 0, 1}}, {{0, 1, 8}, {1, 5, 8}, {0, 8, 4}});
    return {
        {"triangle", {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}, Kind::Open, 3, {0.5, 0, 0}},
        {"quad", sheet(1, 1), Kind::Open, 4, {0.5, 0, 0}},
        {"plane", sheet(10, 10), Kind::Open, 40, {0.05, 0, 0}},
        {"crossed quads", together(sheet(1, 1), standing), Kind::Open, 8, {0.5, 0, 0}},
        {"village", village, Kind::Open, 16, {0.5, 0, 0}},
        {"tube", tube, Kind::Open, 8, {0.5, 0, 0}},
        {"box without a triangle", without(unitBox(), {0}), Kind::Open, 3, {0.5, 0.5, 0}},
        {"box without a side", without(unitBox(), {2, 3}), Kind::Open, 4, {0.5, 0, 1}},
        {"one of many boxes", boxes, Kind::Open, 4, {4, 0, 1}},
        {"sphere with two holes", without(bumpySphere(6), {0, 40}), Kind::Open, 6, {0.368505, 0.205256, 0.843525}},
        {"strip of one side", moebiusStrip(12), Kind::Open, 24, {0.657535, 0.177556, -0.0388229}},
        {"half a sphere",
         without(bumpySphere(4), {1, 4, 5, 7, 10, 11, 13, 16, 17, 19, 22, 23}),
         Kind::Open,
         4,
         {0.5, 0.525, 0}},
        {"edge divided on one side", junction, Kind::Open, 3, {0.5, 0, 1}},
        {"fin", with(unitBox(), {{0, -1, 0}, {1, -1, 0}}, {{0, 1, 8}, {1, 9, 8}}), Kind::Open, 3, {0, -0.5, 0}},
        {"crack", with(without(unitBox(), {0}), {{0, 0, -0.01}}, {{8, 2, 3}}), Kind::Open, 4, {0.5, 0.5, 0}},
        {"box and quad",
         together(unitBox(), transformed(sheet(1, 1), Mat3(1.0), {3, 0, 0})),
         Kind::Open,
         4,
         {3.5, 0, 0}},
        {"box and triangle on it",
         with(unitBox(), {{0.2, 0.2, 1}, {0.8, 0.2, 1}, {0.5, 0.8, 1}}, {{8, 9, 10}}),
         Kind::Open,
         3,
         {0.5, 0.2, 1}},
    };
}

/// Two blocks above an L of three: the two meet at a vertical edge, whose lower end is on one fan of triangles.
TriangleMesh edgeThatStartsOnASurface() {
    return cubes(
        {{0, 0, 1}, {1, 1, 1}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 2}, {1, 0, 2}, {1, 1, 2}, {0, 1, 2}});
}

std::vector<BrokenMesh> badEdges() {
    const TriangleMesh twice = with(unitBox(), {}, unitBox().triangles);
    const TriangleMesh three = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}},
                                {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}, {0, 1, 4}, {1, 2, 4}, {2, 0, 4}}};
    return {
        {"wall inside", with(unitBox(), {}, {{0, 3, 7}, {0, 7, 4}}), Kind::CrowdedEdge, 4, {0.5, 0.5, 0}},
        {"every triangle twice", twice, Kind::CrowdedEdge, 18, {0, 0.5, 0}},
        {"face between tetrahedra", three, Kind::CrowdedEdge, 3, {0.5, 0, 0}},
        {"edge of one fan", edgeThatStartsOnASurface(), Kind::CrowdedEdge, 1, {1, 1, 1.5}},
        {"closed fin", with(unitBox(), {{0.5, -1, 0.5}}, {{0, 5, 8}, {8, 5, 0}}), Kind::CrowdedEdge, 1, {0.5, 0, 0.5}},
        {"bottle of one side", kleinBottle(8), Kind::NotOrientable, 13, {-2.5, 0, -0.353553}},
        {"fine bottle of one side", kleinBottle(24), Kind::NotOrientable, 34, {-1.29896, 1.29896, -0.369644}},
        {"projective plane", projectivePlane(), Kind::NotOrientable, 3, {0.5, 0.5, 1.5}},
        {"box and bottle", together(unitBox(), kleinBottle(6)), Kind::NotOrientable, 10, {-2.56699, 0, -0.433013}},
    };
}

std::vector<BrokenMesh> flatMeshes() {
    const auto flat = [](double height) { return box({0, 0, 0}, {1, 1, height}); };
    const TriangleMesh spike = with(without(unitBox(), {2}), {{1, 1, 1 + 1e-14}}, {{4, 5, 8}, {5, 7, 8}, {7, 4, 8}});
    return {
        {"pillow", pillow(1), Kind::NoVolume, 1, {0.666667, 0.333333, 0}},
        {"large pillow", pillow(10), Kind::NoVolume, 1, {0.0666667, 0.0333333, 0}},
        {"two pillows",
         together(pillow(2), transformed(pillow(2), Mat3(1.0), {2, 0, 0})),
         Kind::NoVolume,
         2,
         {0.333333, 0.166667, 0}},
        {"box and pillow",
         together(unitBox(), transformed(pillow(2), Mat3(1.0), {2, 0, 0})),
         Kind::NoVolume,
         1,
         {2.33333, 0.166667, 0}},
        {"box of no height", flat(0.0), Kind::NoVolume, 1, {0.333333, 0.666667, 0}},
        {"points in a line", tetrahedron({0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}), Kind::NoVolume, 1, {1, 0, 0}},
        {"one place", tetrahedron({1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}), Kind::NoVolume, 1, {1, 2, 3}},
        {"same corners", {{{1, 0, 0}, {0, 0, 0}}, {{0, 0, 1}, {1, 1, 0}}}, Kind::NoVolume, 1, {1, 0, 0}},
        {"doubled triangle",
         doubled({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}),
         Kind::NoVolume,
         1,
         {0.333333, 0.333333, 0}},
        {"box thinner than the lattice", flat(1e-14), Kind::CoincidingPoints, 4, {1, 0, 5e-15}},
        {"box of two steps", flat(4e-12), Kind::NoVolume, 1, {0.333333, 0.666667, 0}},
        {"spike of an atom", spike, Kind::CoincidingPoints, 1, {1, 1, 1}},
        {"spike far away",
         transformed(spike, Mat3(1e6), {1e9, 0, 0}),
         Kind::CoincidingPoints,
         1,
         {1.001e+09, 1e+06, 1e+06}},
    };
}

/// A prism of n sides whose top is turned by half a turn, so that its sides pass through the axis and each other.
TriangleMesh twistedPrism(int n) {
    TriangleMesh mesh;
    for (int k = 0; k < n; ++k) {
        const double angle = 6.283185307179586 * k / n;
        mesh.points.push_back({cosine(angle), sine(angle), 0.0});
        mesh.points.push_back({-cosine(angle), -sine(angle), 1.0});
    }
    const auto number = [n](int k) { return static_cast<std::uint32_t>(2 * (k % n)); };
    for (int k = 0; k < n; ++k) {
        mesh.triangles.push_back({number(k), number(k + 1), number(k + 1) + 1});
        mesh.triangles.push_back({number(k), number(k + 1) + 1, number(k) + 1});
        if (k == 0 || k + 1 == n) continue;
        mesh.triangles.push_back({0, number(k + 1), number(k)});
        mesh.triangles.push_back({1, number(k) + 1, number(k + 1) + 1});
    }
    return mesh;
}

std::vector<BrokenMesh> crossingMeshes() {
    // A U of which one leg reaches into the other.
    TriangleMesh legs = cubes({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 0, 1}, {2, 0, 1}});
    for (Vec3& point : legs.points)
        if (point.x == 2.0 && point.z == 2.0) point.x = 0.5;
    const TriangleMesh needle = with(without(unitBox(), {2}), {{0.3, 0.6, -0.5}}, {{4, 5, 8}, {5, 7, 8}, {7, 4, 8}});
    const TriangleMesh folded = with(without(unitBox(), {2}), {{0.25, 1.5, 1}}, {{4, 5, 8}, {5, 7, 8}, {7, 4, 8}});
    return {
        {"corner through the opposite side",
         moved(unitBox(), 7, {-0.5, 0.25, 0.375}),
         Kind::Crossing,
         5,
         {0, 0.0833333, 0.791667}},
        {"corner through the bottom",
         moved(unitBox(), 7, {0.5, 0.5, -0.5}),
         Kind::Crossing,
         4,
         {0.333333, 0.555556, 0}},
        {"leg in a leg", legs, Kind::Crossing, 23, {1, 0.666667, 1.66667}},
        {"needle through a box", needle, Kind::Crossing, 5, {0.266667, 0.4, 0}},
        {"fold in a plane", folded, Kind::Crossing, 4, {0.333333, 0.666667, 1}},
        {"twisted prism", twistedPrism(5), Kind::Crossing, 14, {1, 0, 0}},
        {"prism of many sides", twistedPrism(31), Kind::Crossing, 164, {0.5, 0, 0.25}},
        {"bumpy sphere with a long bump",
         moved(bumpySphere(24), 200, {0.1, 0.2, -3.0}),
         Kind::Crossing,
         30,
         {0.0373557, 0.638077, -0.79664}},
        {"torus with a point pulled across",
         moved(torus(12, 8), 0, {-3, 0.1, 0.1}),
         Kind::Crossing,
         62,
         {0.367754, 0.554343, 0.181119}},
    };
}

std::vector<BrokenMesh> overlappingMeshes() {
    const TriangleMesh outer = boxAt(0, 0, 0, 4);
    const Kind kind = Kind::OverlappingShells;
    return {
        {"boxes", together(unitBox(), boxAt(0.5, 0.5, 0.5)), kind, 1, {0.75, 0.5, 1}},
        {"boxes in line", together(unitBox(), boxAt(0.5, 0, 0)), kind, 1, {0.666667, 0.833333, 0}},
        {"box twice", together(unitBox(), unitBox()), kind, 1, {0.333333, 0.666667, 0}},
        {"box in box", together(outer, boxAt(1, 1, 1)), kind, 1, {1.33333, 1.66667, 1}},
        {"box in box, inside out", insideOut(together(outer, boxAt(1, 1, 1))), kind, 1, {1.33333, 1.66667, 1}},
        {"inner box first", together(boxAt(1, 1, 1), outer), kind, 1, {1.33333, 1.66667, 1}},
        {"box in box at a side", together(outer, boxAt(0, 1, 1)), kind, 1, {0, 1.33333, 2}},
        {"box in box at an edge", together(outer, boxAt(0, 0, 1)), kind, 1, {0.5, 0, 1}},
        {"box in box at a corner", together(outer, boxAt(0, 0, 0)), kind, 1, {0.333333, 0.666667, 0}},
        {"tetrahedron at a corner inside",
         together(outer, tetrahedron({0, 0, 0}, {1, 2, 1}, {2, 1, 1}, {1, 1, 2})),
         kind,
         1,
         {1, 1, 0.666667}},
        {"tetrahedron with its edge inside one",
         together(outer, tetrahedron({0, 0, 1}, {0, 0, 2}, {1, 2, 1}, {2, 1, 1})),
         kind,
         1,
         {0, 0, 1.5}},
        {"cavity in a cavity",
         together(outer, insideOut(together(boxAt(1, 1, 1, 2), boxAt(1.5, 1.5, 1.5, 1)))),
         kind,
         1,
         {1.83333, 2.16667, 1.5}},
        {"cavity that reaches outside",
         together(unitBox(), insideOut(boxAt(0.5, 0.25, 0.25, 0.7))),
         kind,
         1,
         {1, 0.85, 0.25}},
        {"box across a cavity's side",
         together(together(outer, insideOut(boxAt(1, 1, 1, 2))), boxAt(0.5, 1.5, 1.5)),
         kind,
         1,
         {1, 1.75, 2.5}},
    };
}

std::vector<BrokenMesh> overlappingBeamsAndBalls() {
    std::set<std::array<int, 3>> along, upright;
    for (int k = 0; k < 3; ++k)
        along.insert({k, 1, 1}), upright.insert({1, k, 1}), upright.insert({1, k, 0}), upright.insert({1, k, 2});
    std::set<std::array<int, 3>> plate = {{1, 1, 0}};
    for (int k = 0; k < 9; ++k) plate.insert({k % 3, k / 3, 1});
    TriangleMesh many = unitBox();
    for (int k = 1; k < 11; ++k) many = together(many, boxAt(0.5 * k, 0.1 * k, 0.1 * k));
    const auto ball = [](double size, Vec3 at) { return transformed(bumpySphere(16), Mat3(size), at); };
    const Kind kind = Kind::OverlappingShells;
    return {
        {"beams", together(box({-2, 0, 0}, {3, 1, 1}), box({0.2, -2, 0.2}, {0.8, 3, 0.8})), kind, 1, {0.32, 0, 0.2}},
        {"beams that meet at their own edges", together(cubes(along), cubes(upright)), kind, 1, {1, 1, 1.5}},
        {"plate on a box, with a plug in it",
         together(box({-1, -1, -1}, {4, 4, 1}), cubes(plate)),
         kind,
         1,
         {1.33333, 0.666667, 1}},
        {"plate with a plug, and a box around it",
         together(cubes(plate), box({-1, -1, -1}, {4, 4, 1})),
         kind,
         1,
         {0.666667, 1.33333, 1}},
        {"walls at a stair",
         together(box({0, 0, 0}, {10, 0.2, 3}), box({4, -5, 0}, {4.2, 5, 3})),
         kind,
         1,
         {4.05141, 0.140508, 0}},
        {"by little", together(unitBox(), boxAt(1.0 - 1e-9, 0, 0)), kind, 1, {1, 1, 0}},
        {"eleven boxes", many, kind, 10, {0.666667, 0.1, 1}},
        {"spheres", together(ball(1.0, {}), ball(1.0, {0.7, 0.3, 0.1})), kind, 1, {0.258267, 0.0132432, 0.969993}},
        {"sphere in a sphere", together(ball(1.0, {}), ball(0.3, {})), kind, 1, {0.0393183, 0.00820526, 0.305872}},
        {"spheres in a sphere",
         together(ball(1.0, {}), together(ball(0.2, {0.4, 0, 0}), ball(0.2, {-0.4, 0, 0}))),
         kind,
         2,
         {0.426212, 0.00547017, 0.203914}},
        {"torus through a torus twice",
         together(torus(24, 12), transformed(torus(24, 12), Mat3(1.0), {0.5, 0, 0.1})),
         kind,
         1,
         {1.11897, 0.152975, 0.362725}},
    };
}

std::vector<BrokenMesh> thinMeshes() {
    // On one side of the fin its foot is one edge, on the other two.
    const TriangleMesh fin = with(without(unitBox(), {4}), {{0.5, -1, 0.5}, {0.5, 0, 0.5}},
                                  {{0, 1, 9}, {9, 1, 5}, {5, 0, 8}, {0, 9, 8}, {9, 5, 8}});
    return {
        {"fin of no thickness", fin, Kind::NoThickness, 2, {0.333333, -0.333333, 0.333333}},
        {"cavity at a side",
         together(boxAt(0, 0, 0, 3), insideOut(boxAt(0, 1, 1))),
         Kind::NoThickness,
         2,
         {0, 1.33333, 1.66667}},
        {"cavities side by side",
         together(boxAt(0, 0, 0, 4), insideOut(together(boxAt(1, 1, 1), boxAt(2, 1, 1)))),
         Kind::NoThickness,
         2,
         {2, 1.66667, 1.33333}},
    };
}

std::vector<BrokenMesh> brokenMeshes() {
    std::vector<BrokenMesh> all;
    for (const auto& make : {uselessNumbers, openMeshes, badEdges, flatMeshes, crossingMeshes, overlappingMeshes,
                             overlappingBeamsAndBalls, thinMeshes}) {
        for (BrokenMesh& mesh : make()) all.push_back(std::move(mesh));
    }
    return all;
}

}  // namespace

class MeshFaultTest : public QObject {
    Q_OBJECT
private slots:
    void brokenMeshesAreRefused_data() {
        QTest::addColumn<int>("index");
        const std::vector<BrokenMesh> all = brokenMeshes();
        QVERIFY(all.size() >= 70);
        for (std::size_t k = 0; k < all.size(); ++k) QTest::newRow(all[k].name) << int(k);
    }
    void brokenMeshesAreRefused() {
        QFETCH(int, index);
        const BrokenMesh broken = brokenMeshes()[std::size_t(index)];
        const Result<MeshVerdict> verdict = judgeMesh(broken.mesh);
        QVERIFY(verdict);
        QVERIFY(!verdict->findings.empty());
        const MeshFinding& fault = verdict->findings[0];
        QCOMPARE(nameOf(fault.kind), nameOf(broken.kind));
        QVERIFY2(fault.count == broken.count, fault.message.c_str());
        QVERIFY2(
            glm::distance(fault.place, broken.place) <= 1e-5 * (1.0 + glm::length(broken.place)),  // as in the table
            fault.message.c_str());
        QVERIFY(fault.message.ends_with("."));
        QVERIFY(fault.message.find(fault.count == 1 ? "1 " : std::to_string(fault.count)) != std::string::npos ||
                fault.count <= 1);
        for (const std::uint32_t triangle : fault.triangles) QVERIFY(triangle < broken.mesh.triangles.size());
        QVERIFY(!verdict->isFit());
        QVERIFY(verdict->mesh.triangles.empty() && verdict->shells.empty());
        QCOMPARE(std::ranges::count_if(verdict->findings, [](const auto& f) { return isFault(f.kind); }), 1);
    }
    void pointsThatAreTooFarAreNotCalledInfinite() {
        const auto messageWith = [](double z) {
            return QString::fromStdString(judgeMesh(moved(unitBox(), 1, {1, 0, z}))->findings[0].message);
        };
        QCOMPARE(messageWith(3.4e38),
                 "4 triangles refer to points 1e30 m or more from the origin, the first is triangle 1.");
        QCOMPARE(messageWith(std::numeric_limits<double>::infinity()),
                 "4 triangles refer to points that are not finite, the first is triangle 1.");
    }
};

RUBBLE_TEST(MeshFaultTest)
#include "MeshFaultTest.moc"
