#pragma once

#include "core/fracture/ThesisMethod.h"
#include "core/fracture/Verify.h"
#include "core/fracture/VoronoiPartition.h"
#include "core/io/BodiesJson.h"
#include "core/io/FractureJson.h"
#include "core/io/MaterialFile.h"
#include "core/io/PackFile.h"
#include "core/io/ProjectFile.h"

#include <cmath>
#include <optional>
#include <string>
#include <string_view>

namespace rubble::test {

/// What fuzz targets do with bytes, and the corpus test with those that once went wrong: reads them, carries out what was
/// accepted and says what is wrong with it, or nothing. Bigger input than this is read only.
inline constexpr std::size_t kMostFuzzedSeeds = 64;
inline constexpr std::size_t kMostFuzzedCorners = 64;
inline constexpr std::size_t kMostFuzzedBodies = 16;
inline constexpr int kFuzzedSteps = 5;

using Sentence = std::optional<std::string>;

/// Every refusal says something.
inline Sentence refusalFault(const Error& error) {
    if (!error.message.empty() && error.message.back() == '.') return std::nullopt;
    return "The refusal \"" + error.message + "\" is no sentence.";
}

inline std::size_t cornersOf(const Polygon& polygon) {
    std::size_t corners = polygon.outer.size();
    for (const Ring& hole : polygon.holes) corners += hole.size();
    return corners;
}

/// Every stage of cutting a prism.
inline Sentence stageFault(const FractureInput& input) {
    const Result<Delaunay> delaunay = triangulate(input.seeds);
    if (!delaunay) return refusalFault(delaunay.error());
    if (Sentence fault = verifyDelaunay(*delaunay, input.seeds)) return fault;
    Result<Partition> partition = voronoiPartition(input.prism.outline, *delaunay);
    if (!partition) return refusalFault(partition.error());
    if (Sentence fault = verifyPartition(*partition, input.prism.outline)) return fault;
    if (Sentence fault = verifyNearestSeed(*partition, input.seeds)) return fault;
    const Result<Fragments> fragments = extrudedFragments(input.prism, std::move(*partition));
    if (!fragments) return refusalFault(fragments.error());
    return verifyFragments(*fragments, input.prism);
}

inline Sentence fractureFault(std::string_view bytes) {
    const Result<FractureInput> input = readFractureInput(bytes);
    if (!input) return refusalFault(input.error());
    if (input->seeds.size() > kMostFuzzedSeeds || cornersOf(input->prism.outline) > kMostFuzzedCorners)
        return std::nullopt;
    for (const FractureMethod method : {FractureMethod::Exact, FractureMethod::Thesis}) {
        const Result<std::string> json = fractureJson(*input, method);
        if (!json) return refusalFault(json.error());
    }
    return stageFault(*input);
}

/// A project that is read must come back from its own text, and the text from it.
inline Sentence projectFault(std::string_view bytes) {
    const Result<Project> project = readProjectText(bytes);
    if (!project) return refusalFault(project.error());
    if (Sentence fault = verifyProject(*project)) return fault;
    const std::string text = projectText(*project);
    const Result<Project> again = readProjectText(text);
    if (!again) return "What was written is refused: " + again.error().message;
    if (projectText(*again) != text) return "What was written reads back as something else.";
    return std::nullopt;
}

/// A material that is read must come back from its own text, and be one that a project can keep.
inline Sentence materialFault(std::string_view bytes) {
    const Result<MaterialPreset> preset = readMaterialPresetText(bytes);
    if (!preset) return refusalFault(preset.error());
    if (Sentence fault = verifyPreset(*preset)) return fault;
    const std::string text = materialPresetText(*preset);
    const Result<MaterialPreset> again = readMaterialPresetText(text);
    if (!again) return "What was written is refused: " + again.error().message;
    if (materialPresetText(*again) != text) return "What was written reads back as something else.";
    Project project{.nextId = 2};
    project.materials = {materialOf(*preset, 1)};
    return verifyProject(project);
}

/// A pack may be wrong in itself; saying so must not fail.
inline Sentence packFault(std::string_view bytes) {
    const Result<Pack> pack = readPack(bytes);
    if (!pack) return refusalFault(pack.error());
    const Sentence fault = verifyPack(*pack);
    return fault ? refusalFault({ErrorCode::BadInput, *fault}) : std::nullopt;
}

/// Bodies that are accepted move without ending up nowhere.
inline Sentence bodiesFault(std::string_view bytes) {
    const Result<BodyScene> scene = readBodyScene(bytes);
    if (!scene) return refusalFault(scene.error());
    if (Sentence fault = verifyBodyScene(*scene)) return fault;
    if (scene->bodies.size() > kMostFuzzedBodies) return std::nullopt;
    Result<SceneWorld> moved = makeWorld(*scene);
    if (!moved) return refusalFault(moved.error());
    for (int step = 0; step < kFuzzedSteps; ++step) moved->world.step(1.0 / 60.0);
    for (std::size_t k = 0; k < moved->bodies.size(); ++k) {
        const Pose pose = moved->world.state(moved->bodies[k]).pose;
        const bool isFinite = std::isfinite(glm::length(pose.position)) && std::isfinite(glm::length(pose.orientation));
        if (!isFinite) return "Body \"" + scene->bodies[k].name + "\" is nowhere after some steps.";
    }
    return std::nullopt;
}

}  // namespace rubble::test
