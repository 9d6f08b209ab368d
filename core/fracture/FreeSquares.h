#pragma once

#include "core/base/Random.h"
#include "core/base/TaskContext.h"
#include "core/fracture/SeedGrid.h"
#include "core/geometry/Polygon.h"

#include <optional>
#include <vector>

namespace rubble {

/// Where in a domain a seed may still find room: squares of one size, quartered again and again, of which those
/// outside the domain and those covered by a seed are dropped. What is left closes in on the last gaps.
/// Source: Ebeida, Mitchell, Patney, Davidson, Owens, "A simple algorithm for maximal Poisson-disk sampling in high
/// dimensions", 2012.
class FreeSquares {
public:
    /// One square around the domain, which must outlive this.
    explicit FreeSquares(const Polygon& domain);

    bool isEmpty() const { return m_squares.empty(); }
    std::size_t size() const { return m_squares.size(); }
    double side() const { return m_side; }  // m

    /// A random point of a random square; nothing where it misses the domain. Takes three numbers of the stream.
    std::optional<Vec2> dart(Random& random) const;
    /// Quarters every square and keeps what is neither outside nor covered.
    ///
    /// Errors: Cancelled.
    Status quarter(const SeedGrid& seeds, const TaskContext& task);

private:
    struct Square {
        Vec2 min;
        bool isInside;  // wholly in the domain: no need to ask any more
    };
    std::optional<Square> partInDomain(Square square) const;

    const Polygon& m_domain;
    double m_side;
    std::vector<Square> m_squares;
};

}  // namespace rubble
