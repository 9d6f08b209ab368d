#include "core/asset/StarterProject.h"

namespace rubble {

Project emptyProject() {
    Project project;
    project.materials = {{.id = project.nextId++,
                          .name = "plaster",
                          .density = 1200.0,
                          .outside = {0.87, 0.84, 0.78},
                          .inside = {0.68, 0.62, 0.55}}};
    return project;
}

Project starterProject() {
    Project project = emptyProject();
    Asset wall{.id = project.nextId++, .name = "wall", .material = project.materials[0].id};
    wall.prism = {{{{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}, {}}, 0.5};
    wall.pattern.layers = {{.id = project.nextId++, .randomSeed = 1, .parameters = UniformScatter{.count = 20}}};
    const Id asset = wall.id;
    project.assets = {std::move(wall)};
    project.instances = {
        {.id = project.nextId++, .name = "wall", .asset = asset, .pose = {.position = {0.0, 0.5, 0.0}}}};
    return project;
}

}  // namespace rubble
