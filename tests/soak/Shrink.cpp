#include "tests/soak/Shrink.h"

#include "core/asset/checks/VerifyProject.h"
#include "core/asset/project/AssetShape.h"
#include "tests/soak/ChildProcess.h"
#include "tests/support/geometry/Outlines.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <set>

namespace rubble::soak {
namespace {

/// The nearest decimal number with so many digits behind the point.
double rounded(double value, int digits) {
    const std::string text = [&] {
        char written[400];
        std::snprintf(written, sizeof written, "%.*f", digits, value);
        return std::string(written);
    }();
    return std::strtod(text.c_str(), nullptr);
}

Vec3 rounded(Vec3 value, int digits) {
    return {rounded(value.x, digits), rounded(value.y, digits), rounded(value.z, digits)};
}

/// Makes a case smaller in one way after the other, as long as it fails.
class Shrinker {
public:
    Shrinker(SoakCase one, Failure failure, int attempts)
        : m_best{std::move(one), std::move(failure)}, m_attempts(attempts) {}

    ShrunkCase shrunk() {
        attempt([&](SoakCase& one) { endAfter(one, m_best.failure.step); });
        for (std::size_t before = 0, now = sizeOf(m_best.one); before != now && m_attempts > 0;) {
            before = now;
            dropParts();
            simplifyAssets();
            simplifyScene();
            now = sizeOf(m_best.one);
        }
        simplifyNumbers();
        return std::move(m_best);
    }

private:
    static std::size_t sizeOf(const SoakCase& one) {
        std::size_t size = one.inputs.size() + one.saves.size() + one.rewinds.size() + one.project.instances.size() +
                           one.project.mortars.size() + one.project.assets.size();
        for (const Asset& asset : one.project.assets) {
            size += asset.pattern.layers.size() + asset.levels.size() + asset.bonding.clusters.size() +
                    asset.bonding.strokes.size();
        }
        return size;
    }

    /// Leaves out what comes after a step.
    static void endAfter(SoakCase& one, std::uint64_t step) {
        one.steps = std::clamp<std::uint64_t>(step, 1, one.steps);
        std::erase_if(one.inputs, [&](const TimedInput& timed) { return timed.step >= one.steps; });
        std::erase_if(one.rewinds, [&](const Rewind& rewind) { return rewind.step + rewind.steps > one.steps; });
        std::erase_if(one.saves, [&](std::uint64_t save) { return save > one.steps; });
    }

    /// Whether a changed case still breaks the promise; it is then the best one.
    bool attempt(const std::function<void(SoakCase&)>& change) {
        if (m_attempts <= 0) return false;
        SoakCase changed = m_best.one;
        change(changed);
        if (changed == m_best.one || verifyProject(changed.project)) return false;
        --m_attempts;
        const bool isProcess = m_best.failure.invariant == kCrash || m_best.failure.invariant == kHang;
        const Outcome outcome = ChildRun(changed, isProcess ? "" : m_best.failure.invariant).finished();
        const auto isSame = [&](const Failure& one) { return one.invariant == m_best.failure.invariant; };
        const auto found = std::ranges::find_if(outcome.failures, isSame);
        if (found == outcome.failures.end()) return false;
        endAfter(changed, found->step);
        m_best = {std::move(changed), *found};
        return true;
    }

    /// Drops elements of a list of the case: all, halves, single ones.
    template <class List>
    void dropFrom(const std::function<List&(SoakCase&)>& listOf) {
        for (std::size_t size = listOf(m_best.one).size(); size > 0; size /= 2) {
            for (std::size_t from = 0; from < listOf(m_best.one).size();) {
                const bool isDropped = attempt([&](SoakCase& one) {
                    List& list = listOf(one);
                    const auto begin = list.begin() + static_cast<std::ptrdiff_t>(from);
                    list.erase(begin, begin + static_cast<std::ptrdiff_t>(std::min(size, list.size() - from)));
                    dropUnused(one.project);
                });
                if (!isDropped) from += size;
            }
        }
    }

