#include "core/io/json/JsonWriter.h"
#include "core/io/system/AtomicFile.h"
#include "tests/support/scenes/RestingScenes.h"
#include "tests/support/scenes/SlidingScenes.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>

using namespace rubble;

namespace {

constexpr int kRandomSeeds = 5;

void writeHulls(JsonWriter& json, const std::vector<Polytope>& hulls) {
    json.openArray("hulls");
    for (const Polytope& hull : hulls) {
        json.openArray();
        for (const Vec3& vertex : hull.vertices) json.numbers({}, {vertex.x, vertex.y, vertex.z});
        json.close();
    }
    json.close();
}

/// The scene as docs/formats/bodies.md describes it.
std::string textOf(const BodyScene& scene) {
    const auto write = [](JsonWriter& json, const char* key, Vec3 v) { json.numbers(key, {v.x, v.y, v.z}); };
    JsonWriter json(JsonLayout::CompactLines);
    json.openObject();
    write(json, "gravity", scene.gravity);
    json.openArray("bodies");
    for (const SceneBody& body : scene.bodies) {
        json.openObject();
        json.text("name", body.name);
        json.text("kind", body.kind == BodyKind::Static ? "static" : "dynamic");
        json.number("density", body.density);
        json.number("friction", body.friction);
        json.number("restitution", body.restitution);
        write(json, "position", body.pose.position);
        const Quat turn = body.pose.orientation;
        json.numbers("orientation", {turn.w, turn.x, turn.y, turn.z});
        write(json, "velocity", body.velocity);
        write(json, "angularVelocity", body.angularVelocity);
        writeHulls(json, scene.shapes[body.shape]);
        json.close();
    }
    json.close();
    json.close();
    return std::move(json).finished();
}

bool save(const std::filesystem::path& folder, std::string name, const BodyScene& scene) {
    std::ranges::replace_if(
        name, [](char c) { return c == ' ' || c == ':'; }, '-');
    const Status written = writeFileAtomically((folder / (name + ".json")).string(), textOf(scene));
    if (!written) std::fprintf(stderr, "%s\n", written.error().message.c_str());
    return written.hasValue();
}

bool saveResting(const std::filesystem::path& folder, std::span<const test::RestingScene> scenes) {
    std::filesystem::create_directories(folder);
    bool isSaved = true;
    for (const test::RestingScene& scene : scenes) {
        for (int k = 1; k <= kRandomSeeds; ++k) {
            const auto randomSeed = static_cast<std::uint64_t>(k);
            isSaved = save(folder, scene.name + ("-" + std::to_string(k)), scene.build(randomSeed)) && isSaved;
        }
    }
    return isSaved;
}

bool saveSliding(const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    bool isSaved = true;
    for (const test::SlidingScene& sliding : test::slidingScenes()) {
        isSaved = save(folder, sliding.name, sliding.scene) && isSaved;
    }
    return isSaved;
}

}  // namespace

/// Writes the stacks and piles, for five random seeds, and the sliding boxes to a folder, to be simulated by
/// rubble-cli simulate and by other engines.
int main(int argumentCount, char** arguments) {
    if (argumentCount != 2) {
        std::fprintf(stderr, "usage: scene_files FOLDER\n");
        return 2;
    }
    const std::filesystem::path folder(arguments[1]);
    const bool areSaved = saveResting(folder / "stacks", test::stackScenes()) &&
                          saveResting(folder / "piles", test::pileScenes()) && saveSliding(folder / "sliding");
    return areSaved ? 0 : 1;
}
