// Tests core/asset/mesh/FragmentMesh.cpp and core/asset/mesh/ExtrudedMesh.cpp.
#include "core/asset/mesh/FragmentMesh.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Fragments.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace rubble;

namespace {

std::vector<Vec2> uvsOf(const Mesh& mesh, std::size_t face) {
    std::vector<Vec2> uvs;
    for (const MeshCorner corner : mesh.cornersOf(mesh.faces[face])) uvs.push_back(mesh.uvs[corner.uv]);
    return uvs;
}

long insideFaces(const Mesh& mesh) {
    return std::count_if(mesh.faces.begin(), mesh.faces.end(),
                         [](const MeshFace& face) { return face.side == FaceSide::Inside; });
}

/// The mesh of the left half of the unit square, cut off at x = 0.5, 2 deep.
Mesh leftHalfMesh(const Asset& asset) {
    const Bake bake = halvedSquare();
    return fragmentMesh(bake.fragment(0), asset);
}

/// The mesh of a piece with another one behind every edge that is not outside.
Mesh pieceMesh(const Polygon& outline, const std::vector<std::uint32_t>& neighbour, double depth, const Asset& asset) {
    const Bake bake = bakeOf({{outline, neighbour}, {outline, neighbour}}, depth);
    return fragmentMesh(bake.fragment(0), asset);
}

std::string meshFault(const Mesh& mesh, double volume) { return verifyMesh(mesh, volume).value_or(""); }

}  // namespace

