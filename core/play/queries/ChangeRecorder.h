#pragma once

#include "core/geometry/search/Box3.h"
#include "core/play/session/Session.h"

#include <vector>

namespace rubble {

/// The changes that a ChangeRecorder keeps apart, 56 bytes each: those of 1,000 moving bodies in a thousand steps.
inline constexpr std::size_t kMaxChanges = std::size_t{1} << 20;

/// Records where the bodies of a session changed while it is played, for what is derived from their places, such as
/// navigation meshes. It only reads the session.
class ChangeRecorder {
public:
    /// Of more than `maxChanges`, the older half is kept as one: steps within it are answered as its first.
    explicit ChangeRecorder(const Session& session, std::size_t maxChanges = kMaxChanges);

    /// Must be called after each step, in O(n) for n bodies. After Session::restore() a new recorder is needed.
    void add(const Session& session);

    /// World boxes of all bodies that moved, broke, were added or were removed since `step` steps were done: those of
    /// their old and new places, merged and sorted by mergedBoxes(). Outside of them nothing differs. The path between
    /// the places is not covered. A step before the recorder's first is taken for its first.
    std::vector<Box3> changedBoxes(std::uint64_t step) const;
    /// The steps that the session had done at the last add().
    std::uint64_t step() const { return m_step; }

private:
    struct Place {
        std::uint32_t number = 0;  // of the body
        BodyId body;
        Box3 local;  // of its exact hulls, in its own frame
        Pose pose;
        Box3 box;  // in the world
    };
    struct Change {
        std::uint32_t number = 0;
        Box3 before;  // empty: the body did not exist
    };
    /// The changes of a step, or of several that are kept as one.
    struct Span {
        std::uint64_t last = 0;  // the steps done after it
        std::vector<Change> changes;
    };

    void addMoved(const Session& session, std::vector<Change>& changes);
    void addBorn(const Session& session, std::vector<Change>& changes);
    void joinOlderHalf();

    std::size_t m_maxChanges = 0;
    std::uint64_t m_step = 0;
    std::vector<Place> m_places;  // of the bodies that exist, ascending number
    std::vector<Span> m_spans;    // ascending; each begins where the one before ended
    std::size_t m_changes = 0;    // in all spans
};

}  // namespace rubble
