#pragma once

#include "core/play/session/Session.h"
#include "editor/play/PlayFrame.h"

#include <map>

namespace rubble {

/// The impacts of one course of a session: what broke, and what withstood a tenth of its threshold or more.
class ImpactLog {
public:
    /// The number of steps recorded.
    std::uint64_t steps() const { return m_steps; }
    /// By ascending step.
    const std::vector<ImpactRecord>& impacts() const { return m_impacts; }
    /// The number of breaks.
    std::size_t breaks() const;

    /// Records the session's last step, which must be the next one. Returns its impacts.
    std::span<const ImpactRecord> record(const Session& session);
    /// Discards what happened after this step.
    void discardAfter(std::uint64_t step);

private:
    void addWithstood(const Session& session, const PlayImpact& impact);

    std::uint64_t m_steps = 0;
    std::vector<ImpactRecord> m_impacts;
    std::map<std::uint32_t, ImpactRecord> m_lastWithstood;  // by body
};

}  // namespace rubble
