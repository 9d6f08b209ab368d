#include "core/asset/compare/BakeDifference.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace rubble {
namespace {

/// The fragments of a bake by path.
std::map<FragmentPath, std::uint32_t> numbersIn(const Bake& bake) {
    std::map<FragmentPath, std::uint32_t> numbers;
    for (std::uint32_t k = 0; k < bake.fragmentCount(); ++k) numbers.emplace(bake.fragmentPath(k), k);
    return numbers;
}

double diagonalOf(const Bake& bake) {
    const bool isPrism = bake.fractures.empty() || bake.fractures[0].fragments.extruded() != nullptr;
    Box3 box;
    for (const Polytope& hull : bake.wholeHulls) {
        for (const Vec3& vertex : hull.vertices) box.include(isPrism ? Vec3{vertex.x, vertex.y, 0.0} : vertex);
    }
    return bake.wholeHulls.empty() ? 0.0 : box.diagonal();
}

double largestEntry(const Mat3& matrix) {
    double largest = 0.0;
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) largest = std::max(largest, std::abs(matrix[column][row]));
    }
    return largest;
}

/// True if volume or inertia differ by more than a relative limit.
bool differ(const MassProperties& before, const MassProperties& after, double relative) {
    if (std::abs(before.volume - after.volume) > relative * std::max(before.volume, after.volume)) return true;
    const double largest = std::max(largestEntry(before.inertia), largestEntry(after.inertia));
    return largestEntry(before.inertia - after.inertia) > relative * largest;
}

/// Compares two bakes fragment by fragment.
class Comparison {
public:
    Comparison(const Bake& before, const Bake& after, const DifferenceLimits& limits)
        : m_before(before),
          m_after(after),
          m_limits(limits),
          m_minShift(limits.shift * std::max(diagonalOf(before), diagonalOf(after))) {}

    BakeDifference result() {
        const std::map<FragmentPath, std::uint32_t> later = numbersIn(m_after);
        std::vector<bool> isMatched(m_after.fragmentCount());
        for (std::uint32_t k = 0; k < m_before.fragmentCount(); ++k) {
            FragmentPath path = m_before.fragmentPath(k);
            const auto found = later.find(path);
            if (found != later.end()) isMatched[found->second] = true;
            compare(std::move(path), k, found == later.end() ? kNone : found->second);
        }
        for (std::uint32_t k = 0; k < m_after.fragmentCount(); ++k) {
            if (!isMatched[k]) compare(m_after.fragmentPath(k), kNone, k);
        }
        std::ranges::stable_sort(m_difference.fragments, {}, &FragmentDifference::change);
        return std::move(m_difference);
    }

private:
    LevelDifference& at(std::uint32_t level) {
        if (level >= m_difference.levels.size()) m_difference.levels.resize(level + 1);
        return m_difference.levels[level];
    }

    void add(FragmentChange change, FragmentDifference fragment) {
        ++at(fragment.level).changed[static_cast<int>(change)];
        fragment.change = change;
        m_difference.fragments.push_back(std::move(fragment));
    }

    /// Compares one fragment, given by its numbers in both bakes.
    void compare(FragmentPath path, std::uint32_t before, std::uint32_t after) {
        FragmentDifference fragment{.path = std::move(path), .before = before, .after = after};
        fragment.level = levelOf(fragment.path);
        LevelDifference& level = at(fragment.level);
        level.before += before != kNone;
        level.after += after != kNone;
        if (before != kNone) fragment.volumeBefore = m_before.fragment(before).solid.volume();
        if (after != kNone) fragment.volumeAfter = m_after.fragment(after).solid.volume();
        if (after == kNone) return add(FragmentChange::Gone, std::move(fragment));
        if (before == kNone) return add(FragmentChange::Added, std::move(fragment));
        const Fragment earlier = m_before.fragment(before).solid, later = m_after.fragment(after).solid;
        fragment.shift = glm::distance(earlier.offset(), later.offset());
        if (fragment.shift > m_minShift) return add(FragmentChange::Moved, std::move(fragment));
        if (differ(earlier.mass(), later.mass(), m_limits.relative))
            return add(FragmentChange::Reshaped, std::move(fragment));
        ++level.unchanged;
    }

    const Bake& m_before;
    const Bake& m_after;
    const DifferenceLimits m_limits;
    const double m_minShift;  // m
    BakeDifference m_difference;
};

}  // namespace

std::size_t BakeDifference::count(FragmentChange change) const { return sum().changed[static_cast<int>(change)]; }

LevelDifference BakeDifference::sum() const {
    LevelDifference sum;
    for (const LevelDifference& level : levels) {
        sum.before += level.before;
        sum.after += level.after;
        sum.unchanged += level.unchanged;
        for (int k = 0; k < kFragmentChanges; ++k) sum.changed[k] += level.changed[k];
    }
    return sum;
}

BakeDifference differenceOf(const Bake& before, const Bake& after, const DifferenceLimits& limits) {
    return Comparison(before, after, limits).result();
}

}  // namespace rubble
