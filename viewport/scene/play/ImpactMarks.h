#pragma once

#include "core/play/session/Session.h"
#include "viewport/scene/RenderScene.h"

#include <functional>
#include <span>

namespace rubble {

inline constexpr std::size_t kMaxMarks = 64;  // that are shown, the latest ones

/// What the impacts, breaks and blasts of a session have left on its bodies. A mark is kept in the frame of the asset
/// that was hit, so that it stays on each fragment that has a part of it, wherever that moves.
class ImpactMarks {
public:
    /// Records what the session's last step left. A step may be recorded again, as after a seek; one that left
    /// something else begins another course.
    void record(const Session& session);
    /// The index of the body of a scene that shows a fragment of a body of the session; kNone: the whole.
    using SceneBody = std::function<std::uint32_t(const PlayBody& body, std::uint32_t fragment)>;
    /// Adds the marks of the session's step, of those that were recorded. `isApart`: as in forEachSolid().
    void addTo(RenderScene& scene, const Session& session, const SceneBody& sceneBody,
               const std::function<bool(const PlayBody&)>& isApart) const;

private:
    struct Mark {
        std::uint64_t step = 0;
        std::uint32_t origin = 0;  // of the bodies that have it
        Vec3 centre{0.0};          // m, in the asset's frame
        Vec3 normal{0.0};          // of the surface; soot has none
        double radius = 0.0;       // m
        double seed = 0.0;         // in [0, 1)
        bool operator==(const Mark&) const = default;
    };
    static std::vector<Mark> marksOf(const Session& session);
    static void addImpact(const Session& session, const EventRecord& record, std::vector<Mark>& marks);
    static void addSoot(const Session& session, const Blast& blast, std::vector<Mark>& marks);
    std::span<const Mark> between(std::uint64_t first, std::uint64_t last) const;

    std::uint64_t m_first = 1, m_last = 0;  // the steps that are known; none if m_first > m_last
    std::vector<Mark> m_marks;
};

}  // namespace rubble
