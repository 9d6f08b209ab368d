// Tests core/asset/texture/SurfaceChart.cpp, core/asset/texture/ShelfPacking.cpp, core/asset/texture/TextureAtlas.cpp
// and core/asset/texture/AssetAtlas.cpp.
#include "core/asset/texture/TextureAtlas.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/TexturedAssets.h"

#include <QTest>

#include <cmath>

using namespace rubble;
using namespace rubble::test;

namespace {

constexpr int kSides[] = {512, 1024, 2048, 4096};

/// How many texels are in the rectangles of charts; none if two share one or one is not in the square.
std::optional<std::size_t> texelsIn(const TextureAtlas& atlas) {
    const auto side = static_cast<std::size_t>(atlas.side());
    std::vector<bool> isTaken(side * side, false);
    std::size_t count = 0;
    for (const PlacedChart& placed : atlas.charts()) {
        const auto [x, y] = placed.place;
        if (x < 0 || y < 0 || x + placed.size.width > atlas.side() || y + placed.size.height > atlas.side())
            return std::nullopt;
        for (int row = y; row < y + placed.size.height; ++row) {
            for (int column = x; column < x + placed.size.width; ++column) {
                const std::size_t at = static_cast<std::size_t>(row) * side + static_cast<std::size_t>(column);
                if (isTaken[at]) return std::nullopt;
                isTaken[at] = true;
                ++count;
            }
        }
    }
    return count;
}

/// The changes of a triangle's position with u and with v, m.
std::array<Vec3, 2> slopesOf(const Mesh& mesh, const MeshFace& face) {
    const std::span<const MeshCorner> corners = mesh.cornersOf(face);
    const auto edge = [&](std::size_t k) {
        return mesh.positions[corners[k].position] - mesh.positions[corners[0].position];
    };
    const auto uvEdge = [&](std::size_t k) { return mesh.uvs[corners[k].uv] - mesh.uvs[corners[0].uv]; };
    const Vec2 a = uvEdge(1), b = uvEdge(2);
    const double area = a.x * b.y - a.y * b.x;
    return {(edge(1) * b.y - edge(2) * a.y) / area, (edge(2) * a.x - edge(1) * b.x) / area};
}

double areaOf(const Mesh& mesh, const MeshFace& face) {
    const std::span<const MeshCorner> corners = mesh.cornersOf(face);
    const Vec3 first = mesh.positions[corners[0].position];
    return 0.5 * glm::length(glm::cross(mesh.positions[corners[1].position] - first,
                                        mesh.positions[corners[2].position] - first));
}

}  // namespace