    /// Removes what nothing refers to.
    static void dropUnused(Project& project) {
        std::erase_if(project.assets, [&](const Asset& asset) {
            return std::ranges::none_of(project.instances,
                                        [&](const Instance& instance) { return instance.asset == asset.id; });
        });
        std::erase_if(project.materials, [&](const Material& material) {
            return std::ranges::none_of(project.assets,
                                        [&](const Asset& asset) { return asset.material == material.id; });
        });
    }

    void dropParts() {
        dropFrom<std::vector<TimedInput>>([](SoakCase & one) -> auto& { return one.inputs; });
        dropFrom<std::vector<std::uint64_t>>([](SoakCase & one) -> auto& { return one.saves; });
        dropFrom<std::vector<Rewind>>([](SoakCase & one) -> auto& { return one.rewinds; });
        attempt([](SoakCase& one) { one.isCompared = false; });
        dropFrom<std::vector<Instance>>([](SoakCase & one) -> auto& { return one.project.instances; });
        dropFrom<std::vector<Mortar>>([](SoakCase & one) -> auto& { return one.project.mortars; });
    }

    void simplifyAssets() {
        for (std::size_t k = 0; k < m_best.one.project.assets.size(); ++k) {
            const auto change = [&](const std::function<void(Asset&)>& simplify) {
                return attempt([&](SoakCase& one) {
                    if (k < one.project.assets.size()) simplify(one.project.assets[k]);
                });
            };
            change([](Asset& asset) { asset.levels.clear(); });
            change([](Asset& asset) { asset.breakAs = BreakAs::Whole; });
            change([](Asset& asset) {
                if (asset.breakAs == BreakAs::Whole) asset.bonding = {};
            });
            change([](Asset& asset) { asset.bonding.clusters.clear(); });
            change([](Asset& asset) { asset.bonding.strokes.clear(); });
            change([](Asset& asset) { asset.bonding.heightStrengths.clear(); });
            change([](Asset& asset) { asset.bonding.span = 0.0; });
            change([](Asset& asset) { asset.bonding.collapseDelay = 0.0; });
            change([](Asset& asset) { asset.bonding.minimumIsland = 1; });
            change([](Asset& asset) { asset.shaping = {}; });
            change([](Asset& asset) { asset.cutAtImpact.reset(); });
            change([](Asset& asset) {
                if (asset.mesh() == nullptr) return asset.prism().outline.holes.clear();
                const Vec3 half = 0.5 * rubble::sizeOf(asset);
                asset.shape = Prism{{rectangle(Vec2(-half), Vec2(half)), {}}, 2.0 * half.z};
            });
            change([](Asset& asset) {
                if (asset.isPrism()) makeBox(asset.prism());
            });
            simplifyPattern(k, change);
        }
    }

    static void makeBox(Prism& prism) {
        Vec2 low(1e300), high(-1e300);
        for (const Vec2& point : prism.outline.outer) {
            low = glm::min(low, point);
            high = glm::max(high, point);
        }
        prism.outline = {{low, {high.x, low.y}, high, {low.x, high.y}}, {}};
    }

    template <class Change>
    void simplifyPattern(std::size_t asset, const Change& change) {
        dropFrom<std::vector<PatternLayer>>([asset](SoakCase & one) -> auto& {
            return one.project.assets[asset].pattern.layers;
        });
        for (const std::uint32_t count : {2u, 3u, 4u, 6u, 9u, 14u, 20u}) {
            const bool isSimpler = change([&](Asset& one) {
                if (one.pattern.layers.empty()) return;
                const auto* known = std::get_if<UniformScatter>(&one.pattern.layers.front().parameters);
                if (known != nullptr && known->count.amount <= count) return;
                one.pattern.layers.resize(1);
                one.pattern.layers.front().parameters = UniformScatter{count};
            });
            if (isSimpler) break;
        }
    }

