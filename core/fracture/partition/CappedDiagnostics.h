#pragma once

#include "core/base/Diagnostic.h"

#include <array>
#include <cstddef>
#include <vector>

namespace rubble {

/// How many diagnostics of one code are kept of a fracture, of a bake, or of the problems of an asset. Nobody reads
/// more, and those of half a million fragments take gigabytes.
inline constexpr std::size_t kMaxDiagnosticsPerCode = 1000;

/// Collects diagnostics in order: the first kMaxDiagnosticsPerCode of each code; of the others the number.
class CappedDiagnostics {
public:
    explicit CappedDiagnostics(std::size_t most = kMaxDiagnosticsPerCode) : m_most(most) {}

    bool hasRoom(DiagnosticCode code) const { return m_added[indexOf(code)] < m_most; }
    /// Adds make(), which is only called if there is room.
    template <class Make>
    void add(DiagnosticCode code, const Make& make) {
        if (m_added[indexOf(code)]++ < m_most) m_list.push_back(make());
    }
    void add(Diagnostic&& one) {
        const DiagnosticCode code = one.code;
        add(code, [&] { return std::move(one); });
    }
    /// Counts diagnostics that were not made.
    void addUnmade(DiagnosticCode code, std::size_t count) { m_added[indexOf(code)] += count; }
    /// What was added, then for each code of which there was more one at `place` that says how many.
    std::vector<Diagnostic> list(const DiagnosticPlace& place = {}) &&;

private:
    static std::size_t indexOf(DiagnosticCode code) { return static_cast<std::size_t>(code); }

    std::size_t m_most;
    std::vector<Diagnostic> m_list;
    std::array<std::size_t, kDiagnosticCodes> m_added{};
};

}  // namespace rubble
