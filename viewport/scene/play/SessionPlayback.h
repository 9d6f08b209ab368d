#pragma once

#include "viewport/scene/play/SessionSceneBuilder.h"

#include <functional>

namespace rubble {

/// Plays a session and builds its render scenes at requested steps, in ascending order.
class SessionPlayback {
public:
    /// `session`: a session of `scene` that has not started. `inputs`: by ascending step, in addition to those that the
    /// session already has. Of the options, only colouring and hulls apply.
    SessionPlayback(std::shared_ptr<const PlayScene> scene, Session session, std::vector<TimedInput> inputs = {},
                    const SceneOptions& options = {}, const PlayOverlays& overlays = {});

    const Session& session() const { return m_session; }
    /// Calls back after each step from now on.
    void setAfterStep(std::function<void(const Session&)> afterStep) { m_afterStep = std::move(afterStep); }
    /// The scene at the current step.
    std::shared_ptr<const RenderScene> scene() { return m_builder->sceneOf(m_session); }
    /// Plays on to a step and returns its scene. Builds every scene of the last second before it, since heat cools down
    /// from step to step and an image may lie between the last two. Invalid inputs are skipped with a diagnostic.
    ///
    /// Errors: Cancelled.
    Result<std::shared_ptr<const RenderScene>> sceneAtStep(std::uint64_t step, const TaskContext& task = {});
    /// The diagnostics since the last call.
    std::vector<Diagnostic> drainDiagnostics();

private:
    void step();

    Session m_session;
    std::vector<TimedInput> m_inputs;
    std::size_t m_nextInput = 0;
    std::function<void(const Session&)> m_afterStep;
    std::unique_ptr<SessionSceneBuilder> m_builder;
    std::vector<Diagnostic> m_diagnostics;
};

}  // namespace rubble
