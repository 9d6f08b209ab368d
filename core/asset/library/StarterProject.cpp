#include "core/asset/library/StarterProject.h"

#include "core/asset/strength/Threshold.h"

namespace rubble {
namespace {

/// Adds a wall that breaks like a preset, and an instance of it, to a project with one material. An empty pattern
/// becomes 20 scattered seeds.
Project withWall(Project project, const MaterialPreset& preset) {
    Asset wall{.id = project.nextId++, .name = "wall", .material = project.materials[0].id};
    wall.prism() = {{{{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}, {}}, 0.5};
    deriveThresholdIfKnown(wall, project.materials[0]);
    wall.pattern = patternWithin(preset, {{-0.5, -0.5}, {0.5, 0.5}});
    wall.shaping.roughness = preset.roughness;
    wall.cutAtImpact = preset.cutAtImpact;
    if (wall.pattern.layers.empty()) {
        wall.pattern.layers = {{.randomSeed = 1, .parameters = UniformScatter{.count = 20}}};
    }
    for (PatternLayer& layer : wall.pattern.layers) layer.id = project.nextId++;
    const Id asset = wall.id;
    project.assets = {std::move(wall)};
    project.instances = {
        {.id = project.nextId++, .name = "wall", .asset = asset, .pose = {.position = {0.0, 0.5, 0.0}}}};
    return project;
}

}  // namespace

Project emptyProject() {
    Project project;
    project.materials = {{.id = project.nextId++,
                          .name = "plaster",
                          .density = 1250.0,
                          .friction = 0.6,
                          .restitution = 0.2,
                          .tensileStrength = 1e6,
                          .fractureToughness = 1.5e5,
                          .youngsModulus = 4e9,
                          .outside = {0.91, 0.89, 0.84},
                          .inside = {0.8, 0.77, 0.71},
                          .finish = Finish::Plaster}};
    return project;
}

Project emptyProject(const MaterialPreset& material) {
    Project project;
    project.materials = {materialOf(material, project.nextId++)};
    return project;
}

Project starterProject() { return withWall(emptyProject(), {}); }

Project starterProject(const MaterialPreset& material) { return withWall(emptyProject(material), material); }

}  // namespace rubble
