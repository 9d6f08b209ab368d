#include "viewport/scene/play/SessionPlayback.h"

#include <utility>

namespace rubble {

SessionPlayback::SessionPlayback(std::shared_ptr<const PlayScene> scene, Session session,
                                 std::vector<TimedInput> inputs, const SceneOptions& options,
                                 const PlayOverlays& overlays)
    : m_session(std::move(session)),
      m_inputs(std::move(inputs)),
      m_builder(std::make_unique<SessionSceneBuilder>(std::move(scene), options)) {
    m_builder->setOverlays(overlays);
}

void SessionPlayback::step() {
    for (; m_nextInput < m_inputs.size() && m_inputs[m_nextInput].step <= m_session.stepsDone(); ++m_nextInput) {
        const Status added = m_session.add(m_inputs[m_nextInput].input);
        if (!added) {
            m_diagnostics.push_back(diagnostic(DiagnosticCode::UnappliedInput, {}, added.error().message));
        }
    }
    m_session.step();
    m_builder->record(m_session);
    if (m_afterStep) m_afterStep(m_session);
    const std::vector<Diagnostic>& reported = m_session.events().diagnostics;
    m_diagnostics.insert(m_diagnostics.end(), reported.begin(), reported.end());
}

Result<std::shared_ptr<const RenderScene>> SessionPlayback::sceneAtStep(std::uint64_t step, const TaskContext& task) {
    const std::uint64_t first = m_session.stepsDone();
    const auto second = static_cast<std::uint64_t>(1.0 / m_session.stepLength());
    std::shared_ptr<const RenderScene> last = step <= first + second ? scene() : nullptr;
    while (m_session.stepsDone() < step) {
        if (task.isCancelled()) return TaskContext::cancelled();
        this->step();
        if (m_session.stepsDone() + second >= step) last = scene();
        task.report(static_cast<double>(m_session.stepsDone() - first) / static_cast<double>(step - first));
    }
    return last;
}

std::vector<Diagnostic> SessionPlayback::drainDiagnostics() { return std::exchange(m_diagnostics, {}); }

}  // namespace rubble
