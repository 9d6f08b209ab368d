#include "editor/panels/FragmentFigures.h"

#include "core/base/Parallel.h"
#include "core/geometry/Aspect.h"
#include "editor/document/FragmentSeeds.h"

#include <algorithm>

namespace rubble {

namespace {

constexpr std::size_t kBlock = 256;  // fragments that a thread measures at a time

/// Numbers the pieces of a breaking from `next` on, each followed by its own.
void numberTree(const Bake& bake, const BakedBreaking* breaking, std::vector<double>& places, double& next) {
    if (!breaking) return;
    for (std::uint32_t k = 0; k < breaking->fragments.count(); ++k) {
        places[breaking->first + k] = next++;
        numberTree(bake, bake.breakingOf(breaking->first + k), places, next);
    }
}

}  // namespace

FragmentFigures::FragmentFigures(std::shared_ptr<const Bake> bake, double density, int threads)
    : m_bake(std::move(bake)), m_density(density), m_seeds(seedsOfFragments(*m_bake)) {
    for (int k = 0; k < kFragmentColumns; ++k) {
        if (FragmentColumn(k) != FragmentColumn::Mass) column(FragmentColumn(k)).resize(count());
    }
    double next = 0.0;
    numberTree(*m_bake, m_bake->breakingOf(kNone), column(FragmentColumn::Name), next);
    const std::size_t blocks = (count() + kBlock - 1) / kBlock;
    forEachIndex(blocks, threads, [&](std::size_t block) {
        const IndexRange range = partOf(count(), block, blocks);
        for (std::size_t k = range.begin; k < range.end; ++k) measure(static_cast<std::uint32_t>(k));
    });
}

void FragmentFigures::measure(std::uint32_t fragment) {
    const BakedFragment baked = m_bake->fragment(fragment);
    const Polygon outline = baked.solid.outline();
    column(FragmentColumn::Area)[fragment] = area(outline);
    column(FragmentColumn::Volume)[fragment] = baked.solid.volume();
    column(FragmentColumn::Aspect)[fragment] = aspectOf(outline);
    column(FragmentColumn::Neighbours)[fragment] = static_cast<double>(baked.solid.bonds().size());
    column(FragmentColumn::Level)[fragment] = baked.level;
}

double FragmentFigures::value(FragmentColumn column, std::uint32_t fragment) const {
    if (column == FragmentColumn::Mass) return value(FragmentColumn::Volume, fragment) * m_density;
    return m_columns[static_cast<std::size_t>(column)][fragment];
}

void FragmentFigures::setProblems(std::span<const Problem> problems) {
    std::vector<double>& counts = column(FragmentColumn::Problems);
    std::ranges::fill(counts, 0.0);
    m_problemTexts.clear();
    for (const Problem& problem : problems) {
        if (problem.fragment >= counts.size()) continue;
        ++counts[problem.fragment];
        std::string& text = m_problemTexts[problem.fragment];
        text += (text.empty() ? "" : "\n") + problem.message;
    }
}

std::string FragmentFigures::problemText(std::uint32_t fragment) const {
    const auto found = m_problemTexts.find(fragment);
    return found == m_problemTexts.end() ? std::string() : found->second;
}

FragmentSum FragmentFigures::sum(const std::vector<bool>& isCounted) const {
    FragmentSum sum;
    if (!m_bake) return sum;
    std::vector<bool> isCovered(count(), false);  // it, or what it is a piece of, is in the sum
    for (const BakedBreaking& breaking : m_bake->breakings) {
        const bool isParentCovered = breaking.parent != kNone && isCovered[breaking.parent];
        for (std::uint32_t k = breaking.first; k < breaking.first + breaking.fragments.count(); ++k) {
            isCovered[k] = isParentCovered || isCounted[k];
            if (isCounted[k]) ++sum.count;
            if (isCovered[k] && !isParentCovered) sum.volume += value(FragmentColumn::Volume, k);
        }
    }
    sum.mass = sum.volume * m_density;
    return sum;
}

}  // namespace rubble