class TextureAtlasTest : public QObject {
    Q_OBJECT
private slots:
    void shelvesHoldRectangles() {
        const std::vector<TexelSize> sizes{{3, 2}, {5, 4}, {4, 4}, {8, 1}};
        const auto places = packedInShelves(sizes, 9);
        QVERIFY(places);
        QCOMPARE((*places)[1].x, 0);  // the highest first, of these the widest
        QCOMPARE((*places)[2].x, 5);
        QCOMPARE((*places)[0].y, 4);
        QCOMPARE((*places)[3].y, 6);
        QVERIFY(!packedInShelves(sizes, 6));
        QVERIFY(!packedInShelves(std::vector<TexelSize>{{7, 1}}, 6));
        QVERIFY(packedInShelves({}, 6)->empty());
    }
    void chartsDoNotOverlap() {
        for (const Asset& asset : texturedSamples()) {
            const TexturedAsset textured = texturedAsset(asset);
            for (const int side : kSides) {
                const TextureAtlas atlas = textured.atlas(side).value();
                QCOMPARE(atlas.side(), side);
                const std::optional<std::size_t> texels = texelsIn(atlas);
                QVERIFY(texels);
                const double filled = static_cast<double>(*texels) / side / side;
                QVERIFY2(filled > 0.55, qPrintable(QString::number(filled)));
            }
        }
    }
    void facesAreInTheirCharts() {
        for (const Asset& asset : texturedSamples()) {
            const TexturedAsset textured = texturedAsset(asset);
            const TextureAtlas atlas = textured.atlas(1024).value();
            for (std::size_t part = 0; part < textured.meshes.size(); ++part) {
                const Mesh mesh = atlas.textured(part, textured.meshes[part]);
                for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
                    const PlacedChart& placed = atlas.charts()[atlas.chartOf(part, f)];
                    const Vec2 low = Vec2(placed.place.x, placed.place.y) + double{TextureAtlas::kGutter};
                    const Vec2 high = low + Vec2(placed.size.width, placed.size.height) - 2.0 * TextureAtlas::kGutter;
                    for (const MeshCorner corner : mesh.cornersOf(mesh.faces[f])) {
                        const Vec2 texel = 1024.0 * mesh.uvs[corner.uv];
                        QVERIFY(glm::all(glm::greaterThanEqual(texel, low - 1e-6)));
                        QVERIFY(glm::all(glm::lessThanEqual(texel, high + 1e-6)));
                    }
                }
            }
        }
    }
    /// Triangles have tangents along u, and texels are at most 1.25 times as long on them as on others.
    void tangentsAreThoseOfTheTexture() {
        for (const Asset& asset : texturedSamples()) {
            const TexturedAsset textured = texturedAsset(asset);
            const TextureAtlas atlas = textured.atlas(2048).value();
            for (std::size_t part = 0; part < textured.meshes.size(); ++part) {
                const Mesh mesh = triangulated(atlas.textured(part, textured.meshes[part]));
                QCOMPARE(mesh.tangents.size(), mesh.faces.size());
                for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
                    const Vec3 normal = mesh.normals[mesh.faces[f].normal], tangent(mesh.tangents[f]);
                    QVERIFY(std::abs(glm::length(tangent) - 1.0) < 1e-9);
                    QVERIFY(std::abs(glm::dot(tangent, normal)) < 1e-9);
                    QCOMPARE(mesh.tangents[f].w, 1.0);
                    if (areaOf(mesh, mesh.faces[f]) < 1e-6) continue;  // its slopes are rounding errors
                    const auto [alongU, alongV] = slopesOf(mesh, mesh.faces[f]);
                    QVERIFY(glm::dot(glm::normalize(alongU), tangent) > 1.0 - 1e-6);
                    QVERIFY(glm::dot(alongV, glm::cross(normal, tangent)) > 0.0);
                    for (const Vec3 slope : {alongU, alongV}) {
                        const double stretch = glm::length(slope) / 2048.0 * atlas.density();
                        QVERIFY2(stretch > 1.0 - 1e-6 && stretch < 1.25 + 1e-6, qPrintable(QString::number(stretch)));
                    }
                }
            }
        }
    }
    /// The outside of a wall has 12 planes, whatever it breaks into: door and window end at one height.
    void planesOfTheOutsideAreShared() {
        const TexturedAsset wall = texturedAsset(wallWithOpenings().assets[0]);
        QVERIFY(wall.meshes.size() > 60);
        const TextureAtlas outside = wall.atlas(1024, {.outside = true, .inside = false}).value();
        QCOMPARE(outside.charts().size(), std::size_t{12});
        for (std::size_t part = 0; part < wall.meshes.size(); ++part) {
            for (std::size_t f = 0; f < wall.meshes[part].faces.size(); ++f) {
                const bool isInside = wall.meshes[part].faces[f].side == FaceSide::Inside;
                QCOMPARE(outside.chartOf(part, f) == MeshCharts::kNoChart, isInside);
            }
        }
    }
    /// Without a chart, faces keep their texture coordinates.
    void othersKeepTheirPlaces() {
        const TexturedAsset wall = texturedAsset(wallWithOpenings().assets[0]);
        const TextureAtlas inside = wall.atlas(1024, {.outside = false, .inside = true}).value();
        const Mesh mesh = inside.textured(3, wall.meshes[3]);
        int kept = 0;
        for (const MeshFace& face : mesh.faces) {
            if (face.side == FaceSide::Inside) continue;
            for (std::uint32_t k = face.firstCorner; k < face.firstCorner + face.cornerCount; ++k, ++kept)
                QVERIFY(mesh.uvs[mesh.corners[k].uv] == wall.meshes[3].uvs[wall.meshes[3].corners[k].uv]);
        }
        QVERIFY(kept > 0);
    }
    void whatDoesNotFitIsRefused() {
        const Result<TextureAtlas> atlas = texturedAsset(wallWithOpenings().assets[0]).atlas(64);
        QVERIFY(!atlas);
        QVERIFY(atlas.error().code == ErrorCode::Limit);
        QVERIFY(atlas.error().message.find("do not fit into a texture of 64 × 64 texels") != std::string::npos);
    }
    void theAtlasOfAnAssetHasTheWholeFirst() {
        const Asset asset = wallWithOpenings().assets[0];
        const Bake baked = bake(asset).value();
        const FragmentMesher mesher(asset);
        const TextureAtlas atlas = assetAtlas(baked, mesher, RoughCuts(baked, asset), {}, 1024).value();
        const TextureAtlas same = texturedAsset(asset).atlas(1024).value();
        QCOMPARE(atlas.charts().size(), same.charts().size());
        QCOMPARE(atlas.density(), same.density());
        QVERIFY(atlas.textured(0, mesher.wholeMesh(baked)).uvs == same.textured(0, mesher.wholeMesh(baked)).uvs);
        TaskContext task;
        task.cancel.cancel();
        QVERIFY(assetAtlas(baked, mesher, RoughCuts(baked, asset), {}, 1024, task).error().code ==
                ErrorCode::Cancelled);
    }
};

RUBBLE_TEST(TextureAtlasTest)
#include "TextureAtlasTest.moc"
