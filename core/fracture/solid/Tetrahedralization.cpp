#include "core/fracture/solid/Tetrahedralization.h"

#include "core/fracture/solid/HilbertCurve3.h"
#include "core/fracture/solid/SolidSigns.h"
#include "core/geometry/predicates/Predicates.h"

#include <algorithm>
#include <bit>

namespace rubble {
namespace {

using Tetrahedron = Tetrahedralization::Tetrahedron;

/// Of the far sites' coordinates, from the middle of the lattice: their bisectors with any site pass outside its box.
constexpr double kFarDistance = 4.0 * kLatticeSteps;
constexpr std::size_t kSitesPerReport = 1024;

/// Pairs the faces of new tetrahedra that share an edge of the cavity's boundary: a small hash table that is emptied
/// by a new stamp.
class EdgeTable {
public:
    /// Empties the table and makes room for `count` edges.
    void reset(std::size_t count) {
        if (m_entries.size() < 4 * count) m_entries.assign(std::bit_ceil(8 * count), {});
        ++m_stamp;
    }
    /// Returns the slot that was given with the reverse edge, or keeps this one and returns kNone.
    std::uint32_t exchange(std::uint32_t from, std::uint32_t to, std::uint32_t slot) {
        const std::uint64_t key = std::uint64_t{std::min(from, to)} << 32 | std::max(from, to);
        std::size_t place = (key * 0x9e3779b97f4a7c15u) >> 40;
        for (;; ++place) {
            Entry& entry = m_entries[place & (m_entries.size() - 1)];
            if (entry.stamp != m_stamp) {
                entry = {key, slot, m_stamp};
                return kNone;
            }
            if (entry.key == key) return entry.slot;
        }
    }

private:
    struct Entry {
        std::uint64_t key = 0;
        std::uint32_t slot = 0;
        std::uint32_t stamp = 0;
    };
    std::vector<Entry> m_entries = std::vector<Entry>(1024);
    std::uint32_t m_stamp = 0;
};

/// Inserts sites one by one: those tetrahedra whose spheres hold the new site make room for its star.
class SiteInserter {
public:
    explicit SiteInserter(Tetrahedralization& result)
        : m_result(result), m_sites(result.sites), m_tetrahedra(result.tetrahedra) {
        const std::uint32_t far = result.siteCount();
        std::array<std::uint32_t, 4> corner = {far, far + 1, far + 2, far + 3};
        if (orient3d(m_sites[corner[0]], m_sites[corner[1]], m_sites[corner[2]], m_sites[corner[3]]) < 0) {
            std::swap(corner[0], corner[1]);
        }
        m_tetrahedra.push_back({corner, {kNone, kNone, kNone, kNone}});
        m_marks.push_back(0);
    }

    void insert(std::uint32_t site) {
        m_mark += 2;
        findCavity(locate(m_sites[site]), site);
        fillCavity(site);
    }

    /// Removes the free tetrahedra.
    void compact() {
        std::vector<std::uint32_t> numbers(m_tetrahedra.size(), 0);
        for (const std::uint32_t free : m_free) numbers[free] = kNone;
        std::uint32_t count = 0;
        for (std::uint32_t& number : numbers) number = number == kNone ? kNone : count++;
        for (std::size_t t = 0; t < m_tetrahedra.size(); ++t) {
            if (numbers[t] == kNone) continue;
            Tetrahedron tetrahedron = m_tetrahedra[t];
            for (std::uint32_t& neighbour : tetrahedron.neighbour) {
                if (neighbour != kNone) neighbour = numbers[neighbour];
            }
            m_tetrahedra[numbers[t]] = tetrahedron;
        }
        m_tetrahedra.resize(count);
    }

private:
    struct BoundaryFace {
        std::uint32_t outside;  // the tetrahedron behind it; kNone: none
        std::uint32_t face;     // of `outside`: the corner opposite
        std::array<std::uint32_t, 3> corner;
    };

    Vec3 point(std::uint32_t t, int corner) const { return m_sites[m_tetrahedra[t].corner[corner]]; }
    RankedSite ranked(std::uint32_t site) const { return {m_sites[site], m_result.seedOf[site]}; }

    std::uint32_t locate(Vec3 target) const {
        std::uint32_t t = m_last, from = kNone;
        for (;;) {
            std::uint32_t next = kNone;
            for (int k = 0; k < 4 && next == kNone; ++k) {
                if (m_tetrahedra[t].neighbour[k] == from && from != kNone) continue;
                const auto& face = kFaceCorners[k];
                if (orient3d(point(t, face[0]), point(t, face[1]), point(t, face[2]), target) < 0) {
                    next = m_tetrahedra[t].neighbour[k];
                }
            }
            if (next == kNone) return t;
            from = t, t = next;
        }
    }

    bool isInConflict(std::uint32_t t, const RankedSite& site) const {
        const std::array<std::uint32_t, 4>& corner = m_tetrahedra[t].corner;
        return solid_signs::inSphere(ranked(corner[0]), ranked(corner[1]), ranked(corner[2]), ranked(corner[3]), site) >
               0;
    }

