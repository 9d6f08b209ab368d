#pragma once

#include "core/asset/Problems.h"

#include <array>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace rubble {

/// What is told of a fragment.
enum class FragmentColumn {
    Name,        // as a number: its place in the tree, where a fragment's own pieces follow it
    Area,        // m^2 of its outline, seen along the prism's depth
    Volume,      // m^3 of all that it weighs
    Mass,        // kg
    Aspect,      // how many times as long as wide its outline is: see aspectOf()
    Neighbours,  // how many fragments of the same breaking it touches
    Level,       // 0: a piece of the whole
    Problems,    // how many there are with it, see problemsOf()
};
inline constexpr int kFragmentColumns = 8;

/// How many fragments, and what they have together: a piece of one that is counted already adds no volume.
struct FragmentSum {
    std::uint32_t count = 0;
    double volume = 0.0;  // m^3
    double mass = 0.0;    // kg
};

/// The figures of all fragments of a bake, computed once and kept in flat arrays.
class FragmentFigures {
public:
    /// Of no fragment.
    FragmentFigures() = default;
    /// O(corners · log corners of a piece), on `threads` threads.
    FragmentFigures(std::shared_ptr<const Bake> bake, double density, int threads);

    /// Null where it is of no fragment.
    const std::shared_ptr<const Bake>& bake() const { return m_bake; }
    std::uint32_t count() const { return static_cast<std::uint32_t>(m_seeds.size()); }
    double value(FragmentColumn column, std::uint32_t fragment) const;
    /// See Bake::fragmentId; made when asked for.
    std::string id(std::uint32_t fragment) const { return m_bake->fragmentId(fragment); }
    /// See seedsOfFragments().
    SeedId seed(std::uint32_t fragment) const { return m_seeds[fragment]; }

    /// Takes what is to be looked at in the bake.
    void setProblems(std::span<const Problem> problems);
    /// The sentences of a fragment's problems, a line each.
    std::string problemText(std::uint32_t fragment) const;

    double density() const { return m_density; }
    void setDensity(double density) { m_density = density; }

    /// Of the fragments that are marked; one mark a fragment.
    FragmentSum sum(const std::vector<bool>& isCounted) const;

private:
    void measure(std::uint32_t fragment);
    std::vector<double>& column(FragmentColumn column) { return m_columns[static_cast<std::size_t>(column)]; }

    std::shared_ptr<const Bake> m_bake;
    double m_density = 1.0;  // kg/m^3
    std::vector<SeedId> m_seeds;
    std::map<std::uint32_t, std::string> m_problemTexts;          // of fragments that have some
    std::array<std::vector<double>, kFragmentColumns> m_columns;  // none for masses, which follow from volumes
};

}  // namespace rubble
