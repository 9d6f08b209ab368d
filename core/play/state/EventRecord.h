#pragma once

#include "core/asset/project/Project.h"
#include "core/geometry/search/Box3.h"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rubble {

/// The kinds of events, in the order in which a step reports them.
enum class EventKind : std::uint8_t {
    Impact,    // two bodies hit each other
    Bonds,     // bonds of a body broke
    Detached,  // an island of a body came free
    Broken,    // a whole was swapped for its fragments
    Settled,   // a body came to rest somewhere else
    Removed,   // a body is gone
};
inline constexpr std::size_t kEventKinds = 6;

/// The name of a kind in files: "impact".
std::string_view nameOf(EventKind kind);

/// Why a body was removed.
enum class RemovalReason : std::uint8_t {
    None,       // it was not
    Lifetime,   // debris that has faded out
    Budget,     // debris beyond the largest number of fragments
    LeftWorld,  // it fell, flew or moved out of the world
    Input,      // an input took it away
};

/// The name of a reason in files: "lifetime"; empty for none.
std::string_view nameOf(RemovalReason reason);

/// Something that happened to a body in a step.
struct EventRecord {
    std::uint64_t step = 0;  // after which it holds
    EventKind kind = EventKind::Impact;
    std::uint32_t body = 0;         // its number
    std::uint32_t other = kNone;    // number of the one that it touched, or came off (detached); kNone: none
    Id instance = 0;                // 0: the ground, or thrown
    std::string fragment;           // its path in the asset, "5.17.1"; empty for the whole
    Vec3 point{0.0, 0.0, 0.0};      // m, in the world
    Vec3 normal{0.0, 0.0, 0.0};     // from `other` into `body`
    double impulse = 0.0;           // N·s, along the normal; bonds: what they took; broken: what broke it
    double speed = 0.0;             // m/s, of the approach, before solving
    double energy = 0.0;            // J: lost by both bodies (impact), or in the break (bonds, broken)
    double area = 0.0;              // m²: of the faces that a break opened
    double mass = 0.0;              // kg: of what came free, came to rest or is gone
    std::uint32_t count = 0;        // fragments that came free; bonds: those that broke
    std::array<Id, 2> materials{};  // of both bodies; of a break: of the body, and of the fresh faces. 0: none
    Box3 box;                       // m: of what changed, in the world
    RemovalReason reason = RemovalReason::None;
    bool operator==(const EventRecord&) const = default;
};

/// Events of a kind that happened and are not reported one by one.
struct OmittedEvents {
    std::uint32_t count = 0;
    double energy = 0.0;  // J, their sum
    bool operator==(const OmittedEvents&) const = default;
};

/// What is reported of a step.
struct EventReport {
    std::vector<EventRecord> records;                  // by kind, then body, then other
    std::array<OmittedEvents, kEventKinds> omitted{};  // by kind
    double restEnergy = 0.0;  // J: that contacts took without an impact: friction, rolling, rattling
    bool operator==(const EventReport&) const = default;

    bool isEmpty() const;
    /// All energy that contacts and breaks took in the step, J.
    double energy() const;
    /// The same for the same report, on every machine.
    std::uint64_t hash() const;
};

}  // namespace rubble
