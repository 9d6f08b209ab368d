#pragma once

#include "core/asset/checks/Problems.h"

#include <array>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace rubble {

/// The columns of the table of fragments.
enum class FragmentColumn {
    Name,        // as a number: its index in a depth-first walk of the fracture levels
    Area,        // m², of its outline
    Volume,      // m³
    Mass,        // kg
    Aspect,      // how many times as long as wide its outline is: see aspectRatio()
    Neighbours,  // number of fragments of the same fracture that it touches
    Level,       // fracture level, 0: a fragment of the whole asset
    Problems,    // number of them: see problemsOf()
};
inline constexpr int kFragmentColumns = 8;

/// Totals of several fragments. A child of a counted fragment adds to the count only, as its volume is counted already.
struct FragmentSum {
    std::uint32_t count = 0;
    double volume = 0.0;  // m³
    double mass = 0.0;    // kg
};

/// The measured values of all fragments of a bake, in one array per column.
class FragmentMetrics {
public:
    /// The metrics of no fragments.
    FragmentMetrics() = default;
    /// Measures on `threads` threads; O(n log n) in the corners of a fragment.
    FragmentMetrics(std::shared_ptr<const Bake> bake, double density, int threads);

    /// Null if there are no fragments.
    const std::shared_ptr<const Bake>& bake() const { return m_bake; }
    std::uint32_t count() const { return static_cast<std::uint32_t>(m_seeds.size()); }
    double value(FragmentColumn column, std::uint32_t fragment) const;
    /// Bake::fragmentId(), computed on each call.
    std::string id(std::uint32_t fragment) const { return m_bake->fragmentId(fragment); }
    /// See seedsOfFragments().
    SeedId seed(std::uint32_t fragment) const { return m_seeds[fragment]; }

    /// Counts the problems of each fragment and keeps their messages.
    void setProblems(std::span<const Diagnostic> problems);
    /// The messages of a fragment's problems, one per line.
    std::string problemText(std::uint32_t fragment) const;

    double density() const { return m_density; }
    void setDensity(double density) { m_density = density; }

    /// The totals of the fragments k with isCounted[k].
    FragmentSum sum(const std::vector<bool>& isCounted) const;

private:
    void measure(std::uint32_t fragment);
    std::vector<double>& column(FragmentColumn column) { return m_columns[static_cast<std::size_t>(column)]; }

    std::shared_ptr<const Bake> m_bake;
    double m_density = 1.0;  // kg/m³
    std::vector<SeedId> m_seeds;
    std::map<std::uint32_t, std::string> m_problemTexts;          // of fragments with problems
    std::array<std::vector<double>, kFragmentColumns> m_columns;  // empty for Mass, which follows from Volume
};

}  // namespace rubble
