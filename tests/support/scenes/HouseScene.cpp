#include "core/asset/bake/Bake.h"
#include "core/base/Assert.h"
#include "tests/support/asset/House.h"
#include "tests/support/scenes/SceneParts.h"
#include "tests/support/scenes/Scenes.h"

#include <map>

namespace rubble::test {
namespace {

constexpr std::uint32_t kPieces = 8;
constexpr double kRoofFriction = 0.8;

/// A piece of an asset: its shape in the scene, and its position in the asset's frame.
struct AssetPiece {
    std::uint32_t shape = 0;
    Vec3 offset{0.0, 0.0, 0.0};
};

using PiecesOf = std::vector<AssetPiece> (*)(const Bake&, BodyScene&);

std::vector<AssetPiece> theWhole(const Bake& bake, BodyScene& scene) {
    return {{addShape(scene, bake.wholeHulls), bake.whole.centre}};
}

std::vector<AssetPiece> itsFragments(const Bake& bake, BodyScene& scene) {
    std::vector<AssetPiece> pieces;
    for (std::uint32_t number = 0; number < bake.fragmentCount(); ++number) {
        const BakedFragment fragment = bake.fragment(number);
        pieces.push_back({addShape(scene, fragment.solid.hulls()), fragment.solid.offset()});
    }
    return pieces;
}

Bake baked(Asset asset, std::uint32_t seeds) {
    asset.pattern.layers = {{.id = 1, .randomSeed = asset.id, .parameters = UniformScatter{.count = seeds}}};
    Result<Bake> bake = rubble::bake(asset);
    RUBBLE_ASSERT(bake.hasValue());
    return std::move(*bake);
}

void addInstance(BodyScene& scene, const Instance& instance, const std::vector<AssetPiece>& pieces, double friction) {
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        const Vec3 place = instance.pose.position + instance.pose.orientation * pieces[k].offset;
        const std::string name = pieces.size() > 1 ? instance.name + '/' + std::to_string(k) : instance.name;
        addFreeBody(scene, name, pieces[k].shape, {place, instance.pose.orientation});
        scene.bodies.back().friction = friction;
    }
}

BodyScene houseOf(std::uint32_t seeds, PiecesOf piecesOf) {
    const Project project = house();
    BodyScene scene;
    addGround(scene, 20.0);
    std::map<Id, std::vector<AssetPiece>> pieces;
    for (const Asset& asset : project.assets) pieces[asset.id] = piecesOf(baked(asset, seeds), scene);
    for (const Instance& instance : project.instances) {
        const bool isRoof = findAsset(project, instance.asset)->name == "roof";
        addInstance(scene, instance, pieces[instance.asset], isRoof ? kRoofFriction : SceneBody{}.friction);
    }
    return scene;
}

}  // namespace

BodyScene houseScene() { return houseOf(1, theWhole); }

BodyScene cutHouseScene() { return houseOf(kPieces, itsFragments); }

}  // namespace rubble::test
