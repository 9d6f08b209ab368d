#include "app/cli/simulation/StepRecord.h"

#include "core/base/Percentile.h"
#include "core/io/text/NumberText.h"

#include <algorithm>
#include <initializer_list>

namespace rubble {
namespace {

constexpr int kCountedSteps = 120;  // at the end, of which the mean counts are taken

constexpr const char* kHeader = "step,time,awake,pairs,contacts,points,kinetic,potential";
constexpr const char* kTimeHeader =
    ",pairsMilliseconds,collideMilliseconds,prepareMilliseconds,solveMilliseconds,finishMilliseconds";

void appendRow(std::string& csv, std::initializer_list<double> values) {
    bool isFirst = true;
    for (const double value : values) {
        if (!isFirst) csv += ',';
        isFirst = false;
        appendNumber(csv, value);
    }
}

}  // namespace

StepRecord::StepRecord(const SimulationPlan& plan) : m_plan(plan) {
    if (plan.isTraced) m_trace = std::string(kHeader) + (plan.isTimed ? kTimeHeader : "") + "\n";
}

void StepRecord::add(int step, const World& world, double milliseconds, double heldPotential) {
    if (m_plan.isTimed) m_milliseconds.push_back(milliseconds);
    if (step > m_plan.steps - kCountedSteps) {
        m_sums.bodies += world.counts().bodies;
        m_sums.pairs += world.counts().candidatePairs;
        m_sums.contactPoints += world.counts().contactPoints;
    }
    if (m_plan.isTraced) addRow(step, world, heldPotential);
}

SimulatedCounts StepRecord::means() const {
    const double steps = std::clamp(m_plan.steps, 1, kCountedSteps);
    return {m_sums.bodies / steps, m_sums.pairs / steps, m_sums.contactPoints / steps};
}

std::optional<StepMilliseconds> StepRecord::milliseconds() const {
    if (m_milliseconds.empty()) return std::nullopt;
    return StepMilliseconds{percentile(m_milliseconds, 0.5), percentile(m_milliseconds, 0.99),
                            percentile(m_milliseconds, 1.0)};
}

void StepRecord::addRow(int step, const World& world, double heldPotential) {
    const StepCounts& counts = world.counts();
    const Momenta momenta = world.momenta();
    appendRow(m_trace, {static_cast<double>(step), step * m_plan.stepLength, static_cast<double>(counts.awake),
                        static_cast<double>(counts.candidatePairs), static_cast<double>(counts.contacts),
                        static_cast<double>(counts.contactPoints), momenta.kinetic, momenta.potential + heldPotential});
    if (m_plan.isTimed) {
        const StepTimes& times = world.times();
        m_trace += ',';
        appendRow(m_trace, {times.pairs, times.collide, times.prepare, times.solve, times.finish});
    }
    m_trace += '\n';
}

}  // namespace rubble
