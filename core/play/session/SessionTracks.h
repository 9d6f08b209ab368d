#pragma once

#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/play/session/Session.h"

#include <glm/gtc/quaternion.hpp>
#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace rubble {

/// Where a solid is in a frame, in the world; between two keys it moves evenly.
struct PoseKey {
    std::uint32_t frame = 0;
    glm::vec3 position{0.0f};                       // m, of the origin of its mesh
    glm::quat orientation{1.0f, 0.0f, 0.0f, 0.0f};  // no neighbours are more than half a turn apart
    bool operator==(const PoseKey&) const = default;
};

/// The size of a solid from a frame on, until the next key: 1; less while it fades; 0 while it is not there.
struct SizeKey {
    std::uint32_t frame = 0;
    float size = 0.0f;
    bool operator==(const SizeKey&) const = default;
};

/// What a solid does in a session. Keys ascend.
struct SolidTrack {
    std::string origin;                      // its instance or saved throw
    std::shared_ptr<const PlayAsset> asset;  // null for a plain projectile
    std::uint32_t fragment = kNone;          // of the asset's bake; kNone: the whole
    std::shared_ptr<const Polytope> hull;    // of a plain projectile, in its own frame
    std::vector<PoseKey> poses;              // at least one
    std::vector<SizeKey> sizes;              // the first at frame 0, each other than the one before
};

/// Everything that was there in a session, frame by frame. Poses are those of meshes, whose origin is that of the
/// fragment, and for a whole its centre of mass.
struct SessionTracks {
    double frameLength = 0.0;        // s
    std::uint32_t lastFrame = 0;     // the first is 0
    std::vector<SolidTrack> solids;  // in order of their appearance
};

/// The maximum of all poses of a recording: 2 GiB.
inline constexpr std::size_t kMaxPoseKeys = std::size_t{1} << 26;

/// Records where the solids of a session are, every few steps. The ground is left out.
class TrackRecorder {
public:
    /// Records the session as it is as frame 0; `every` > 0: the number of steps between frames.
    explicit TrackRecorder(const Session& session, std::uint64_t every = 1);

    /// Must be called after each step.
    ///
    /// Errors: Limit above kMaxPoseKeys.
    Status add(const Session& session);
    SessionTracks tracks() && { return std::move(m_tracks); }

private:
    /// Asset or hull, origin, fragment.
    using Key = std::tuple<const void*, std::uint32_t, std::uint32_t>;
    void record(const Session& session);
    void addKey(SolidTrack& track, const PoseKey& pose, float size);
    void hideMissing();

    SessionTracks m_tracks;
    std::uint64_t m_every;
    std::uint64_t m_start;       // steps done at frame 0
    std::size_t m_keyCount = 0;  // of poses
    std::map<Key, std::size_t> m_solidOf;
    std::vector<std::size_t> m_visible;  // solids in the last frame, ascending
    std::vector<std::size_t> m_seen;     // in the frame being recorded
};

/// Plays a session on, with inputs (ascending step), until `steps` steps are done, and records every step.
///
/// Errors: those of Timeline::seek() and TrackRecorder::add(); Cancelled.
Result<SessionTracks> recordTracks(Session session, std::vector<TimedInput> inputs, std::uint64_t steps,
                                   const TaskContext& task = {});

/// Leaves out poses that lie within `tolerance`, m, of the motion between those that are kept, at all points of a solid
/// of radius `radius`, m, about the origin of its mesh. Neighbours that are kept are at most 10 degrees of rotation
/// apart, unless they were neighbours before. O(keys · longest gap), gaps being at most 120 keys.
std::vector<PoseKey> reducedPoses(const std::vector<PoseKey>& poses, double radius, double tolerance);

}  // namespace rubble