    void findCavity(std::uint32_t first, std::uint32_t site) {
        const RankedSite inserted = ranked(site);
        m_cavity.assign(1, first);
        m_boundary.clear();
        m_marks[first] = m_mark;
        for (std::size_t next = 0; next < m_cavity.size(); ++next) {
            const std::uint32_t t = m_cavity[next];
            for (int k = 0; k < 4; ++k) {
                const std::uint32_t neighbour = m_tetrahedra[t].neighbour[k];
                if (neighbour != kNone && m_marks[neighbour] == m_mark) continue;
                if (neighbour != kNone && m_marks[neighbour] != m_mark + 1) {
                    const bool isHit = isInConflict(neighbour, inserted);
                    m_marks[neighbour] = isHit ? m_mark : m_mark + 1;
                    if (isHit) {
                        m_cavity.push_back(neighbour);
                        continue;
                    }
                }
                addBoundary(t, k, neighbour);
            }
        }
    }

    void addBoundary(std::uint32_t t, int k, std::uint32_t outside) {
        const Tetrahedron& inside = m_tetrahedra[t];
        BoundaryFace face{outside, 0, {}};
        for (int m = 0; m < 3; ++m) face.corner[m] = inside.corner[kFaceCorners[k][m]];
        if (outside != kNone) {
            while (m_tetrahedra[outside].neighbour[face.face] != t) ++face.face;
        }
        m_boundary.push_back(face);
    }

    std::uint32_t takeFree() {
        if (!m_free.empty()) {
            const std::uint32_t t = m_free.back();
            m_free.pop_back();
            return t;
        }
        m_tetrahedra.emplace_back();
        m_marks.push_back(0);
        return static_cast<std::uint32_t>(m_tetrahedra.size()) - 1;
    }

    void fillCavity(std::uint32_t site) {
        m_free.insert(m_free.end(), m_cavity.begin(), m_cavity.end());
        m_edges.reset(3 * m_boundary.size() / 2);
        for (const BoundaryFace& face : m_boundary) {
            const std::uint32_t t = takeFree();
            m_marks[t] = 0;
            m_tetrahedra[t] = {{face.corner[0], face.corner[1], face.corner[2], site},
                               {kNone, kNone, kNone, face.outside}};
            if (face.outside != kNone) m_tetrahedra[face.outside].neighbour[face.face] = t;
            for (std::uint32_t k = 0; k < 3; ++k) linkAcross(t, k);
            m_last = t;
        }
    }

    /// Links a new tetrahedron through the face opposite corner k, which holds the new site, if the other one is there.
    void linkAcross(std::uint32_t t, std::uint32_t k) {
        const std::array<std::uint32_t, 4>& corner = m_tetrahedra[t].corner;
        const std::uint32_t slot = 4 * t + k;
        const std::uint32_t other = m_edges.exchange(corner[(k + 1) % 3], corner[(k + 2) % 3], slot);
        if (other == kNone) return;
        m_tetrahedra[t].neighbour[k] = other / 4;
        m_tetrahedra[other / 4].neighbour[other % 4] = t;
    }

    Tetrahedralization& m_result;
    std::vector<Vec3>& m_sites;
    std::vector<Tetrahedron>& m_tetrahedra;
    std::vector<std::uint32_t> m_marks;  // m_mark: in the cavity of this insertion; + 1: outside it
    std::vector<std::uint32_t> m_free;
    std::vector<std::uint32_t> m_cavity;
    std::vector<BoundaryFace> m_boundary;
    EdgeTable m_edges;
    std::uint32_t m_mark = 0;
    std::uint32_t m_last = 0;
};

void setDistinctSites(std::span<const Vec3> seeds, Tetrahedralization& result) {
    const UninitializedVector<std::uint32_t> order = hilbertOrder(seeds);
    for (const std::uint32_t seed : order) {
        if (!result.sites.empty() && seeds[seed] == result.sites.back()) {
            result.duplicates.push_back({seed, result.seedOf.back()});
            continue;
        }
        result.sites.push_back(seeds[seed]);
        result.seedOf.push_back(seed);
    }
    std::sort(result.duplicates.begin(), result.duplicates.end());
}

}  // namespace

Result<Tetrahedralization> tetrahedralized(std::span<const Vec3> seeds, const TaskContext& task) {
    Tetrahedralization result;
    setDistinctSites(seeds, result);
    const std::uint32_t count = static_cast<std::uint32_t>(result.sites.size());
    const Vec3 middle(kLatticeSteps / 2.0);
    for (const Vec3 direction : {Vec3(1, 1, 1), Vec3(1, -1, -1), Vec3(-1, 1, -1), Vec3(-1, -1, 1)}) {
        result.seedOf.push_back(static_cast<std::uint32_t>(seeds.size() + result.sites.size() - count));
        result.sites.push_back(middle + kFarDistance * direction);
    }
    SiteInserter inserter(result);
    for (std::uint32_t site = 0; site < count; ++site) {
        if (site % kSitesPerReport == 0) {
            if (task.isCancelled()) return TaskContext::cancelled();
            task.report(static_cast<double>(site) / count);
        }
        inserter.insert(site);
    }
    inserter.compact();
    return result;
}

}  // namespace rubble
