#pragma once

#include "core/fracture/pieces/Fragment.h"
#include "core/io/json/JsonWriter.h"

#include <string>
#include <vector>

namespace rubble {

/// The data of a body for pack.json.
struct PackBodySource {
    std::string id;
    std::string name;
    std::uint32_t parent = kNone;
    Vec3 offset{0.0, 0.0, 0.0};  // m
    MassProperties mass;         // at density 1; the body's origin is its centre of mass
    std::vector<FragmentContact> contacts;
    std::uint32_t firstSibling = 0;  // index of the fragment that is 0 in the contacts
    std::vector<Polytope> hulls;
    std::optional<double> threshold;  // N·s, that is set for it
    double gap = 0.0;                 // m between its fragments; 0: none
    double lostVolume = 0.0;          // m³ that the gap takes from them
};

/// Writes a body as an object. `density` in kg/m³.
void writePackBody(JsonWriter& json, std::string_view key, const PackBodySource& body, double density);

/// The estimated size of a body's JSON in bytes.
std::size_t packBodySize(const PackBodySource& body);

}  // namespace rubble
