#include "core/play/session/SessionTracks.h"

#include "core/base/Assert.h"
#include "core/play/session/Timeline.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

constexpr std::size_t kMaxGap = 120;           // keys between those that reducedPoses() keeps
constexpr float kMinRotationCosine = 0.9962f;  // of half of 10 degrees

/// The origin of the mesh of a solid in the solid's frame, m: that of a whole is at its centre of mass.
Vec3 meshOrigin(const PlayBody& body, std::uint32_t fragment) {
    return body.asset != nullptr && fragment == kNone ? body.asset->bake->whole.centre : Vec3(0.0);
}

/// The pose of a mesh whose origin is at `offset` in the frame of a body, which shrinks to its centre of mass.
PoseKey keyOf(std::uint32_t frame, const BodyState& state, Vec3 offset, double fade) {
    const Vec3 origin = state.pose.position + state.pose.orientation * offset;
    return {frame, glm::vec3(glm::mix(origin, state.centre, fade)), glm::quat(state.pose.orientation)};
}

bool isSamePose(const PoseKey& a, const PoseKey& b) {
    return a.position == b.position && a.orientation == b.orientation;
}

/// An upper bound of how far a point of a solid is from where the motion from one pose to another has it, m.
double errorOf(const PoseKey& from, const PoseKey& to, const PoseKey& pose, double radius) {
    const auto fraction = static_cast<float>(pose.frame - from.frame) / static_cast<float>(to.frame - from.frame);
    const glm::vec3 position = from.position + fraction * (to.position - from.position);
    // Close to spherical interpolation: the two quaternions are at most five degrees apart.
    const glm::quat orientation = glm::normalize(from.orientation * (1.0f - fraction) + to.orientation * fraction);
    const glm::quat turn = orientation - pose.orientation;
    return double{glm::length(position - pose.position)} + 2.0 * radius * double{glm::length(turn)};
}

/// Whether the motion between two keys shows all of those between them.
bool shows(const std::vector<PoseKey>& poses, std::size_t from, std::size_t to, double radius, double tolerance) {
    for (std::size_t k = from + 1; k < to; ++k) {
        if (errorOf(poses[from], poses[to], poses[k], radius) > tolerance) return false;
    }
    return true;
}

}  // namespace

TrackRecorder::TrackRecorder(const Session& session, std::uint64_t every)
    : m_every(every), m_start(session.stepsDone()) {
    RUBBLE_ASSERT(every > 0);
    m_tracks.frameLength = session.stepLength() * static_cast<double>(every);
    record(session);
}

Status TrackRecorder::add(const Session& session) {
    const std::uint64_t steps = session.stepsDone() - m_start;
    if (steps % m_every != 0) return success();
    m_tracks.lastFrame = static_cast<std::uint32_t>(steps / m_every);
    record(session);
    if (m_keyCount <= kMaxPoseKeys) return success();
    return Error{ErrorCode::Limit, "The animation has more than " + std::to_string(kMaxPoseKeys) +
                                       " poses, the maximum; simulate fewer steps, or record fewer of them."};
}

void TrackRecorder::record(const Session& session) {
    m_seen.clear();
    for (const PlayBody& body : session.bodies()) {
        if (body.role == PlayRole::Ground) continue;
        const BodyState state = session.world().state(body.body);
        const double fade = session.fadeOf(body);
        const void* const shape = body.asset != nullptr ? static_cast<const void*>(body.asset.get()) : body.hull.get();
        forEachSolid(body, false, [&](std::uint32_t fragment, Vec3 offset) {
            const PoseKey pose = keyOf(m_tracks.lastFrame, state, offset + meshOrigin(body, fragment), fade);
            const auto [known, isNew] =
                m_solidOf.try_emplace(Key(shape, body.origin, fragment), m_tracks.solids.size());
            if (isNew) {
                m_tracks.solids.push_back(
                    {session.origins()[body.origin].name, body.asset, fragment, body.hull, {}, {}});
            }
            addKey(m_tracks.solids[known->second], pose, static_cast<float>(1.0 - fade));
            m_seen.push_back(known->second);
        });
    }
    hideMissing();
}

/// Adds a pose unless the solid rests, and a size unless it stays.
void TrackRecorder::addKey(SolidTrack& track, const PoseKey& pose, float size) {
    const auto addPose = [&](const PoseKey& key) {
        track.poses.push_back(key);
        ++m_keyCount;
    };
    const bool isShown = !track.sizes.empty() && track.sizes.back().size > 0.0f;
    if (track.poses.empty()) {
        addPose(pose);
        if (pose.frame > 0) track.sizes.push_back({0, 0.0f});
    } else if (!isSamePose(track.poses.back(), pose)) {
        // It rested until the last frame; or was not there, and is at once where it is now.
        PoseKey held = isShown ? track.poses.back() : pose;
        held.frame = pose.frame - 1;
        if (track.poses.back().frame < held.frame) addPose(held);
        PoseKey next = pose;
        if (glm::dot(track.poses.back().orientation, next.orientation) < 0.0f) next.orientation = -next.orientation;
        addPose(next);
    }
    if (track.sizes.empty() || track.sizes.back().size != size) track.sizes.push_back({pose.frame, size});
}

/// Hides what was there in the frame before and is not there now.
void TrackRecorder::hideMissing() {
    std::ranges::sort(m_seen);
    for (const std::size_t solid : m_visible) {
        if (!std::ranges::binary_search(m_seen, solid))
            m_tracks.solids[solid].sizes.push_back({m_tracks.lastFrame, 0.0f});
    }
    m_visible = m_seen;
}

Result<SessionTracks> recordTracks(Session session, std::vector<TimedInput> inputs, std::uint64_t steps,
                                   const TaskContext& task) {
    TrackRecorder recorder(session);
    const auto record = [&](const Session& played) { return recorder.add(played); };
    const Status played = playOn(std::move(session), std::move(inputs), steps, task, record);
    if (!played) return played.error();
    return std::move(recorder).tracks();
}

std::vector<PoseKey> reducedPoses(const std::vector<PoseKey>& poses, double radius, double tolerance) {
    std::vector<PoseKey> kept;
    std::size_t from = 0;
    if (!poses.empty()) kept.push_back(poses.front());
    while (from + 1 < poses.size()) {
        std::size_t to = from + 1;
        const auto isReached = [&](std::size_t next) {
            return next < poses.size() && next - from <= kMaxGap &&
                   glm::dot(poses[from].orientation, poses[next].orientation) >= kMinRotationCosine &&
                   shows(poses, from, next, radius, tolerance);
        };
        while (isReached(to + 1)) ++to;
        kept.push_back(poses[to]);
        from = to;
    }
    return kept;
}

}  // namespace rubble
