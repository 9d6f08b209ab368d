// Tests what viewport/scene/SceneGeometry.cpp makes of rough cuts.
#include "viewport/scene/SceneGeometry.h"

#include "core/asset/library/StarterProject.h"
#include "tests/support/TestProgram.h"
#include "viewport/scene/AssetModel.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <map>
#include <tuple>
#include <vector>

using namespace rubble;

namespace {

AssetModel wallWithAmplitude(double amplitude) {
    Asset wall = starterProject().assets[0];
    wall.shaping.roughness = {.amplitude = amplitude, .frequency = 10.0, .octaves = 3};
    return modelOf(wall, std::make_shared<const Bake>(bake(wall).value()), {});
}

/// How many places of cuts have one normal, and how many several, of each fragment.
std::array<int, 2> normalsOfCuts(const SceneGeometry& geometry) {
    using Place = std::tuple<std::uint32_t, float, float, float>;
    std::map<Place, std::vector<glm::vec3>> normals;
    for (const SceneVertex& vertex : geometry.vertices) {
        if (vertex.side != VertexSide::Inside) continue;
        const glm::vec3& p = vertex.position;
        normals[{vertex.solid, p.x, p.y, p.z}].push_back(vertex.normal);
    }
    std::array<int, 2> counts{};
    for (const auto& [place, here] : normals) {
        const bool isOne =
            std::ranges::all_of(here, [&](const glm::vec3& n) { return glm::dot(n, here[0]) > 0.9999f; });
        ++counts[isOne ? 0 : 1];
    }
    return counts;
}

}  // namespace

class SceneGeometryTest : public QObject {
    Q_OBJECT
private slots:
    /// Normals change gradually over the strips of a rough cut, but not around the corner of two straight ones.
    void roughCutsAreOneSurface() {
        const auto rough = normalsOfCuts(*wallWithAmplitude(0.01).geometry);
        QVERIFY2(rough[0] > 10 * rough[1], qPrintable(QString("%1, %2").arg(rough[0]).arg(rough[1])));
        const auto straight = normalsOfCuts(*wallWithAmplitude(0.0).geometry);
        QVERIFY2(straight[1] > 100, qPrintable(QString("%1, %2").arg(straight[0]).arg(straight[1])));
    }
};

RUBBLE_TEST(SceneGeometryTest)
#include "SceneGeometryTest.moc"
