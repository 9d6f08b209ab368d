#pragma once

#include "app/thesis/ThesisCells.h"
#include "core/asset/checks/PlayFaults.h"
#include "core/asset/checks/VerifyProject.h"
#include "core/asset/import/AssetImport.h"
#include "core/base/Utf8.h"
#include "core/fracture/fragments/Extrusion.h"
#include "core/fracture/verify/VerifyDelaunay.h"
#include "core/fracture/verify/VerifyFragments.h"
#include "core/fracture/verify/VerifyNearestSeed.h"
#include "core/fracture/verify/VerifyPartition.h"
#include "core/fracture/voronoi/VoronoiPartition.h"
#include "core/geometry/mesh/SourceScene.h"
#include "core/io/fracture/FractureJson.h"
#include "core/io/media/GreyImageFile.h"
#include "core/io/media/RadianceFile.h"
#include "core/io/pack/PackFile.h"
#include "core/io/play/BodiesJson.h"
#include "core/io/play/ReplayFile.h"
#include "core/io/play/StateFile.h"
#include "core/io/project/MaterialPresetFile.h"
#include "core/io/project/ProjectFile.h"
#include "core/io/project/ShotJson.h"
#include "tests/support/play/SealedStates.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

namespace rubble::test {

// The checks of the fuzz targets and the corpus test: each reads the bytes, processes accepted input and returns the
// first fault, or nothing. Input beyond these sizes is only read.
inline constexpr std::size_t kMaxFuzzedSeeds = 64;
inline constexpr std::size_t kMaxFuzzedCorners = 64;
inline constexpr std::size_t kMaxFuzzedBodies = 16;
inline constexpr int kFuzzedSteps = 5;
inline constexpr std::size_t kMaxFuzzedTriangles = 1000;

using Sentence = std::optional<std::string>;

/// Every error has a message, which is a sentence in UTF-8. It may quote names as they are in the file.
inline Sentence errorFault(const Error& error) {
    if (!error.message.empty() && error.message.back() == '.' && isUtf8(error.message)) return std::nullopt;
    return "The error \"" + error.message + "\" is not a sentence.";
}

/// Whether a project may have an asset of this prism; others are partitioned, but not extruded.
inline bool isBakeable(const Prism& prism) {
    Project project{.nextId = 3};
    project.materials = {{.id = 1, .name = "stone"}};
    project.assets = {{.id = 2, .name = "prism", .material = 1, .shape = prism}};
    return !verifyProject(project);
}

/// Verifies every stage of the fracture of a prism.
inline Sentence stageFault(const FractureInput& input) {
    const Result<Delaunay> delaunay = triangulate(input.seeds);
    if (!delaunay) return errorFault(delaunay.error());
    if (Sentence fault = verifyDelaunay(*delaunay, input.seeds)) return fault;
    Result<Partition> partition = voronoiPartition(input.prism.outline, *delaunay);
    if (!partition) return errorFault(partition.error());
    if (Sentence fault = verifyPartition(*partition, input.prism.outline)) return fault;
    if (Sentence fault = verifyNearestSeed(*partition, input.seeds)) return fault;
    if (!isBakeable(input.prism)) return std::nullopt;
    const Result<Fragments> fragments = extrudedFragments(input.prism, std::move(*partition));
    if (!fragments) return errorFault(fragments.error());
    return verifyFragments(*fragments, input.prism);
}

inline Sentence fractureFault(std::string_view bytes) {
    const Result<FractureInput> input = readFractureInput(bytes);
    if (!input) return errorFault(input.error());
    if (input->seeds.size() > kMaxFuzzedSeeds || cornersOf(input->prism.outline).size() > kMaxFuzzedCorners)
        return std::nullopt;
    const Result<std::string> json = fractureJson(*input);
    if (!json) return errorFault(json.error());
    static_cast<void>(thesisJson(*input));
    return stageFault(*input);
}

/// A project must read back from its own text, and give the same text again.
inline Sentence projectFault(std::string_view bytes) {
    const Result<Project> project = readProjectText(bytes);
    if (!project) return errorFault(project.error());
    if (Sentence fault = verifyProject(*project)) return fault;
    const std::string text = projectText(*project);
    const Result<Project> again = readProjectText(text);
    if (!again) return "The written text is rejected: " + again.error().message;
    if (projectText(*again) != text) return "The written text reads back differently.";
    return std::nullopt;
}

/// A material must read back from its own text, and be valid in a project.
inline Sentence materialFault(std::string_view bytes) {
    const Result<MaterialPreset> preset = readMaterialPresetText(bytes);
    if (!preset) return errorFault(preset.error());
    if (Sentence fault = verifyPreset(*preset)) return fault;
    const std::string text = materialPresetText(*preset);
    const Result<MaterialPreset> again = readMaterialPresetText(text);
    if (!again) return "The written text is rejected: " + again.error().message;
    if (materialPresetText(*again) != text) return "The written text reads back differently.";
    Project project{.nextId = 2};
    project.materials = {materialOf(*preset, 1)};
    return verifyProject(project);
}

/// A replay must read back from its own text, and give the same text again.
inline Sentence replayFault(std::string_view bytes) {
    const Result<Replay> replay = readReplayText(bytes);
    if (!replay) return errorFault(replay.error());
    const std::string text = replayText(*replay);
    const Result<Replay> again = readReplayText(text);
    if (!again) return "The written text is rejected: " + again.error().message;
    if (replayText(*again) != text) return "The written text reads back differently.";
    return std::nullopt;
}

/// Two blocks in five fragments on the ground.
inline const std::shared_ptr<const PlayScene>& fuzzedScene() {
    static const std::shared_ptr<const PlayScene> scene = [] {
        Project project{.nextId = 6};
        project.materials = {{.id = 1, .name = "stone"}};
        Asset block{.id = 2, .name = "block", .material = 1, .threshold = 100.0};
        block.shape = Prism{{{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}, {}}, 0.5};
        block.pattern.layers = {{.id = 3, .parameters = UniformScatter{.count = 5}}};
        project.assets = {block};
        project.instances = {{.id = 4, .name = "lower", .asset = 2},
                             {.id = 5, .name = "upper", .asset = 2, .pose = {.position = {0.2, 1.0, 0.0}}}};
        return playScene(project, {.threads = 1}).value();
    }();
    return scene;
}

/// The fields of a state of fuzzedScene(): after a byte for its kind. What is accepted is simulated.
inline Sentence stateFault(std::string_view fields) {
    const ContentHash hash = sceneHash(fuzzedScene()->project);
    const std::string kind(1, fields.empty() ? '\1' : fields.front());
    std::string header = stateBytes({}, hash).substr(0, kStateHeader);
    header.replace(12, 1, kind);
    Result<SavedSession> saved =
        readStateBytes(withFields(header, std::string(fields.substr(std::min<std::size_t>(fields.size(), 1)))), hash);
    if (!saved) return errorFault(saved.error());
    Result<Session> session = resumedSession(fuzzedScene(), std::move(*saved), {.checksEnergy = false});
    if (!session) return errorFault(session.error());
    for (int step = 0; step < kFuzzedSteps; ++step) session->step();
    return std::nullopt;
}

/// Accepted shots have valid actions.
inline Sentence shotsFault(std::string_view bytes) {
    const Result<std::vector<Shot>> shots = readShotList(bytes);
    if (!shots) return errorFault(shots.error());
    for (const Shot& shot : *shots) {
        if (Sentence fault = faultOf(shot)) return fault;
    }
    return std::nullopt;
}

/// A pack may be inconsistent; verifying it must not fail.
inline Sentence packFault(std::string_view bytes) {
    const Result<Pack> pack = readPack(bytes);
    if (!pack) return errorFault(pack.error());
    const Sentence fault = verifyPack(*pack);
    return fault ? errorFault({ErrorCode::BadInput, *fault}) : std::nullopt;
}

/// Accepted bodies keep finite poses in a simulation.
inline Sentence bodiesFault(std::string_view bytes) {
    const Result<BodyScene> scene = readBodyScene(bytes);
    if (!scene) return errorFault(scene.error());
    if (Sentence fault = verifyBodyScene(*scene)) return fault;
    if (scene->bodies.size() > kMaxFuzzedBodies) return std::nullopt;
    Result<SceneWorld> moved = makeWorld(*scene);
    if (!moved) return errorFault(moved.error());
    for (int step = 0; step < kFuzzedSteps; ++step) moved->world.step(1.0 / 60.0);
    for (std::size_t k = 0; k < moved->bodies.size(); ++k) {
        const Pose pose = moved->world.state(moved->bodies[k]).pose;
        const bool isFinite = std::isfinite(glm::length(pose.position)) && std::isfinite(glm::length(pose.orientation));
        if (!isFinite) return "Body \"" + scene->bodies[k].name + "\" has a pose that is not finite after some steps.";
    }
    return std::nullopt;
}

/// An accepted PNG file gives a valid image for a density layer.
inline Sentence pngFault(std::string_view bytes) {
    Result<GreyImage> image = greyImageOfPng(bytes, "picture.png");
    if (!image) return errorFault(image.error());
    return verifyGreyImage(*densityPictureOf(std::move(*image), "picture.png").image);
}

/// An accepted sky has finite radiances, and light above the horizon.
inline Sentence radianceFault(std::string_view bytes) {
    const Result<RadianceImage> image = radianceOfFile(bytes, "sky.hdr");
    if (!image) return errorFault(image.error());
    const bool isSky = image->width == 2 * image->height && image->width <= RadianceImage::kMaxWidth;
    if (!isSky || image->pixels.size() != std::size_t{image->width} * image->height) return "The size is wrong.";
    double sum = 0.0;
    for (std::size_t k = 0; k < image->pixels.size(); ++k) {
        for (const float value : image->pixels[k]) {
            if (!(value >= 0.0f && value <= 1e30f)) return "A radiance is out of range.";
            if (k < std::max<std::size_t>(image->height / 2, 1) * image->width) sum += static_cast<double>(value);
        }
    }
    return sum > 0.0 ? std::nullopt : Sentence("There is no light.");
}

/// What becomes of the objects of a mesh in a project: each is imported or rejected with a sentence.
inline Sentence importFault(const SourceScene& scene) {
    const Result<ImportOutcome> imported = importedInto({}, scene, "mesh", {}, {.threads = 1});
    if (!imported) return errorFault(imported.error());
    for (const RejectedObject& rejected : imported->rejected) {
        if (Sentence fault = errorFault(rejected.error)) return fault;
    }
    const bool hasMesh = std::ranges::any_of(imported->assets, [](const ImportedAsset& a) { return !a.prism; });
    return hasMesh ? std::nullopt : projectFault(projectText(imported->project));
}

/// What the importer returns must give the same bytes again, and be imported or rejected.
inline Sentence sourceSceneFault(std::string_view bytes) {
    const Result<SourceScene> scene = readSourceScene(bytes);
    if (!scene) return errorFault(scene.error());
    if (sourceSceneBytes(*scene) != bytes) return "The scene gives other bytes.";
    std::size_t triangles = 0;
    for (const SourceObject& object : scene->objects) triangles += object.triangles.size();
    return triangles > kMaxFuzzedTriangles ? std::nullopt : importFault(*scene);
}

}  // namespace rubble::test
