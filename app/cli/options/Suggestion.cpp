#include "app/cli/options/Suggestion.h"

#include <algorithm>
#include <vector>

namespace rubble {

std::size_t editDistance(std::string_view first, std::string_view second) {
    // Three rows of the table of distances between prefixes: of `first` up to k - 2, k - 1 and k letters.
    std::vector<std::size_t> older(second.size() + 1), old(second.size() + 1), row(second.size() + 1);
    for (std::size_t j = 0; j <= second.size(); ++j) row[j] = j;
    for (std::size_t k = 1; k <= first.size(); ++k) {
        older.swap(old);
        old.swap(row);
        row[0] = k;
        for (std::size_t j = 1; j <= second.size(); ++j) {
            const std::size_t replaced = old[j - 1] + (first[k - 1] == second[j - 1] ? 0 : 1);
            row[j] = std::min({replaced, old[j] + 1, row[j - 1] + 1});
            const bool isExchanged = k > 1 && j > 1 && first[k - 1] == second[j - 2] && first[k - 2] == second[j - 1];
            if (isExchanged) row[j] = std::min(row[j], older[j - 2] + 1);
        }
    }
    return row.back();
}

std::optional<std::string> suggestionFor(std::string_view typed, std::span<const std::string> names) {
    const std::string* nearest = nullptr;
    std::size_t least = 0;
    std::vector<const std::string*> longer;
    for (const std::string& name : names) {
        const std::size_t distance = editDistance(typed, name);
        const bool isNear = 3 * distance <= name.size();
        if (isNear && (nearest == nullptr || distance < least)) {
            nearest = &name;
            least = distance;
        }
        if (!typed.empty() && name.starts_with(typed)) longer.push_back(&name);
    }
    if (nearest != nullptr) return *nearest;
    if (longer.size() == 1) return *longer.front();
    return std::nullopt;
}

}  // namespace rubble
