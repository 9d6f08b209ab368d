#pragma once

#include "core/play/scene/JoinedSupport.h"

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <queue>
#include <span>
#include <utility>
#include <vector>

namespace rubble {

/// A node of the structure of an instance.
struct InstanceNode {
    Id instance = 0;
    std::uint32_t node = 0;
    auto operator<=>(const InstanceNode&) const = default;
};

/// Nodes that wait, by fraction of the span. Within the span they are in buckets: those of the lowest come first, in
/// any order, and a node that is reached again at a smaller fraction waits again. Those beyond it come by fraction.
class WaitingNodes {
public:
    using Entry = std::pair<double, std::uint32_t>;

    void add(double fraction, std::uint32_t node);
    std::optional<Entry> next();

private:
    static constexpr std::size_t kBuckets = 32;
    std::array<std::vector<Entry>, kBuckets> m_buckets;
    std::size_t m_lowest = kBuckets;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> m_beyond;
};

/// supportFractions() of structures, also while bonds break: what breaks costs what it supported. The same numbers as
/// computed anew, whatever broke in which order.
///
/// Keeps for each node over which bonds its fraction was ever lowered. Where one of them breaks, all that was lowered
/// from there is reached anew from what was not: a fraction may go down around a circle, over what stands upon
/// something, so the last of these bonds alone would not tell what it rests on.
/// Source: Ramalingam, Reps 1996, "An incremental algorithm for a generalization of the shortest-path problem".
class SupportSpread {
public:
    /// `limits`: see supportFractions().
    SupportSpread(const std::map<Id, JoinedStructure>& joined, const NodeFractions& limits);

    /// Whether a structure had broken bonds that `damage` has not; then nothing else may be called but for others.
    bool isMended(Id instance, std::span<const BondDamage> damage) const;
    /// Sets the damage of a structure, in which nothing may be mended.
    void setDamage(Id instance, std::span<const BondDamage> damage);
    /// Takes account of what broke. Returns the nodes that support no longer reaches and reached before, ascending.
    /// O(n log n) in the nodes to which support came over what broke, and their bonds.
    std::vector<InstanceNode> spread();

    /// Of a structure's nodes: infinite where no support reaches.
    std::vector<double> fractionsOf(Id instance) const;
    /// How many nodes support spread from so far.
    std::size_t visits() const { return m_visits; }

private:
    /// A structure, and what its nodes need in each step.
    struct Member {
        Id instance = 0;
        const PlayStructure* structure = nullptr;
        Vec3 up{0.0};                    // in its frame
        std::vector<BondDamage> damage;  // of each bond
        std::uint32_t first = 0;         // the index of its first node among all
        std::uint32_t firstBond = 0;     // the index of its first bond among all
        double perMetre = 0.0;           // of the span
        bool hasSpan = false;
        bool hasSteps = false;  // PlayStructure::steps are those against the present gravity

        bool isBroken(std::uint32_t bond) const { return damage[bond] == kBroken; }
        double stepOf(std::uint32_t node, std::uint32_t link) const;
    };
    /// A bond over which a node's fraction was lowered.
    struct Lowering {
        std::uint32_t bond = 0;        // its index among all; of mortar, the node's half
        std::uint32_t before = kNone;  // the node's one before it
    };

    void addMember(Id instance, const JoinedStructure& joined);
    void addSources(const Member& member);
    void spreadFromWaiting();
    void follow(const Member& member, std::uint32_t node, std::uint32_t link, double fraction);
    void cross(const Member& member, std::uint32_t half, const Member& other, std::uint32_t otherHalf, double fraction);
    void reach(const Member& member, std::uint32_t node, double fraction, std::uint32_t bond);
    /// The index of the node beyond a link, and the bond as its Lowering names it; kNone: an anchor.
    std::pair<std::uint32_t, std::uint32_t> beyond(const Member& member, const BondLink& link) const;
    bool wasLoweredOver(std::uint32_t index, std::uint32_t bond) const;
    void loseIfLoweredOver(std::uint32_t index, std::uint32_t bond);
    void reachAnew(std::uint32_t index);

    const Member& memberOf(Id instance) const { return m_members[memberIndex(instance)]; }
    std::size_t memberIndex(Id instance) const;
    const Member& memberOfNode(std::uint32_t index) const { return m_members[m_memberOf[index]]; }

    std::vector<Member> m_members;                                // ascending instances
    std::vector<double> m_fractions;                              // of each node
    std::vector<double> m_limits;                                 // of each node
    std::vector<std::uint32_t> m_memberOf;                        // of each node, in m_members
    std::vector<std::uint32_t> m_lastLowering;                    // of each node, in m_lowerings
    std::vector<Lowering> m_lowerings;                            //
    std::vector<std::pair<std::size_t, std::uint32_t>> m_broken;  // members and their bonds, since spread()
    std::vector<std::uint32_t> m_lost;                            // nodes that have to be reached anew
    WaitingNodes m_waiting;
    std::size_t m_visits = 0;
};

}  // namespace rubble