    void simplifyScene() {
        const auto change = [&](const std::function<void(Project&)>& simplify) {
            attempt([&](SoakCase& one) { simplify(one.project); });
        };
        change([](Project& project) { project.debris = {}; });
        change([](Project& project) { project.damage = {}; });
        change([](Project& project) { project.ground = {.isOn = project.ground.isOn}; });
        change([](Project& project) { project.gravity = {0.0, -9.81, 0.0}; });
        attempt([](SoakCase& one) { one.dt = 1.0 / 60.0; });
        for (std::size_t k = 0; k < m_best.one.project.materials.size(); ++k) {
            change([&](Project& project) {
                if (k >= project.materials.size()) return;
                project.materials[k].density = 1000.0;
                project.materials[k].friction = 0.6;
            });
            change([&](Project& project) {
                if (k < project.materials.size()) project.materials[k].restitution = 0.0;
            });
        }
        for (std::size_t k = 0; k < m_best.one.project.instances.size(); ++k) simplifyInstance(k);
    }

    void simplifyInstance(std::size_t k) {
        const auto change = [&](const std::function<void(Instance&)>& simplify) {
            attempt([&](SoakCase& one) {
                if (k < one.project.instances.size()) simplify(one.project.instances[k]);
            });
        };
        change([](Instance& one) { one.isUnbreakable = false; });
        change([](Instance& one) { one.isFixed = false; });
        change([](Instance& one) { one.isAnchored = false; });
        change([](Instance& one) { one.bondStrength = 1.0; });
        change([](Instance& one) { one.threshold.reset(); });
        change([](Instance& one) { one.pose.orientation = {1.0, 0.0, 0.0, 0.0}; });
    }

    void simplifyNumbers() {
        for (const int digits : {1, 2, 3}) {
            for (std::size_t k = 0; k < m_best.one.project.instances.size(); ++k) {
                attempt([&](SoakCase& one) {
                    Vec3& position = one.project.instances[k].pose.position;
                    position = rounded(position, digits);
                });
            }
            for (std::size_t k = 0; k < m_best.one.project.assets.size(); ++k) {
                if (m_best.one.project.assets[k].isPrism())
                    attempt([&](SoakCase& one) { roundPrism(one.project.assets[k].prism(), digits); });
                attempt([&](SoakCase& one) { roundStrength(one.project.assets[k], digits); });
            }
            for (std::size_t k = 0; k < m_best.one.inputs.size(); ++k) {
                attempt([&](SoakCase& one) { roundInput(one.inputs[k].input, digits); });
            }
        }
    }

    /// To so many digits from its first: it may be of any size.
    static void roundDigits(double& value, int digits) {
        char written[40];
        std::snprintf(written, sizeof written, "%.*g", digits, value);
        value = std::strtod(written, nullptr);
    }

    static void roundStrength(Asset& asset, int digits) {
        roundDigits(asset.threshold, digits);
        roundDigits(asset.bonding.radius, digits);
        roundDigits(asset.bonding.span, digits);
        roundDigits(asset.bonding.damageFrom, digits);
        if (asset.bonding.impulsePerArea) roundDigits(*asset.bonding.impulsePerArea, digits);
    }

    static void roundInput(PlayInput& input, int digits) {
        auto* const shot = std::get_if<ShotInput>(&input);
        if (shot == nullptr) return;
        if (auto* thrown = std::get_if<Throw>(&shot->action)) {
            thrown->from = rounded(thrown->from, digits);
            thrown->to = rounded(thrown->to, digits);
            for (double* value : {&thrown->mass, &thrown->speed, &thrown->size.x, &thrown->size.y, &thrown->size.z})
                roundDigits(*value, digits);
        } else if (auto* blow = std::get_if<Hammer>(&shot->action)) {
            blow->at = rounded(blow->at, digits);
        } else if (auto* blast = std::get_if<Blast>(&shot->action)) {
            blast->at = rounded(blast->at, digits);
            roundDigits(blast->impulse, digits);
            roundDigits(blast->radius, digits);
        }
    }

    static void roundPrism(Prism& prism, int digits) {
        for (Vec2& point : prism.outline.outer) point = {rounded(point.x, digits), rounded(point.y, digits)};
        if (const double depth = rounded(prism.depth, digits); depth > 0.0) prism.depth = depth;
    }

    ShrunkCase m_best;
    int m_attempts;
};

}  // namespace

ShrunkCase shrunkCase(SoakCase one, Failure failure, int attempts) {
    return Shrinker(std::move(one), std::move(failure), attempts).shrunk();
}

}  // namespace rubble::soak
