// Tests core/asset/texture/TextureBake.cpp and core/asset/texture/ChartOwners.cpp.
#include "core/asset/texture/ChartOwners.h"
#include "core/asset/texture/TextureBake.h"
#include "core/base/Hash.h"
#include "core/base/Random.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/TexturedAssets.h"

#include <QTest>

#include <cmath>

using namespace rubble;
using namespace rubble::test;

namespace {

constexpr Vec3 kGrey(0.35, 0.3, 0.25);

struct Finishes {
    SurfaceFinish outside, inside;
};

Finishes finishesOf(const Asset& asset, Finish finish) {
    const Material material{.id = 1, .name = "any", .finish = finish};
    const AssetFinish both = assetFinish(asset, material);
    return {surfaceFinish(both, FinishSide::Outside, kGrey), surfaceFinish(both, FinishSide::Inside, kGrey)};
}

BakedMaps mapsOf(const TextureAtlas& atlas, const Finishes& finishes, int threads = 2) {
    TaskContext task;
    task.threads = threads;
    return bakedMaps(atlas, finishes.outside, finishes.inside, task).value();
}

std::string hashOf(const BakedMaps& maps) {
    Hasher hasher;
    for (const std::vector<std::uint8_t>* map : {&maps.colour, &maps.normal, &maps.surface})
        hasher.add(std::string_view(reinterpret_cast<const char*>(map->data()), map->size()));
    return hasher.digest().hex();
}

/// A random point of a random face.
struct SurfacePoint {
    std::size_t part = 0, face = 0;
    Vec3 point, normal;  // in the asset's frame
    std::vector<Vec3> corners;
};
SurfacePoint randomPoint(const TexturedAsset& textured, Random& random) {
    SurfacePoint found;
    found.part = static_cast<std::size_t>(random.below(textured.meshes.size()));
    const Mesh& mesh = textured.meshes[found.part];
    found.face = static_cast<std::size_t>(random.below(mesh.faces.size()));
    const MeshFace& face = mesh.faces[found.face];
    found.normal = mesh.normals[face.normal];
    for (const MeshCorner corner : mesh.cornersOf(face))
        found.corners.push_back(mesh.positions[corner.position] + textured.offsets[found.part]);
    const std::size_t third = 2 + static_cast<std::size_t>(random.below(found.corners.size() - 2));
    double a = random.unit(), b = random.unit();
    if (a + b > 1.0) a = 1.0 - a, b = 1.0 - b;
    found.point = found.corners[0] + a * (found.corners[third - 1] - found.corners[0]) +
                  b * (found.corners[third] - found.corners[0]);
    return found;
}

/// Whether a point in the plane of a face is in it, by more than a thousandth of its size.
bool isWithin(const SurfacePoint& found, Vec3 point) {
    for (std::size_t k = 0; k < found.corners.size(); ++k) {
        const Vec3 from = found.corners[k], edge = found.corners[(k + 1) % found.corners.size()] - from;
        if (glm::dot(glm::cross(edge, point - from), found.normal) <= 1e-9) return false;
    }
    return true;
}

double linearOf(std::uint8_t byte) {
    const double value = byte / 255.0;
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}
double byteOf(double linear) {
    return 255.0 * (linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055);
}

}  // namespace

