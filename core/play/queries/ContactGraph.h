#pragma once

#include "core/play/scene/PlayBody.h"

#include <span>
#include <vector>

namespace rubble {

/// A body that another touches.
struct TouchingBody {
    std::uint32_t body = 0;  // index in the bodies of the graph
    double up = 0.0;         // of the contact normal towards it, in [-1, 1]: 1 if it rests on the other
};

/// The contacts between all bodies of a world, as a graph of these bodies by their indices. Up is against gravity,
/// which must not be zero.
class ContactGraph {
public:
    ContactGraph(std::span<const PlayBody> bodies, const World& world);

    std::span<const TouchingBody> touching(std::uint32_t body) const { return m_touching[body]; }
    bool isDynamic(std::uint32_t body) const { return m_dynamic[body]; }

    /// Adds the dynamic bodies that are connected with `bodies`, at most `most` in all; true if
    /// there are no more.
    bool addConnected(std::vector<std::uint32_t>& bodies, std::size_t most) const;
    /// Adds the dynamic bodies that rest on `bodies`, on others that do, and so on.
    void addResting(std::vector<std::uint32_t>& bodies) const;
    /// Adds all bodies that touch one of `bodies`.
    void addTouching(std::vector<std::uint32_t>& bodies) const;

private:
    std::vector<std::vector<TouchingBody>> m_touching;
    std::vector<bool> m_dynamic;
};

}  // namespace rubble
