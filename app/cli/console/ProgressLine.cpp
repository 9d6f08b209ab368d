#include "app/cli/console/ProgressLine.h"

#include <ostream>

namespace rubble {
namespace {

constexpr const char* kEmptyLine = "\r\x1b[K";  // to the start of the line, then erase to its end

}  // namespace

void ProgressLine::show(double fraction) {
    const int percent = static_cast<int>(100.0 * fraction);
    if (m_context.terminal == nullptr || percent <= m_percent) return;
    m_percent = percent;
    *m_context.terminal << kEmptyLine << m_task << ' ' << percent << " %" << std::flush;
}

void ProgressLine::clear() {
    if (m_percent >= 0) *m_context.terminal << kEmptyLine << std::flush;
}

}  // namespace rubble
