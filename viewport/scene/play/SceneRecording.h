#pragma once

#include "core/play/events/EventHistory.h"
#include "core/play/scene/PlayScene.h"
#include "viewport/scene/play/SessionMoment.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace rubble {

/// The default limit holds six minutes in which 300 bodies move all the time, or 15 s of 8,000.
inline constexpr std::size_t kMaxRecordingBytes = std::size_t{256} << 20;

/// How the steps of a session looked, so that any of them can be shown again at once, without simulating it: its
/// picture has the same bits. Of a step it keeps the bodies that have moved, appeared or disappeared since the step
/// before, and all of them where the changes since the last such keyframe add up to as many. Where it has grown too
/// large, it forgets every second one of the older steps, of which half of the memory is.
class SceneRecording {
public:
    /// `stepLength`: of the session, s. At most `maxBytes` are kept, but the first and the last step always are.
    SceneRecording(std::shared_ptr<const PlayScene> scene, double stepLength,
                   std::size_t maxBytes = kMaxRecordingBytes);

    /// Adds a step after the last one, with what happened in it. Steps up to the last one are ignored.
    void add(std::uint64_t step, SessionMoment moment, const PlayEvents& events);
    /// Forgets the steps after this one.
    void discardAfter(std::uint64_t step);
    void clear() { *this = SceneRecording(m_scene, m_stepLength, m_maxBytes); }

    /// Whether the step would be ignored by add().
    bool isKnown(std::uint64_t step) const { return !m_steps.empty() && step <= m_steps.back().step; }
    /// The last recorded step until this one; nothing before the first.
    std::optional<std::uint64_t> lastStepUntil(std::uint64_t step) const;
    /// The scene of a step that lastStepUntil() gave: what SessionSceneBuilder::sceneOf() returns after a seek to it,
    /// without overlays. It may have more bodies, which are hidden.
    std::shared_ptr<const RenderScene> sceneAt(std::uint64_t step) const;

    std::size_t stepCount() const { return m_steps.size(); }
    /// The memory of the steps and their layouts.
    std::size_t bytes() const { return m_stepBytes + m_layoutBytes; }

private:
    using Lines = std::shared_ptr<const std::vector<SceneLine>>;
    using Marks = std::shared_ptr<const std::vector<SurfaceMark>>;
    /// What has changed since the recorded step before, or everything if it is a keyframe.
    struct Step {
        std::uint64_t step = 0;
        std::uint32_t layout = 0;  // index
        bool isKey = false;
        bool hasOwnLines = false;           // they are not those of the step before
        bool hasOwnMarks = false;           // nor the marks
        std::vector<ShownBody> shown;       // that have moved or appeared, ascending
        std::vector<std::uint32_t> hidden;  // that have disappeared, ascending
        Lines lines;
        Marks marks;
        Vec3 gravity{0.0, 0.0, 0.0};
        std::size_t bytes() const;
    };
    static Step merged(const Step& earlier, Step later);
    std::uint32_t layoutOf(const std::shared_ptr<const RenderScene>& layout);
    void setChanges(Step& step, const std::vector<ShownBody>& bodies) const;
    void push(Step step);
    void thin();
    void dropUnusedLayouts();

    std::shared_ptr<const PlayScene> m_scene;
    double m_stepLength = 0.0;
    std::size_t m_maxBytes = 0;
    std::vector<std::shared_ptr<const RenderScene>> m_layouts;  // in the order of the steps that use them
    std::vector<Step> m_steps;                                  // ascending
    std::vector<ShownBody> m_last;                              // of the last step; empty after it was forgotten
    std::size_t m_changes = 0;                                  // bodies that have changed since the last keyframe
    std::size_t m_stepBytes = 0, m_layoutBytes = 0;
    EventHistory m_events;
};

}  // namespace rubble
