#include "app/cli/output/Warnings.h"

#include "core/base/MessageText.h"

#include <ostream>

namespace rubble {
namespace {

constexpr std::size_t kMaxPrinted = 3;

std::string ownerText(const std::string& asset) { return "Asset " + quotedName(asset) + ": "; }

}  // namespace

void printWarnings(const CliContext& context, std::span<const AssetWarnings> assets, const std::string& project) {
    std::size_t count = 0;
    std::size_t owners = 0;
    std::string lastOwner;
    for (const AssetWarnings& asset : assets) {
        if (asset.warnings.empty()) continue;
        lastOwner = ownerText(asset.asset);
        ++owners;
        for (const Diagnostic& warning : asset.warnings) {
            if (count++ < kMaxPrinted) context.err << lastOwner << warning.message << '\n';
        }
    }
    if (count <= kMaxPrinted) return;
    const std::string all = std::to_string(count) + " warnings";
    context.err << (owners == 1 ? lastOwner + all : all + " about " + std::to_string(owners) + " assets")
                << ", of which the first " << kMaxPrinted << " are shown; rubble-cli check " << project
                << " prints all.\n";
}

std::string firstLinesOf(const std::vector<std::string>& lines) {
    std::string text;
    for (std::size_t k = 0; k < lines.size() && k < kMaxPrinted; ++k) text += (k == 0 ? "" : "\n") + lines[k];
    if (lines.size() <= kMaxPrinted) return text;
    return text + "\nAnd " + std::to_string(lines.size() - kMaxPrinted) + " more.";
}

}  // namespace rubble
