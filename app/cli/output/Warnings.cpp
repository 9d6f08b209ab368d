#include "app/cli/output/Warnings.h"

#include <algorithm>
#include <ostream>

namespace rubble {

void printWarnings(const CliContext& context, const std::string& asset, const std::vector<Diagnostic>& warnings,
                   const std::string& project) {
    constexpr std::size_t kMaxPrinted = 3;
    const std::string owner = "Asset \"" + asset + "\": ";
    const std::size_t printed = std::min(warnings.size(), kMaxPrinted);
    for (std::size_t k = 0; k < printed; ++k) context.err << owner << warnings[k].message << '\n';
    if (printed == warnings.size()) return;
    context.err << owner << warnings.size() << " warnings, of which the first " << printed
                << " are shown; rubble-cli check " << project << " prints all.\n";
}

}  // namespace rubble
