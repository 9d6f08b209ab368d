#include "core/fracture/partition/CappedDiagnostics.h"

#include <string>
#include <utility>

namespace rubble {

std::vector<Diagnostic> CappedDiagnostics::list(const DiagnosticPlace& place) && {
    for (std::size_t code = 0; code < m_added.size(); ++code) {
        if (m_added[code] <= m_most) continue;
        const std::size_t more = m_added[code] - m_most;
        const auto kind = static_cast<DiagnosticCode>(code);
        m_list.push_back(diagnostic(kind, place,
                                    std::to_string(more) + " more " + (more == 1 ? "message" : "messages") +
                                        " of this kind (" + nameOf(kind) + ") left out.",
                                    static_cast<double>(more)));
    }
    return std::move(m_list);
}

}  // namespace rubble
