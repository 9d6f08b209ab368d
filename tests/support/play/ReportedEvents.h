#pragma once

#include "core/play/state/EventRecord.h"
#include "tests/support/asset/ProjectParts.h"

namespace rubble::test {

/// Something that the steps of a session reported, and the materials that it names.
struct ReportedEvents {
    Project project;
    std::vector<EventRecord> events;
};

/// A block of 1 x 1 x 0.5 m at (0, `height`, 0) that broke in step 1 of a blow from +z.
inline ReportedEvents brokenBlock(double energy = 100.0, Material material = {}, double area = 4.0,
                                  double height = 5.0) {
    ReportedEvents reported;
    const Id id = addMaterial(reported.project, material);
    EventRecord broken{.step = 1,
                       .kind = EventKind::Broken,
                       .body = 1,
                       .other = 2,
                       .point = {0.0, height, 0.25},
                       .normal = {0.0, 0.0, -1.0},
                       .energy = energy,
                       .area = area,
                       .mass = 0.5 * material.density,
                       .count = 5,
                       .materials = {id, id}};
    broken.box = {{-0.5, height - 0.5, -0.25}, {0.5, height + 0.5, 0.25}};
    reported.events = {broken};
    return reported;
}

/// A body that hit the ground at the origin in step 1.
inline ReportedEvents impactOnGround(double energy, Material material = {}) {
    ReportedEvents reported;
    const Id id = addMaterial(reported.project, material);
    reported.events = {{.step = 1,
                        .body = 1,
                        .other = 0,
                        .normal = {0.0, 1.0, 0.0},
                        .speed = 5.0,
                        .energy = energy,
                        .materials = {id, 0}}};
    return reported;
}

/// Materials with the figures of presets of the library.
inline Material breakableOf(double density, double toughness, double opacity = 1.0) {
    return {.density = density, .fractureToughness = toughness, .opacity = opacity};
}
inline const Material kBrick = breakableOf(1900.0, 1e6), kConcrete = breakableOf(2400.0, 4e5);
inline const Material kPlaster = breakableOf(1250.0, 1.5e5), kGlass = breakableOf(2500.0, 7.5e5, 0.3);
inline const Material kIce = breakableOf(917.0, 1e5, 0.6), kSteel = breakableOf(7850.0, 6e7);
inline const Material kSpruce = breakableOf(420.0, 5e6);

}  // namespace rubble::test