class FragmentMeshTest : public QObject {
    Q_OBJECT
private slots:
    void halfHasOneInsideFace() {
        const Mesh mesh = leftHalfMesh(assetOf(unitSquare(), 2.0));
        QCOMPARE(meshFault(mesh, 1.0), "");
        QCOMPARE(mesh.positions.size(), std::size_t{8});
        QCOMPARE(mesh.faces.size(), std::size_t{6});
        QCOMPARE(insideFaces(mesh), 1L);
        QVERIFY(mesh.faces.back().side == FaceSide::Inside);
        QVERIFY(mesh.normals[mesh.faces.back().normal] == Vec3(1.0, 0.0, 0.0));
        QVERIFY(mesh.positions[0] == Vec3(-0.25, -0.5, 1.0));
        QVERIFY(mesh.positions[4] == Vec3(-0.25, -0.5, -1.0));
    }
    void outsideUvsAreTheOutlineInMetres() {
        const Mesh mesh = leftHalfMesh(assetOf(unitSquare(), 2.0));
        const std::vector<Vec2> front = {{0.0, 0.0}, {0.5, 0.0}, {0.5, 1.0}, {0.0, 1.0}};
        QVERIFY(uvsOf(mesh, 0) == front);
        // The left side is the last of the outline's four: 3 m to 4 m along it.
        const std::vector<Vec2> left = {{3.0, 1.0}, {3.0, -1.0}, {4.0, -1.0}, {4.0, 1.0}};
        QVERIFY(uvsOf(mesh, 4) == left);
        // The top runs from (0.5, 1) to (0, 1): half of the third side.
        const std::vector<Vec2> top = {{2.5, 1.0}, {2.5, -1.0}, {3.0, -1.0}, {3.0, 1.0}};
        QVERIFY(uvsOf(mesh, 3) == top);
    }
    void insideUvsStartAtTheCut() {
        Asset asset = assetOf(unitSquare(), 2.0);
        asset.insideUvScale = 4.0;
        const std::vector<Vec2> cut = {{0.0, 4.0}, {0.0, -4.0}, {4.0, -4.0}, {4.0, 4.0}};
        QVERIFY(uvsOf(leftHalfMesh(asset), 5) == cut);
    }
    void clockwiseOutlineIsNotMirrored() {
        const Ring clockwise = reversed(unitSquare().outer);
        const Mesh mesh = leftHalfMesh(assetOf({clockwise, {}}, 2.0));
        const std::vector<Vec2> left = uvsOf(mesh, 4);
        QCOMPARE(left[2].x - left[0].x, 1.0);
    }
    void cornerOnAStraightSideIsKept() {
        // The neighbours above and below meet at (0.5, 0.5): the cap has five corners, so must the sides.
        const Mesh mesh = pieceMesh({{{0.0, 0.0}, {0.5, 0.0}, {0.5, 0.5}, {0.5, 1.0}, {0.0, 1.0}}, {}},
                                    {kNone, 1, 1, kNone, kNone}, 2.0, assetOf(unitSquare(), 2.0));
        QCOMPARE(meshFault(mesh, 1.0), "");
        QCOMPARE(mesh.faces.size(), std::size_t{7});
        QCOMPARE(mesh.faces[0].cornerCount, 5u);
        QCOMPARE(insideFaces(mesh), 2L);
    }
    void coincidentCornersAreMerged() {
        const Mesh mesh = pieceMesh({{{0, 0}, {1, 0}, {1, 1}, {1, 1}, {0, 1}, {0, 0}}, {}},
                                    {kNone, 1, 1, kNone, kNone, kNone}, 1.0, assetOf(unitSquare(), 1.0));
        QCOMPARE(meshFault(mesh, 1.0), "");
        QCOMPARE(mesh.positions.size(), std::size_t{8});
    }
    void concavePieceHasConvexCapFaces() {
        const Polygon corner{{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, {}};
        const Mesh mesh = pieceMesh(corner, {kNone, kNone, 1, 1, kNone, kNone}, 1.0,
                                    assetOf({{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, {}}, 1.0));
        QCOMPARE(meshFault(mesh, 3.0), "");
        QCOMPARE(mesh.faces.size(), std::size_t{2 + 2 + 6});
        QCOMPARE(mesh.positions.size(), std::size_t{12});
        QCOMPARE(insideFaces(mesh), 2L);
        QCOMPARE(meshFault(triangulated(mesh), 3.0), "");
    }
    void pieceWithAHoleIsClosed() {
        const Polygon frame{{{0, 0}, {3, 0}, {3, 3}, {0, 3}}, {{{1, 1}, {1, 2}, {2, 2}, {2, 1}}}};
        const Mesh mesh =
            pieceMesh(frame, {kNone, kNone, kNone, kNone, kNone, kNone, kNone, 1}, 0.5, assetOf(frame, 0.5));
        QCOMPARE(meshFault(mesh, 4.0), "");
        QCOMPARE(meshFault(triangulated(mesh), 4.0), "");
        QCOMPARE(insideFaces(mesh), 1L);
        // The hole's first side runs up from (1, 1): out of the solid is to its right, +x.
        QVERIFY(mesh.normals[mesh.faces[mesh.faces.size() - 4].normal] == Vec3(1.0, 0.0, 0.0));
    }
    void parentsCutIsInsideOnDeeperLevels() {
        // A piece of the left half: its right side has no sibling behind it, but is the parent's cut.
        const Ring left = rectangle({0.0, 0.0}, {0.5, 1.0});
        const Bake bake = bakeOf({{{left, {}}, {kNone, kNone, 1, kNone}}, {{left, {}}, {0, 0, 0, 0}}}, 2.0);
        BakedFragment fragment = bake.fragment(0);
        fragment.level = 1;
        const Mesh mesh = fragmentMesh(fragment, assetOf(unitSquare(), 2.0));
        QCOMPARE(insideFaces(mesh), 2L);
        QCOMPARE(meshFault(mesh, 1.0), "");
    }
    void wholeHasOnlyOutsideFaces() {
        const Asset asset =
            assetOf({unitSquare().outer, {{{0.25, 0.25}, {0.75, 0.25}, {0.75, 0.75}, {0.25, 0.75}}}}, 2.0);
        Bake bake;
        bake.whole = massOfPrism(asset.prism().outline, asset.prism().depth);
        bake.wholeHulls.resize(4);
        const Mesh mesh = wholeMesh(bake, asset);
        QCOMPARE(meshFault(mesh, 1.5), "");
        QCOMPARE(insideFaces(mesh), 0L);
        QVERIFY(mesh.positions[0] == Vec3(-0.5, -0.5, 1.0));
    }
    void importedSurfaceGivesUvsAndMaterials() {
        Asset asset = assetOf(unitSquare(), 2.0);
        Surface surface;
        surface.materials = {"plaster", "paint"};
        surface.front = {true, {{2.0, 0.0, 0.5, 0.0, 3.0, 0.0}}, 1};
        surface.back = {true, {{1.0, 0.0, 0.0, 0.0, 1.0, 0.0}}, 0};
        // One triangle on the left side, large enough for all of it: u = 1 - y and v = z.
        surface.triangles = {
            {{Vec3{0, 1, -1}, Vec3{0, -3, -1}, Vec3{0, 1, 3}}, {Vec2{0, -1}, Vec2{4, -1}, Vec2{0, 3}}, 0}};
        asset.surface = std::make_shared<const Surface>(surface);
        const Mesh mesh = leftHalfMesh(asset);
        QCOMPARE(meshFault(mesh, 1.0), "");
        QCOMPARE(mesh.faces[0].material, 0u);  // faces are ordered by material: the back comes first,
        QCOMPARE(mesh.faces[4].material, 1u);  // the front last of the outside faces
        const std::vector<Vec2> front = {{0.5, 0.0}, {1.5, 0.0}, {1.5, 3.0}, {0.5, 3.0}};
        QVERIFY(uvsOf(mesh, 4) == front);
        const auto left = std::find_if(mesh.faces.begin(), mesh.faces.end(),
                                       [&](const MeshFace& face) { return mesh.normals[face.normal].x < 0.0; });
        const std::vector<Vec2> uvs = uvsOf(mesh, static_cast<std::size_t>(left - mesh.faces.begin()));
        const std::vector<Vec2> expected = {{0.0, 1.0}, {0.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}};
        for (std::size_t i = 0; i < 4; ++i) QVERIFY(glm::distance(uvs[i], expected[i]) < 1e-15);
    }
};

RUBBLE_TEST(FragmentMeshTest)
#include "FragmentMeshTest.moc"