class TextureBakeTest : public QObject {
    Q_OBJECT
private slots:
    /// 1,000 points of each asset: the texel at a point shows the finish in its own middle, with the slope that it has
    /// there.
    void texelsShowTheFinish() {
        const Finish kFinishes[] = {Finish::Concrete, Finish::Brick, Finish::Stone, Finish::Metal};
        std::size_t number = 0;
        for (const Asset& asset : texturedSamples()) {
            const TexturedAsset textured = texturedAsset(asset);
            const TextureAtlas atlas = textured.atlas(1024).value();
            const Finishes finishes = finishesOf(asset, kFinishes[number]);
            const BakedMaps maps = mapsOf(atlas, finishes);
            Random random(++number);
            for (int points = 0; points < 1000;) {
                const SurfacePoint found = randomPoint(textured, random);
                const PlacedChart& placed = atlas.charts()[atlas.chartOf(found.part, found.face)];
                const Vec2 middle = glm::floor(atlas.texelAt(placed, found.point)) + 0.5;
                const ChartFace face{found.normal, glm::dot(found.normal, found.point), {}};
                const Vec3 point = atlas.pointAt(placed, middle, face);
                if (!placed.chart.isPlanar() && !isWithin(found, point)) continue;
                ++points;
                const SurfaceFinish& finish =
                    placed.chart.side == FinishSide::Outside ? finishes.outside : finishes.inside;
                const FinishedSurface surface = finish.at(point, found.normal);
                const std::size_t row = static_cast<std::size_t>(1024.0 - middle.y),
                                  at = 3 * (1024 * row + static_cast<std::size_t>(middle.x));
                const Vec3 along = placed.chart.tangentOf(found.normal), up = glm::cross(found.normal, along);
                const auto slope = [&](Vec3 direction) {
                    const double step = 1.0 / atlas.density();
                    return (finish.at(point + step * direction, found.normal).height -
                            finish.at(point - step * direction, found.normal).height) /
                           (2.0 * step);
                };
                const Vec3 normal = glm::normalize(Vec3(-slope(along), -slope(up), 1.0));
                for (int c = 0; c < 3; ++c) {
                    const std::size_t byte = at + static_cast<std::size_t>(c);
                    QVERIFY(std::abs(byteOf(surface.albedo[c]) - maps.colour[byte]) <= 2.0);
                    QVERIFY(std::abs(127.5 * normal[c] + 127.5 - maps.normal[byte]) <= 2.0);
                }
                QCOMPARE(maps.surface[at], std::uint8_t{255});
                QVERIFY(std::abs(255.0 * surface.roughness - maps.surface[at + 1]) <= 1.0);
                QVERIFY(std::abs(255.0 * surface.metalness - maps.surface[at + 2]) <= 1.0);
            }
        }
    }
    void plainSurfacesAreFlat() {
        const Asset asset = texturedSamples()[1];
        const TextureAtlas atlas = texturedAsset(asset).atlas(512).value();
        const BakedMaps maps = mapsOf(atlas, finishesOf(asset, Finish::Plain));
        QCOMPARE(maps.side, 512);
        QCOMPARE(maps.normal.size(), std::size_t{3} * 512 * 512);
        for (std::size_t k = 0; k < maps.normal.size(); ++k) QCOMPARE(int{maps.normal[k]}, k % 3 == 2 ? 255 : 128);
        const PlacedChart& first = atlas.charts()[0];
        const std::size_t at =
            3 * (512 * static_cast<std::size_t>(511 - first.place.y - 3) + 3 + static_cast<std::size_t>(first.place.x));
        QVERIFY(std::abs(linearOf(maps.colour[at]) - kGrey.x) < 0.005);
        QCOMPARE(int{maps.surface[at + 1]}, 204);
    }
    /// The texels around a plane continue it, so that nothing else shines through at its edges.
    void guttersContinueTheirChart() {
        const Asset asset = wallWithOpenings().assets[0];
        const TextureAtlas atlas = texturedAsset(asset).atlas(512).value();
        const Finishes finishes = finishesOf(asset, Finish::Concrete);
        const BakedMaps maps = mapsOf(atlas, finishes);
        for (const PlacedChart& placed : atlas.charts()) {
            const SurfaceFinish& finish = placed.chart.side == FinishSide::Outside ? finishes.outside : finishes.inside;
            for (const int column : {0, 1, placed.size.width - 2, placed.size.width - 1}) {
                const int row = placed.size.height - 1;
                const Vec2 middle = Vec2(placed.place.x + column, placed.place.y + row) + 0.5;
                const ChartFace& face = placed.chart.faces[0];
                if (!placed.chart.isPlanar()) continue;
                const FinishedSurface surface = finish.at(atlas.pointAt(placed, middle, face), face.normal);
                const std::size_t at = 3 * (512 * static_cast<std::size_t>(511 - placed.place.y - row) +
                                            static_cast<std::size_t>(placed.place.x + column));
                QVERIFY(std::abs(byteOf(surface.albedo.x) - maps.colour[at]) <= 1.0);
            }
        }
    }
    void threadsDoNotMatter() {
        for (const Asset& asset : texturedSamples()) {
            const TextureAtlas atlas = texturedAsset(asset).atlas(512).value();
            const Finishes finishes = finishesOf(asset, Finish::Stone);
            QCOMPARE(hashOf(mapsOf(atlas, finishes, 1)), hashOf(mapsOf(atlas, finishes, 4)));
        }
    }
    /// This hash is that of every machine.
    void machinesDoNotMatter() {
        const Asset asset = wallWithOpenings().assets[0];
        const TextureAtlas atlas = texturedAsset(asset).atlas(512).value();
        const std::string hash = hashOf(mapsOf(atlas, finishesOf(asset, Finish::Brick)));
        QCOMPARE(QString::fromStdString(hash), QString("e40c7fb5bba5e9bbe1c719e830fca0f7"));
    }
    void bakingIsCancelled() {
        const Asset asset = wallWithOpenings().assets[0];
        const TextureAtlas atlas = texturedAsset(asset).atlas(512).value();
        const Finishes finishes = finishesOf(asset, Finish::Stone);
        TaskContext task;
        task.cancel.cancel();
        QVERIFY(bakedMaps(atlas, finishes.outside, finishes.inside, task).error().code == ErrorCode::Cancelled);
    }
    void texelsBesideFacesHaveTheNearest() {
        SurfaceChart chart;
        chart.high = {8.0, 4.0};
        const Vec3 up(0.0, 0.0, 1.0);
        chart.faces = {{up, 0.0, {{0, 0}, {4, 0}, {0, 4}}}, {up, 0.0, {{8, 0}, {8, 4}, {4, 4}}}};
        const std::vector<std::uint32_t> owners = chartOwners({chart, {}, {12, 8}}, 1.0);
        const auto at = [&](int column, int row) { return owners[static_cast<std::size_t>(12 * row + column)]; };
        QCOMPARE(owners.size(), std::size_t{96});
        QCOMPARE(at(2, 2), 0u);   // in the first
        QCOMPARE(at(9, 5), 1u);   // in the second
        QCOMPARE(at(0, 0), 0u);   // in the gutter
        QCOMPARE(at(11, 7), 1u);  //
        QCOMPARE(at(5, 4), 0u);   // between both
        QCOMPARE(at(7, 4), 1u);
    }
};

RUBBLE_TEST(TextureBakeTest)
#include "TextureBakeTest.moc"
