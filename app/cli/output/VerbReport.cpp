#include "app/cli/output/VerbReport.h"

namespace rubble {

void addFinding(VerbReport& report, const std::string& line) {
    report.findings += (report.findings.empty() ? "" : "\n") + line;
}

}  // namespace rubble
