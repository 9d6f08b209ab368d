#include "editor/panels/models/FragmentMetrics.h"

#include "core/base/Parallel.h"
#include "core/geometry/hull/AspectRatio.h"
#include "core/structure/bonds/FragmentSilhouette.h"
#include "editor/document/FragmentSeeds.h"

#include <algorithm>

namespace rubble {

namespace {

constexpr std::size_t kBlock = 256;  // fragments that a thread measures per task

/// Numbers the fragments of a fracture depth-first from `next` on.
void numberTree(const Bake& bake, const BakedFracture* fracture, std::vector<double>& order, double& next) {
    if (!fracture) return;
    for (std::uint32_t k = 0; k < fracture->fragments.count(); ++k) {
        order[fracture->first + k] = next++;
        numberTree(bake, bake.fractureOf(fracture->first + k), order, next);
    }
}

}  // namespace

FragmentMetrics::FragmentMetrics(std::shared_ptr<const Bake> bake, double density, int threads)
    : m_bake(std::move(bake)), m_density(density), m_seeds(seedsOfFragments(*m_bake)) {
    for (int k = 0; k < kFragmentColumns; ++k) {
        if (FragmentColumn(k) != FragmentColumn::Mass) column(FragmentColumn(k)).resize(count());
    }
    double next = 0.0;
    numberTree(*m_bake, m_bake->fractureOf(kNone), column(FragmentColumn::Name), next);
    const std::size_t blocks = (count() + kBlock - 1) / kBlock;
    forEachIndex(blocks, threads, [&](std::size_t block) {
        const IndexRange range = chunkRange(count(), block, blocks);
        for (std::size_t k = range.begin; k < range.end; ++k) measure(static_cast<std::uint32_t>(k));
    });
}

void FragmentMetrics::measure(std::uint32_t fragment) {
    const BakedFragment baked = m_bake->fragment(fragment);
    column(FragmentColumn::Area)[fragment] = area(silhouetteOf(baked.solid));
    column(FragmentColumn::Volume)[fragment] = baked.solid.volume();
    column(FragmentColumn::Aspect)[fragment] = baked.solid.aspectRatio();
    column(FragmentColumn::Neighbours)[fragment] = static_cast<double>(baked.solid.contacts().size());
    column(FragmentColumn::Level)[fragment] = baked.level;
}

double FragmentMetrics::value(FragmentColumn column, std::uint32_t fragment) const {
    if (column == FragmentColumn::Mass) return value(FragmentColumn::Volume, fragment) * m_density;
    return m_columns[static_cast<std::size_t>(column)][fragment];
}

void FragmentMetrics::setProblems(std::span<const Diagnostic> problems) {
    std::vector<double>& counts = column(FragmentColumn::Problems);
    std::ranges::fill(counts, 0.0);
    m_problemTexts.clear();
    for (const Diagnostic& problem : problems) {
        if (problem.place.fragment >= counts.size()) continue;
        ++counts[problem.place.fragment];
        std::string& text = m_problemTexts[problem.place.fragment];
        text += (text.empty() ? "" : "\n") + problem.message;
    }
}

std::string FragmentMetrics::problemText(std::uint32_t fragment) const {
    const auto found = m_problemTexts.find(fragment);
    return found == m_problemTexts.end() ? std::string() : found->second;
}

FragmentSum FragmentMetrics::sum(const std::vector<bool>& isCounted) const {
    FragmentSum sum;
    if (!m_bake) return sum;
    std::vector<bool> isCovered(count(), false);  // the fragment or an ancestor is in the sum
    for (const BakedFracture& fracture : m_bake->fractures) {
        const bool isParentCovered = fracture.parent != kNone && isCovered[fracture.parent];
        for (std::uint32_t k = fracture.first; k < fracture.first + fracture.fragments.count(); ++k) {
            isCovered[k] = isParentCovered || isCounted[k];
            if (isCounted[k]) ++sum.count;
            if (isCovered[k] && !isParentCovered) sum.volume += value(FragmentColumn::Volume, k);
        }
    }
    sum.mass = sum.volume * m_density;
    return sum;
}

}  // namespace rubble
