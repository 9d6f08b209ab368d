#pragma once

#include "core/fracture/Fragment.h"

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rubble {

/// What a pack tells of a body.
struct BodySource {
    std::string id;
    std::string name;
    std::uint32_t parent = kNone;
    Vec3 offset{0.0, 0.0, 0.0};  // m
    MassProperties mass;         // at density 1; its centre is the body's origin
    std::vector<Bond> bonds;
    std::uint32_t firstSibling = 0;  // index of the fragment that the bonds call 0
    std::vector<Polytope> hulls;
};

/// Text in memory of its own.
struct TextBlock {
    std::unique_ptr<char[]> memory;
    std::size_t size = 0;
    std::string_view view() const { return {memory.get(), size}; }
};

/// The bodies as JSON objects without blanks, one a line, a comma and a line feed between them. `density` in kg/m^3.
TextBlock bodiesJson(std::span<const BodySource> bodies, double density);

}  // namespace rubble
